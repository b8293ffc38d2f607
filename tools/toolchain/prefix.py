# SPDX-License-Identifier: MIT
"""A private folder with programs from Debian's packages, for machines that lack them. No root.

apt-get downloads with a state of its own, dpkg unpacks, and patchelf (from the same suite) points
each program at the folder's own loader and libraries: they are newer than the host's. Starting the
programs through the loader instead breaks OS.get_executable_path() and every exported game.
"""

from __future__ import annotations

import os
import shutil
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import ClassVar

from .apt import KEYRING, SUITE, AptError, apt_command, apt_run, mirrors, unpack
from .console import Failure, step, tail
from .paths import cache, lock, make_folder, need_space

LAYOUT = 4  # Raised when the way the folder is made changes: older folders are then made anew.
GODOT_PACKAGES = ["godot", "godot-template-release", "godot-template-debug", "patchelf"]
DISPLAY_PACKAGES = ["xvfb", "x11-xkb-utils", "xkb-data", "libgl1-mesa-dri", "libglx-mesa0"]
DISPLAY_PACKAGES += ["libegl1", "libegl-mesa0"]
PROGRAMS = ["godot", "godot-template-release", "godot-template-debug", "Xvfb", "xkbcomp"]
LIBRARIES = Path("usr/lib/x86_64-linux-gnu")
LOADER = "ld-linux-x86-64.so.2"


