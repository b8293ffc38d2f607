# SPDX-License-Identifier: MIT
"""The engine classes of the build profile (Node, PhysicsServer3D, ...)."""

from __future__ import annotations

from .api import Api, Json
from .cpp_types import Signature, TypeMap
from .enums import enum_lines
from .errors import UnsupportedType
from .naming import identifier, snake_case
from .output import Output

_CAST_TO = [
    "\ttemplate <class T>",
    "\tstatic T *cast_to(Object *p_object) { return dynamic_cast<T *>(p_object); }",
    "\ttemplate <class T>",
    "\tstatic const T *cast_to(const Object *p_object) "
    "{ return dynamic_cast<const T *>(p_object); }",
]


def generate(api: Api, output: Output) -> list[str]:
    """Writes a header and a source for each class; returns the methods that it had to skip."""
    skipped = []
    for name in api.classes:
        engine_class = _EngineClass(api, name)
        engine_class.read()
        file = snake_case(name)
        output.add_header(f"classes/{file}.hpp", engine_class.header())
        output.add(f"src/classes/{file}.cpp", engine_class.source())
        skipped += engine_class.skipped
    return skipped


class _EngineClass:
    """Writes one class."""

    def __init__(self, api: Api, name: str) -> None:
        self._types = TypeMap(api)
        self._name = name
        self._entry: Json = api.classes[name]
        self._base = str(self._entry.get("inherits") or "Wrapped")
        self._is_singleton = name in api.singletons
        self._complete: set[str] = set()  # Classes whose headers the header needs.
        self._forward: set[str] = set()  # Classes that only the source needs.
        self._members: list[str] = []
        self._virtuals: list[str] = []
        self._definitions: list[str] = []
        self.skipped: list[str] = []

    def read(self) -> None:
        """Collects the members; once."""
        for enum in self._entry.get("enums", []):
            self._members += enum_lines(enum, "\t")
        for constant in self._entry.get("constants", []):
            self._members.append(
                f"\tstatic constexpr int64_t {constant['name']} = {constant['value']};"
            )
        if self._name == "Object":
            self._members += _CAST_TO
        if self._is_singleton:
            self._singleton()
        for method in self._entry.get("methods", []):
            self._method(method)
        self._complete -= {self._name, self._base}
        self._forward -= {self._name, self._base, *self._complete}

    def header(self) -> list[str]:
        """The header."""
        includes = ["classes/wrapped", "classes/global_constants"]
        if self._base != "Wrapped":
            includes.append(f"classes/{snake_case(self._base)}")
        includes += [f"classes/{snake_case(name)}" for name in sorted(self._complete)]
        virtuals = self._virtuals
        if self._base != "Wrapped":
            virtuals = [f"\t\t{self._base}::register_virtuals<T, B>();", *virtuals]
        return [
            *[f"#include <godot_cpp/{include}.hpp>" for include in includes],
            "",
            "namespace godot {",
            "",
            *[f"class {name};" for name in sorted(self._forward)],
            "",
            f"class {self._name} : public {self._base} {{",
            f"\tGDENGINE_CLASS({self._name}, {self._base})",
            "",
            "public:",
            *self._members,
            "",
            "\t/// Tells the engine which virtual methods T has overridden since its parent B.",
            "\ttemplate <class T, class B>",
            "\tstatic void register_virtuals() {",
            *virtuals,
            "\t}",
            "};",
            "",
            "} // namespace godot",
        ]

    def source(self) -> list[str]:
        """The source."""
        used = sorted(self._forward)
        return [
            f"#include <godot_cpp/classes/{snake_case(self._name)}.hpp>",
            "#include <godot_cpp/classes/ref.hpp>",
            *[f"#include <godot_cpp/classes/{snake_case(name)}.hpp>" for name in used],
            "",
            "namespace godot {",
            "",
            f"static const internal::EngineClass<{self._name}> registration;",
            "",
            *self._definitions,
            "} // namespace godot",
        ]

    def _singleton(self) -> None:
        self._members.append(f"\tstatic {self._name} *get_singleton();")
        self._define(
            f"{self._name} *{self._name}::get_singleton()",
            f"static {self._name} *const singleton = "
            f'internal::singleton<{self._name}>("{self._name}");',
            "return singleton;",
        )

    def _method(self, method: Json) -> None:
        try:
            signature = self._types.signature(method)
        except UnsupportedType as error:
            self.skipped.append(f"{self._name}.{method['name']}: {error}")
            return
        for entry in signature.types:
            self._complete |= {entry.owner} - {""}
            self._forward |= {entry.mention} - {""}
        if method["is_virtual"]:
            self._virtual(method, signature)
        elif method["is_vararg"]:
            self._vararg(method, signature)
        else:
            self._plain(method, signature)

    def _define(self, head: str, *body: str) -> None:
        self._definitions += [head + " {", *[f"\t{line}" for line in body], "}", ""]

    def _heads(self, method: Json, signature: Signature) -> tuple[str, str]:
        """The head of the declaration and that of the definition, less `static` and `virtual`."""
        result = signature.result.spelling
        name = identifier(method["name"])
        const = " const" if method["is_const"] else ""
        return (
            f"{result} {name}({signature.declare(with_defaults=True)}){const}",
            f"{result} {self._name}::{name}({signature.declare()}){const}",
        )

    def _lookup(self, method: Json) -> str:
        return (
            "static const auto method = internal::method_bind("
            f'"{self._name}", "{method["name"]}", {method["hash"]});'
        )

    def _plain(self, method: Json, signature: Signature) -> None:
        declaration, definition = self._heads(method, signature)
        self._members.append(f"\t{'static ' if method['is_static'] else ''}{declaration};")
        owner = "nullptr" if method["is_static"] else "_owner"
        arguments = signature.arguments("method", owner)
        self._define(
            definition,
            self._lookup(method),
            f"return internal::ptrcall<{signature.result.spelling}>({arguments});",
        )

    def _virtual(self, method: Json, signature: Signature) -> None:
        declaration, _definition = self._heads(method, signature)
        name = identifier(method["name"])
        result = signature.result
        unnamed = ", ".join(entry.type.declare("") for entry in signature.parameters)
        const = " const" if method["is_const"] else ""
        definition = f"{result.spelling} {self._name}::{name}({unnamed}){const}"
        self._members.append(f"\tvirtual {declaration};")
        value = "nullptr" if result.is_pointer else f"{result.spelling}()"
        self._define(definition, "return;" if result.spelling == "void" else f"return {value};")
        self._virtuals += [
            f"\t\tif constexpr (!std::is_same_v<decltype(&B::{name}), decltype(&T::{name})>) {{",
            f'\t\t\tinternal::bind_virtual<T>("{method["name"]}", &T::{name});',
            "\t\t}",
        ]

    def _vararg(self, method: Json, signature: Signature) -> None:
        """A template packs the arguments into Variants, and a private method makes the call."""
        result = signature.result.spelling
        const = " const" if method["is_const"] else ""
        call = f"_call_{method['name']}(const Variant **p_arguments, int64_t p_count){const}"
        head = signature.declare() + (", " if signature.parameters else "")
        named = "".join(f"Variant({entry.name}), " for entry in signature.parameters)
        self._members += [
            "\ttemplate <class... Arguments>",
            f"\t{result} {identifier(method['name'])}({head}const Arguments &...p_arguments)"
            f"{const} {{",
            # One element too many, because an array can't be empty.
            f"\t\tconst Variant values[] = {{ {named}Variant(p_arguments)..., Variant() }};",
            "\t\tconstexpr size_t count = std::size(values) - 1;",
            "\t\tconst Variant *pointers[count + 1] = {};",
            "\t\tfor (size_t i = 0; i < count; i++) {",
            "\t\t\tpointers[i] = &values[i];",
            "\t\t}",
            f"\t\treturn _call_{method['name']}(pointers, count);",
            "\t}",
            "",
            "private:",
            f"\t{result} {call};",
            "",
            "public:",
        ]
        body = "internal::varcall(method, _owner, p_arguments, p_count)"
        if result != "void":
            body = f"return internal::Traits<{result}>::from_variant({body})"
        self._define(f"{result} {self._name}::{call}", self._lookup(method), body + ";")
