# SPDX-License-Identifier: MIT
"""The gate that keeps dead methods out of the bindings."""

from __future__ import annotations

from toolchain.bound import check, find_unnamed

SOURCE = """
	ClassDB::bind_method(D_METHOD("set_mass", "mass"), &Wheel::set_mass);
	ClassDB::bind_method(D_METHOD("get_mass"), &Wheel::get_mass);
	ClassDB::bind_method(
			D_METHOD("turn", "by"), &Wheel::turn, DEFVAL(1));
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "mass", PROPERTY_HINT_NONE, "suffix:kg"),
			"set_mass", "get_mass");
	BIND_ENUM_CONSTANT(FRONT);
	BIND_ENUM_CONSTANT(REAR);
"""


def test_what_scripts_name_is_alive() -> None:
    assert find_unnamed([SOURCE], {"mass", "turn", "REAR"}) == []
    assert find_unnamed([SOURCE], {"get_mass", "turn", "FRONT"}) == []


def test_what_nobody_names_is_found() -> None:
    assert find_unnamed([SOURCE], {"mass", "REAR"}) == ["Wheel.turn"]
    assert find_unnamed([SOURCE], {"turn", "REAR"}) == ["Wheel.mass"]
    assert find_unnamed([SOURCE], {"turn", "mass"}) == ["Wheel.FRONT", "Wheel.REAR"]


def test_what_is_kept_has_a_reason_and_is_needed() -> None:
    kept = ["# A comment.", "", "Wheel.mass a setting in the inspector"]
    assert check(["Wheel.mass"], kept) == []
    assert [line.split(":")[0] for line in check(["Wheel.turn"], [])] == ["Wheel.turn"]
    assert "give a reason" in check(["Wheel.mass"], ["Wheel.mass"])[0]
    assert "remove it" in check([], kept)[0]
