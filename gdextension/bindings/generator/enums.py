# SPDX-License-Identifier: MIT
"""Enums and constants, global and of classes."""

from __future__ import annotations

from .api import Api, Json
from .output import Output


def enum_lines(entry: Json, indent: str = "") -> list[str]:
    """The definition of an enum."""
    name = entry["name"].rpartition(".")[2]
    return [
        f"{indent}enum {name} {{",
        *[f"{indent}\t{value['name']} = {_literal(value['value'])}," for value in entry["values"]],
        f"{indent}}};",
        "",
    ]


def cast_lines(owner: str, entries: list[Json]) -> list[str]:
    """Makes enums usable in bound signatures."""
    prefix = f"{owner}::" if owner else ""
    lines = []
    for entry in entries:
        kind = "BITFIELD" if entry.get("is_bitfield") else "ENUM"
        lines.append(f"VARIANT_{kind}_CAST({prefix}{entry['name']});")
    return lines


def generate(api: Api, output: Output) -> None:
    """Writes global_constants.hpp, and Variant's enums as an include for its class body."""
    plain = [entry for entry in api.global_enums if "." not in entry["name"]]
    lines = ["#include <cstdint>", "", "namespace godot {", ""]
    for entry in plain:
        lines += enum_lines(entry)
    output.add_header("classes/global_constants.hpp", [*lines, "} // namespace godot"])
    output.add_header(
        "classes/global_constants_binds.hpp",
        [
            "#include <godot_cpp/classes/global_constants.hpp>",
            "#include <godot_cpp/core/enum_info.hpp>",
            "",
            *cast_lines("", plain),
        ],
    )
    output.add("include/godot_cpp/variant/variant_enums.inc", _variant_enums(api))
    header = api.header
    output.add_header(
        "core/version.hpp",
        [
            f"#define GODOT_VERSION_MAJOR {header['version_major']}",
            f"#define GODOT_VERSION_MINOR {header['version_minor']}",
            f"#define GODOT_VERSION_PATCH {header['version_patch']}",
        ],
    )


def _variant_enums(api: Api) -> list[str]:
    types = api.global_enum("Variant.Type")
    values = [{**value, "name": _variant_type_name(value["name"])} for value in types["values"]]
    operators = api.global_enum("Variant.Operator")
    return [*enum_lines({**types, "values": values}, "\t"), *enum_lines(operators, "\t")]


def _variant_type_name(name: str) -> str:
    return "VARIANT_MAX" if name == "TYPE_MAX" else name.removeprefix("TYPE_")


def _literal(value: int) -> str:
    return f"{value}LL" if abs(value) >= 2**31 else str(value)
