# SPDX-License-Identifier: MIT
"""The screen: the user's own where there is one, otherwise a virtual one of our own (Xvfb)."""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from .console import Failure
from .paths import cache, lock
from .prefix import LIBRARIES, Prefix

SIZE = "1280x720x24"
# Shaders that nobody uses any more gather: from here on they are compiled anew.
MOST_SHADERS = 128 << 20


def real_display() -> bool:
    """Whether windows would be seen by somebody. DISMOUNT_DISPLAY=virtual says no."""
    if os.environ.get("DISMOUNT_DISPLAY") == "virtual":
        return False
    return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


def _xvfb() -> tuple[list[str], Path]:
    """The command that starts Xvfb, and the folder to start it in."""
    system = shutil.which("Xvfb")
    if system and shutil.which("xkbcomp"):
        return [system], Path("/")
    prefix = Prefix()
    program = prefix.program("Xvfb")
    keyboard = prefix.root / "usr/share/X11/xkb"
    # Our copy looks for xkbcomp in its working folder: see prefix.py.
    return [str(program), "-xkbdir", str(keyboard)], prefix.bin


def _drivers() -> dict[str, str]:
    """Where software OpenGL is, for a Godot that brings its own libraries."""
    root = Prefix().root
    if not root.exists():
        return {}
    vendors = root / "usr/share/glvnd/egl_vendor.d"
    return {
        "LIBGL_DRIVERS_PATH": str(root / LIBRARIES / "dri"),
        "__EGL_VENDOR_LIBRARY_DIRS": str(vendors),
        "LIBGL_ALWAYS_SOFTWARE": "1",
    }


@contextmanager
def _shaders(are_kept: bool) -> Iterator[str]:
    """The folder where Mesa keeps what it has compiled, which takes as long as all else of a
    window's start. What is kept for the next display is copied: programs of several displays that
    share such a folder have ended by SIGBUS in it."""
    kept = cache() / "shaders"
    with tempfile.TemporaryDirectory(prefix="dismount-shaders-") as name:
        if not are_kept:
            yield name
            return
        with lock(cache() / "shaders.lock", "copying shaders"):
            if 0 < _bytes_in(kept) < MOST_SHADERS:
                shutil.copytree(kept, name, dirs_exist_ok=True)
        yield name
        with lock(cache() / "shaders.lock", "keeping shaders"):
            if _bytes_in(Path(name)) > _bytes_in(kept) or _bytes_in(kept) > MOST_SHADERS:
                part = kept.with_name("shaders.part")
                shutil.rmtree(part, ignore_errors=True)
                shutil.copytree(name, part)
                shutil.rmtree(kept, ignore_errors=True)
                part.rename(kept)


def _bytes_in(folder: Path) -> int:
    return sum(file.stat().st_size for file in folder.rglob("*") if file.is_file())


@contextmanager
def virtual_display(size: str = SIZE, keeps_shaders: bool = False) -> Iterator[dict[str, str]]:
    """Runs an X server without a screen; yields the environment for its clients. Tests keep
    compiled shaders; what measures or films begins without any."""
    command, folder = _xvfb()
    read_end, write_end = os.pipe()
    flags = ["-displayfd", str(write_end), "-screen", "0", size, "-nolisten", "tcp", "-noreset"]
    server = subprocess.Popen(
        command + flags,
        cwd=folder,
        env={**os.environ, **_drivers()},
        pass_fds=[write_end],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
    )
    os.close(write_end)
    try:
        with os.fdopen(read_end) as reader:
            number = reader.readline().strip()  # Empty at once if the server ends.
        if not number:
            said = server.stderr.read().decode(errors="replace").strip().splitlines()
            raise Failure(
                "The virtual display (Xvfb) does not start: " + (said[-1] if said else "no reason")
            )
        with _shaders(keeps_shaders) as shaders:
            yield {
                **_drivers(),
                "DISPLAY": f":{number}",
                "WAYLAND_DISPLAY": "",
                "LP_NUM_THREADS": "1",
                "MESA_SHADER_CACHE_DIR": shaders,
                # The machine's Vulkan drivers may be of another Mesa, which cuts that cache short.
                "VK_DRIVER_FILES": os.environ.get("VK_DRIVER_FILES", os.devnull),
            }
    finally:
        server.terminate()
        try:
            server.wait(5)
        except subprocess.TimeoutExpired:
            server.kill()
            server.wait()
