# SPDX-License-Identifier: MIT
"""Maps types of the API dump to C++, and says how a value crosses into the engine."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum, auto

from .api import Api, Json
from .errors import UnsupportedType
from .naming import parameter_name

_INT_METADATA = {
    "int8": "int8_t",
    "int16": "int16_t",
    "int32": "int32_t",
    "int64": "int64_t",
    "uint8": "uint8_t",
    "uint16": "uint16_t",
    "uint32": "uint32_t",
    "uint64": "uint64_t",
    "char16": "char16_t",
    "char32": "char32_t",
}


_NUMBERS = {"float", "double", "int", *_INT_METADATA.values()}


def is_plain(structure: str) -> bool:
    """Whether a native structure, as the dump writes it, has numbers alone."""
    fields = [field.split() for field in structure.split(";") if field.strip()]
    return bool(fields) and all(len(field) == 2 and field[0] in _NUMBERS for field in fields)


class Kind(Enum):
    """Families of types that cross into the engine in the same way."""

    VOID = auto()
    BOOL = auto()
    INTEGER = auto()
    FLOAT = auto()
    VALUE = auto()
    OBJECT = auto()
    REF = auto()
    POINTER = auto()  # To plain memory; virtuals alone have such parameters here.


@dataclass(frozen=True)
class CppType:
    """A C++ type that a bound signature uses."""

    kind: Kind
    spelling: str
    engine_class: str = ""  # The engine class that it mentions, if any.
    structure: str = ""  # The native structure that it points to, if any.

    def parameter(self, name: str) -> str:
        """Declares a parameter."""
        if self.kind in (Kind.VALUE, Kind.REF):
            return f"const {self.spelling} &{name}"
        return f"{self.spelling}{'' if self.spelling.endswith('*') else ' '}{name}"

    def returning(self, name: str) -> str:
        """The head of a function that returns it."""
        return f"{self.spelling}{'' if self.spelling.endswith('*') else ' '}{name}"

    def encode(self, name: str) -> tuple[str, str]:
        """A statement that widens an argument (or nothing), and the pointer to hand over."""
        wide = {
            Kind.BOOL: f"GDExtensionBool {name}_raw = {name};",
            Kind.INTEGER: f"int64_t {name}_raw = int64_t({name});",
            Kind.FLOAT: f"double {name}_raw = {name};",
            Kind.OBJECT: f"GDExtensionConstObjectPtr {name}_raw = internal::owner({name});",
            Kind.REF: f"GDExtensionConstObjectPtr {name}_raw = internal::owner({name}.ptr());",
        }
        if self.kind is Kind.VALUE or self.spelling in ("int64_t", "double"):
            return "", f"&{name}"
        return f"const {wide[self.kind]}", f"&{name}_raw"

    def result(self) -> tuple[str, str]:
        """A statement that declares where the engine puts the result, and the value to return."""
        if self.kind is Kind.BOOL:
            return "GDExtensionBool result = false;", "result != 0"
        if self.kind is Kind.INTEGER:
            return "int64_t result = 0;", f"static_cast<{self.spelling}>(result)"
        if self.kind is Kind.FLOAT:
            return "double result = 0.0;", f"static_cast<{self.spelling}>(result)"
        if self.kind is Kind.OBJECT:
            return (
                "GDExtensionObjectPtr result = nullptr;",
                f"internal::wrap<{self.engine_class}>(result)",
            )
        if self.kind is Kind.REF:
            # The engine hands over one reference, which the Ref adopts.
            return (
                "GDExtensionObjectPtr result = nullptr;",
                f"{self.spelling}::adopt(internal::wrap<{self.engine_class}>(result))",
            )
        return f"{self.spelling} result;", "result"


@dataclass(frozen=True)
class Parameter:
    """A parameter of a bound method."""

    type: CppType
    name: str
    default: str | None  # As the dump writes it.

    def declare(self) -> str:
        """The parameter without its default."""
        return self.type.parameter(self.name)


class TypeMap:
    """Finds the C++ type of anything that the dump names."""

    def __init__(self, api: Api) -> None:
        self._api = api

    def find(self, name: str, meta: str | None = None) -> CppType:
        """The C++ type; UnsupportedType where there is none."""
        if name == "int":
            return CppType(Kind.INTEGER, _INT_METADATA.get(meta or "", "int64_t"))
        if name == "float":
            return CppType(Kind.FLOAT, "float" if meta == "float" else "double")
        if name == "bool":
            return CppType(Kind.BOOL, "bool")
        if name == "Variant" or name in self._api.builtins:
            return CppType(Kind.VALUE, name)
        if name.startswith(("enum::", "bitfield::")):
            return self._enum(name)
        if name.startswith("typedarray::"):
            return self._typed_array(name.removeprefix("typedarray::"))
        if name in self._api.classes:
            if self._api.is_ref_counted(name):
                return CppType(Kind.REF, f"Ref<{name}>", name)
            return CppType(Kind.OBJECT, f"{name} *", name)
        if name.endswith("*"):
            return self._pointer(name)
        raise UnsupportedType(name)

    def result(self, method: Json) -> CppType:
        """The type that a method of a class, a builtin or a utility function returns."""
        if "return_value" in method:
            value = method["return_value"]
            return self.find(value["type"], value.get("meta"))
        if "return_type" in method:
            return self.find(method["return_type"])
        return CppType(Kind.VOID, "void")

    def parameters(self, method: Json) -> list[Parameter]:
        """The parameters of a method."""
        return [
            Parameter(
                self.find(entry["type"], entry.get("meta")),
                parameter_name(entry["name"]),
                entry.get("default_value"),
            )
            for entry in method.get("arguments", [])
        ]

    def _pointer(self, name: str) -> CppType:
        """A pointer to memory or to a native structure of numbers."""
        target = name.removesuffix("*").strip()
        spelling = f"{target} *"
        plain = target.removeprefix("const ").strip()
        if plain == "void":
            return CppType(Kind.POINTER, spelling)
        if is_plain(self._api.native_structures.get(plain, "")):
            return CppType(Kind.POINTER, spelling, structure=plain)
        raise UnsupportedType(name)

    def _enum(self, name: str) -> CppType:
        prefix, _, qualified = name.partition("::")
        owner = qualified.rpartition(".")[0]
        is_class = owner in self._api.classes
        if owner and not is_class and owner != "Variant" and owner not in self._api.builtins:
            raise UnsupportedType(name)
        spelling = qualified.replace(".", "::")
        if prefix == "bitfield":
            spelling = f"BitField<{spelling}>"
        return CppType(Kind.INTEGER, spelling, owner if is_class else "")

    def _typed_array(self, element: str) -> CppType:
        # Hints such as "24/17:Shape3D" or nested dictionaries have no C++ element type.
        if element not in self._api.classes and element not in self._api.builtins:
            if element in ("int", "float", "bool"):
                spelling = {"int": "int64_t", "float": "double", "bool": "bool"}[element]
                return CppType(Kind.VALUE, f"TypedArray<{spelling}>")
            raise UnsupportedType(element)
        owner = element if element in self._api.classes else ""
        return CppType(Kind.VALUE, f"TypedArray<{element}>", owner)
