# SPDX-License-Identifier: MIT
"""The gate for the order of methods says which one stands wrong, and only then."""

from __future__ import annotations

import pytest
from toolchain.method_order import find_fault


@pytest.mark.parametrize(
    "methods",
    [
        "",
        "func a()",
        "func _a()",
        "static func make()|func _init()|func _ready()|func a()|func _b()|static func _c()",
        "func a()|static func make()|func _process(_delta: float)|func _b()",
        "static func make()|static func _c()",
        "class Inner:\n\tfunc _x() -> void:\n\t\tpass|func a()",
        "func _b()|class Inner:\n\tfunc x() -> void:\n\t\tpass",
        "@abstract func a()|@rpc('any_peer') func b()|func _c()",
        "# func _a()|func b()",
        "var f: Callable = func() -> void: pass|func b()",
    ],
)
def test_public_before_private_is_in_order(methods: str) -> None:
    assert find_fault("\n\n\n".join(methods.split("|"))) == ""


@pytest.mark.parametrize(
    ("methods", "wrong"),
    [
        ("func _b()|func a()", "4: a() comes after _b()"),
        ("func _b()|func _c()|func a()", "7: a() comes after _b()"),
        ("static func _b()|static func a()", "a() comes after _b()"),
        ("func _b()|@rpc('any_peer')\nfunc a()", "5: a() comes after _b()"),
        ("func _b()|@abstract func a()", "a() comes after _b()"),
        ("func _b()|func _ready()", "_ready() comes after _b()"),
        ("func a()|func _b()|static func make()", "make() comes after _b()"),
    ],
)
def test_a_public_method_after_a_private_one_is_named(methods: str, wrong: str) -> None:
    assert wrong in find_fault("\n\n\n".join(methods.split("|")))
