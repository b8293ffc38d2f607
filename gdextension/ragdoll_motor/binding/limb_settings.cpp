// SPDX-License-Identifier: MIT
#include "limb_settings.hpp"

#include <cmath>

namespace godot {

void LimbSettings::set_actuation(int p_mode, const StringName &p_group, double p_blend_s) {
	int group = -1;
	ERR_FAIL_COND_MSG(p_mode < 0 || p_mode >= ragdoll::ACTUATION_COUNT, "RagdollMotor: there is no such actuation.");
	ERR_FAIL_COND_MSG(
			!_plan.find_group(p_group, group), "RagdollMotor: the profile has no group " + String(p_group) + ".");
	_driver.get_table().set_mode(ragdoll::Actuation(p_mode), group, float(p_blend_s));
}

ragdoll::Actuation LimbSettings::get_actuation(const StringName &p_group) const {
	int group = -1;
	const bool is_known = _plan.find_group(p_group, group);
	for (std::size_t i = 0; is_known && i < _driver.get_rig().size(); i++) {
		if (group < 0 || _driver.get_rig()[i].group == group) {
			return _driver.get_table().get_wanted_mode(i);
		}
	}
	return ragdoll::Actuation::VELOCITY_MOTOR;
}

void LimbSettings::set_strength(double p_strength, const StringName &p_group, double p_blend_s) {
	int group = -1;
	ERR_FAIL_COND_MSG(!is_amount(p_strength), "RagdollMotor: a strength is 0 or more.");
	ERR_FAIL_COND_MSG(
			!_plan.find_group(p_group, group), "RagdollMotor: the profile has no group " + String(p_group) + ".");
	_driver.get_table().set_strength(float(p_strength), group, float(p_blend_s));
}

double LimbSettings::get_strength(const StringName &p_group) const {
	int group = -1;
	return _plan.find_group(p_group, group) ? _driver.get_table().get_group_strength(group < 0 ? 0 : group) : 0.0;
}

void LimbSettings::set_spring(double p_frequency, double p_damping_ratio, const StringName &p_group) {
	int group = -1;
	ERR_FAIL_COND_MSG(!is_amount(p_frequency) || !is_amount(p_damping_ratio),
			"RagdollMotor: a spring's frequency and damping ratio are 0 or more.");
	ERR_FAIL_COND_MSG(
			!_plan.find_group(p_group, group), "RagdollMotor: the profile has no group " + String(p_group) + ".");
	_driver.get_table().set_spring(float(p_frequency), float(p_damping_ratio), group);
}

bool LimbSettings::set_control(const Ref<RagdollControl> &p_control, double p_blend_s) {
	ERR_FAIL_COND_V_MSG(p_control.is_null(), false, "RagdollMotor: there is no control.");
	ERR_FAIL_COND_V_MSG(!is_amount(p_blend_s), false, "RagdollMotor: a blend takes 0 s or more.");
	std::vector<std::uint8_t> limbs;
	if (!_plan.find_limbs(p_control->get_limbs(), limbs)) {
		return false;
	}
	for (std::size_t i = 0; i < limbs.size(); i++) {
		if (limbs[i] != 0) {
			_driver.set_control(i, p_control->to_core(), float(p_blend_s));
		}
	}
	return true;
}

bool LimbSettings::apply_profile(const Ref<RagdollControlProfile> &p_profile, double p_blend_s) {
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
		_driver.set_control(limb, controls[limb], float(blend_s));
	}
	return true;
}

} // namespace godot
