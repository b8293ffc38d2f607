# SPDX-License-Identifier: MIT
"""The gate for the order of methods in scripts/ and addons/: public ones before private ones.

Whoever reads a class from its top learns first what it offers. Static methods and the engine's
virtual ones count as public; inner classes may stand anywhere.
"""

from __future__ import annotations

import re
import sys

from .paths import ROOT
from .tracked import tracked

# The engine calls these; what they do is no secret of the class.
VIRTUALS = {
    "_draw",
    "_enter_tree",
    "_exit_tree",
    "_get",
    "_get_configuration_warnings",
    "_get_property_list",
    "_gui_input",
    "_init",
    "_input",
    "_notification",
    "_physics_process",
    "_process",
    "_property_can_revert",
    "_property_get_revert",
    "_ready",
    "_set",
    "_shortcut_input",
    "_static_init",
    "_to_string",
    "_unhandled_input",
    "_unhandled_key_input",
    "_validate_property",
}

_METHOD = re.compile(r"^(?:@\w+(?:\(.*?\))?\s+)*(?:static\s+)?func\s+(\w+)", re.MULTILINE)


def is_private(name: str) -> bool:
    """Whether a method is one that only its own class uses."""
    return name.startswith("_") and name not in VIRTUALS


def find_fault(text: str) -> str:
    """The first method that stands wrong in a script, or nothing."""
    private = ""
    for found in _METHOD.finditer(text):
        name = found[1]
        if is_private(name):
            private = private or name
        elif private:
            line = text.count("\n", 0, found.start(1)) + 1
            return f"{line}: {name}() comes after {private}(): move it before all private methods"
    return ""


def main() -> int:
    """Checks the repository; the exit status says whether it is in order."""
    faults = []
    for name in tracked("scripts/*.gd", "addons/*.gd"):
        if fault := find_fault((ROOT / name).read_text(encoding="utf-8")):
            faults.append(f"{name}:{fault}")
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
