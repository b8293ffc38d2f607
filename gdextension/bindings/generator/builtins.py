# SPDX-License-Identifier: MIT
"""Builtin types that only the engine can handle: strings, containers, RID, Callable, Signal."""

from __future__ import annotations

from .api import Api, Json
from .calls import call_body, function, vararg_parameters, vararg_template
from .defaults import declare_all, default_expression
from .enums import enum_lines
from .errors import UnsupportedType
from .naming import identifier, snake_case
from .output import Output
from .type_map import Parameter, TypeMap

_OPERATORS = {
    "==": "EQUAL",
    "!=": "NOT_EQUAL",
    "<": "LESS",
    "<=": "LESS_EQUAL",
    ">": "GREATER",
    ">=": "GREATER_EQUAL",
    "+": "ADD",
    "%": "MODULE",
}

# The rest of StringName's methods are String's: convert, and call them there.
_STRING_NAME_METHODS = ("length", "is_empty", "hash")

# Types with further members in include/godot_cpp/variant/<type>_members.inc.
_WITH_MEMBERS = ("String", "StringName", "NodePath", "Array", "Dictionary")

_PACKED_ELEMENTS = {
    "PackedByteArray": "uint8_t",
    "PackedInt32Array": "int32_t",
    "PackedInt64Array": "int64_t",
    "PackedFloat32Array": "float",
    "PackedFloat64Array": "double",
}


