# SPDX-License-Identifier: MIT
"""`./run package NAME`: a part of the house as an addon for any Godot project.

What goes into a package is computed: the scripts that its roots and its example name, and those
that these name. A script that would need a library of another package is an error, not a surprise
in somebody's game.
"""

from __future__ import annotations

import re
import shutil
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath

from . import archive, arrows
from .archive import ARCHIVES
from .console import Failure, say
from .nearest import suggest
from .paths import BUILD, ROOT, make_folder
from .project import UDEV_RULES, prepare

HELP = """./run package NAME...

server and client are archives in build/packages/ that run on any Linux with an x86_64 processor, as
any user, from a read-only folder, without network: unpack one and call ./start. In it are the
loader, all libraries, licences, a Containerfile and, for the server, a unit for systemd.

"""
ADDONS_HELP = """
The others are addons, in build/addons/NAME/: libraries, scripts, documentation, an example, the
licence. Copy one into the folder addons/ of a Godot project; NAME/README.md says how it goes on.

"""

ADDONS = BUILD / "addons"
EXAMPLES = "examples/packages"
PAGES = "docs/packages"
_PATH = re.compile(r"res://([^\s\"':]+)")
_LINK = re.compile(r"(?<!!)\[([^\]]*)\]\(([^)\s]+)\)")


@dataclass(frozen=True)
class Package:
    """What a package is for; what it holds follows from that."""

    about: str
    libraries: tuple[str, ...]  # Folders below gdextension/, each with a NAME.gdextension.
    roots: tuple[str, ...]  # Classes that its users name.
    assets: tuple[str, ...] = ()  # What its example shows.
    docs: tuple[str, ...] = ()  # Pages of docs/ that its own page leads to.
    more: tuple[Path, ...] = ()  # What else lies beside its page.


PACKAGES = {
    "ragdoll_motor": Package(
        "people made of bodies that follow live motion",
        ("ragdoll_motor",),
        ("Ragdoll", "BvhSource", "RagdollProfileReader", "SkeletonMotion"),
        ("examples/packages/soldier.glb", "assets/motion/01_01.bvh"),
        ("ragdoll.md", "motion-files.md"),
        (ROOT / "assets" / "CREDITS.md",),
    ),
    "xbus": Package(
        "wired Xsens suits and MVN's stream, as XRBodyTrackers too",
        ("xbus", "heading"),
        (
            *("UsbSuitFeed", "SuitSource", "CalibrationStore", "TrackerPublisher"),
            *("MvnStream", "MvnSource", "RawPlayback"),
        ),
        ("examples/packages/soldier.glb",),
        ("suits.md", "calibration.md", "xbus.md", "mvn.md", "recordings.md"),
        (UDEV_RULES, ROOT / "assets" / "CREDITS.md"),
    ),
    "threaded_peer": Package(
        "Godot's multiplayer over an ENet host in a thread of its own",
        ("transport", "host"),
        ("ThreadedPeer", "TransportSealing"),
    ),
}


@dataclass
class Contents:
    """The files of a package: where each lies in the repository, by its path in the package."""

    files: dict[str, Path] = field(default_factory=dict)

    def add(self, inside: str, source: Path) -> None:
        """Puts a file into the package."""
        if not source.is_file():
            raise Failure(f"There is no {source.relative_to(ROOT)} for {inside}.")
        self.files[inside] = source

    def paths(self, name: str) -> dict[str, str]:
        """The path in a project that has the package, by the one in ours."""
        return {
            source.relative_to(ROOT).as_posix(): f"addons/{name}/{inside}"
            for inside, source in self.files.items()
        }


def help_text() -> str:
    """What `./run package --help` prints."""
    archives = "".join(f"  {name:<14} {one.about}\n" for name, one in ARCHIVES.items())
    addons = "".join(f"  {name:<14} {one.about}\n" for name, one in PACKAGES.items())
    return HELP + archives + ADDONS_HELP + addons


def main(arguments: list[str]) -> int:
    """Writes the packages that are named."""
    known = [*ARCHIVES, *PACKAGES]
    unknown = [name for name in arguments if name not in known]
    if unknown or not arguments:
        what = f"There is no package '{unknown[0]}'" if unknown else "usage: ./run package NAME..."
        hint = suggest(unknown[0], known) if unknown else ""
        raise Failure(f"{what}{hint or ': ' + ', '.join(known) + '.'}", 2)
    archives = [name for name in arguments if name in ARCHIVES]
    prepare(export=bool(archives))
    for name in archives:
        print(archive.write(ARCHIVES[name]))
    for folder in write([name for name in arguments if name in PACKAGES], ADDONS):
        say(f"[ ok ] {folder.relative_to(ROOT)}")
        print(folder)
    return 0


