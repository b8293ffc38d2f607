# SPDX-License-Identifier: MIT
"""Conversions between Variant and the builtin types."""

from __future__ import annotations

from .api import Api
from .output import Output


def generate(api: Api, output: Output) -> None:
    """Writes the conversions as an include for Variant's class body, and their definitions."""
    declarations = []
    definitions = ["#include <godot_cpp/variant/variant.hpp>", "", "namespace godot {", ""]
    tags = []
    for name in api.builtins:
        # Variant::AABB and others are enum constants, so the types need their full names.
        cpp = f"::godot::{name}"
        tag = f"GDEXTENSION_VARIANT_TYPE_{api.variant_type(name)}"
        tags += [
            "template <>",
            f"struct BuiltinType<{name}> {{",
            f"\tstatic constexpr GDExtensionVariantType value = {tag};",
            "};",
            "",
        ]
        declarations += [f"\tVariant(const {cpp} &p_value);", f"\toperator {cpp}() const;"]
        definitions += _definitions(cpp, tag)
    output.add("include/godot_cpp/variant/variant_conversions.inc", declarations)
    output.add("include/godot_cpp/variant/builtin_types.inc", tags)
    output.add("src/variant_conversions.cpp", [*definitions, "} // namespace godot"])


def _definitions(cpp: str, tag: str) -> list[str]:
    return [
        f"Variant::Variant(const {cpp} &p_value) {{",
        "\tstatic const auto function = "
        f"internal::engine.get_variant_from_type_constructor({tag});",
        f"\tfunction(opaque, const_cast<{cpp} *>(&p_value));",
        "}",
        "",
        f"Variant::operator {cpp}() const {{",
        f"\tstatic const auto function = internal::engine.get_variant_to_type_constructor({tag});",
        f"\t{cpp} result;",
        "\tinternal::destroy(result); // The engine constructs in place.",
        "\tfunction(&result, const_cast<uint8_t *>(opaque));",
        "\treturn result;",
        "}",
        "",
    ]