class BuiltinWriter:
    """Writes one builtin type: lines of its class, of its source, of its templates."""

    def __init__(self, api: Api, types: TypeMap, name: str) -> None:
        self._types = types
        self._entry: Json = api.builtins[name]
        self._type_enum = f"GDEXTENSION_VARIANT_TYPE_{api.variant_type(name)}"
        self._size = api.sizes[name]
        self._variant_type = api.variant_type
        self.name = name
        self.header: list[str] = []
        self.source: list[str] = []
        self.templates: list[str] = []
        self._constructors: list[int] = []
        self._methods: list[Json] = []
        self._tables = f"{snake_case(name)}_tables"
        self._operators: list[tuple[str, str]] = []

    def write(self) -> None:
        """Fills header, source and templates."""
        self.header += [f"class {self.name} {{", "public:"]
        for entry in self._entry.get("enums", []):
            self.header += enum_lines(entry, "\t")
        self.header.append(f"\talignas(8) uint8_t opaque[{self._size}] = {{}};")
        self.header += ["", f"\texplicit {self.name}(internal::Uninitialized) {{}}"]
        for constructor in self._entry["constructors"]:
            self._constructor(constructor)
        self._life_cycle()
        for operator in self._entry.get("operators", []):
            self._operator(operator)
        for method in self._entry.get("methods", []):
            if self.name != "StringName" or method["name"] in _STRING_NAME_METHODS:
                self._method(method)
        if self.name.startswith("Packed"):
            self._packed_access()
        if self.name in _WITH_MEMBERS:
            self.header.append(f"#include <godot_cpp/variant/{snake_case(self.name)}_members.inc>")
        self.header += ["};", ""]

    def _constructor(self, entry: Json) -> None:
        try:
            parameters = self._types.parameters(entry)
        except UnsupportedType:
            return
        slot = len(self._constructors)
        self._constructors.append(entry["index"])
        head = f"{self.name}({declare_all(parameters)})"
        self.header.append(f"\t{head};")
        body = []
        pointers = []
        for parameter in parameters:
            statement, pointer = parameter.type.encode(parameter.name)
            body += [f"\t{statement}"] if statement else []
            pointers.append(pointer)
        arguments = "nullptr"
        if pointers:
            body.append(f"\tconst void *arguments[] = {{ {', '.join(pointers)} }};")
            arguments = "arguments"
        body.append(f"\t{self._tables}::constructors[{slot}].function(opaque, {arguments});")
        self.source += function(f"{self.name}::{head}", body)

    def _life_cycle(self) -> None:
        name = self.name
        if not self._entry["has_destructor"]:
            self.header.append(f"\t{name} &operator=(const {name} &p_other) = default;")
            return
        self.header += [
            f"\t{name}({name} &&p_other) noexcept {{ std::swap(opaque, p_other.opaque); }}",
            f"\t~{name}();",
            f"\t{name} &operator=(const {name} &p_other);",
            f"\t{name} &operator=({name} &&p_other) noexcept {{",
            "\t\tstd::swap(opaque, p_other.opaque);",
            "\t\treturn *this;",
            "\t}",
        ]
        self.source += function(f"{name}::~{name}()", [f"\t{self._tables}::destructor(opaque);"])
        copy = [f"\t{name} copy(p_other);", "\tstd::swap(opaque, copy.opaque);", "\treturn *this;"]
        self.source += function(f"{name} &{name}::operator=(const {name} &p_other)", copy)

    def _operator(self, entry: Json) -> None:
        right = entry.get("right_type")
        formats = self.name == "String" and entry["name"] == "%" and right == "Array"
        if entry["name"] not in _OPERATORS or (right != self.name and not formats):
            return
        if entry["name"] == "%" and not formats:
            return
        slot = len(self._operators)
        self._operators.append((_OPERATORS[entry["name"]], right))
        result = self._types.find(entry["return_type"])
        declaration, value = result.result()
        head = f"operator{entry['name']}(const {right} &p_other) const"
        self.header.append(f"\t{result.spelling} {head};")
        self.source += function(
            f"{result.spelling} {self.name}::{head}",
            [
                f"\t{declaration}",
                f"\t{self._tables}::operators[{slot}].function(opaque, p_other.opaque, &result);",
                f"\treturn {value};",
            ],
        )

    def _method(self, entry: Json) -> None:
        try:
            parameters = self._types.parameters(entry)
            result = self._types.result(entry)
        except UnsupportedType:
            return
        self._methods.append(entry)
        name = identifier(entry["name"])
        const = " const" if entry["is_const"] else ""
        base = "nullptr" if entry["is_static"] else "const_cast<uint8_t *>(opaque)"
        method = f"{self._tables}::methods[{self._tables}::m_{entry['name']}].function"
        if entry["is_vararg"]:
            self._vararg(entry, parameters, result.spelling, method)
            return
        self._variant_default(name, const, parameters, result.spelling)
        static = "static " if entry["is_static"] else ""
        # Variant is incomplete in this header: its defaults are overloads.
        shown = [p if p.type.spelling != "Variant" else _without_default(p) for p in parameters]
        self.header.append(f"\t{static}{result.spelling} {name}({declare_all(shown)}){const};")
        self.source += function(
            f"{result.spelling} {self.name}::{name}({declare_all(parameters, False)}){const}",
            call_body(
                result,
                parameters,
                lambda args, into: f"{method}({base}, {args}, {into}, {len(parameters)});",
            ),
        )

    def _variant_default(
        self, name: str, const: str, parameters: list[Parameter], result: str
    ) -> None:
        if not parameters or parameters[-1].type.spelling != "Variant":
            return
        last = parameters[-1]
        if last.default is None:
            return
        kept = parameters[:-1]
        head = f"{name}({declare_all(kept, False)}){const}"
        names = ", ".join([p.name for p in kept] + [default_expression(last.default, last.type)])
        self.header.append(f"\t{result} {head};")
        self.source += function(
            f"{result} {self.name}::{head}",
            [f"\t{'' if result == 'void' else 'return '}{name}({names});"],
        )

    def _vararg(self, entry: Json, parameters: list[Parameter], result: str, method: str) -> None:
        name = identifier(entry["name"])
        const = " const" if entry["is_const"] else ""
        head = f"{name}({vararg_parameters(parameters)}){const}"
        inner = f"{name}_vararg(const void *const *p_arguments, int64_t p_count){const}"
        give = "" if result == "void" else "return "
        self.header += [
            "\ttemplate <class... Arguments>",
            f"\t{result} {head};",
            f"\t{result} {inner};",
        ]
        # The template needs the complete Variant: it goes into a header behind it.
        lines = vararg_template(
            f"{result} {self.name}::{head}", parameters, f"{give}{name}_vararg(pointers, count);"
        )
        self.templates += [*[line.removeprefix("\t") for line in lines], ""]
        body = [
            f"\t{method}(const_cast<uint8_t *>(opaque), p_arguments, "
            f"{'nullptr' if result == 'void' else '&result'}, int(p_count));"
        ]
        if result != "void":
            body = [f"\t{result} result;", *body, "\treturn result;"]
        self.source += function(f"{result} {self.name}::{inner}", body)

    def _packed_access(self) -> None:
        element = _PACKED_ELEMENTS.get(self.name, self.name[len("Packed") : -len("Array")])
        index = f"internal::engine.{snake_case(self.name)}_operator_index"
        read = f"static_cast<const {element} *>({index}_const(opaque, p_index))"
        write = f"static_cast<{element} *>({index}(opaque, p_index))"
        self.header += [
            f"\t{self.name}(std::initializer_list<{element}> p_elements);",
            f"\t/// The first of the elements; null when there are none. `{self.name}` must not be",
            "\t/// resized while the pointer is in use.",
            f"\tconst {element} *ptr() const {{ return {read.replace('p_index', '0')}; }}",
            f"\t{element} *ptrw() {{ return {write.replace('p_index', '0')}; }}",
            f"\tconst {element} &operator[](int64_t p_index) const {{ return *{read}; }}",
            f"\t{element} &operator[](int64_t p_index) {{ return *{write}; }}",
            f"\tconst {element} *begin() const {{ return ptr(); }}",
            f"\tconst {element} *end() const {{ return ptr() + size(); }}",
        ]
        self.source += function(
            f"{self.name}::{self.name}(std::initializer_list<{element}> p_elements) :\n"
            f"\t\t{self.name}()",
            [
                "\tresize(int64_t(p_elements.size()));",
                "\tstd::copy(p_elements.begin(), p_elements.end(), ptrw());",
            ],
        )

    def source_lines(self) -> list[str]:
        """The whole source file."""
        operators = [
            f"\t{{ GDEXTENSION_VARIANT_OP_{operator}, "
            f"GDEXTENSION_VARIANT_TYPE_{self._variant_type(right)}, nullptr }},"
            for operator, right in self._operators
        ]
        has_destructor = self._entry["has_destructor"]
        destructor = f"&{self._tables}::destructor" if has_destructor else "nullptr"
        return [
            "#include <godot_cpp/classes/object.hpp>",
            "#include <godot_cpp/core/binding_tables.hpp>",
            "#include <godot_cpp/variant/variant.hpp>",
            "",
            "#include <algorithm>",
            "",
            "namespace godot {",
            "",
            # Named, because several sources are compiled as one.
            f"namespace {self._tables} {{",
            "",
            "namespace {",
            "",
            *_method_table("BuiltinMethod", self._methods),
            "internal::BuiltinConstructor constructors[] = {",
            *[f"\t{{ {index}, nullptr }}," for index in self._constructors],
            "};",
            "",
            "internal::BuiltinOperator operators[] = {",
            *operators,
            "};",
            "",
            "[[maybe_unused]] GDExtensionPtrDestructor destructor = nullptr;",
            "",
            "} // namespace",
            "",
            f"}} // namespace {self._tables}",
            "",
            *self.source,
            f"extern const internal::BuiltinTable {table_name(self.name)};",
            f"const internal::BuiltinTable {table_name(self.name)} = {{",
            f'\t{self._type_enum}, "{self.name}", internal::span({self._tables}::constructors),',
            f"\tinternal::span({self._tables}::methods),",
            f"\tinternal::span({self._tables}::operators),",
            f"\t{destructor},",
            "};",
            "",
            "} // namespace godot",
        ]


