# SPDX-License-Identifier: MIT
"""Turns class documentation (XML) into a C++ source that registers it with our own bindings.

usage: python3 -m generator.embed_documentation --output OUTPUT.cpp CLASS.xml...
"""

import argparse
from pathlib import Path


def literal(line: str) -> str:
    """A line of text as a C++ string literal, in ASCII."""
    text = ""
    for byte in line.encode():
        plain = 32 <= byte < 127 and chr(byte) not in '"\\?'
        # Octal, because a hexadecimal escape would swallow digits behind it.
        text += chr(byte) if plain else f"\\{byte:03o}"
    return f'\t"{text}"'


def source(files: list[Path]) -> str:
    """The whole source file."""
    lines = ["#include <godot_cpp/godot.hpp>", "", "namespace {", ""]
    for index, file in enumerate(files):
        text = file.read_text(encoding="utf-8")
        lines += [f"constexpr char xml_{index}[] =", *map(literal, text.splitlines(keepends=True))]
        lines[-1] += ";"
        size = f"sizeof(xml_{index}) - 1"
        lines += [f"const godot::internal::Documentation doc_{index}(xml_{index}, {size});", ""]
    return "\n".join([*lines, "} // namespace", ""])


def main() -> None:
    """Runs the command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--output", type=Path, required=True)
    parser.add_argument("files", type=Path, nargs="+")
    arguments = parser.parse_args()
    arguments.output.write_text(source(arguments.files), encoding="utf-8")


if __name__ == "__main__":
    main()