def write(names: Iterable[str], target: Path) -> list[Path]:
    """Writes packages below a folder; those of one call may lie in one project.

    What two of them share lies in the first: a project can have each class once.
    """
    files = arrows.read_files(ROOT)
    paths: dict[str, str] = {}
    folders: list[Path] = []
    for name in names:
        contents = collect(name, PACKAGES[name], files)
        for inside, source in list(contents.files.items()):
            is_shared = inside.startswith(("scripts/", "scenes/", "example/"))
            if is_shared and source.relative_to(ROOT).as_posix() in paths:
                del contents.files[inside]
        paths.update(contents.paths(name))
        folder = target / name
        shutil.rmtree(folder, ignore_errors=True)
        for inside, source in contents.files.items():
            make_folder((folder / inside).parent)
            _copy(source, folder / inside, inside, contents, paths)
        (folder / "docs").mkdir(exist_ok=True)
        (folder / "docs" / ".gdignore").touch()
        folders.append(folder)
    return folders


def collect(name: str, package: Package, files: Mapping[str, str]) -> Contents:
    """What belongs to a package, of the scripts and scenes that there are."""
    contents = Contents()
    for path in find_scripts(name, package, files):
        contents.add(path, ROOT / path)
        if (ROOT / f"{path}.uid").exists():
            contents.add(f"{path}.uid", ROOT / f"{path}.uid")
        for other in _PATH.findall(files[path]):
            if other not in files and (ROOT / other).is_file():
                contents.add(other, ROOT / other)
    for library in package.libraries:
        listed = ROOT / "gdextension" / library / f"{library}.gdextension"
        contents.add(listed.name, listed)
        for binary in _PATH.findall(listed.read_text(encoding="utf-8")):
            contents.add(f"bin/{PurePosixPath(binary).name}", ROOT / binary)
    for path in sorted((ROOT / EXAMPLES / name).rglob("*")):
        if path.suffix in (".gd", ".uid", ".tscn"):
            contents.add(f"example/{path.relative_to(ROOT / EXAMPLES / name).as_posix()}", path)
    for asset in package.assets:
        contents.add(f"example/{PurePosixPath(asset).name}", ROOT / asset)
    contents.add("README.md", ROOT / PAGES / f"{name}.md")
    for page in package.docs:
        contents.add(f"docs/{page}", ROOT / "docs" / page)
    for extra in (ROOT / "LICENSE", *package.more):
        contents.add(extra.name, extra)
    return contents


def find_scripts(name: str, package: Package, files: Mapping[str, str]) -> list[str]:
    """The scripts and scenes that a package needs: what its roots and its example name, and on."""
    classes = {arrows.find_class(text): path for path, text in files.items()}
    missing = [root for root in package.roots if root not in classes]
    if missing:
        raise Failure(f"The package {name} is to have {missing[0]}, which is no class of ours.")
    uses: dict[str, set[str]] = {}
    for use in arrows.find_uses(files):
        uses.setdefault(use.user, set()).add(use.used)
    natives = _native_classes()
    waiting = [classes[root] for root in package.roots]
    for script in (ROOT / EXAMPLES / name).rglob("*.gd"):
        names, _paths = arrows.read_tokens(script.read_text(encoding="utf-8"))
        waiting += [classes[one] for one in names & classes.keys()]
        _check_libraries(name, package, script.relative_to(ROOT).as_posix(), names, natives)
    found: set[str] = set()
    while waiting:
        path = waiting.pop()
        if path in found:
            continue
        found.add(path)
        waiting += uses.get(path, ())
        if path.endswith(".gd"):
            _check_libraries(name, package, path, arrows.read_tokens(files[path])[0], natives)
    return sorted(found)


def _native_classes() -> dict[str, str]:
    """Of each class in C++ the library that has it."""
    pages = (ROOT / "gdextension").glob("*/doc_classes/*.xml")
    return {page.stem: page.parent.parent.name for page in pages}


def _check_libraries(
    name: str, package: Package, path: str, names: set[str], natives: Mapping[str, str]
) -> None:
    for one in sorted(names & natives.keys()):
        if natives[one] not in package.libraries:
            raise Failure(
                f"The package {name} would need the library {natives[one]}, as {path} uses {one}."
            )


def _copy(
    source: Path, target: Path, inside: str, contents: Contents, paths: Mapping[str, str]
) -> None:
    """Copies a file; paths in scripts and scenes, and links in pages, lead to where things are."""
    if source.suffix in (".gd", ".tscn", ".tres", ".gdextension"):
        text = source.read_text(encoding="utf-8")
        text = _PATH.sub(lambda match: f"res://{paths.get(match[1], match[1])}", text)
        target.write_text(text, encoding="utf-8")
    elif source.suffix == ".md":
        text = source.read_text(encoding="utf-8")
        target.write_text(_relink(text, source, inside, contents), encoding="utf-8")
    else:
        shutil.copyfile(source, target)


def _relink(text: str, source: Path, inside: str, contents: Contents) -> str:
    """Links to what the package has, plain words where it has not."""
    targets = {path.resolve(): where for where, path in contents.files.items()}
    depth = "../" * inside.count("/")

    def change(match: re.Match[str]) -> str:
        words, link = match[1], match[2]
        if link.startswith(("http:", "https:", "#")):
            return match[0]
        file, hash_mark, anchor = link.partition("#")
        where = targets.get((source.parent / file).resolve())
        return words if where is None else f"[{words}]({depth}{where}{hash_mark}{anchor})"

    return _LINK.sub(change, text)
