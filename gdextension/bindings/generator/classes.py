# SPDX-License-Identifier: MIT
"""Engine classes: a header and a source for each."""

from __future__ import annotations

from .api import Api, Json
from .calls import call_body, function, vararg_parameters, vararg_template
from .defaults import declare_all
from .enums import cast_lines, enum_lines
from .errors import UnsupportedType
from .naming import identifier, snake_case
from .output import Output
from .type_map import CppType, Kind, Parameter, TypeMap

# godot-cpp gives the plain name to a template that casts.
_RENAMED = {("Node", "get_node"): "get_node_internal"}

_CAST_TO = [
    "\ttemplate <class T>",
    "\tstatic T *cast_to(Object *p_object) { return dynamic_cast<T *>(p_object); }",
    "\ttemplate <class T>",
    "\tstatic const T *cast_to(const Object *p_object) {",
    "\t\treturn dynamic_cast<const T *>(p_object);",
    "\t}",
    "",
]
_GET_NODE = [
    "\ttemplate <class T>",
    "\tT *get_node(const NodePath &p_path) const {",
    "\t\treturn Object::cast_to<T>(get_node_internal(p_path));",
    "\t}",
    "",
]
_HAND_WRITTEN = {"Object": _CAST_TO, "Node": _GET_NODE}


