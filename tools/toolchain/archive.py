# SPDX-License-Identifier: MIT
"""`./run package server|client`: an archive that runs on any Linux with an x86_64 processor.

It has the loader and every library of the program, so it needs nothing of the machine but a kernel.
The loader is the program that is started, under the program's name: the engine finds its files
beside what it was started as.
"""

from __future__ import annotations

import json
import re
import shutil
import struct
import subprocess
import tarfile
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from .apt import names_in
from .console import Failure, step, tail
from .paths import BUILD, CLIENT_BINARY, ROOT, SERVER_BINARY, cache, make_folder
from .prefix import LIBRARIES, Prefix

FOLDER = BUILD / "packages"
TEMPLATES = ROOT / "tools" / "packaging"
# What is loaded by name at run time; it is taken along where it is there.
LOADED = ("libfontconfig.so.1", "libdbus-1.so.3")
SHOWN = (
    *("libX11.so.6", "libXcursor.so.1", "libXext.so.6", "libXi.so.6", "libXinerama.so.1"),
    *("libXrandr.so.2", "libXrender.so.1", "libxkbcommon.so.0", "libwayland-client.so.0"),
    *("libwayland-cursor.so.0", "libwayland-egl.so.1", "libdecor-0.so.0", "libvulkan.so.1"),
    *("libEGL.so.1", "libGLESv2.so.2", "libGL.so.1", "libGLX.so.0", "libGLX_mesa.so.0"),
    *("libEGL_mesa.so.0", "libasound.so.2", "libpulse.so.0", "libudev.so.1", "libSDL3.so.0"),
)
_NEEDED = re.compile(r"^\s*(\S+) => (/\S+) \(", re.MULTILINE)
_MISSING = re.compile(r"^\s*(\S+) => not found", re.MULTILINE)


@dataclass(frozen=True)
class Archive:
    """A program that is delivered."""

    name: str
    about: str
    binary: Path
    arguments: str  # What the start script puts before the user's own.
    loaded: tuple[str, ...]
    helps_webcam: bool = False  # Whether the webcam's helper goes with it.
    default: str = ""  # The user's arguments where the start script gets none.


ARCHIVES = {
    "server": Archive(
        "dismount-server",
        "an archive of the dedicated server, for machines without anything",
        SERVER_BINARY,
        "--headless --",
        LOADED,
    ),
    "client": Archive(
        "dismount-client",
        "the same of the client: trainee, observer, instructor, replay",
        CLIENT_BINARY,
        "--",
        LOADED + SHOWN,
        helps_webcam=True,
        default="--role=start",
    ),
}


def version() -> str:
    """The program's version."""
    text = (ROOT / "project.godot").read_text(encoding="utf-8")
    found = re.search(r'^config/version="(.*)"$', text, re.MULTILINE)
    return found[1] if found else "0"


def write(archive: Archive, target: Path = FOLDER, level: int = 6) -> Path:
    """Writes NAME-VERSION.tar.gz below a folder; the program has to be exported already."""
    folder = gather(archive, target)
    result = target / f"{folder.name}.tar.gz"
    with step(f"pack {result.name}"), tarfile.open(result, "w:gz", compresslevel=level) as tar:
        tar.add(folder, arcname=folder.name, filter=_anonymous)
    return result


def gather(archive: Archive, target: Path) -> Path:
    """Puts all that belongs to an archive into a folder below another."""
    name = f"{archive.name}-{version()}-linux-x86_64"
    folder = target / name
    shutil.rmtree(folder, ignore_errors=True)
    make_folder(folder / "lib")
    with step(f"gather {archive.name} and its libraries"):
        loader = find_interpreter(archive.binary)
        for file in archive.binary.parent.iterdir():
            shutil.copy2(file, folder / file.name)
        if archive.helps_webcam:
            _copy_helper(folder / "webcam")
        libraries = find_libraries(archive, loader)
        for soname, path in libraries.items():
            shutil.copy2(path.resolve(), folder / "lib" / soname)
        # Under this name the engine looks for its data beside itself.
        stem = archive.binary.stem
        shutil.copy2(loader.resolve(), folder / stem)
        (folder / stem).chmod(0o755)
        _write_texts(archive, folder, stem)
        _write_licences(folder / "licences", [loader, *libraries.values()])
    return folder


def _copy_helper(target: Path) -> None:
    make_folder(target)
    for file in sorted((ROOT / "tools" / "webcam").glob("*.py")):
        shutil.copyfile(file, target / file.name)


def _anonymous(member: tarfile.TarInfo) -> tarfile.TarInfo:
    """Files that belong to root and that everybody may read, whoever packs them."""
    member.uid = member.gid = 0
    member.uname = member.gname = "root"
    member.mode = 0o755 if member.isdir() or member.mode & 0o100 else 0o644
    return member


