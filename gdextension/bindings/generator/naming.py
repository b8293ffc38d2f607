# SPDX-License-Identifier: MIT
"""How the engine's names are spelt in C++: the same as in godot-cpp."""

from __future__ import annotations

import re

_KEYWORDS_TEXT = """
    alignas and asm auto bool break case catch char class const continue default delete do double
    else enum explicit export extern false float for friend goto if inline int long mutable
    namespace new not operator or private protected public register return short signed sizeof
    static struct switch template this throw true try typedef typeid typename typeof union unsigned
    using virtual void volatile while xor
"""
_KEYWORDS = frozenset(_KEYWORDS_TEXT.split())


def snake_case(name: str) -> str:
    """`PhysicsServer3D` -> `physics_server3d`, as godot-cpp names its headers."""
    name = re.sub(r"([a-z0-9])([A-Z])", r"\1_\2", name)
    name = re.sub(r"([A-Z]+)([A-Z][a-z])", r"\1_\2", name)
    for dimension in "234":
        name = name.replace(f"{dimension}_D", f"{dimension}D")
    return name.lower()


def identifier(name: str) -> str:
    """The name itself, or with an underscore behind it where it is a C++ keyword."""
    return name + "_" if name in _KEYWORDS else name


def parameter_name(name: str) -> str:
    """The name of a parameter."""
    return "p_" + name
