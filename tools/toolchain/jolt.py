# SPDX-License-Identifier: MIT
"""Jolt without the engine, for ./run bench raw_jolt.

Its source is taken from Debian's source package of Godot, so it is the very Jolt (with the engine's
patches) that the private Godot has inside. It is built once for all clones, in the user's cache.
"""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

from .apt import KEYRING, SUITE, AptError, apt_command, apt_run, mirrors
from .console import Failure, step, tail
from .godot import Godot
from .paths import BUILD, ROOT, cache, lock, make_folder, need_space

PROJECT = ROOT / "tests" / "bench" / "raw_jolt"
LIBRARY = "libJolt.a"
TOOLS = ("apt-get", "tar", "xz", "cmake")


def options(godot: Godot) -> list[str]:
    """Options for the benchmark: where the program is, or why it is absent."""
    try:
        return [f"--program={program(godot)}"]
    except Failure as failure:
        return [f"--absent={str(failure).splitlines()[0]}"]


def program(godot: Godot) -> Path:
    """The program that replays recordings with Jolt alone, built where it is not up to date."""
    jolt = library(debian_version(godot.full_version))
    work = BUILD / "raw_jolt"
    with lock(BUILD / "lock", "building this clone"):
        _build(work, "raw_jolt", jolt / "source", f"-DJOLT_LIBRARY={jolt / LIBRARY}")
    return work / "raw_jolt"


def debian_version(full_version: str) -> str:
    """The Debian version of an engine, or an empty text: "4.6.3.stable.debian4.6.3+ds-2"."""
    match = re.search(r"\.debian(\d[\w.+~-]*)$", full_version)
    return match.group(1) if match else ""


def library(version: str) -> Path:
    """The folder with Jolt's source and library; an interrupted attempt leaves nothing."""
    folder = cache() / f"jolt-{SUITE}{'-' + version if version else ''}"
    if folder.exists():
        return folder
    missing = [tool for tool in TOOLS if shutil.which(tool) is None]
    if missing or not KEYRING.exists():
        what = ", ".join(missing) or str(KEYRING)
        raise Failure(f"Jolt's source cannot be fetched without {what}: install that first.")
    make_folder(cache())
    with lock(cache() / "jolt.lock", "setting up Jolt"):
        if folder.exists():
            return folder
        need_space(cache(), 600, "Jolt")
        work = folder.with_name(folder.name + ".part")
        shutil.rmtree(work, ignore_errors=True)
        _unpack(_download(work, version), work)
        with step("build Jolt (about two minutes)"):
            _build(work / "build", "Jolt", work / "source")
        shutil.move(work / "build" / LIBRARY, work / LIBRARY)
        for rest in ("build", "apt"):
            shutil.rmtree(work / rest, ignore_errors=True)
        work.rename(folder)
    return folder


def _download(work: Path, version: str) -> Path:
    """Fetches the source package that fits the engine, or the newest; returns its archive."""
    failure = "apt names no mirror"
    for site in mirrors():
        apt = apt_command(work, site, "deb-src")
        # Packages of earlier versions leave the mirrors.
        for package in [f"godot={version}", "godot"] if version else ["godot"]:
            try:
                with step(f"download the source of {package} from Debian {SUITE} (34 MB)"):
                    apt_run([*apt, "update"])
                    apt_run([*apt, "source", "--download-only", package], work)
                return next(work.glob("godot_*.orig.tar.*"))
            except (AptError, StopIteration) as error:
                failure = (str(error).strip().splitlines() or ["it holds no archive"])[-1]
    raise Failure(
        f"Jolt's source cannot be had from Debian {SUITE} ({failure}): check the network, or set "
        "DISMOUNT_DEBIAN_MIRROR to a Debian mirror."
    )


def _unpack(archive: Path, work: Path) -> None:
    source = make_folder(work / "source")
    command = ["tar", "-xf", str(archive), "-C", str(source), "--strip-components=3"]
    command += ["--wildcards", "*/thirdparty/jolt_physics/*"]
    with step("unpack Jolt"):
        done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0 or not (source / "Jolt" / "Jolt.h").exists():
        raise Failure(f"{archive.name} holds no Jolt to unpack.\n{tail(done.stderr, 3)}")
    for leftover in work.glob("godot_*"):
        leftover.unlink()


def _build(folder: Path, target: str, source: Path, *more: str) -> None:
    generator = "Ninja" if shutil.which("ninja") else "Unix Makefiles"
    configure = ["cmake", "-S", str(PROJECT), "-B", str(folder), "-G", generator]
    build = ["cmake", "--build", str(folder), "--target", target, "--parallel", "2"]
    for command in ([*configure, f"-DJOLT_DIR={source}", *more], build):
        done = subprocess.run(
            command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False
        )
        if done.returncode != 0:
            raise Failure(f"Jolt alone could not be built.\n{tail(done.stdout, 20)}")
