# SPDX-License-Identifier: MIT
"""libusb, libsodium and libmysofa to build against and to ship, umockdev for the suit emulator.

No root. What the machine has installed is taken. Otherwise Debian's packages are unpacked into a
private folder: of the host's own release where there is one, else of the oldest that serves, as our
extension is loaded by the host's programs as well as by the private, newer Godot.
"""

from __future__ import annotations

import re
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path

from .apt import KEYRING, SUITE, AptError, apt_command, apt_run, mirrors, unpack
from .console import Failure, say, step, tail
from .paths import cache, lock, make_folder, need_space

LAYOUT = 4  # Raised when the way the folder is made changes: older folders are then made anew.
OLDER_SUITES = ["bookworm", "trixie"]
# With all that they need at run time, except for the C library: that is the host's.
RUN_PACKAGES = ["libusb-1.0-0", "libsodium23", "libmysofa1", "libumockdev0", "umockdev"]
BASE_PACKAGES = ("libc6_", "libgcc-s1_", "gcc-")
# Headers and links alone: what else these packages want would be a compiler.
BUILD_PACKAGES = [
    "libusb-1.0-0-dev",
    "libsodium-dev",
    "libmysofa-dev",
    "libumockdev-dev",
    "libglib2.0-dev",
]
# What CMake found in those folders, in its record.
_FOUND = re.compile(r"DISMOUNT_\w+_(LIBRARY|INCLUDE|CONFIG)$")
LIBRARIES = Path("usr/lib/x86_64-linux-gnu")
NEEDED = {
    "libusb-1.0": "libusb-1.0-0-dev",
    "libsodium": "libsodium-dev",
    "libmysofa": "libmysofa-dev",
}
INSTALL = (
    "sudo sh -c 'apt-get update && apt-get install -y --no-install-recommends "
    f"{' '.join(NEEDED.values())}'"
)


@dataclass(frozen=True)
class Libraries:
    """Where each library is: in a folder like /usr, or None for the machine's own."""

    libusb: Path | None
    libsodium: Path | None
    libmysofa: Path | None
    umockdev: Path | None
    has_umockdev: bool

    def options(self) -> dict[str, str]:
        """Options for CMake: see gdextension/cmake/dismount_{lib*,umockdev}.cmake."""
        return {
            "DISMOUNT_LIBUSB_ROOT": str(self.libusb or ""),
            "DISMOUNT_LIBSODIUM_ROOT": str(self.libsodium or ""),
            "DISMOUNT_LIBMYSOFA_ROOT": str(self.libmysofa or ""),
            "DISMOUNT_UMOCKDEV": "ON" if self.has_umockdev else "OFF",
            "DISMOUNT_UMOCKDEV_ROOT": str(self.umockdev or ""),
        }


def options(record: dict[str, str]) -> dict[str, str]:
    """Options for CMake: those of its record while what it found is there, else what `find` says.

    What else has been installed meanwhile is no reason to build anew.
    """
    names = Libraries(None, None, None, None, True).options()
    if record.get("DISMOUNT_UMOCKDEV") == "ON" and names.keys() <= record.keys():
        kept = {name: record[name] for name in names}
        roots = {value for name, value in kept.items() if name.endswith("_ROOT")}
        files = [value for name, value in record.items() if _FOUND.match(name)]
        if all(_is_current(root) for root in roots) and all(Path(file).exists() for file in files):
            return kept
    return find().options()


def _is_current(root: str) -> bool:
    """Whether a folder like /usr is no private one that would be made otherwise now."""
    return all(part == _name() for part in Path(root).parts if part.startswith("libraries-"))


def _name() -> str:
    return f"libraries-{suites()[0]}-{LAYOUT}"


def find() -> Libraries:
    """The libraries to build with; what the machine lacks is fetched into the private folder."""
    own = {name: installed(name) for name in [*NEEDED, "umockdev-1.0"]}
    root = None
    if not all(own.values()):
        try:
            root = ensure() / "root" / "usr"
        except Failure as failure:
            if not all(own[name] for name in NEEDED):
                raise
            say(f"[ -- ] there will be no suit emulator: {str(failure).splitlines()[0]}")
            return Libraries(None, None, None, None, False)
    places = [None if own[name] else root for name in own]
    return Libraries(*places, has_umockdev=True)


