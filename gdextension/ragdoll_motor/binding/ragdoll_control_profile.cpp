// SPDX-License-Identifier: MIT
#include "ragdoll_control_profile.hpp"

namespace godot {

void RagdollControlProfile::set_profile_name(const StringName &p_name) {
	_profile_name = p_name;
	emit_changed();
}

void RagdollControlProfile::set_controls(const TypedArray<RagdollControl> &p_controls) {
	_controls = p_controls;
	emit_changed();
}

void RagdollControlProfile::set_blend_s(double p_blend_s) {
	ERR_FAIL_COND_MSG(!(p_blend_s >= 0.0 && p_blend_s <= 3600.0), "RagdollControlProfile: a blend is 0 to 3600 s.");
	_blend_s = p_blend_s;
	emit_changed();
}

void RagdollControlProfile::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_profile_name", "name"), &RagdollControlProfile::set_profile_name);
	ClassDB::bind_method(D_METHOD("get_profile_name"), &RagdollControlProfile::get_profile_name);
	ClassDB::bind_method(D_METHOD("set_controls", "controls"), &RagdollControlProfile::set_controls);
	ClassDB::bind_method(D_METHOD("get_controls"), &RagdollControlProfile::get_controls);
	ClassDB::bind_method(D_METHOD("set_blend_s", "blend_s"), &RagdollControlProfile::set_blend_s);
	ClassDB::bind_method(D_METHOD("get_blend_s"), &RagdollControlProfile::get_blend_s);
	ADD_PROPERTY(PropertyInfo(Variant::STRING_NAME, "profile_name"), "set_profile_name", "get_profile_name");
	// 24 is an object, 17 a resource type: how the engine writes the elements of an array.
	ADD_PROPERTY(PropertyInfo(Variant::ARRAY, "controls", PROPERTY_HINT_ARRAY_TYPE, "24/17:RagdollControl"),
			"set_controls", "get_controls");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "blend_s", PROPERTY_HINT_RANGE, "0,5,0.01,or_greater,suffix:s"),
			"set_blend_s", "get_blend_s");
}

} // namespace godot
