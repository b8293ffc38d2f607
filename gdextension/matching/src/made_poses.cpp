// SPDX-License-Identifier: MIT
#include "made_poses.hpp"

#include <algorithm>
#include <cmath>

namespace matching {

namespace {

/// A turn about +X: forward, rad.
Quat pitch(float p_angle) {
	return exp({ p_angle, 0.0f, 0.0f });
}

/// The rotation of an arm's limb that points somewhere; `p_up` is where the back of the hand would be.
Quat arm_along(const Vec3 &p_direction, const Vec3 &p_up, std::size_t p_side) {
	const Vec3 x = unit(p_direction) * (p_side == 0 ? 1.0f : -1.0f);
	const Vec3 y = unit(p_up - x * p_up.dot(x));
	return kinematics::from_axes(x, y, x.cross(y));
}

void put_arm(std::size_t p_side, const Vec3 &p_upper, const Vec3 &p_lower, const Vec3 &p_up, Pose &r_pose) {
	const float out = p_side == 0 ? 1.0f : -1.0f;
	const std::size_t upper = LEFT_UPPER_ARM + 3 * p_side;
	r_pose.limbs[upper] = arm_along({ p_upper.x * out, p_upper.y, p_upper.z }, p_up, p_side);
	r_pose.limbs[upper + 1] = arm_along({ p_lower.x * out, p_lower.y, p_lower.z }, p_up, p_side);
	r_pose.limbs[upper + 2] = r_pose.limbs[upper + 1];
}

/// Turns all limbs of a leg from hanging to pointing: thigh and shank each by an angle about +X, rad, and the thigh
/// outwards.
void put_leg(std::size_t p_side, float p_thigh, float p_shank, float p_out, const Quat &p_trunk, Pose &r_pose) {
	const Quat out = exp({ 0.0f, 0.0f, p_side == 0 ? p_out : -p_out });
	const std::size_t thigh = thigh_of(p_side);
	r_pose.limbs[thigh] = p_trunk * out * pitch(p_thigh);
	r_pose.limbs[thigh + 1] = p_trunk * out * pitch(p_shank);
	r_pose.limbs[thigh + 2] = r_pose.limbs[thigh + 1];
}

void put_trunk(const Quat &p_hips, const Quat &p_chest, const Quat &p_head, Pose &r_pose) {
	r_pose.limbs[HIPS] = p_hips;
	r_pose.limbs[SPINE] = blend(p_hips, p_chest, 0.5f);
	r_pose.limbs[CHEST] = p_chest;
	r_pose.limbs[HEAD] = p_head;
}

void put_ankles(const Body &p_body, Pose &r_pose) {
	for (std::size_t side = 0; side < 2; side++) {
		r_pose.ankles[side] = ankle_of(p_body, r_pose, side);
	}
}

} // namespace

float crouch(float p_share, const Body &p_body, Pose &r_pose) {
	r_pose.limbs[HIPS] = pitch(0.35f * p_share) * r_pose.limbs[HIPS];
	r_pose.limbs[SPINE] = pitch(0.5f * p_share) * r_pose.limbs[SPINE];
	r_pose.limbs[CHEST] = pitch(0.6f * p_share) * r_pose.limbs[CHEST];
	r_pose.limbs[HEAD] = pitch(0.15f * p_share) * r_pose.limbs[HEAD];
	for (std::size_t side = 0; side < 2; side++) {
		const std::size_t upper = LEFT_UPPER_ARM + 3 * side;
		// Elbows beside the trunk, hands in front of it.
		r_pose.limbs[upper] = pitch(0.1f * p_share) * r_pose.limbs[upper];
		for (const std::size_t limb : { upper + 1, upper + 2 }) {
			r_pose.limbs[limb] = pitch(-0.8f * p_share) * r_pose.limbs[limb];
		}
	}
	r_pose.hips.z -= 0.045f * p_body.hip_height * p_share;
	const float down = 0.34f * p_body.hip_height * p_share;
	r_pose.hips.y -= down;
	return down;
}

Pose airborne(const Pose &p_from, const Body &p_body, float p_rising) {
	Pose pose = p_from;
	// Going up the legs stay behind, coming down they reach for the ground.
	const float tuck = 0.5f + 0.3f * std::clamp(p_rising * 0.3f, -1.0f, 1.0f);
	pose.hips.x *= 0.3f;
	pose.hips.z *= 0.3f;
	put_leg(0, -0.75f * tuck - 0.1f, 0.55f * tuck, 0.1f, {}, pose);
	put_leg(1, -0.25f * tuck, 0.9f * tuck, 0.1f, {}, pose);
	for (std::size_t side = 0; side < 2; side++) {
		put_arm(side, { 0.55f, -0.8f, 0.1f }, { 0.25f, -0.45f, 0.85f }, { 0.5f, 0.8f, 0.3f }, pose);
	}
	put_ankles(p_body, pose);
	return pose;
}

Pose prone(const Body &p_body, float p_travelled) {
	Pose pose;
	const Quat lying = pitch(0.5f * PI - 0.06f);
	// One pull of an arm and a push of the other leg for every step.
	const float phase = p_travelled * PI / (0.35f * p_body.hip_height);
	const float swing = std::sin(phase);
	const Quat rolled = exp({ 0.0f, 0.0f, 0.1f * swing }) * lying;
	put_trunk(rolled, pitch(0.5f * PI - 0.3f), pitch(0.35f), pose);
	for (std::size_t side = 0; side < 2; side++) {
		const float own = side == 0 ? swing : -swing;
		const float bend = 0.35f + 0.3f * own;
		put_leg(side, -0.15f * bend, 0.25f * bend, 0.18f + 0.5f * std::max(bend, 0.0f), lying, pose);
		// The toes point back.
		pose.limbs[foot_of(side)] = pose.limbs[foot_of(side)] * pitch(1.35f);
		put_arm(side, { 0.45f, -0.35f, 0.75f - 0.25f * own }, { -0.35f, -0.12f, 0.9f + 0.1f * own },
				{ 0.2f, 1.0f, 0.2f }, pose);
	}
	pose.hips = { 0.0f, 0.125f * p_body.hip_height, -0.15f * p_body.hip_height };
	put_ankles(p_body, pose);
	return pose;
}

Pose ladder(const Body &p_body, float p_climbed) {
	Pose pose;
	put_trunk(pitch(0.08f), pitch(0.02f), pitch(-0.3f), pose);
	// Opposite hand and foot go together, one rung each.
	const float swing = std::sin(p_climbed * PI / 0.3f);
	for (std::size_t side = 0; side < 2; side++) {
		const float hand = side == 0 ? swing : -swing;
		put_leg(side, -0.85f + 0.4f * hand, 0.15f - 0.3f * hand, 0.08f, {}, pose);
		put_arm(side, { 0.3f, 0.15f + 0.45f * hand, 0.8f }, { -0.1f, 0.65f + 0.1f * hand, 0.6f }, { 0.6f, 0.3f, -0.6f },
				pose);
		pose.limbs[foot_of(side)] = pitch(-0.1f);
	}
	pose.hips = { 0.0f, 0.93f * p_body.hip_height, 0.0f };
	put_ankles(p_body, pose);
	return pose;
}

Pose vault(const Body &p_body) {
	Pose pose;
	put_trunk(pitch(0.7f), pitch(0.85f), pitch(0.1f), pose);
	put_leg(0, -1.3f, 0.5f, 0.15f, {}, pose);
	put_leg(1, -0.5f, 0.9f, 0.2f, {}, pose);
	for (std::size_t side = 0; side < 2; side++) {
		put_arm(side, { 0.25f, -0.75f, 0.6f }, { 0.05f, -0.9f, 0.4f }, { 0.7f, 0.5f, -0.5f }, pose);
	}
	pose.hips = { 0.0f, 0.95f * p_body.hip_height, 0.0f };
	put_ankles(p_body, pose);
	return pose;
}

} // namespace matching
