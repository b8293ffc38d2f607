# SPDX-License-Identifier: MIT
"""Maps types, parameters and default values of the API dump to C++."""

from __future__ import annotations

import re
from dataclasses import dataclass

from .api import Api, Json
from .errors import UnsupportedType
from .naming import parameter_name

_INTEGERS = {
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
_ELEMENT_SCALARS = {"bool": "bool", "int": "int64_t", "float": "double"}


@dataclass(frozen=True)
class CppType:
    """A C++ type of a bound signature."""

    spelling: str
    by_reference: bool = False  # Passed as a const reference, otherwise by value.
    is_enum: bool = False
    owner: str = ""  # The engine class whose header must be complete: the owner of an enum.
    mention: str = ""  # The engine class that needs no more than a forward declaration.

    @property
    def is_pointer(self) -> bool:
        """Whether it is a plain pointer to an engine object."""
        return self.spelling.endswith("*")

    def declare(self, name: str) -> str:
        """Declares a parameter."""
        if self.by_reference:
            return f"const {self.spelling} &{name}"
        return f"{self.spelling}{'' if self.is_pointer else ' '}{name}"


VOID = CppType("void")


@dataclass(frozen=True)
class Parameter:
    """A parameter of a bound method."""

    type: CppType
    name: str
    default: str | None = None  # As the dump writes it.

    def declare(self, with_default: bool = False) -> str:
        """`const String &p_name = "x"`."""
        text = self.type.declare(self.name)
        if with_default and self.default is not None:
            text += " = " + default_expression(self.default, self.type)
        return text


@dataclass(frozen=True)
class Signature:
    """Result and parameters of a bound method."""

    result: CppType
    parameters: list[Parameter]

    def declare(self, with_defaults: bool = False) -> str:
        """The parameter list."""
        return ", ".join(entry.declare(with_defaults) for entry in self.parameters)

    def arguments(self, *leading: str) -> str:
        """The argument list of a call that hands the parameters on, behind other arguments."""
        return ", ".join([*leading, *(entry.name for entry in self.parameters)])

    @property
    def types(self) -> list[CppType]:
        """Every type that the signature mentions."""
        return [self.result, *(entry.type for entry in self.parameters)]


class TypeMap:
    """Finds the C++ type of anything that the dump names."""

    def __init__(self, api: Api) -> None:
        self._api = api

    def find(self, name: str, meta: str | None = None) -> CppType:
        """The C++ type; UnsupportedType where there is none."""
        if name == "int":
            return CppType(_INTEGERS.get(meta or "", "int64_t"))
        if name == "float":
            return CppType("float" if meta == "float" else "double")
        if name == "bool":
            return CppType("bool")
        if name == "Variant" or name in self._api.builtins:
            return CppType(name, by_reference=True)
        if name.startswith(("enum::", "bitfield::")):
            return self._enum(name)
        if name.startswith("typedarray::"):
            return self._typed_array(name.removeprefix("typedarray::"))
        if name in self._api.classes:
            if self._api.is_ref_counted(name):
                return CppType(f"Ref<{name}>", by_reference=True, mention=name)
            return CppType(f"{name} *", mention=name)
        raise UnsupportedType(name)

    def signature(self, method: Json) -> Signature:
        """The signature of a method of a class or a builtin, or of a utility function."""
        result = VOID
        if "return_value" in method:
            value = method["return_value"]
            result = self.find(value["type"], value.get("meta"))
        elif "return_type" in method:
            result = self.find(method["return_type"])
        parameters = [
            Parameter(
                self.find(entry["type"], entry.get("meta")),
                parameter_name(entry["name"]),
                entry.get("default_value"),
            )
            for entry in method.get("arguments", [])
        ]
        return Signature(result, parameters)

    def _enum(self, name: str) -> CppType:
        prefix, _, qualified = name.partition("::")
        owner = qualified.rpartition(".")[0]
        is_class = owner in self._api.classes
        if owner and not is_class and owner != "Variant" and owner not in self._api.builtins:
            raise UnsupportedType(name)
        spelling = qualified.replace(".", "::")
        if prefix == "bitfield":
            spelling = f"BitField<{spelling}>"
        return CppType(spelling, is_enum=True, owner=owner if is_class else "")

    def _typed_array(self, element: str) -> CppType:
        if element in _ELEMENT_SCALARS:
            return CppType(f"TypedArray<{_ELEMENT_SCALARS[element]}>", by_reference=True)
        if element in self._api.builtins:
            return CppType(f"TypedArray<{element}>", by_reference=True)
        if element in self._api.classes:
            return CppType(f"TypedArray<{element}>", by_reference=True, mention=element)
        # Such as "24/17:Shape3D", or a class that the profile leaves out.
        return CppType("Array", by_reference=True)


def default_expression(value: str, cpp: CppType) -> str:
    """From the dump's notation to C++: `&"Master"` -> `"Master"`, `null` -> `nullptr`, ..."""
    if value == "null":
        return "nullptr" if cpp.is_pointer else f"{cpp.spelling}()"
    if value in ("[]", "{}") or value.startswith(("Array[", "Dictionary[")):
        return f"{cpp.spelling}()"
    if value.startswith(('&"', '^"')):
        return value[1:]
    if value.startswith(("Transform2D(", "Transform3D(", "Basis(")):
        # The dump writes the identity number by number; it is what the constructor makes.
        return f"{cpp.spelling}()"
    if cpp.is_enum:
        enum = re.sub(r"^BitField<(.*)>$", r"\1", cpp.spelling)
        return f"static_cast<{enum}>({value})"
    if re.fullmatch(r"-?\d+", value) and cpp.by_reference and cpp.spelling != "Variant":
        return f"{cpp.spelling}({value})"
    return value
