// SPDX-License-Identifier: MIT
// RagdollMotor: controls of single limbs, profiles of them, and hits.
#include "ragdoll_motor.hpp"

#include <convert.hpp>

#include <algorithm>
#include <cmath>

namespace godot {

bool RagdollMotor::set_limb_control(const Ref<RagdollControl> &p_control, double p_blend_s) {
	ERR_FAIL_COND_V_MSG(!_driver, false, "RagdollMotor: set_limb_control() comes after setup().");
	ERR_FAIL_COND_V_MSG(p_control.is_null(), false, "RagdollMotor: there is no control.");
	ERR_FAIL_COND_V_MSG(!is_amount(p_blend_s), false, "RagdollMotor: a blend takes 0 s or more.");
	std::vector<std::uint8_t> limbs;
	if (!_plan.find_limbs(p_control->get_limbs(), limbs)) {
		return false;
	}
	for (std::size_t i = 0; i < limbs.size(); i++) {
		if (limbs[i] != 0) {
			_driver->set_control(i, p_control->to_core(), float(p_blend_s));
		}
	}
	return true;
}

bool RagdollMotor::apply_control_profile(const Ref<RagdollControlProfile> &p_profile, double p_blend_s) {
	ERR_FAIL_COND_V_MSG(!_driver, false, "RagdollMotor: apply_control_profile() comes after setup().");
	ERR_FAIL_COND_V_MSG(p_profile.is_null(), false, "RagdollMotor: there is no control profile.");
	ERR_FAIL_COND_V_MSG(!std::isfinite(p_blend_s), false, "RagdollMotor: a blend is a number of seconds.");
	std::vector<ragdoll::LimbControl> controls(_plan.get_bones().size());
	std::vector<std::uint8_t> limbs;
	const TypedArray<RagdollControl> given = p_profile->get_controls();
	for (int64_t i = 0; i < given.size(); i++) {
		const Ref<RagdollControl> control = given[i];
		ERR_FAIL_COND_V_MSG(control.is_null(), false,
				"RagdollMotor: a control of the profile " + String(p_profile->get_profile_name()) + " is empty.");
		if (!_plan.find_limbs(control->get_limbs(), limbs)) {
			return false;
		}
		for (std::size_t limb = 0; limb < limbs.size(); limb++) {
			controls[limb] = limbs[limb] != 0 ? control->to_core() : controls[limb];
		}
	}
	const double blend_s = p_blend_s < 0.0 ? p_profile->get_blend_s() : p_blend_s;
	for (std::size_t limb = 0; limb < controls.size(); limb++) {
		_driver->set_control(limb, controls[limb], float(blend_s));
	}
	_control_profile = p_profile->get_profile_name();
	return true;
}

bool RagdollMotor::invoke_control_profile(const StringName &p_name, double p_blend_s) {
	for (int64_t i = 0; i < _control_profiles.size(); i++) {
		const Ref<RagdollControlProfile> profile = _control_profiles[i];
		if (profile.is_valid() && profile->get_profile_name() == p_name) {
			return apply_control_profile(profile, p_blend_s);
		}
	}
	ERR_FAIL_V_MSG(false, "RagdollMotor: control_profiles has none of the name " + String(p_name) + ".");
}

int64_t RagdollMotor::hit(const Vector3 &p_impulse, const Vector3 &p_position, double p_strength, double p_blend_s,
		const StringName &p_group) {
	int group = -1;
	ERR_FAIL_COND_V_MSG(!_driver, -1, "RagdollMotor: hit() comes after setup().");
	ERR_FAIL_COND_V_MSG(!p_impulse.is_finite() || !p_position.is_finite(), -1,
			"RagdollMotor: the impulse and the position of a hit are finite.");
	ERR_FAIL_COND_V_MSG(!(p_strength >= 0.0 && p_strength <= 1.0), -1, "RagdollMotor: what a hit leaves is 0 to 1.");
	ERR_FAIL_COND_V_MSG(!is_amount(p_blend_s), -1, "RagdollMotor: a blend takes 0 s or more.");
	ERR_FAIL_COND_V_MSG(
			!_plan.find_group(p_group, group), -1, "RagdollMotor: the profile has no group " + String(p_group) + ".");
	if (!_bodies->read(_state)) {
		return -1;
	}
	std::vector<float> before(_plan.get_bones().size());
	for (std::size_t i = 0; i < before.size(); i++) {
		before[i] = _driver->get_table().get_flinch(i);
	}
	const int limb =
			_driver->hit(_state, to_core(p_impulse), to_core(p_position), group, float(p_strength), float(p_blend_s));
	if (limb >= 0) {
		for (std::size_t i = 0; i < before.size(); i++) {
			const float after = std::max(_driver->get_table().get_flinch(i), ragdoll::ActuationTable::LIMP_FRICTION);
			_bodies->weaken(i, after / std::max(before[i], after));
		}
		_bodies->strike(std::size_t(limb), p_impulse, p_position - from_core(_state.centres[std::size_t(limb)]));
	}
	_is_state_read = false; // Its velocities are others now.
	return limb;
}

void RagdollMotor::bind_limb_control() {
	ClassDB::bind_method(D_METHOD("hit", "impulse", "position", "strength", "blend_s", "group"), &RagdollMotor::hit,
			DEFVAL(0.05), DEFVAL(0.5), DEFVAL(StringName()));
	ClassDB::bind_method(
			D_METHOD("set_limb_control", "control", "blend_s"), &RagdollMotor::set_limb_control, DEFVAL(0.0));
	ClassDB::bind_method(D_METHOD("apply_control_profile", "profile", "blend_s"), &RagdollMotor::apply_control_profile,
			DEFVAL(-1.0));
	ClassDB::bind_method(
			D_METHOD("invoke_control_profile", "name", "blend_s"), &RagdollMotor::invoke_control_profile, DEFVAL(-1.0));
	ClassDB::bind_method(D_METHOD("get_control_profile"), &RagdollMotor::get_control_profile);
	ClassDB::bind_method(D_METHOD("set_control_profiles", "profiles"), &RagdollMotor::set_control_profiles);
	ClassDB::bind_method(D_METHOD("get_control_profiles"), &RagdollMotor::get_control_profiles);
	// 24 is an object, 17 a resource type: how the engine writes the elements of an array.
	ADD_PROPERTY(
			PropertyInfo(Variant::ARRAY, "control_profiles", PROPERTY_HINT_ARRAY_TYPE, "24/17:RagdollControlProfile"),
			"set_control_profiles", "get_control_profiles");
}

} // namespace godot
