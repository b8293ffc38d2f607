# SPDX-License-Identifier: MIT
"""The lists that start-up goes through: all builtin types, all engine classes."""

from __future__ import annotations

from .api import Api
from .builtins import table_name
from .naming import snake_case
from .output import Output


def generate(api: Api, output: Output) -> None:
    """Writes registry.cpp."""
    tables = [table_name(name) for name in api.opaque_types]
    is_class = api.method("Object", "is_class")
    output.add(
        "src/registry.cpp",
        [
            *[f"#include <godot_cpp/classes/{snake_case(name)}.hpp>" for name in api.classes],
            "#include <godot_cpp/core/binding_tables.hpp>",
            "",
            "namespace godot {",
            "",
            *[f"extern const internal::BuiltinTable {table};" for table in tables],
            "",
            "namespace internal {",
            "",
            "const std::vector<const BuiltinTable *> &builtin_tables() {",
            "\tstatic const std::vector<const BuiltinTable *> tables = {",
            *[f"\t\t&{table}," for table in tables],
            "\t};",
            "\treturn tables;",
            "}",
            "",
            "const std::vector<EngineClass *> &engine_classes() {",
            "\tstatic const std::vector<EngineClass *> classes = {",
            *[f"\t\t&{name}::engine_class()," for name in api.classes],
            "\t};",
            "\treturn classes;",
            "}",
            "",
            f'MethodBind object_is_class = {{ "is_class", {is_class["hash"]}, nullptr }};',
            "",
            "} // namespace internal",
            "",
            "} // namespace godot",
        ],
    )
