# SPDX-License-Identifier: MIT
"""python3 -m generator.embed_documentation --output FILE.cpp CLASS.xml ...

Turns class reference pages into a C++ source that hands them to the editor.
"""

from __future__ import annotations

import argparse
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from .errors import GeneratorError


def literal(text: str) -> str:
    """A C++ string literal, a line of text to a line."""
    escaped = []
    for line in text.splitlines(keepends=True):
        line = line.replace("\\", "\\\\").replace('"', '\\"').replace("?", "\\?")
        escaped.append('\t"' + line.replace("\n", "\\n").replace("\t", "\\t") + '"')
    return "\n".join(escaped)


def source(pages: list[Path]) -> str:
    """The C++ source for some pages."""
    lines = ["#include <godot_cpp/core/documentation.hpp>", ""]
    for index, page in enumerate(pages):
        try:
            text = page.read_text(encoding="utf-8")
            ElementTree.fromstring(text)
        except (OSError, ElementTree.ParseError) as error:
            raise GeneratorError(f"{page.name} is no readable XML: {error}.") from error
        name = f"page_{index}"
        lines += [
            f"static const char {name}[] =",
            literal(text) + ";",
            "static const godot::internal::Documentation "
            f"{name}_documentation({name}, sizeof({name}) - 1);",
            "",
        ]
    return "\n".join(lines)


def main() -> int:
    """Runs the tool; returns its exit status."""
    parser = argparse.ArgumentParser(prog="embed_documentation", description=__doc__)
    parser.add_argument("--output", type=Path, required=True, help="the C++ source to write")
    parser.add_argument("pages", type=Path, nargs="+", help="XML files")
    arguments = parser.parse_args()
    try:
        arguments.output.write_text(source(arguments.pages), encoding="utf-8")
    except (GeneratorError, OSError) as error:
        print(f"embed_documentation: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
