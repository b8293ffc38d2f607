# SPDX-License-Identifier: MIT
"""Enums: the global ones, and those inside of classes."""

from __future__ import annotations

from .api import Api, Json
from .output import Output


def enum_lines(entry: Json, indent: str = "") -> list[str]:
    """The definition of an enum. All are as wide as the engine passes them."""
    name = entry["name"].rpartition(".")[2]
    return [
        f"{indent}enum {name} : int64_t {{",
        *[f"{indent}\t{value['name']} = {_literal(value['value'])}," for value in entry["values"]],
        f"{indent}}};",
    ]


def generate(api: Api, output: Output) -> None:
    """Writes global_constants.hpp, and Variant's enums as an include for its class body."""
    lines = ["#include <cstdint>", "", "namespace godot {"]
    for entry in api.global_enums:
        if "." not in entry["name"]:
            lines += ["", *enum_lines(entry)]
    output.add_header("classes/global_constants.hpp", [*lines, "", "} // namespace godot"])
    output.add("include/godot_cpp/variant/variant_enums.inc", _variant_enums(api))


def _variant_enums(api: Api) -> list[str]:
    types = api.global_enum("Variant.Type")
    values = [{**value, "name": _variant_type_name(value["name"])} for value in types["values"]]
    operators = api.global_enum("Variant.Operator")
    return [*enum_lines({**types, "values": values}, "\t"), *enum_lines(operators, "\t")]


def _variant_type_name(name: str) -> str:
    # Variant::AABB and its like shadow the classes of that name: write ::godot::AABB inside.
    return "VARIANT_MAX" if name == "TYPE_MAX" else name.removeprefix("TYPE_")


def _literal(value: int) -> str:
    return f"{value}LL" if abs(value) >= 2**31 else str(value)