class ClassWriter:
    """Writes one engine class."""

    def __init__(self, api: Api, types: TypeMap, name: str) -> None:
        self._types = types
        self._entry = api.classes[name]
        self._singleton = name in api.singletons
        self.name = name
        self.parent = self._entry.get("inherits") or "Wrapped"
        self.skipped = 0
        self._body: list[str] = []
        self._source: list[str] = []
        self._virtuals: list[str] = []
        self._methods: list[Json] = []
        self._tables = f"{snake_case(name)}_tables"
        self._mentioned: set[str] = set()
        self._included: set[str] = set()
        self.structures: set[str] = set()
        self._has_ref_default = False

    def write(self) -> None:
        """Fills body and source."""
        for entry in self._entry.get("enums", []):
            self._body += enum_lines(entry, "\t")
        for entry in self._entry.get("constants", []):
            self._body.append(f"\tstatic constexpr int {entry['name']} = {entry['value']};")
        self._body += _HAND_WRITTEN.get(self.name, [])
        if self._singleton:
            self._add_singleton()
        for method in self._entry.get("methods", []):
            try:
                parameters = self._types.parameters(method)
                result = self._types.result(method)
            except UnsupportedType:
                self.skipped += 1
                continue
            used = [*[p.type for p in parameters], result]
            if not method["is_virtual"] and any(cpp.kind is Kind.POINTER for cpp in used):
                self.skipped += 1
                continue
            self._note_classes(used)
            self._add_method(method, parameters, result)

    def _note_classes(self, used: list[CppType]) -> None:
        for cpp in used:
            if cpp.structure:
                self.structures.add(cpp.structure)
            if cpp.engine_class in ("", self.name):
                continue
            # An enum needs its class; a pointer or Ref only a declaration of it.
            enum = cpp.kind is Kind.INTEGER
            (self._included if enum else self._mentioned).add(cpp.engine_class)

    def _add_singleton(self) -> None:
        self._body.append(f"\tstatic {self.name} *get_singleton();")
        self._source += function(
            f"{self.name} *{self.name}::get_singleton()",
            [
                f"\tstatic {self.name} *singleton = internal::singleton<{self.name}>"
                f'("{self.name}");',
                "\treturn singleton;",
            ],
        )

    def _add_method(self, method: Json, parameters: list[Parameter], result: CppType) -> None:
        name = _RENAMED.get((self.name, method["name"]), identifier(method["name"]))
        const = " const" if method["is_const"] else ""
        if method["is_virtual"]:
            self._add_virtual(name, method["name"], const, parameters, result)
            return
        self._methods.append(method)
        # A default is an object, which takes more than a declaration of its class.
        for parameter in parameters:
            if parameter.default is not None and parameter.type.kind is Kind.REF:
                self._included.add(parameter.type.engine_class)
                self._has_ref_default = True
        if method["is_vararg"]:
            self._add_vararg(name, method, parameters, result)
            return
        static = "static " if method["is_static"] else ""
        owner = "nullptr" if method["is_static"] else "_owner"
        bind = self._bind(method)
        full_name = f"{self.name}::{name}"
        self._body.append(f"\t{static}{result.returning(name)}({declare_all(parameters)}){const};")
        self._source += function(
            f"{result.returning(full_name)}({declare_all(parameters, False)}){const}",
            call_body(
                result, parameters, lambda args, into: f"{bind}.ptrcall({owner}, {args}, {into});"
            ),
        )

    def _add_virtual(
        self, name: str, api_name: str, const: str, parameters: list[Parameter], result: CppType
    ) -> None:
        self._body.append(f"\tvirtual {result.returning(name)}({declare_all(parameters)}){const};")
        unnamed = ", ".join(parameter.type.parameter("").rstrip() for parameter in parameters)
        body = [] if result.kind is Kind.VOID else ["\treturn {};"]
        full_name = f"{self.name}::{name}"
        self._source += function(f"{result.returning(full_name)}({unnamed}){const}", body)
        self._virtuals += [
            f"\t\tif constexpr (!std::is_same_v<decltype(&Base::{name}), "
            f"decltype(&Class::{name})>) {{",
            f'\t\t\tinternal::add_virtual<Class>("{api_name}", &Class::{name});',
            "\t\t}",
        ]

    def _bind(self, method: Json) -> str:
        """The engine's function that a method calls."""
        return f"{self._tables}::methods[{self._tables}::m_{method['name']}]"

    def _add_vararg(
        self, name: str, method: Json, parameters: list[Parameter], result: CppType
    ) -> None:
        const = " const" if method["is_const"] else ""
        give = "" if result.kind is Kind.VOID else "return "
        head = f"{result.spelling} {name}({vararg_parameters(parameters)}){const}"
        self._body += vararg_template(head, parameters, f"{give}{name}_vararg(pointers, count);")
        inner = f"{name}_vararg(const void *const *p_arguments, int64_t p_count){const}"
        self._body.append(f"\t{result.spelling} {inner};")
        call = f"{self._bind(method)}.call(_owner, p_arguments, p_count)"
        if result.kind is Kind.VOID:
            body = [f"\t{call};"]
        elif result.kind is Kind.INTEGER:
            body = [f"\treturn static_cast<{result.spelling}>(int64_t({call}));"]
        else:
            body = [f"\treturn {call};"]
        self._source += function(f"{result.spelling} {self.name}::{inner}", body)

    def header_lines(self) -> list[str]:
        """The whole header."""
        includes = ["classes/global_constants.hpp", "classes/wrapped.hpp", "variant/variant.hpp"]
        includes += [f"classes/{snake_case(used)}.hpp" for used in sorted(self._included)]
        if self._has_ref_default:
            includes.append("classes/ref.hpp")
        if any("TypedArray<" in line for line in self._body):
            includes.append("variant/typed_array.hpp")
        if self.parent != "Wrapped":
            includes.append(f"classes/{snake_case(self.parent)}.hpp")
        includes += [f"classes/{snake_case(used)}.hpp" for used in sorted(self.structures)]
        forward = sorted(self._mentioned - self._included - {self.parent})
        inherited = f"\t\t{self.parent}::register_virtuals<Class, Base>();"
        return [
            *[f"#include <godot_cpp/{include}>" for include in sorted(set(includes))],
            "",
            "namespace godot {",
            "",
            *[f"class {name};" for name in forward],
            "",
            f"class {self.name} : public {self.parent} {{",
            f"\tGODOT_ENGINE_CLASS({self.name}, {self.parent})",
            "",
            "public:",
            *self._body,
            "",
            "protected:",
            "\ttemplate <class Class, class Base>",
            "\tstatic void register_virtuals() {",
            inherited,
            *self._virtuals,
            "\t}",
            "};",
            "",
            "} // namespace godot",
            "",
            *cast_lines(self.name, self._entry.get("enums", [])),
        ]

    def source_lines(self) -> list[str]:
        """The whole source file."""
        used = sorted(self._mentioned | self._included | {self.name})
        methods = self._methods
        return [
            *[f"#include <godot_cpp/classes/{snake_case(name)}.hpp>" for name in used],
            "#include <godot_cpp/classes/ref.hpp>",
            "#include <godot_cpp/core/binding_tables.hpp>",
            "",
            "namespace godot {",
            "",
            # Named, because several sources are compiled as one.
            f"namespace {self._tables} {{",
            "",
            "namespace {",
            "",
            "enum Method : size_t {",
            *[f"\tm_{method['name']}," for method in methods],
            "\tmethod_count,",
            "};",
            "",
            # One entry too many, because an array can't be empty.
            "internal::MethodBind methods[method_count + 1] = {",
            *[f'\t{{ "{method["name"]}", {method["hash"]}, nullptr }},' for method in methods],
            "};",
            "",
            "} // namespace",
            "",
            f"}} // namespace {self._tables}",
            "",
            *self._source,
            "internal::EngineClass &" + f"{self.name}::engine_class() {{",
            "\tstatic internal::EngineClass instance = {",
            f'\t\t"{self.name}", internal::wrapper_callbacks<{self.name}>(), '
            f"{{ {self._tables}::methods, {self._tables}::method_count }},",
            "\t};",
            "\treturn instance;",
            "}",
            "",
            "} // namespace godot",
        ]


def structure_lines(name: str, format: str) -> list[str]:
    """The header of a native structure."""
    fields = [f"\t{field.strip()} = 0;" for field in format.split(";") if field.strip()]
    head = ["#include <cstdint>", "", "namespace godot {", ""]
    return [*head, f"struct {name} {{", *fields, "};", "", "} // namespace godot"]


def generate(api: Api, types: TypeMap, output: Output) -> tuple[int, int]:
    """Writes all classes; returns how many methods were written and skipped."""
    written = 0
    skipped = 0
    structures: set[str] = set()
    for name in api.classes:
        writer = ClassWriter(api, types, name)
        writer.write()
        structures |= writer.structures
        file = snake_case(name)
        output.add_header(f"classes/{file}.hpp", writer.header_lines())
        output.add(f"src/classes/{file}.cpp", writer.source_lines())
        written += len(api.classes[name].get("methods", [])) - writer.skipped
        skipped += writer.skipped
    for name in sorted(structures):
        lines = structure_lines(name, api.native_structures[name])
        output.add_header(f"classes/{snake_case(name)}.hpp", lines)
    return written, skipped
