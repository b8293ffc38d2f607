// SPDX-License-Identifier: MIT
#include "body/leg.hpp"

#include <algorithm>
#include <cmath>

namespace ragdoll {

namespace {

constexpr float MIN_LENGTH = 0.02f; // Of a thigh or shank that can be bent, m.

/// The inner angle between two sides of a triangle, rad.
float angle_opposite(float p_left, float p_right, float p_opposite) {
	const float cosine = (p_left * p_left + p_right * p_right - p_opposite * p_opposite) / (2.0f * p_left * p_right);
	return std::acos(std::clamp(cosine, -1.0f, 1.0f));
}

} // namespace

Quat rotation_between(const Vec3 &p_from, const Vec3 &p_to) {
	const float lengths = p_from.length() * p_to.length();
	if (lengths < 1e-9f || p_from.dot(p_to) < -0.99f * lengths) {
		return Quat(); // The opposite: never for a foot that moves by centimetres.
	}
	const Vec3 axis = p_from.cross(p_to);
	return Quat{ axis.x, axis.y, axis.z, lengths + p_from.dot(p_to) }.normalized();
}

std::vector<Leg> find_legs(const Rig &p_rig, const std::vector<ContactPoint> &p_contacts) {
	std::vector<Leg> legs;
	for (const ContactPoint &contact : p_contacts) {
		const bool known =
				std::any_of(legs.begin(), legs.end(), [&](const Leg &p_leg) { return p_leg.foot == contact.limb; });
		const int shin = p_rig[std::size_t(contact.limb)].parent;
		const int thigh = shin >= 0 ? p_rig[std::size_t(shin)].parent : -1;
		if (contact.sole && !known && thigh >= 0 && p_rig[std::size_t(thigh)].parent >= 0) {
			legs.push_back({ contact.limb, shin, thigh });
		}
	}
	return legs;
}

void bend_leg(const Rig &p_rig, const Leg &p_leg, const Vec3 &p_offset, Pose &r_pose, std::vector<Vec3> &r_joints) {
	Quat &thigh = r_pose.orientations[std::size_t(p_leg.thigh)];
	Quat &shin = r_pose.orientations[std::size_t(p_leg.shin)];
	const Vec3 hip = r_joints[std::size_t(p_leg.thigh)];
	const Vec3 upper = thigh.rotate(p_rig[std::size_t(p_leg.shin)].anchor);
	const Vec3 lower = shin.rotate(p_rig[std::size_t(p_leg.foot)].anchor);
	const float a = upper.length();
	const float b = lower.length();
	if (std::min(a, b) < MIN_LENGTH) {
		return;
	}
	Vec3 wanted = upper + lower + p_offset;
	const float longest = a + b - 0.001f;
	if (wanted.length() > longest) {
		// A leg that is too short lifts the foot rather than drag it.
		const float left = longest * longest - wanted.x * wanted.x - wanted.z * wanted.z;
		wanted.y = std::copysign(std::sqrt(std::max(left, 0.0f)), wanted.y);
	}
	const float reach = std::clamp(wanted.length(), std::fabs(a - b) + 0.01f, longest);
	// The knee opens or closes about its own axis, then the whole leg swings to the position.
	Vec3 axis = upper.cross(lower);
	if (axis.length() < 0.02f * a * b) {
		// Stretched: knees go where the toes point.
		const Quat &foot = r_pose.orientations[std::size_t(p_leg.foot)];
		const Vec3 toes = foot.rotate(p_rig[std::size_t(p_leg.foot)].centre);
		axis = (toes - upper * (toes.dot(upper) / (a * a))).cross(upper);
	}
	const float more = angle_opposite(a, b, reach) - angle_opposite(a, b, (upper + lower).length());
	Quat knee;
	if (axis.length() > 1e-3f * a * b) {
		knee = exp(axis * (-more / axis.length()));
	}
	const Quat swing = rotation_between(upper + knee.rotate(lower), wanted);
	thigh = swing * thigh;
	shin = swing * knee * shin;
	r_joints[std::size_t(p_leg.shin)] = hip + swing.rotate(upper);
	r_joints[std::size_t(p_leg.foot)] = r_joints[std::size_t(p_leg.shin)] + (swing * knee).rotate(lower);
}

} // namespace ragdoll
