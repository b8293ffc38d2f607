# SPDX-License-Identifier: MIT
"""Command line: see --help."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from . import builtins, classes, enums, interface, registry, utility
from .api import Api, check_supported, enabled_classes, load_json
from .errors import GeneratorError
from .output import Output
from .type_map import TypeMap


def generate(dump: Path, header: Path, profile: Path, folder: Path) -> str:
    """Generates everything into a folder; returns a summary."""
    contents = load_json(dump)
    check_supported(contents)
    api = Api(contents, enabled_classes(load_json(profile)))
    try:
        interface_text = header.read_text(encoding="utf-8")
    except OSError as error:
        raise GeneratorError(f"Can't read {header}: {error.strerror}.") from error
    types = TypeMap(api)
    output = Output()
    interface.generate(api, interface_text, output)
    enums.generate(api, output)
    builtins.generate(api, types, output)
    utility.generate(api, types, output)
    written, skipped = classes.generate(api, types, output)
    registry.generate(api, output)
    output.write(folder)
    return (
        f"{api.version}: {len(api.classes)} classes, {written} methods "
        f"({skipped} left out: they mention classes outside the profile)"
    )


def main() -> int:
    """Runs the command line."""
    parser = argparse.ArgumentParser(prog="generator", description=__doc__)
    parser.add_argument("--api", type=Path, required=True, help="extension_api.json")
    parser.add_argument("--interface", type=Path, required=True, help="gdextension_interface.h")
    parser.add_argument("--profile", type=Path, required=True, help="build profile (JSON)")
    parser.add_argument("--out", type=Path, required=True, help="folder for the generated files")
    arguments = parser.parse_args()
    try:
        print(generate(arguments.api, arguments.interface, arguments.profile, arguments.out))
    except GeneratorError as error:
        print(f"Generating the bindings failed: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
