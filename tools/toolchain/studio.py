# SPDX-License-Identifier: MIT
"""`./run studio`: the effects studio in a window."""

from __future__ import annotations

import os
import re
import subprocess
import threading
from typing import IO

from .console import Failure
from .display import real_display
from .nearest import check_options
from .paths import ROOT, user_path
from .project import prepare

HELP = """./run studio [NAME] [options]

The effects studio: the text of a particle effect on the left, the effect on the right, renewed at
every key press. NAME is an effect of assets/effects, such as smoke. It needs a display.

  --effects=FOLDER      folder of the effects (assets/effects)
  --out=FOLDER          where pictures and films go (the engine's user folder)
  --renderer=NAME       gl_compatibility, mobile or forward_plus (gl_compatibility)

Keys: F1 all settings and words, Ctrl+Space completion, Ctrl+S save, Ctrl+Z undo, F5 from the
beginning, F6 pause, F7 step. "Send" shows the effect to everybody in a session: the server's
instructor password is taken from DISMOUNT_PASSWORD.

Exit codes: 0 done, 1 there is no display, 2 wrong options.
"""
RENDERERS = ("gl_compatibility", "mobile", "forward_plus")
SCENE = "res://scenes/studio/studio.tscn"
# What the compiler says of a text that somebody is just typing: the studio shows it itself.
_TYPING = re.compile(
    r"SHADER ERROR|Shader compilation failed|^\s+at: |GDScript backtrace|^\s+\[\d+\] "
)


def main(arguments: list[str]) -> int:
    """Opens the studio and waits until it is closed."""
    given = [argument for argument in arguments if argument != "--"]
    check_options("./run studio", given, HELP)
    values = dict(
        argument.removeprefix("--").split("=", 1) for argument in given if "=" in argument
    )
    names = [argument for argument in given if not argument.startswith("-")]
    renderer = values.get("renderer", RENDERERS[0])
    if renderer not in RENDERERS or len(names) > 1:
        raise Failure("usage: ./run studio [NAME] [--renderer=" + "|".join(RENDERERS) + "]", 2)
    if not real_display():
        raise Failure("The studio needs a display: start it in a desktop session.")
    godot = prepare(export=False)
    command = [str(godot.program), "--no-header", "--path", str(ROOT)]
    command += ["--rendering-method", renderer, SCENE, "--"]
    if "effects" in values:
        command.append(f"--effects={user_path(values['effects'])}")
    command += [f"--effect={name}" for name in names]
    environment = {**os.environ}
    if "out" in values:
        environment["DISMOUNT_OUT"] = str(user_path(values["out"]))
    with subprocess.Popen(command, env=environment, stderr=subprocess.PIPE, text=True) as process:
        assert process.stderr is not None
        threading.Thread(target=_pass_on, args=(process.stderr,), daemon=True).start()
        try:
            return process.wait()
        except BaseException:
            process.terminate()
            raise


def _pass_on(stream: IO[str]) -> None:
    for line in stream:
        if not _TYPING.search(line):
            print(line, end="", flush=True)
