# SPDX-License-Identifier: MIT
"""The engine's dump (extension_api.json) narrowed down to the classes of a build profile."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from .errors import GeneratorError

# Single precision on a 64-bit machine: the only build configuration that is supported.
BUILD_CONFIGURATION = "float_64"

# Builtin types that are plain numbers: written by hand, with native arithmetic.
MATH_TYPES = (
    *("Vector2", "Vector2i", "Vector3", "Vector3i", "Vector4", "Vector4i", "Rect2", "Rect2i"),
    *("Transform2D", "Transform3D", "Basis", "Quaternion", "Projection", "Plane", "AABB", "Color"),
)

# Builtin types that are C++ fundamentals.
SCALAR_TYPES = ("Nil", "bool", "int", "float")

# Needed by the bindings themselves, whatever the profile says.
CORE_CLASSES = ("Object", "RefCounted")

Json = dict[str, Any]


class Api:
    """What the engine offers, and which part of it is wanted."""

    def __init__(self, dump: Json, enabled_classes: list[str]) -> None:
        self.header: Json = dump["header"]
        self.global_enums: list[Json] = dump["global_enums"]
        self.utility_functions: list[Json] = dump["utility_functions"]
        self.singletons = {entry["name"] for entry in dump["singletons"]}
        self.builtins = {
            entry["name"]: entry
            for entry in dump["builtin_classes"]
            if entry["name"] not in SCALAR_TYPES
        }
        self.opaque_types = [name for name in self.builtins if name not in MATH_TYPES]
        self.sizes = _sizes(dump)
        self.native_structures: dict[str, str] = {
            entry["name"]: entry["format"]
            for entry in dump.get("native_structures", [])
            if entry["name"] in enabled_classes
        }
        self._all_classes = {entry["name"]: entry for entry in dump["classes"]}
        classes = [name for name in enabled_classes if name not in self.native_structures]
        self.classes = self._with_parents([*CORE_CLASSES, *classes])
        self._variant_types = {
            value["name"].removeprefix("TYPE_").replace("_", ""): value["name"][5:]
            for value in self.global_enum("Variant.Type")["values"]
        }

    @property
    def version(self) -> str:
        """The engine's full name and version."""
        return str(self.header["version_full_name"])

    def global_enum(self, name: str) -> Json:
        """A global enum by its name in the dump."""
        for entry in self.global_enums:
            if entry["name"] == name:
                return entry
        raise GeneratorError(f"The API dump of {self.version} has no enum {name}.")

    def variant_type(self, builtin: str) -> str:
        """`PackedByteArray` -> `PACKED_BYTE_ARRAY`."""
        return self._variant_types[builtin.upper()]

    def method(self, class_name: str, name: str) -> Json:
        """A method of any engine class, in the profile or not."""
        for entry in self._all_classes.get(class_name, {}).get("methods", []):
            if entry["name"] == name:
                return dict(entry)
        raise GeneratorError(f"{self.version} has no method {class_name}.{name}.")

    def is_ref_counted(self, name: str) -> bool:
        """Whether objects of an engine class live in Ref<T>."""
        return bool(self.classes[name]["is_refcounted"])

    def _with_parents(self, names: list[str]) -> dict[str, Json]:
        """The named classes, each behind its parents."""
        unknown = sorted({name for name in names if name not in self._all_classes})
        if unknown:
            raise GeneratorError(
                f"The build profile names {_listing(unknown)}, but {self.version} has no such "
                "class. Correct enabled_classes in the build profile, or dump the API of the "
                "engine that has it."
            )
        if "ClassDB" in names:
            raise GeneratorError("ClassDB can't be in the build profile: C++ has its own.")
        ordered: dict[str, Json] = {}
        for name in names:
            chain = []
            link: str | None = name
            while link:
                chain.append(link)
                link = self._all_classes[link].get("inherits")
            for member in reversed(chain):
                ordered[member] = self._all_classes[member]
        return ordered


def load_json(path: Path) -> Json:
    """Reads a JSON file, with a plain message where it can't."""
    try:
        return dict(json.loads(path.read_text(encoding="utf-8")))
    except OSError as error:
        raise GeneratorError(f"Can't read {path}: {error.strerror}.") from error
    except (ValueError, TypeError) as error:
        raise GeneratorError(f"{path} is no JSON object: {error}.") from error


def enabled_classes(profile: Json) -> list[str]:
    """The classes and native structures of a build profile in godot-cpp's format."""
    names = profile.get("enabled_classes")
    if not isinstance(names, list) or not all(isinstance(name, str) for name in names):
        raise GeneratorError('The build profile needs "enabled_classes": a list of class names.')
    if profile.get("disabled_classes"):
        raise GeneratorError('"disabled_classes" is not supported: list "enabled_classes" instead.')
    return names


def check_supported(dump: Json) -> None:
    """Refuses dumps of engines that the bindings can't serve."""
    header = dump.get("header", {})
    version = (header.get("version_major", 0), header.get("version_minor", 0))
    if version < (4, 6):
        raise GeneratorError(
            f"The API dump is of Godot {version[0]}.{version[1]}; the bindings need 4.6 or newer."
        )
    if header.get("precision", "single") != "single":
        raise GeneratorError("The API dump is of a double-precision engine: not supported.")


def _sizes(dump: Json) -> dict[str, int]:
    for entry in dump["builtin_class_sizes"]:
        if entry["build_configuration"] == BUILD_CONFIGURATION:
            return {size["name"]: size["size"] for size in entry["sizes"]}
    raise GeneratorError(f"The API dump has no sizes for {BUILD_CONFIGURATION}.")


def _listing(names: list[str]) -> str:
    return ", ".join(f'"{name}"' for name in names)
