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
from .prefix import LIBRARIES, Prefix

SIZE = "1280x720x24"


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
def virtual_display(size: str = SIZE) -> Iterator[dict[str, str]]:
    """Runs an X server without a screen; yields the environment for its clients."""
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
        with tempfile.TemporaryDirectory(prefix="dismount-shaders-") as shaders:
            yield {
                **_drivers(),
                "DISPLAY": f":{number}",
                "WAYLAND_DISPLAY": "",
                "LP_NUM_THREADS": "1",
                # Programs of several displays that share Mesa's cache have ended by SIGBUS in it.
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
