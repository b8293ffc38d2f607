# SPDX-License-Identifier: MIT
"""Runs programs of an archive where there is nothing else; unshare starts it in test_archives.py.

sandbox.py FOLDER USER PORT ROOT: FOLDER holds unpacked archives. They are all that the root has,
besides /proc, /dev/null, /dev/urandom and an empty /tmp; nothing but /tmp can be written, and the
network has a loopback alone. Prints what server and clients said, then their exit codes.
"""

from __future__ import annotations

import fcntl
import json
import os
import re
import signal
import socket
import struct
import subprocess
import sys
import time
from pathlib import Path

LIMIT_S = 120.0


def mount(*arguments: str) -> None:
    subprocess.run(["mount", *arguments], check=True)


def raise_loopback() -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        # SIOCSIFFLAGS with IFF_UP and IFF_RUNNING.
        fcntl.ioctl(probe, 0x8914, struct.pack("16sH14x", b"lo", 0x41))


def make_root(root: Path, archives: Path) -> None:
    mount("-t", "tmpfs", "-o", "mode=755", "none", str(root))
    for name in ("proc", "dev", "tmp", "opt"):
        (root / name).mkdir()
    (root / "tmp").chmod(0o777)
    mount("--rbind", "/proc", str(root / "proc"))
    for device in ("null", "urandom"):
        (root / "dev" / device).touch()
        mount("--bind", f"/dev/{device}", str(root / "dev" / device))
    mount("--bind", str(archives), str(root / "opt"))
    mount("-o", "remount,bind,ro", str(root / "opt"))


def entry(root: Path, name: str) -> list[str]:
    """The command that the Containerfile has."""
    folder = next((root / "opt").glob(f"dismount-{name}-*-linux-x86_64"))
    text = (folder / "Containerfile").read_text(encoding="utf-8")
    command: list[str] = json.loads(re.findall(r"^ENTRYPOINT (.*)$", text, re.MULTILINE)[0])
    return [part.replace(f"/opt/dismount-{name}", f"/opt/{folder.name}") for part in command]


class Inside:
    """A program in the new root."""

    def __init__(self, root: Path, user: int, command: list[str]) -> None:
        def enter() -> None:
            os.chroot(root)
            os.chdir("/tmp")
            if user:
                os.setgroups([])
                os.setgid(user)
                os.setuid(user)

        self.text = b""
        self.process = subprocess.Popen(
            command,
            env={"XDG_DATA_HOME": "/tmp"},
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            preexec_fn=enter,
        )
        os.set_blocking(self.process.stdout.fileno(), False)

    def await_text(self, text: str) -> None:
        end = time.monotonic() + LIMIT_S
        while text.encode() not in self.text and time.monotonic() < end:
            if self.process.poll() is not None:
                break
            self.text += self.process.stdout.read() or b""
            time.sleep(0.05)

    def finish(self) -> int:
        self.process.send_signal(signal.SIGTERM)
        code = self.process.wait(LIMIT_S)
        self.text += self.process.stdout.read() or b""
        return code


def main() -> None:
    archives, user, port = Path(sys.argv[1]), int(sys.argv[2]), sys.argv[3]
    root = Path(sys.argv[4])
    raise_loopback()
    make_root(root, archives)
    server = Inside(root, user, [*entry(root, "server"), f"--port={port}"])
    server.await_text("listening on UDP port")
    options = ["--role=observer", f"--port={port}", "--connect-timeout=120"]
    client = entry(root, "client")
    client.insert(client.index("--"), "--headless")
    observer = Inside(root, user, [*client, *options])
    observer.await_text("joined")
    codes = [observer.finish(), server.finish()]
    print(server.text.decode(errors="replace"), observer.text.decode(errors="replace"))
    print(json.dumps({"codes": codes}))


if __name__ == "__main__":
    main()