def installed(name: str) -> bool:
    """Whether the machine has a library, with what is needed to build with it."""
    if shutil.which("pkg-config") is None:
        return False
    return subprocess.run(["pkg-config", "--exists", name], check=False).returncode == 0


def suites(release: Path = Path("/etc/os-release")) -> list[str]:
    """Debian's releases to try: first the host's own, whose libraries fit it best."""
    own = []
    if release.exists():
        pairs = (line.partition("=") for line in release.read_text(encoding="utf-8").splitlines())
        facts = {name: value.strip('"') for name, _, value in pairs}
        if facts.get("ID") == "debian" and facts.get("VERSION_CODENAME"):
            own = [facts["VERSION_CODENAME"]]
    return list(dict.fromkeys([*own, *OLDER_SUITES, SUITE]))


def ensure() -> Path:
    """The private folder, made once for all clones; an interrupted attempt leaves nothing."""
    folder = cache() / _name()
    if folder.exists():
        return folder
    missing = [tool for tool in ("apt-get", "dpkg") if shutil.which(tool) is None]
    if missing or not KEYRING.exists():
        what = ", ".join(missing) or str(KEYRING)
        raise Failure(
            f"libusb 1.0, libsodium or libmysofa is not installed and cannot be fetched without "
            f"{what}: install all with their headers ({', '.join(NEEDED.values())}, or as your "
            "system names them)."
        )
    make_folder(cache())
    with lock(cache() / "libraries.lock", "setting up libraries"):
        if not folder.exists():
            need_space(cache(), 200, "libraries")
            work = folder.with_name(folder.name + ".part")
            shutil.rmtree(work, ignore_errors=True)
            _make(work)
            work.rename(folder)
    return folder


def _make(work: Path) -> None:
    sites = mirrors()
    failure = "apt names no mirror"
    for suite in suites():
        for site in sites:
            apt = apt_command(work, site, suite)
            try:
                with step(f"download libraries from Debian {suite} (about 11 MB)"):
                    apt_run([*apt, "update"])
                    archives = _download(apt, work)
            except AptError as error:
                failure = (str(error).strip().splitlines() or [failure])[-1]
                shutil.rmtree(work, ignore_errors=True)
                continue
            _unpack(archives, work)
            return
    raise Failure(
        "libusb 1.0, libsodium or libmysofa is not installed and cannot be had from Debian's "
        f"mirrors ({failure}): install them with '{INSTALL}', or set DISMOUNT_DEBIAN_MIRROR to a "
        "Debian mirror."
    )


def _download(apt: list[str], work: Path) -> list[Path]:
    """Fetches the packages into the work folder; returns their archives."""
    command = [*apt, "-y", "--no-install-recommends", "--print-uris", "install", *RUN_PACKAGES]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    names = [line.split()[1] for line in done.stdout.splitlines() if line.startswith("'")]
    if done.returncode != 0 or not names:
        raise AptError(done.stderr or "it lacks a library")
    run = [name.split("_")[0] for name in names if not name.startswith(BASE_PACKAGES)]
    folder = make_folder(work / "archives")
    apt_run([*apt, "download", *run, *BUILD_PACKAGES], folder)
    return sorted(folder.glob("*.deb"))


def _unpack(archives: list[Path], work: Path) -> None:
    with step(f"unpack {len(archives)} packages"):
        for archive in archives:
            done = unpack(archive, work / "root")
            if done.returncode != 0:
                raise Failure(f"{archive.name} could not be unpacked.\n{tail(done.stderr, 3)}")
        _gather(work / "root")
        for rest in ("apt", "archives"):
            shutil.rmtree(work / rest, ignore_errors=True)


def _gather(root: Path) -> None:
    """Puts the libraries of /lib beside the others: one folder to look in."""
    for library in (root / "lib" / LIBRARIES.name).glob("*.so*"):
        target = root / LIBRARIES / library.name
        if not target.exists():
            shutil.move(library, target)
