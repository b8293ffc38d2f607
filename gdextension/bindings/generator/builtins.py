# SPDX-License-Identifier: MIT
"""The builtin types (String, Array, Vector3, ...): class bodies and calls."""

from __future__ import annotations

import re
from pathlib import Path

from .api import MATH_TYPES, Api, Json
from .cpp_types import Signature, TypeMap
from .enums import enum_lines
from .errors import UnsupportedType
from .naming import identifier, snake_case
from .output import Output

_OPERATORS = {
    "==": "EQUAL",
    "!=": "NOT_EQUAL",
    "<": "LESS",
    "<=": "LESS_EQUAL",
    ">": "GREATER",
    ">=": "GREATER_EQUAL",
    "+": "ADD",
    "-": "SUBTRACT",
    "*": "MULTIPLY",
    "/": "DIVIDE",
    "%": "MODULE",
}
_PACKED_ELEMENTS = {
    "PackedByteArray": "uint8_t",
    "PackedInt32Array": "int32_t",
    "PackedInt64Array": "int64_t",
    "PackedFloat32Array": "float",
    "PackedFloat64Array": "double",
}
# What the macro of that name in variant.hpp defines.
_VECTOR_OPERATORS = {"==", "!=", "+", "-", "*", "/"}
_HANDWRITTEN = Path(__file__).with_name("builtin_members.inc")
# Strings convert into these without being asked.
_FROM_STRING = ("StringName", "NodePath")


def generate(api: Api, output: Output) -> None:
    """Writes every builtin type, in an order in which each is complete where it's a member."""
    handwritten = _read_handwritten()
    declarations = [*[f"class {name};" for name in api.builtins], "template <class T>"]
    declarations += ["class TypedArray;"]
    definitions: list[str] = []
    for name in [*MATH_TYPES, *api.opaque_types]:
        builtin = _Builtin(api, name, handwritten.get(name, []))
        declarations += ["", *builtin.declare()]
        definitions += builtin.definitions
    output.add("include/godot_cpp/variant/builtins.inc", declarations)
    output.add(
        "src/builtins.cpp",
        ["#include <godot_cpp/classes/object.hpp>", "", "namespace godot {", ""]
        + [*definitions, "} // namespace godot"],
    )
    for name in api.builtins:
        output.add_header(
            f"variant/{snake_case(name)}.hpp", ["#include <godot_cpp/variant/variant.hpp>"]
        )


def _read_handwritten() -> dict[str, list[str]]:
    """The handwritten members of each type, from the sections `//@ Type` of their file."""
    sections: dict[str, list[str]] = {}
    lines: list[str] = []
    for line in _HANDWRITTEN.read_text(encoding="utf-8").splitlines():
        if line.startswith("//@ "):
            lines = sections.setdefault(line[4:], [])
        else:
            lines.append(line)
    return {
        name: ["\t" + line if line else "" for line in "\n".join(text).strip("\n").split("\n")]
        for name, text in sections.items()
    }


