// SPDX-License-Identifier: MIT
#include "motion_matcher.hpp"

#include <convert.hpp>

#include <cstring>

namespace godot {

namespace {

constexpr double MAX_M = 3.0;

} // namespace

void MotionMatcher::set_motion_set(const Ref<MotionSet> &p_set) {
	ERR_FAIL_COND_MSG(p_set.is_null() || p_set->core() == nullptr, "Load a motion set first.");
	_core.set_motion_set(p_set->core());
}

void MotionMatcher::change_motion_set(const Ref<MotionSet> &p_set) {
	ERR_FAIL_COND_MSG(p_set.is_null() || p_set->core() == nullptr, "Load a motion set first.");
	_core.change_motion_set(p_set->core());
}

void MotionMatcher::set_body(double p_hip_height, const PackedFloat32Array &p_lengths) {
	ERR_FAIL_COND_MSG(!(p_hip_height > 0.1 && p_hip_height < MAX_M), "A hip height is between 0.1 and 3 m.");
	const auto length = [&](std::size_t p_limb) {
		const int64_t other = int64_t(matching::mirrored(p_limb));
		if (p_lengths.size() != int64_t(matching::LIMBS)) {
			return 0.0f;
		}
		const float own = p_lengths[int64_t(p_limb)] > 0.0f ? p_lengths[int64_t(p_limb)] : p_lengths[other];
		return own > 0.0f && own < float(MAX_M) ? own : 0.0f;
	};
	_core.set_body(matching::Body::of(float(p_hip_height), length(matching::LEFT_UPPER_LEG),
			length(matching::LEFT_LOWER_LEG), length(matching::LEFT_FOOT)));
}

void MotionMatcher::set_joints(
		double p_hip_height, const PackedVector3Array &p_joints_in_parent, const PackedVector3Array &p_joints_in_limb) {
	ERR_FAIL_COND_MSG(!(p_hip_height > 0.1 && p_hip_height < MAX_M), "A hip height is between 0.1 and 3 m.");
	const int64_t limbs = int64_t(matching::LIMBS);
	ERR_FAIL_COND_MSG(p_joints_in_parent.size() != limbs || p_joints_in_limb.size() != limbs,
			"There is a joint for each of 16 limbs.");
	const auto limb = [&](std::size_t p_from, std::size_t p_to) {
		return to_core(p_joints_in_parent[int64_t(p_to)] - p_joints_in_limb[int64_t(p_from)]);
	};
	matching::Body body = matching::Body::of(float(p_hip_height));
	for (std::size_t side = 0; side < 2; side++) {
		const std::size_t thigh = matching::thigh_of(side);
		body.hip_joints[side] = limb(matching::HIPS, thigh);
		body.thigh = limb(thigh, thigh + 1).length();
		body.shank = limb(thigh + 1, thigh + 2).length();
	}
	ERR_FAIL_COND_MSG(!(body.thigh > 0.05f && body.shank > 0.05f), "A body has legs.");
	body.measure();
	_core.set_body(body);
}

void MotionMatcher::set_ground(double p_left, double p_right) {
	_ground = { float(p_left), float(p_right) };
}

void MotionMatcher::reset(const Vector3 &p_position, double p_heading) {
	ERR_FAIL_COND_MSG(!p_position.is_finite() || !std::isfinite(p_heading), "A place and a heading are finite.");
	_core.reset(to_core(p_position), float(p_heading));
}

void MotionMatcher::advance(double p_delta, const Vector3 &p_position, const Vector3 &p_velocity, double p_heading,
		const Vector3 &p_wished_velocity, double p_wished_heading, int64_t p_stance, bool p_is_grounded) {
	ERR_FAIL_COND_MSG(p_stance < STAND || p_stance > VAULT, "A stance is 0 to 4.");
	matching::Wish wish;
	wish.position = to_core(p_position);
	wish.velocity = to_core(p_velocity);
	wish.heading = float(p_heading);
	wish.wished_velocity = to_core(p_wished_velocity);
	wish.wished_heading = float(p_wished_heading);
	wish.stance = matching::Stance(p_stance);
	wish.is_grounded = p_is_grounded;
	wish.ground = _ground;
	_core.advance(float(p_delta), wish);
}

PackedFloat32Array MotionMatcher::get_orientations() const {
	PackedFloat32Array result;
	result.resize(4 * int64_t(matching::LIMBS));
	static_assert(sizeof(_core.pose().limbs) == 16 * matching::LIMBS);
	std::memcpy(result.ptrw(), _core.pose().limbs.data(), sizeof(_core.pose().limbs));
	return result;
}

Vector3 MotionMatcher::get_root() const {
	return from_core(_core.pose().hips);
}

PackedVector3Array MotionMatcher::get_soles() const {
	PackedVector3Array result;
	for (std::size_t side = 0; side < 2; side++) {
		result.push_back(from_core(_core.sole_point(side, _core.body().heel())));
		result.push_back(from_core(_core.sole_point(side, _core.body().ball())));
	}
	return result;
}

String MotionMatcher::get_clip_name() const {
	return String(_core.clip_name());
}

Ref<MotionMatcher> MotionMatcher::copy() const {
	Ref<MotionMatcher> other;
	other.instantiate();
	other->_core = _core;
	other->_ground = _ground;
	return other;
}

void MotionMatcher::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_motion_set", "set"), &MotionMatcher::set_motion_set);
	ClassDB::bind_method(D_METHOD("change_motion_set", "set"), &MotionMatcher::change_motion_set);
	ClassDB::bind_method(D_METHOD("set_body", "hip_height", "lengths"), &MotionMatcher::set_body);
	ClassDB::bind_method(
			D_METHOD("set_joints", "hip_height", "joints_in_parent", "joints_in_limb"), &MotionMatcher::set_joints);
	ClassDB::bind_method(D_METHOD("set_ground", "left", "right"), &MotionMatcher::set_ground);
	ClassDB::bind_method(D_METHOD("reset", "position", "heading"), &MotionMatcher::reset);
	ClassDB::bind_method(D_METHOD("advance", "delta", "position", "velocity", "heading", "wished_velocity",
								 "wished_heading", "stance", "is_grounded"),
			&MotionMatcher::advance);
	ClassDB::bind_method(D_METHOD("get_orientations"), &MotionMatcher::get_orientations);
	ClassDB::bind_method(D_METHOD("get_root"), &MotionMatcher::get_root);
	ClassDB::bind_method(D_METHOD("get_soles"), &MotionMatcher::get_soles);
	ClassDB::bind_method(D_METHOD("get_clip_name"), &MotionMatcher::get_clip_name);
	ClassDB::bind_method(D_METHOD("copy"), &MotionMatcher::copy);
	BIND_ENUM_CONSTANT(STAND);
	BIND_ENUM_CONSTANT(CROUCH);
	BIND_ENUM_CONSTANT(PRONE);
	BIND_ENUM_CONSTANT(LADDER);
	BIND_ENUM_CONSTANT(VAULT);
}

} // namespace godot
