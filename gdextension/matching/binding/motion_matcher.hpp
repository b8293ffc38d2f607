// SPDX-License-Identifier: MIT
#pragma once

#include "motion_set.hpp"

#include <motion_matcher.hpp>

#include <godot_cpp/variant/vector3.hpp>

namespace godot {

/// Turns what a mover does into a person's pose. Documented in doc_classes/MotionMatcher.xml.
class MotionMatcher : public RefCounted {
	GDCLASS(MotionMatcher, RefCounted)

public:
	enum Stance {
		STAND,
		CROUCH,
		PRONE,
		LADDER,
		VAULT
	};

	void set_motion_set(const Ref<MotionSet> &p_set);
	void change_motion_set(const Ref<MotionSet> &p_set);
	void set_body(double p_hip_height, const PackedFloat32Array &p_lengths);
	void set_joints(double p_hip_height, const PackedVector3Array &p_joints_in_parent,
			const PackedVector3Array &p_joints_in_limb);
	void set_ground(double p_left, double p_right);
	void reset(const Vector3 &p_position, double p_heading);
	void advance(double p_delta, const Vector3 &p_position, const Vector3 &p_velocity, double p_heading,
			const Vector3 &p_wished_velocity, double p_wished_heading, int64_t p_stance, bool p_is_grounded);
	PackedFloat32Array get_orientations() const;
	Vector3 get_root() const;
	PackedVector3Array get_soles() const;
	String get_clip_name() const;
	Ref<MotionMatcher> copy() const;

protected:
	static void _bind_methods();

private:
	matching::MotionMatcher _core;
	std::array<float, 2> _ground = matching::Wish().ground;
};

} // namespace godot

VARIANT_ENUM_CAST(MotionMatcher::Stance);