def table_name(builtin: str) -> str:
    """The name of a type's table of engine functions."""
    return f"{snake_case(builtin)}_table"


def _method_table(kind: str, methods: list[Json]) -> list[str]:
    return [
        "enum Method : size_t {",
        *[f"\tm_{method['name']}," for method in methods],
        "};",
        "",
        f"internal::{kind} methods[] = {{",
        *[f'\t{{ "{method["name"]}", {method["hash"]}, nullptr }},' for method in methods],
        "};",
        "",
    ]


def _without_default(parameter: Parameter) -> Parameter:
    return Parameter(parameter.type, parameter.name, None)


def generate(api: Api, types: TypeMap, output: Output) -> None:
    """Writes builtin_types.hpp with all of them, a source for each, and short-hand headers."""
    header: list[str] = [f"class {name};" for name in api.opaque_types] + [""]
    templates: list[str] = []
    for name in api.opaque_types:
        writer = BuiltinWriter(api, types, name)
        writer.write()
        header += writer.header
        templates += writer.templates
        output.add(f"src/variant/{snake_case(name)}.cpp", writer.source_lines())
        output.add_header(
            f"variant/{snake_case(name)}.hpp", ["#include <godot_cpp/variant/variant.hpp>"]
        )
    output.add("include/godot_cpp/variant/builtin_types.inc", header)
    output.add("include/godot_cpp/variant/builtin_varargs.inc", templates)
    output.add("include/godot_cpp/variant/variant_conversions.inc", _conversions(api))
    output.add("include/godot_cpp/variant/builtin_traits.inc", _traits(api))


def _conversions(api: Api) -> list[str]:
    """Members of Variant: a constructor and a conversion for each builtin type."""
    lines = []
    for name in api.builtins:
        kind = f"GDEXTENSION_VARIANT_TYPE_{api.variant_type(name)}"
        start = "(internal::uninitialized)" if name in api.opaque_types else ""
        # Qualified, because Variant::AABB and the like are enumerators.
        lines += [
            f"\tVariant(const ::godot::{name} &p_value) {{",
            f"\t\tinternal::make_variant({kind}, opaque, &p_value);",
            "\t}",
            f"\toperator ::godot::{name}() const {{",
            f"\t\t::godot::{name} value{start};",
            f"\t\tinternal::read_variant({kind}, &value, opaque);",
            "\t\treturn value;",
            "\t}",
            "",
        ]
    return lines


def _traits(api: Api) -> list[str]:
    lines = []
    for name in api.builtins:
        lines += [
            "template <>",
            f"struct BuiltinType<{name}> {{",
            "\tstatic constexpr GDExtensionVariantType type = "
            f"GDEXTENSION_VARIANT_TYPE_{api.variant_type(name)};",
            f'\tstatic constexpr const char *name = "{name}";',
            "};",
            "",
        ]
    return lines
