# SPDX-License-Identifier: MIT
"""The list of what the bindings expect of the engine, which they check when they are loaded."""

from __future__ import annotations

from .api import Api
from .output import Output


def generate(api: Api, output: Output) -> None:
    """Writes the list of methods and their hashes."""
    lines = [
        "#include <godot_cpp/core/expected_api.hpp>",
        "",
        "namespace godot::internal {",
        "",
        f'const char *const expected_engine = "{api.version}";',
        "",
        "static const ExpectedMethod methods[] = {",
    ]
    for name, entry in api.classes.items():
        if entry.get("api_type") == "editor":
            continue  # The classes of the editor are not in an exported game.
        for method in entry.get("methods", []):
            if not method["is_virtual"]:
                lines.append(f'\t{{ "{name}", "{method["name"]}", {method["hash"]} }},')
    lines += [
        "};",
        "",
        "const ExpectedMethod *const expected_methods = methods;",
        "const size_t expected_method_count = sizeof(methods) / sizeof(methods[0]);",
        "",
        "} // namespace godot::internal",
    ]
    output.add("src/expected_api.cpp", lines)
