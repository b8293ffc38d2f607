# SPDX-License-Identifier: MIT
"""The documents agree with the code, and their commands do what the page says.

The commands are typed as a reader types them: each comes up, and ends when told to. Only SERVER is
replaced, by the address of a server here; the port comes by the environment.
"""

from __future__ import annotations

import os
import re
import shlex

import pytest
from toolchain.paths import ROOT
from toolchain.processes import Program, free_port

from .conftest import World, shared

PAGES = ["README.md", "docs/session-guide.md", "docs/suit-emulator.md"]
LIMIT_S = 180.0
# What a command says when it does what it is for.
READY = {
    "server": "listening on UDP port",
    "trainee": "joined",
    "observer": "joined",
    "instructor": "joined",
    "replay": "Dismount",
    "suit-emulator": "measures:",
}
# The main job (./run alone) has a test of its own: test_commands.py.
BLOCK = re.compile(r"^```(?:sh)?\n(.*?)^```", re.MULTILINE | re.DOTALL)


def blocks() -> list[tuple[str, list[str]]]:
    """The commands of each block of each page, without those that stood before."""
    found, known = [], set()
    for page in PAGES:
        text = (ROOT / page).read_text(encoding="utf-8")
        for number, block in enumerate(BLOCK.findall(text)):
            lines = [line.partition(" #")[0].strip() for line in block.splitlines()]
            lines = [line for line in lines if line.startswith("./run ") and line not in known]
            known.update(lines)
            if lines:
                found.append((f"{page} {number}", lines))
    return found


class Reader:
    """What a reader has who stands in the folder of Dismount, and a server elsewhere."""

    def __init__(self, world: World) -> None:
        self.folder = world.folder / "reader"
        self.folder.mkdir()
        for name in ("run", "assets"):
            (self.folder / name).symlink_to(ROOT / name)
        world.server()
        self.port = world.port

    def call(self, line: str) -> None:
        """Types a line; waits until it is ready, and ends it."""
        words = shlex.split(line.replace("SERVER", "127.0.0.1"))
        command = words[1]
        environment = self._environment(free_port() if command == "server" else self.port)
        log = self.folder / "log.txt"
        with Program(words, log, environment, self.folder, types=True) as program:
            program.await_that(
                lambda: READY[command] in program.log() and self._has_recorded(words), line, LIMIT_S
            )
            # A replay ends by itself.
            code = program.await_exit(LIMIT_S) if command == "replay" else program.end(LIMIT_S)
        assert code in (0, 130), f"'{line}' ended with {code}:\n{program.log()}"
        assert "ERROR" not in program.log()

    def _environment(self, port: int) -> dict[str, str]:
        plain = {k: v for k, v in os.environ.items() if not k.startswith(("DISMOUNT_", "XDG_"))}
        for name in ("DISPLAY", "WAYLAND_DISPLAY"):
            plain.pop(name, None)
        if "DISMOUNT_USER_CACHE" in os.environ:
            plain["XDG_CACHE_HOME"] = os.environ["DISMOUNT_USER_CACHE"]
        own = {"DISMOUNT_PORT": str(port), "XDG_DATA_HOME": str(self.folder / "data")}
        return {**plain, **own}

    def _has_recorded(self, words: list[str]) -> bool:
        """Whether there is more than its beginning in a recording, if a command makes one."""
        names = [word.partition("=")[2] for word in words if word.startswith("--record=")]
        files = [self.folder / name for name in names]
        return all(file.exists() and file.stat().st_size > 100 for file in files)


reader = shared(Reader)


def test_there_are_commands() -> None:
    assert sum(len(lines) for _, lines in blocks()) >= 12


@pytest.mark.parametrize("block", blocks(), ids=lambda block: block[0])
def test_commands_do_what_the_page_says(reader: Reader, block: tuple[str, list[str]]) -> None:
    for line in block[1]:
        reader.call(line)


def _text(name: str) -> str:
    return (ROOT / name).read_text(encoding="utf-8")


def _rows(text: str, heading: str) -> set[str]:
    """The names between backticks in the first column of the table below a heading."""
    table = text.partition(heading)[2].partition("\n\n")[0]
    cells = [line.split("|")[1] for line in table.splitlines() if line.startswith("|")]
    return {name for cell in cells for name in re.findall(r"`([^`]+)`", cell)}


def _constant(name: str, constant: str) -> str:
    """What a script gives a constant."""
    match = re.search(rf"^const {constant}: \w+ = (\w+)$", _text(name), re.MULTILINE)
    assert match, f"{name} has no constant {constant}"
    return match[1]


@pytest.mark.parametrize("page", ["README.md", "docs/limits.md", "docs/protocol.md"])
def test_documents_name_the_protocol_version(page: str) -> None:
    version = _constant("scripts/net/messages/protocol.gd", "VERSION")
    named = re.findall(r"(?i)\bprotocol(?:,| \|)? version,? (\d+)", _text(page))
    assert set(named) == {version}


def test_the_readme_lists_every_world() -> None:
    scenes = (ROOT / "scenes" / "world").glob("*/*.tscn")
    worlds = {scene.stem for scene in scenes if scene.stem == scene.parent.name}
    assert _rows(_text("README.md"), "| `--world=` | what it is |") == worlds
    guide = _text("docs/session-guide.md")
    assert {name for name in worlds if f"`--world={name}`" in guide} == worlds


def test_the_readme_lists_every_role() -> None:
    # docs/options.md is made from the code, which lint checks. Load has a command of its own.
    roles = _rows(_text("docs/options.md"), "## Roles\n\n") - {"load"}
    commands = {row.split()[1] for row in _rows(_text("README.md"), "| command | what it does |")}
    assert commands == roles
    help_text = _text("tools/help.txt").partition("Roles")[2].partition("\n\n")[0]
    assert set(re.findall(r"\./run (\w+) {2,}", help_text)) == roles


def test_every_display_is_described() -> None:
    row = next(line for line in _text("docs/options.md").splitlines() if "`--display=NAME`" in line)
    displays = set(row.split("|")[3].strip().split(", "))
    assert _rows(_text("docs/displays.md"), "| `--display=` | what it is |") == displays


@pytest.mark.parametrize("page", ["README.md", "docs/session-guide.md", "docs/limits.md"])
def test_documents_name_options_that_there_are(page: str) -> None:
    known = _text("docs/options.md") + _text("tools/help.txt")
    known += "".join(_text(f"tools/help/{name}") for name in os.listdir(ROOT / "tools" / "help"))
    named = set(re.findall(r"(?<![\w-])--[a-z][a-z-]*\w", _text(page)))
    assert named - set(re.findall(r"--[a-z][a-z-]*\w", known)) == set()
