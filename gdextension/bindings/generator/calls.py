# SPDX-License-Identifier: MIT
"""The body of a function that calls the engine: encode the arguments, call, decode the result."""

from __future__ import annotations

from collections.abc import Callable

from .type_map import CppType, Kind, Parameter


def call_body(
    result: CppType, parameters: list[Parameter], call: Callable[[str, str], str]
) -> list[str]:
    """Lines of a body; `call` makes the call from the names of argument array and result."""
    lines = []
    pointers = []
    for parameter in parameters:
        statement, pointer = parameter.type.encode(parameter.name)
        if statement:
            lines.append(f"\t{statement}")
        pointers.append(pointer)
    arguments = "nullptr"
    if pointers:
        lines.append(f"\tconst void *arguments[] = {{ {', '.join(pointers)} }};")
        arguments = "arguments"
    if result.kind is Kind.VOID:
        return [*lines, f"\t{call(arguments, 'nullptr')}"]
    declaration, value = result.result()
    return [*lines, f"\t{declaration}", f"\t{call(arguments, '&result')}", f"\treturn {value};"]


def function(head: str, body: list[str]) -> list[str]:
    """A whole function definition."""
    return [head + " {", *body, "}", ""]


def vararg_template(head: str, parameters: list[Parameter], call: str) -> list[str]:
    """A template that packs named and further arguments into Variants; lines of class scope."""
    named = "".join(f"Variant({parameter.name}), " for parameter in parameters)
    return [
        "\ttemplate <class... Arguments>",
        f"\t{head} {{",
        # One element too many, because an array can't be empty.
        f"\t\tconst Variant values[] = {{ {named}Variant(p_arguments)..., Variant() }};",
        f"\t\tconstexpr size_t count = {len(parameters)} + sizeof...(Arguments);",
        "\t\tconst void *pointers[count + 1];",
        "\t\tfor (size_t i = 0; i < count; i++) {",
        "\t\t\tpointers[i] = &values[i];",
        "\t\t}",
        f"\t\t{call}",
        "\t}",
    ]


def vararg_parameters(parameters: list[Parameter]) -> str:
    """The parameter list of such a template."""
    texts = [parameter.declare() for parameter in parameters]
    return ", ".join([*texts, "const Arguments &...p_arguments"])
