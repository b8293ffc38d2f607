// SPDX-License-Identifier: MIT
#pragma once

#include "driven_ragdoll.hpp"
#include "ragdoll_control_profile.hpp"

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/variant/string_name.hpp>

#include <cstdint>
#include <vector>

namespace godot {

/// Changes how limbs of a ragdoll are driven, one by one or by the groups of its profile, by the names that scripts
/// have for them. Reports an error where a name or a number means nothing.
class LimbSettings {
public:
	explicit LimbSettings(DrivenRagdoll &p_ragdoll) : _plan(p_ragdoll.get_plan()), _driver(p_ragdoll.get_driver()) {}

	/// Whether a number can be a force, a gain, a strength: 0 or more, and finite as the core has it.
	static bool is_amount(double p_value) { return p_value >= 0.0 && p_value <= 1e30; }

	void set_actuation(int p_mode, const StringName &p_group, double p_blend_s);
	ragdoll::Actuation get_actuation(const StringName &p_group) const;
	void set_strength(double p_strength, const StringName &p_group, double p_blend_s);
	double get_strength(const StringName &p_group) const;
	void set_spring(double p_frequency, double p_damping_ratio, const StringName &p_group);
	bool set_control(const Ref<RagdollControl> &p_control, double p_blend_s);
	/// Sets all limbs; those that the profile does not name get a control's defaults.
	/// @param p_blend_s below 0: as the profile has it
	bool apply_profile(const Ref<RagdollControlProfile> &p_profile, double p_blend_s);

private:
	const RagdollPlan &_plan;
	ragdoll::Driver &_driver;
};

} // namespace godot