class _Builtin:
    """Writes one builtin type."""

    def __init__(self, api: Api, name: str, handwritten: list[str]) -> None:
        self._api = api
        self._types = TypeMap(api)
        self._name = name
        self._entry: Json = api.builtins[name]
        self._variant_type = f"GDEXTENSION_VARIANT_TYPE_{api.variant_type(name)}"
        self._opaque = name in api.opaque_types
        self._handwritten = handwritten
        text = "\n".join(handwritten)
        # What is written by hand is not generated: a method, an operator, a constructor.
        self._names = set(re.findall(r"\b(\w+)\(", text))
        self._names |= set(re.findall(r"operator(\W+?)\(", text))
        if "GODOT_VECTOR_OPERATORS(" in text:
            self._names |= _VECTOR_OPERATORS
        self._constructors = {int(index) for index in re.findall(r"// Constructor (\d+)", text)}
        self.definitions: list[str] = []

    def declare(self) -> list[str]:
        """The class; fills `definitions` on the way."""
        lines = [f"class {self._name} {{", "public:"]
        for enum in self._entry.get("enums", []):
            lines += enum_lines(enum, "\t")
        if self._opaque:
            lines.append(f"\talignas(8) uint8_t opaque[{self._api.sizes[self._name]}] = {{}};")
        lines += self._handwritten
        for constructor in self._entry["constructors"]:
            lines += self._constructor(constructor)
        if self._opaque:
            lines += self._lifetime()
        for method in self._entry.get("methods", []):
            if method["name"] not in self._names:
                lines += self._vararg(method) if method["is_vararg"] else self._method(method)
        for operator in self._entry.get("operators", []):
            lines += self._operator(operator)
        if self._name.startswith("Packed"):
            lines += self._elements()
        return [*lines, "};"]

    def _define(self, head: str, *body: str) -> None:
        self.definitions += [head + " {", *[f"\t{line}" for line in body], "}", ""]

    def _constructor(self, entry: Json) -> list[str]:
        try:
            signature = self._types.signature({"arguments": entry.get("arguments", [])})
        except UnsupportedType:
            return []
        spellings = [parameter.type.spelling for parameter in signature.parameters]
        is_copy = spellings == [self._name]
        scalar = all(spelling == "double" for spelling in spellings)
        if not self._opaque and (is_copy or scalar or entry["index"] in self._constructors):
            return []
        converts = self._name in _FROM_STRING and spellings == ["String"]
        explicit = "explicit " if len(spellings) == 1 and not is_copy and not converts else ""
        head = f"{self._name}({signature.declare()})"
        self._define(
            f"{self._name}::{head}",
            "static const auto function = internal::engine.variant_get_ptr_constructor("
            f"{self._variant_type}, {entry['index']});",
            f"internal::construct({signature.arguments('function', 'this')});",
        )
        return [f"\t{explicit}{head};"]

    def _lifetime(self) -> list[str]:
        name = self._name
        lines = [f"\t{name}({name} &&p_other) noexcept {{ std::swap(opaque, p_other.opaque); }}"]
        if not self._entry["has_destructor"]:
            return [*lines, f"\t{name} &operator=(const {name} &p_other) = default;"]
        self._define(
            f"{name}::~{name}()",
            "static const auto function = internal::engine.variant_get_ptr_destructor("
            f"{self._variant_type});",
            "function(opaque);",
        )
        return [
            *lines,
            f"\t~{name}();",
            f"\t{name} &operator=({name} p_other) noexcept {{",
            "\t\tstd::swap(opaque, p_other.opaque);",
            "\t\treturn *this;",
            "\t}",
        ]

    def _lookup(self, method: Json) -> str:
        return (
            f"static const auto function = internal::builtin_method({self._variant_type}, "
            f'"{method["name"]}", {method["hash"]});'
        )

    def _vararg(self, method: Json) -> list[str]:
        if method.get("arguments"):
            return []  # None exists; Callable's have variable arguments only.
        try:
            result = self._types.signature(method).result.spelling
        except UnsupportedType:
            return []
        # The result type depends on the template, because Variant is not complete yet.
        dependent = f"internal::Dependent<{result}, Arguments...>"
        return [
            "\ttemplate <class... Arguments>",
            f"\t{dependent} {identifier(method['name'])}(const Arguments &...p_arguments) const {{",
            f"\t\t{self._lookup(method)}",
            f"\t\treturn internal::call_builtin<{dependent}>("
            "function, const_cast<uint8_t *>(opaque), internal::to_variant(p_arguments)...);",
            "\t}",
        ]

    def _method(self, method: Json) -> list[str]:
        try:
            signature = self._types.signature(method)
        except UnsupportedType:
            return []
        name = identifier(method["name"])
        result = signature.result.spelling
        const = " const" if method["is_const"] else ""
        base = "nullptr" if method["is_static"] else f"const_cast<{self._name} *>(this)"
        self._define(
            f"{result} {self._name}::{name}({signature.declare()}){const}",
            self._lookup(method),
            f"return internal::call_builtin<{result}>({signature.arguments('function', base)});",
        )
        static = "static " if method["is_static"] else ""
        declared = ", ".join(
            # A Variant is incomplete here: its default becomes an overload.
            entry.declare(with_default=entry.type.spelling != "Variant")
            for entry in signature.parameters
        )
        lines = [f"\t{static}{result} {name}({declared}){const};"]
        last = signature.parameters[-1] if signature.parameters else None
        if last and last.default is not None and last.type.spelling == "Variant":
            lines.append(self._without_last(name, signature, const))
        return lines

    def _without_last(self, name: str, signature: Signature, const: str) -> str:
        shorter = Signature(signature.result, signature.parameters[:-1])
        result = signature.result.spelling
        arguments = ", ".join([*(entry.name for entry in shorter.parameters), "Variant()"])
        self._define(
            f"{result} {self._name}::{name}({shorter.declare()}){const}",
            f"return {name}({arguments});",
        )
        return f"\t{result} {name}({shorter.declare()}){const};"

    def _operator(self, entry: Json) -> list[str]:
        symbol = entry["name"]
        right_name = entry.get("right_type", "Variant")
        if symbol not in _OPERATORS or symbol in self._names or right_name == "Variant":
            return []
        try:
            right = self._types.find(right_name)
            result = self._types.find(entry["return_type"]).spelling
        except UnsupportedType:
            return []
        head = f"operator{symbol}({right.declare('p_other')}) const"
        self._define(
            f"{result} {self._name}::{head}",
            "static const auto function = internal::engine.variant_get_ptr_operator_evaluator("
            f"GDEXTENSION_VARIANT_OP_{_OPERATORS[symbol]}, {self._variant_type}, "
            f"GDEXTENSION_VARIANT_TYPE_{self._api.variant_type(right_name)});",
            f"return internal::call_operator<{result}>(function, this, p_other);",
        )
        return [f"\t{result} {head};"]

    def _elements(self) -> list[str]:
        """Raw access to the elements of a packed array."""
        element = _PACKED_ELEMENTS.get(self._name, self._name[6:-5])
        index = f"internal::engine.{snake_case(self._name)}_operator_index"
        read = f"reinterpret_cast<const {element} *>({index}_const(opaque, %s))"
        write = f"reinterpret_cast<{element} *>({index}(opaque, %s))"
        return [
            f"\tconst {element} *ptr() const {{ return {read % 0}; }}",
            f"\t{element} *ptrw() {{ return {write % 0}; }}",
            f"\tconst {element} &operator[](int64_t p_index) const {{",
            f"\t\treturn *{read % 'p_index'};",
            "\t}",
            f"\t{element} &operator[](int64_t p_index) {{",
            f"\t\treturn *{write % 'p_index'};",
            "\t}",
        ]
