# SPDX-License-Identifier: MIT
"""apt-get with a state of its own: packages of another suite than the host's, without root."""

from __future__ import annotations

import os
import re
import subprocess
from pathlib import Path

from .paths import cache, make_folder, write_whole

SUITE = os.environ.get("DISMOUNT_DEBIAN_SUITE", "forky")
KEYRING = Path("/usr/share/keyrings/debian-archive-keyring.gpg")


class AptError(Exception):
    """What apt-get said when it failed."""


def mirrors() -> list[str]:
    """Addresses to try, from the environment or the machine's own apt configuration."""
    own = os.environ.get("DISMOUNT_DEBIAN_MIRROR")
    if own:
        return [own]
    result = subprocess.run(
        ["apt-get", "indextargets", "--format", "$(SITE)"],
        capture_output=True,
        text=True,
        check=False,
    )
    found = [line.strip().rstrip("/") for line in result.stdout.splitlines() if line.strip()]
    found = [re.sub(r"/ubuntu$", "/debian", site) for site in found if "security" not in site]
    return list(dict.fromkeys(found))


def apt_command(work: Path, site: str, suite: str = SUITE, store: str = "packages") -> list[str]:
    """apt-get for one mirror's packages, its state in work/apt; what it downloads lies in a folder
    of the cache that only one may use at a time."""
    state = work / "apt"
    for name in ("lists/partial", "etc"):
        make_folder(state / name)
    (state / "status").touch()
    (state / "etc" / "suite.sources").write_text(
        f"Types: deb\nURIs: {site}\nSuites: {suite}\nComponents: main\nSigned-By: {KEYRING}\n",
        encoding="utf-8",
    )
    packages = make_folder(cache() / store / "archives" / "partial").parents[1]
    options = [
        "Dir::Etc::sourcelist=/dev/null",
        f"Dir::Etc::sourceparts={state}/etc",
        "Dir::Etc::trustedparts=/dev/null",
        f"Dir::State::lists={state}/lists",
        f"Dir::State::status={state}/status",
        f"Dir::Cache={packages}",
        "APT::Sandbox::User=",
        "Debug::NoLocking=1",
        "Acquire::Languages=none",
        "Acquire::Retries=2",
    ]
    return ["apt-get", "-qq", *(part for option in options for part in ("-o", option))]


def unpack(archive: Path, folder: Path) -> subprocess.CompletedProcess[str]:
    """Unpacks a package, and keeps the names of its files for names_in."""
    command = ["dpkg", "--vextract", str(archive), str(folder)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode == 0:
        _keep_names(archive, done.stdout)
    return done


def names_in(archive: Path) -> frozenset[str]:
    """Names of the files of a package."""
    kept = _names_file(archive)
    if not kept.exists():
        # It takes as long as to unpack it.
        command = ["dpkg-deb", "--contents", str(archive)]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        _keep_names(archive, done.stdout)
    return frozenset(kept.read_text(encoding="utf-8").split("\n"))


def _names_file(archive: Path) -> Path:
    return cache() / "packages" / "names" / f"{archive.name}.txt"


def _keep_names(archive: Path, listed: str) -> None:
    kept = _names_file(archive)
    names = sorted({line.rstrip("/").rsplit("/", 1)[-1] for line in listed.splitlines()})
    write_whole(kept, "\n".join(names))


def apt_run(command: list[str], cwd: Path | None = None) -> None:
    """Runs apt-get; an AptError says what went wrong."""
    done = subprocess.run(command, cwd=cwd, capture_output=True, text=True, check=False)
    # A failed update of one source is only a warning to apt, hence the look at its words.
    if done.returncode != 0 or "Failed to fetch" in done.stderr:
        raise AptError(done.stderr or done.stdout or "apt-get failed")
