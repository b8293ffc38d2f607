# SPDX-License-Identifier: MIT
"""What ./run package server and client write runs where there is nothing else."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tarfile
from pathlib import Path

import pytest
from toolchain import archive
from toolchain.processes import free_port

SANDBOX = Path(__file__).with_name("sandbox.py")
# Nobody whom the machine knows.
USER = 54321


def _namespaces() -> list[str]:
    """How to get namespaces of our own: as root with another user inside, else as ourselves."""
    kinds = ["-mnp", "--fork"] if os.geteuid() == 0 else ["-Urmnp", "--fork"]
    for flags in (kinds, [kinds[0].replace("p", "")]):
        command = ["unshare", *flags, "true"]
        if subprocess.run(command, capture_output=True, check=False).returncode == 0:
            return command[:-1]
    return []


@pytest.fixture(scope="module")
def unpacked(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder that both archives lie in, unpacked."""
    folder = tmp_path_factory.mktemp("archives")
    folder.chmod(0o755)
    packed = archive.write(archive.ARCHIVES["server"], folder / "packed", 0)
    with tarfile.open(packed) as tar:
        tar.extractall(folder / "opt", filter="data")
    # Packing the larger one would take half a minute.
    archive.gather(archive.ARCHIVES["client"], folder / "opt")
    (folder / "opt").chmod(0o755)
    return folder / "opt"


def test_an_empty_root_is_enough(unpacked: Path, tmp_path: Path) -> None:
    """No loader, no library, no shell, no cache, no network; another user; nothing to write to."""
    namespaces = _namespaces()
    if not namespaces:
        pytest.skip("this machine gives nobody a namespace")
    root = tmp_path / "root"
    root.mkdir()
    user = USER if os.geteuid() == 0 else 0
    command = [sys.executable, str(SANDBOX), str(unpacked), str(user), str(free_port()), str(root)]
    done = subprocess.run(
        [*namespaces, *command], capture_output=True, text=True, timeout=300, check=False
    )
    assert done.returncode == 0, done.stdout + done.stderr
    assert json.loads(done.stdout.splitlines()[-1]) == {"codes": [0, 0]}, done.stdout
    assert "listening on UDP port" in done.stdout
    assert "client: joined" in done.stdout
    # The engine says that there is no xdg-user-dir; nothing of ours is wrong.
    assert "Z ERROR" not in done.stdout
    assert "SCRIPT ERROR" not in done.stdout


def test_the_start_script_runs_from_anywhere(unpacked: Path, tmp_path: Path) -> None:
    start = next(unpacked.glob("dismount-server-*")) / "start"
    link = tmp_path / "dismount"
    link.symlink_to(start)
    for command in ([str(start), "--version"], [str(link), "--help"]):
        done = subprocess.run(
            command,
            cwd="/",
            env={"PATH": "/usr/bin:/bin"},
            capture_output=True,
            text=True,
            timeout=120,
            check=False,
        )
        assert done.returncode == 0, done.stdout + done.stderr
        assert archive.version() in done.stdout or "--max-clients" in done.stdout


def test_what_is_beside_the_program(unpacked: Path) -> None:
    server = next(unpacked.glob("dismount-server-*"))
    client = next(unpacked.glob("dismount-client-*"))
    for folder in (server, client):
        names = {file.name for file in folder.iterdir()}
        assert {"start", "README.md", "Containerfile", "lib", "licences"} <= names
        texts = {file.name for file in (folder / "licences").iterdir()}
        assert {"dismount.txt", "assets.md"} <= texts
        for file in folder.rglob("*"):
            if file.is_file() and file.suffix in ("", ".md", ".service", ".cfg"):
                assert b"@NAME@" not in file.read_bytes()[:4000]
    unit = (server / "dismount.service").read_text(encoding="utf-8")
    # A user that systemd makes up may not read what only root may.
    assert "DynamicUser=yes" in unit
    assert "\nLoadCredential=dismount.cfg:/etc/dismount.cfg\n" in unit
    assert "--config=${CREDENTIALS_DIRECTORY}/dismount.cfg" in unit
    assert not (client / "dismount.service").exists()
    # Its options are right, too.
    done = subprocess.run(
        [str(server / "start"), f"--config={server / 'server.cfg'}", "--duration=0.5"]
        + [f"--port={free_port()}"],
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