class Prefix:
    """The private folder: `bin/` holds what is to be started, `root/` what was unpacked."""

    name = f"prefix-{SUITE}-{LAYOUT}"
    packages: ClassVar[list[str]] = GODOT_PACKAGES + DISPLAY_PACKAGES
    programs: ClassVar[list[str]] = PROGRAMS
    what = "Godot"
    store = "packages"  # Where it is downloaded to.
    download_mb = 180
    unpacked_mb = 1800
    absent = "No Godot >= 4.6 was found"
    remedy = "put a Godot 4.6 with its export templates on PATH or in $GODOT"

    def __init__(self) -> None:
        self.folder = cache() / self.name
        self.bin = self.folder / "bin"
        self.root = self.folder / "root"

    def program(self, name: str) -> Path:
        """A program of the folder, which is made first where it isn't there yet."""
        self.ensure()
        return self.bin / name

    def ensure(self) -> None:
        """Makes the folder once for all clones; an interrupted attempt leaves nothing."""
        if self.folder.exists():
            return
        self._require_debian()
        make_folder(cache())
        with lock(cache() / f"{self.store}.lock", f"setting up {self.what}"):
            if self.folder.exists():
                return
            need_space(cache(), self.unpacked_mb, f"the private {self.what}")
            work = self.folder.with_name(self.folder.name + ".part")
            shutil.rmtree(work, ignore_errors=True)
            archives = self._download(work)
            self._unpack(archives, work)
            work.rename(self.folder)

    def _require_debian(self) -> None:
        """Says what to do where the host has no apt and so cannot make the folder."""
        missing = [tool for tool in ("apt-get", "dpkg") if shutil.which(tool) is None]
        if missing:
            raise Failure(
                f"{self.absent}, and this system has no apt to fetch it with: {self.remedy}."
            )
        if not KEYRING.exists():
            raise Failure(
                f"{self.absent}, and {KEYRING} is missing, which checks the packages: install it "
                f"with 'sudo apt-get install debian-archive-keyring', or {self.remedy}."
            )

    def _download(self, work: Path) -> list[Path]:
        sites = mirrors()
        if not sites:
            raise Failure(
                f"{self.absent}, and apt names no mirror to fetch it from: set "
                f"DISMOUNT_DEBIAN_MIRROR to a Debian mirror's address, or {self.remedy}."
            )
        failure = ""
        for site in sites:
            apt = apt_command(work, site, store=self.store)
            try:
                about = f"(about {self.download_mb} MB)"
                with step(f"download {self.what} from Debian {SUITE} {about}"):
                    apt_run([*apt, "update"])
                    download = [*apt, "-y", "--no-install-recommends", "--download-only"]
                    apt_run([*download, "install", *self.packages])
                return self._chosen(apt, self.packages)
            except AptError as error:
                failure = str(error)
        raise Failure(
            f"Debian {SUITE}'s packages can't be had from {', '.join(sites)}: check the network, "
            f"set DISMOUNT_DEBIAN_MIRROR to another Debian mirror, or {self.remedy}.\n"
            + tail(failure, 4)
        )

    def _chosen(self, apt: list[str], packages: list[str]) -> list[Path]:
        """The package files that this very installation needs, of all that are in the cache."""
        command = [*apt, "-y", "--no-install-recommends", "--print-uris", "install", *packages]
        fresh = ["-o", "Dir::Cache::archives=/nonexistent"]
        listed = subprocess.run(command + fresh, capture_output=True, text=True, check=False).stdout
        names = [line.split()[1] for line in listed.splitlines() if line.startswith("'")]
        folder = cache() / self.store / "archives"
        found = [folder / name for name in names if (folder / name).exists()]
        if not found:
            raise Failure(f"The downloaded packages are missing in {folder}: delete it and retry.")
        return found

    def _unpack(self, archives: list[Path], work: Path) -> None:
        with step(f"unpack {len(archives)} packages"):
            with ThreadPoolExecutor(os.cpu_count() or 2) as pool:
                list(pool.map(lambda archive: self._extract(archive, work / "root"), archives))
            shutil.rmtree(work / "apt", ignore_errors=True)
            self._patch(work)

    @staticmethod
    def _extract(archive: Path, root: Path) -> None:
        done = unpack(archive, root)
        if done.returncode != 0:
            archive.unlink(missing_ok=True)
            raise Failure(
                f"The package {archive.name} could not be unpacked and was removed from the cache "
                "(disk full, or a broken download?): start again.\n" + tail(done.stderr, 3)
            )

    def _patch(self, work: Path) -> None:
        """Points programs at the libraries where they will be once the folder has its name."""
        here = work / "root" / LIBRARIES
        there = self.root / LIBRARIES
        rpath = self._search_path(there)
        edit = self._editor(work)
        for library in [*here.glob("*.so*"), *here.glob("pulseaudio/*.so")]:
            # A library with a path of its own hides the program's path from what it needs.
            if not library.is_symlink() and self._output([*edit, "--print-rpath", str(library)]):
                subprocess.run([*edit, "--force-rpath", "--set-rpath", rpath, library], check=True)
        make_folder(work / "bin")
        for name in self.programs:
            program = work / "bin" / name
            shutil.move(work / "root/usr/bin" / name, program)
            own = ["--set-interpreter", str(there / LOADER), "--force-rpath"]
            subprocess.run([*edit, *own, "--set-rpath", rpath, str(program)], check=True)
        self._finish(work)

    @staticmethod
    def _editor(work: Path) -> list[str]:
        """Patchelf, started through the folder's own loader."""
        here = work / "root" / LIBRARIES
        loader = [str(here / LOADER), "--library-path", str(here)]
        return [*loader, str(work / "root/usr/bin/patchelf")]

    @staticmethod
    def _search_path(there: Path) -> str:
        """Where programs look for libraries."""
        return f"{there}:{there}/pulseaudio"

    def _finish(self, work: Path) -> None:
        """What this folder's own programs need besides."""
        self._localise_xvfb(work / "bin" / "Xvfb")

    @staticmethod
    def _output(command: list[str]) -> str:
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        return done.stdout.strip()

    @staticmethod
    def _localise_xvfb(xvfb: Path) -> None:
        """Lets Xvfb find xkbcomp in its working folder: its built-in path is the host's."""
        built_in, own = b"\0/usr/bin\0", b"\0.\0"
        data = xvfb.read_bytes()
        if data.count(built_in) != 1:
            raise Failure(f"{xvfb.name} is not laid out as expected: install xvfb and start again.")
        xvfb.write_bytes(data.replace(built_in, own.ljust(len(built_in), b"\0")))
