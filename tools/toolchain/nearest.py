# SPDX-License-Identifier: MIT
"""What somebody may have meant who mistyped a name, and options that no command has."""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterable

from .console import Failure

_OPTION = re.compile(r"(?<![\w-])--([a-z][a-z0-9-]*)")


def suggest(word: str, known: Iterable[str]) -> str:
    """A question to put behind a complaint, such as ": did you mean --person?"; or nothing."""
    found = difflib.get_close_matches(word, list(known), n=1, cutoff=0.6)
    return f": did you mean {found[0]}?" if found else ""


def options_in(text: str) -> list[str]:
    """The options that a help text names, with their hyphens."""
    return list(dict.fromkeys(f"--{name}" for name in _OPTION.findall(text)))


def check_options(command: str, arguments: Iterable[str], text: str) -> None:
    """Refuses an option that the command's help does not name."""
    known = options_in(text)
    for argument in arguments:
        name = argument.partition("=")[0]
        if name.startswith("--") and name != "--" and name not in known:
            raise Failure(unknown_option(command, name, known), 2)


def unknown_option(command: str, argument: str, known: Iterable[str]) -> str:
    """The complaint about an option that a command does not have, or that lacks its value."""
    name = argument.partition("=")[0]
    if name in known:
        return f"{name} expects a value: see {command} --help."
    if not name.startswith("--"):
        return f"'{argument}' is no option: see {command} --help."
    hint = suggest(name, known) or f": see {command} --help."
    return f"{command} has no option {name}{hint}"
