# SPDX-License-Identifier: MIT
"""Default values: from the dump's notation to a C++ expression."""

from __future__ import annotations

import re

from .type_map import CppType, Kind, Parameter


def default_expression(value: str, cpp: CppType) -> str:
    """`&"Master"` as a StringName -> `"Master"`, `Array[RID]([])` -> `TypedArray<RID>()`, ..."""
    if value == "null":
        return "nullptr" if cpp.kind is Kind.OBJECT else f"{cpp.spelling}()"
    if value in ("[]", "{}") or value.startswith(("Array[", "Dictionary[")):
        return f"{cpp.spelling}()"
    if value.startswith('&"'):
        return value[1:]
    if value.startswith(("Transform2D(", "Transform3D(", "Basis(")):
        # The dump writes the identity number by number; it is what the constructor makes.
        return f"{cpp.spelling}()"
    if cpp.kind is Kind.INTEGER and not cpp.spelling.endswith("_t"):
        enum = re.sub(r"^BitField<(.*)>$", r"\1", cpp.spelling)
        return f"static_cast<{enum}>({value})"
    return value


def declare_all(parameters: list[Parameter], with_defaults: bool = True) -> str:
    """The parameter list of a declaration."""
    texts = []
    for parameter in parameters:
        text = parameter.declare()
        if with_defaults and parameter.default is not None:
            text += " = " + default_expression(parameter.default, parameter.type)
        texts.append(text)
    return ", ".join(texts)
