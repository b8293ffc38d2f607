# SPDX-License-Identifier: MIT
"""Utility functions: printing, random numbers, conversions. For mathematics there is <cmath>."""

from __future__ import annotations

from .api import Api, Json
from .calls import call_body, function, vararg_parameters, vararg_template
from .defaults import declare_all
from .errors import UnsupportedType
from .naming import identifier
from .output import Output
from .type_map import TypeMap

_CATEGORIES = ("general", "random")


def generate(api: Api, types: TypeMap, output: Output) -> None:
    """Writes the class UtilityFunctions."""
    header: list[str] = []
    source: list[str] = []
    entries: list[Json] = []
    for entry in api.utility_functions:
        if entry["category"] not in _CATEGORIES:
            continue
        try:
            _add(types, entry, header, source)
        except UnsupportedType:
            continue
        entries.append(entry)
    output.add_header(
        "variant/utility_functions.hpp",
        [
            "#include <godot_cpp/classes/object.hpp>",
            "#include <godot_cpp/variant/variant.hpp>",
            "",
            "namespace godot {",
            "",
            "class UtilityFunctions {",
            "public:",
            *header,
            "};",
            "",
            "} // namespace godot",
        ],
    )
    output.add("src/utility_functions.cpp", _source(entries, source))


def _add(types: TypeMap, entry: Json, header: list[str], source: list[str]) -> None:
    parameters = types.parameters(entry)
    result = types.result(entry)
    name = identifier(entry["name"])
    call = f"functions[f_{entry['name']}].function"
    if not entry["is_vararg"]:
        header.append(f"\tstatic {result.spelling} {name}({declare_all(parameters)});")
        body = call_body(
            result, parameters, lambda args, into: f"{call}({into}, {args}, {len(parameters)});"
        )
        head = f"{result.spelling} UtilityFunctions::{name}({declare_all(parameters)})"
        source += function(head, body)
        return
    # The dump names arguments ("arg1") that every call passes among the others.
    give = "" if result.spelling == "void" else "return "
    head = f"static {result.spelling} {name}({vararg_parameters([])})"
    header += vararg_template(head, [], f"{give}{name}_vararg(pointers, count);")
    inner = f"{name}_vararg(const void *const *p_arguments, int64_t p_count)"
    header.append(f"\tstatic {result.spelling} {inner};")
    into = "nullptr" if result.spelling == "void" else "&result"
    body = [f"\t{call}({into}, p_arguments, int(p_count));"]
    if result.spelling != "void":
        declaration, value = result.result()
        body = [f"\t{declaration}", *body, f"\treturn {value};"]
    source += function(f"{result.spelling} UtilityFunctions::{inner}", body)


def _source(entries: list[Json], source: list[str]) -> list[str]:
    return [
        "#include <godot_cpp/core/binding_tables.hpp>",
        "#include <godot_cpp/variant/utility_functions.hpp>",
        "",
        "namespace godot {",
        "",
        "namespace {",
        "",
        "enum Function : size_t {",
        *[f"\tf_{entry['name']}," for entry in entries],
        "};",
        "",
        "internal::UtilityFunction functions[] = {",
        *[f'\t{{ "{entry["name"]}", {entry["hash"]}, nullptr }},' for entry in entries],
        "};",
        "",
        "} // namespace",
        "",
        *source,
        "namespace internal {",
        "",
        "Span<UtilityFunction> utility_functions() {",
        "\treturn span(functions);",
        "}",
        "",
        "} // namespace internal",
        "",
        "} // namespace godot",
    ]
