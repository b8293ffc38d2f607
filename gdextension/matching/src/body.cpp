// SPDX-License-Identifier: MIT
#include "body.hpp"

#include <algorithm>
#include <cmath>

namespace matching {

namespace {

/// The shortest rotation from one direction to another, both of length 1.
Quat between(const Vec3 &p_from, const Vec3 &p_to) {
	const Vec3 axis = p_from.cross(p_to);
	const float w = 1.0f + p_from.dot(p_to);
	if (w < 1e-5f) {
		return { 1.0f, 0.0f, 0.0f, 0.0f };
	}
	return Quat{ axis.x, axis.y, axis.z, w }.normalized();
}

} // namespace

Body Body::of(float p_hip_height, float p_thigh, float p_shank, float p_foot) {
	Body body;
	// The soldier's skeleton, whose hips are 1.0115 m high.
	body.ankle_height = 0.0734f * p_hip_height;
	body.foot = p_foot > 0.0f ? 0.96f * p_foot : 0.148f * p_hip_height;
	body.thigh = p_thigh > 0.0f ? p_thigh : 0.4358f * p_hip_height;
	body.shank = p_shank > 0.0f ? p_shank : 0.452f * p_hip_height;
	for (std::size_t side = 0; side < 2; side++) {
		body.hip_joints[side] = Vec3{ side == 0 ? 0.1117f : -0.1117f, -0.045f, -0.0171f } * p_hip_height;
	}
	body.measure();
	return body;
}

void Body::measure() {
	hip_height = leg() + ankle_height - 0.5f * (hip_joints[0].y + hip_joints[1].y);
}

Vec3 reach(const Vec3 &p_hip_joint, const Vec3 &p_ankle, float p_thigh, float p_shank, const Vec3 &p_front,
		Quat &r_thigh, Quat &r_shank) {
	const Vec3 down{ 0.0f, -1.0f, 0.0f };
	const Vec3 thigh = r_thigh.rotate(down);
	const Vec3 shank = r_shank.rotate(down);
	const Vec3 to = p_ankle - p_hip_joint;
	const Vec3 along = unit(to, down);
	// A leg is never quite straight: the knee would snap.
	const float length = std::clamp(to.length(), 0.25f * (p_thigh + p_shank), 0.998f * (p_thigh + p_shank));
	// The knee is in front of the line from hip joint to ankle: where the pose has it, if it bends clearly.
	const Vec3 line = unit(thigh * p_thigh + shank * p_shank, down);
	Vec3 side = thigh * p_thigh - line * (thigh.dot(line) * p_thigh);
	side = between(line, along).rotate(side) + p_front * 0.05f;
	side = unit(side - along * side.dot(along), p_front);
	const float cosine = std::clamp(
			(p_thigh * p_thigh + length * length - p_shank * p_shank) / (2.0f * p_thigh * length), -1.0f, 1.0f);
	const float sine = std::sqrt(1.0f - cosine * cosine);
	const Vec3 new_thigh = along * cosine + side * sine;
	const Vec3 knee = p_hip_joint + new_thigh * p_thigh;
	const Vec3 ankle = p_hip_joint + along * length;
	const Vec3 new_shank = unit(ankle - knee, down);
	r_thigh = between(thigh, new_thigh) * r_thigh;
	r_shank = between(shank, new_shank) * r_shank;
	return ankle;
}

Vec3 ankle_of(const Body &p_body, const Pose &p_pose, std::size_t p_side) {
	const Vec3 joint = p_pose.hips + p_pose.limbs[HIPS].rotate(p_body.hip_joints[p_side]);
	return joint + p_pose.limbs[thigh_of(p_side)].rotate({ 0.0f, -p_body.thigh, 0.0f }) +
			p_pose.limbs[thigh_of(p_side) + 1].rotate({ 0.0f, -p_body.shank, 0.0f });
}

} // namespace matching
