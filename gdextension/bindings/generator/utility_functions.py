# SPDX-License-Identifier: MIT
"""The utility functions (print, lerp, ...) as static methods of one class."""

from __future__ import annotations

from .api import Api, Json
from .cpp_types import TypeMap
from .errors import UnsupportedType
from .naming import identifier
from .output import Output


def generate(api: Api, output: Output) -> None:
    """Writes utility_functions.hpp."""
    types = TypeMap(api)
    lines = ["#include <godot_cpp/variant/variant.hpp>", "", "namespace godot {", ""]
    lines += ["class UtilityFunctions {", "public:"]
    for entry in api.utility_functions:
        try:
            lines += _function(types, entry)
        except UnsupportedType:
            continue
    output.add_header("variant/utility_functions.hpp", [*lines, "};", "", "} // namespace godot"])


def _function(types: TypeMap, entry: Json) -> list[str]:
    signature = types.signature(entry)
    result = signature.result.spelling
    parameters = signature.declare()
    arguments = signature.arguments("function")
    lines = []
    if entry["is_vararg"]:
        # The engine names the first of them, but they are all Variants.
        lines.append("\ttemplate <class... Arguments>")
        parameters = "const Arguments &...p_arguments"
        arguments = "function, Variant(p_arguments)..."
    return [
        *lines,
        f"\tstatic {result} {identifier(entry['name'])}({parameters}) {{",
        "\t\tstatic const auto function = internal::utility_function("
        f'"{entry["name"]}", {entry["hash"]});',
        f"\t\treturn internal::call_utility<{result}>({arguments});",
        "\t}",
    ]
