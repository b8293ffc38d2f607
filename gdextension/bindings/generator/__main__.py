# SPDX-License-Identifier: MIT
"""python3 -m generator --api extension_api.json --interface gdextension_interface.h ..."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from . import builtins, checklist, engine_classes, enums, interface, utility_functions, variant
from .api import Api, check_supported, enabled_classes, load_json
from .errors import GeneratorError
from .output import Output


def build(dump: dict, profile: dict, header: str) -> tuple[Output, list[str]]:
    """The generated files, and the methods that had to be left out."""
    check_supported(dump)
    api = Api(dump, enabled_classes(profile))
    output = Output()
    interface.generate(header, output)
    enums.generate(api, output)
    builtins.generate(api, output)
    variant.generate(api, output)
    utility_functions.generate(api, output)
    skipped = engine_classes.generate(api, output)
    checklist.generate(api, output)
    return output, skipped


def main() -> int:
    """Runs the generator; returns its exit status."""
    parser = argparse.ArgumentParser(prog="generator", description=__doc__)
    parser.add_argument("--api", type=Path, required=True, help="the engine's extension_api.json")
    parser.add_argument(
        "--interface", type=Path, required=True, help="the engine's gdextension_interface.h"
    )
    parser.add_argument(
        "--profile", type=Path, required=True, help="build profile that names the classes"
    )
    parser.add_argument("--output", type=Path, required=True, help="folder to write to")
    parser.add_argument("--verbose", action="store_true", help="list the methods left out")
    arguments = parser.parse_args()
    try:
        header = arguments.interface.read_text(encoding="utf-8")
        output, skipped = build(load_json(arguments.api), load_json(arguments.profile), header)
        output.write(arguments.output)
    except (GeneratorError, OSError) as error:
        print(f"generator: {error}", file=sys.stderr)
        return 1
    print(f"Bindings: {len(output.files)} files; {len(skipped)} methods left out")
    if arguments.verbose:
        print("\n".join(skipped))
    return 0


if __name__ == "__main__":
    sys.exit(main())
