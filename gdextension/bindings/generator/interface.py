# SPDX-License-Identifier: MIT
"""The table of engine functions, from the comments and typedefs of gdextension_interface.h."""

from __future__ import annotations

import re

from .api import Api
from .errors import GeneratorError
from .output import Output

# The comment may not run past its end; two types are spelt "GDExtensionsInterface".
_FUNCTION = re.compile(
    r"/\*\*(?P<doc>(?:(?!\*/).)*?@name (?P<name>\w+)(?:(?!\*/).)*)\*/\s*"
    r"typedef [^;]*?\(\*(?P<type>GDExtensions?Interface\w+)\)",
    re.S,
)


def functions(header: str) -> list[tuple[str, str]]:
    """Name and type of each function of the interface that is not deprecated."""
    found = [
        (match["name"], match["type"])
        for match in _FUNCTION.finditer(header)
        if "@deprecated" not in match["doc"]
    ]
    if not found:
        raise GeneratorError("gdextension_interface.h declares no functions: is it the right file?")
    return found


def generate(api: Api, header: str, output: Output) -> None:
    """Writes the header itself, the table of its functions, and the loader of the table."""
    found = functions(header)
    output.add("include/gdextension_interface.h", [header], notice=False)
    output.add_header(
        "core/engine_interface.hpp",
        [
            "#include <gdextension_interface.h>",
            "",
            "namespace godot::internal {",
            "",
            "/// The functions that the engine offers to extensions.",
            "struct EngineInterface {",
            *[f"\t{kind} {name} = nullptr;" for name, kind in found],
            "",
            "\t/// The name of the first function that this engine lacks, or null.",
            "\tconst char *load(GDExtensionInterfaceGetProcAddress p_get_proc_address);",
            "};",
            "",
            "extern EngineInterface engine;",
            "",
            f'constexpr const char *generated_for = "{api.version}";',
            "",
            "} // namespace godot::internal",
        ],
    )
    output.add("src/engine_interface.cpp", _loader(found))


def _loader(found: list[tuple[str, str]]) -> list[str]:
    entries = [
        f'\t\t{{ "{name}", reinterpret_cast<GDExtensionInterfaceFunctionPtr *>(&{name}) }},'
        for name, _kind in found
    ]
    return [
        "#include <godot_cpp/core/engine_interface.hpp>",
        "",
        "namespace godot::internal {",
        "",
        "EngineInterface engine;",
        "",
        "const char *EngineInterface::load("
        "GDExtensionInterfaceGetProcAddress p_get_proc_address) {",
        "\tstruct Entry {",
        "\t\tconst char *name;",
        "\t\tGDExtensionInterfaceFunctionPtr *slot;",
        "\t};",
        "\tconst Entry entries[] = {",
        *entries,
        "\t};",
        "\tfor (const Entry &entry : entries) {",
        "\t\t*entry.slot = p_get_proc_address(entry.name);",
        "\t\tif (*entry.slot == nullptr) {",
        "\t\t\treturn entry.name;",
        "\t\t}",
        "\t}",
        "\treturn nullptr;",
        "}",
        "",
        "} // namespace godot::internal",
    ]
