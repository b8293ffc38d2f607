// SPDX-License-Identifier: MIT
#include "comparison/comparison.hpp"

#include "comparison/lowest_contact.hpp"
#include "comparison/lowest_foot.hpp"
#include "comparison/thesis_joints.hpp"

#include <algorithm>

namespace ragdoll {

std::vector<ModeTravel> make_thesis_travels(const std::vector<ContactPoint> &p_contacts) {
	std::vector<ModeTravel> travels;
	travels.push_back({ RootMode::LOWEST_FOOT, std::make_unique<LowestFoot>(p_contacts) });
	travels.push_back({ RootMode::CONTACTS, std::make_unique<LowestContact>(p_contacts) });
	return travels;
}

std::unique_ptr<JointDrive> make_thesis_joints(const Rig &p_rig) {
	return std::make_unique<ThesisJoints>(p_rig);
}

Vec3 find_righting_turn(const Quat &p_actual, const Quat &p_now, const Quat &p_next, float p_delta_s, float p_gain) {
	const float gain = std::min(p_gain, 1.0f / p_delta_s);
	return log(p_now.inverse() * p_next) * (1.0f / p_delta_s) + log(p_actual.inverse() * p_now) * gain;
}

} // namespace ragdoll
