# SPDX-License-Identifier: MIT
"""The commands of the documents, as a reader types them: each comes up, and ends when told to.

Only SERVER is replaced, by the address of a server here; the port comes by the environment.
"""

from __future__ import annotations

import os
import re
import shlex
import signal
import subprocess
import time
from pathlib import Path

import pytest
from toolchain.paths import ROOT
from toolchain.processes import free_port

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
    """The commands of each block of each page."""
    found = []
    for page in PAGES:
        text = (ROOT / page).read_text(encoding="utf-8")
        for number, block in enumerate(BLOCK.findall(text)):
            lines = [line.partition(" #")[0].strip() for line in block.splitlines()]
            lines = [line for line in lines if line.startswith("./run ")]
            if lines:
                found.append((f"{page} {number}", lines))
    return found


@shared
def session(world: World) -> World:
    """Where readers join."""
    world.server()
    return world


def test_there_are_commands() -> None:
    assert sum(len(lines) for _, lines in blocks()) >= 12


@pytest.mark.parametrize("block", blocks(), ids=lambda block: block[0])
def test_commands_do_what_the_page_says(
    session: World, tmp_path: Path, block: tuple[str, list[str]]
) -> None:
    folder = tmp_path / "reader"
    folder.mkdir()
    # What a reader has who stands in the folder of Dismount.
    for name in ("run", "assets"):
        (folder / name).symlink_to(ROOT / name)
    for line in block[1]:
        call(folder, line.replace("SERVER", "127.0.0.1"), session)


def call(folder: Path, line: str, world: World) -> None:
    """Types a line; waits until it is ready, and ends it."""
    words = shlex.split(line)
    command = words[1]
    port = free_port() if command == "server" else world.port
    environment = {k: v for k, v in os.environ.items() if not k.startswith(("DISMOUNT_", "XDG_"))}
    for name in ("DISPLAY", "WAYLAND_DISPLAY"):
        environment.pop(name, None)
    environment |= {"DISMOUNT_PORT": str(port), "XDG_DATA_HOME": str(folder / "data")}
    if "DISMOUNT_USER_CACHE" in os.environ:
        environment["XDG_CACHE_HOME"] = os.environ["DISMOUNT_USER_CACHE"]
    log = folder / "log.txt"
    with log.open("wb") as output:
        process = subprocess.Popen(
            words,
            cwd=folder,
            env=environment,
            stdin=subprocess.PIPE,
            stdout=output,
            stderr=subprocess.STDOUT,
        )
    try:
        end = time.monotonic() + LIMIT_S
        while READY[command] not in log.read_text(encoding="utf-8", errors="replace"):
            said = log.read_text(encoding="utf-8", errors="replace")
            assert process.poll() is None, f"'{line}' ended with {process.returncode}:\n{said}"
            assert time.monotonic() < end, f"'{line}' is not ready:\n{said}"
            time.sleep(0.02)
        # A recording needs a moment to be one; a replay ends by itself.
        if command != "replay":
            time.sleep(0.5)
            process.send_signal(signal.SIGTERM)
        code = process.wait(LIMIT_S)
    finally:
        process.kill()
        process.wait()
    said = log.read_text(encoding="utf-8", errors="replace")
    assert code in (0, 130), f"'{line}' ended with {code}:\n{said}"
    assert "ERROR" not in said