def find_interpreter(program: Path) -> Path:
    """The loader that an ELF program names."""
    with program.open("rb") as file:
        header = file.read(64)
        if header[:5] != b"\x7fELF\x02":
            raise Failure(f"{program} is no 64-bit program.")
        offset, size, count = (*struct.unpack_from("<Q", header, 32), *_entries(header))
        for index in range(count):
            file.seek(offset + index * size)
            row = file.read(size)
            if struct.unpack_from("<I", row)[0] == 3:  # PT_INTERP
                begin, length = struct.unpack_from("<Q16xQ", row, 8)
                file.seek(begin)
                return Path(file.read(length).rstrip(b"\0").decode())
    raise Failure(f"{program} names no loader.")


def _entries(header: bytes) -> tuple[int, int]:
    size, count = struct.unpack_from("<HH", header, 54)
    return int(size), int(count)


def find_libraries(archive: Archive, loader: Path) -> dict[str, Path]:
    """What the program and its extensions load, and what those load, by soname."""
    folders = [archive.binary.parent, loader.parent]
    private = Prefix().root / LIBRARIES
    if private.exists():
        folders += [private, private / "pulseaudio"]
    folders += [Path("/usr/lib/x86_64-linux-gnu"), Path("/usr/lib64"), Path("/usr/lib")]
    own = {file.name for file in archive.binary.parent.glob("*.so*")}
    roots = [archive.binary, *archive.binary.parent.glob("*.so*")]
    found: dict[str, Path] = {}
    for name in archive.loaded:
        path = next((one / name for one in folders if (one / name).exists()), None)
        if path is not None:
            found[name] = path
            roots.append(path)
    search = ":".join(str(folder) for folder in folders)
    for root in roots:
        command = [str(loader), "--library-path", search, "--list", str(root)]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        missing = _MISSING.findall(done.stdout)
        if missing or done.returncode != 0:
            what = f"lacks {', '.join(missing)}" if missing else tail(done.stderr, 2)
            raise Failure(f"{root.name} cannot be packed: it {what}.")
        for soname, path in _NEEDED.findall(done.stdout):
            if soname not in own:
                found.setdefault(soname, Path(path))
    return found


def _write_texts(archive: Archive, folder: Path, stem: str) -> None:
    """The start script, the unit, the recipe of a container, the words."""
    values = {
        "@NAME@": archive.name,
        "@LOADER@": stem,
        "@PROGRAM@": archive.binary.name,
        "@ARGUMENTS@": archive.arguments,
        "@DEFAULT@": archive.default,
        "@VERSION@": version(),
        "@CONTAINER_ARGUMENTS@": "".join(f', "{one}"' for one in archive.arguments.split()),
    }
    names = {"start": "start", "README.md": "README.md", "Containerfile": "Containerfile"}
    if archive.name == "dismount-server":
        names |= {"dismount.service": "dismount.service", "server.cfg": "server.cfg"}
    else:
        names |= {"dismount.desktop": "dismount.desktop", "add-to-menu": "add-to-menu"}
        shutil.copyfile(ROOT / "assets" / "ui" / "icon.svg", folder / "icon.svg")
    for source, name in names.items():
        text = (TEMPLATES / source).read_text(encoding="utf-8")
        for mark, value in values.items():
            text = text.replace(mark, value)
        (folder / name).write_text(text, encoding="utf-8")
    for script in ("start", "add-to-menu"):
        if (folder / script).exists():
            (folder / script).chmod(0o755)
    if "libEGL_mesa.so.0" in archive.loaded:
        # How the vendor-neutral EGL finds Mesa where the machine has no folder of vendors.
        vendor = {"file_format_version": "1.0.0", "ICD": {"library_path": "libEGL_mesa.so.0"}}
        (folder / "lib" / "egl_mesa.json").write_text(json.dumps(vendor) + "\n", encoding="utf-8")


def _write_licences(folder: Path, files: Iterable[Path]) -> None:
    """The copyright files of the packages that the libraries come from, and our own."""
    make_folder(folder)
    shutil.copyfile(ROOT / "LICENSE", folder / "dismount.txt")
    shutil.copyfile(ROOT / "assets" / "CREDITS.md", folder / "assets.md")
    documents = [Path("/usr/share/doc")]
    documents += sorted(cache().glob("*/root/usr/share/doc"))
    packages = _packages_of({file.resolve().name for file in files})
    for package in sorted({*packages, "godot", "libusb-1.0-0", "libsodium23", "libmysofa1"}):
        for place in documents:
            text = place / package / "copyright"
            if text.is_file():
                shutil.copyfile(text, folder / f"{package}.txt")
                break


def _packages_of(names: set[str]) -> set[str]:
    """The Debian packages that have files of these names: of the archives, else of the machine."""
    found: set[str] = set()
    archives = sorted((cache() / "packages" / "archives").glob("*.deb"))
    for archive in archives if Prefix().folder.exists() else []:
        if names & names_in(archive):
            found.add(archive.name.split("_")[0])
    if not archives and shutil.which("dpkg"):
        command = ["dpkg", "-S", *(f"*/{name}" for name in sorted(names))]
        listed = subprocess.run(command, capture_output=True, text=True, check=False)
        found |= {line.split(":")[0] for line in listed.stdout.splitlines()}
    return found
