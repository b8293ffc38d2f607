// SPDX-License-Identifier: MIT
#pragma once

#include <smoothing/smoother.hpp>

#include <algorithm>
#include <random>
#include <vector>

/// A person of three limbs who swings an arm, a network that delays, and a display of 60 Hz.
namespace fixtures {

using namespace wire;

constexpr SmoothingMethod ALL_METHODS[] = { SmoothingMethod::NONE, SmoothingMethod::LINEAR,
	SmoothingMethod::EXTRAPOLATE_LERP, SmoothingMethod::HERMITE, SmoothingMethod::ERROR_OFFSET,
	SmoothingMethod::ADAPTIVE_LOW_DELAY };

inline kinematics::Skeleton arm() {
	kinematics::Skeleton skeleton;
	skeleton.limb_count = 3;
	skeleton.parents[0] = -1;
	for (std::size_t i = 1; i < 3; i++) {
		skeleton.parents[i] = int(i) - 1;
		skeleton.joints_in_parent[i] = { 0.3f, 0.0f, 0.0f };
		skeleton.joints_in_limb[i] = { -0.3f, 0.0f, 0.0f };
	}
	return skeleton;
}

/// Walks at 1 m/s and swings the arm once a second.
inline PersonUpdate swinging(uint32_t p_tick, uint16_t p_id = 0) {
	const float time = float(p_tick) / 60.0f;
	PersonUpdate update;
	update.tick = p_tick;
	update.id = p_id;
	update.pose.root = { time, 1.0f, 0.0f };
	update.pose.orientations[1] = kinematics::exp({ 0.0f, 0.0f, std::sin(6.283f * time) });
	update.pose.orientations[2] = kinematics::exp({ 0.0f, 0.6f * std::cos(6.283f * time), std::sin(6.283f * time) });
	return update;
}

struct Arrival {
	double arrival;
	uint32_t tick;
};

/// When every p_step-th tick arrives, in that order.
inline std::vector<Arrival> network(
		uint32_t p_first, uint32_t p_end, uint32_t p_step, double p_delay, double p_jitter, double p_loss) {
	std::mt19937 random(7);
	std::uniform_real_distribution<double> share(0.0, 1.0);
	std::vector<Arrival> result;
	for (uint32_t tick = p_first; tick < p_end; tick += p_step) {
		const double delay = p_delay + (2.0 * share(random) - 1.0) * p_jitter;
		if (share(random) >= p_loss) {
			result.push_back({ double(tick) / 60.0 + delay, tick });
		}
	}
	std::sort(result.begin(), result.end(),
			[](const Arrival &p_a, const Arrival &p_b) { return p_a.arrival < p_b.arrival; });
	return result;
}

inline bool is_finite(const Smoother::Person &p_person) {
	for (std::size_t i = 0; i < std::size_t(p_person.limb_count); i++) {
		const float norm = p_person.pose.orientations[i].dot(p_person.pose.orientations[i]);
		if (!p_person.positions[i].is_finite() || !(std::fabs(norm - 1.0f) < 1e-3f)) {
			return false;
		}
	}
	return true;
}

/// The widest gap at a joint, m.
inline float widest_gap(const kinematics::Skeleton &p_skeleton, const Smoother::Person &p_person) {
	float widest = 0.0f;
	for (std::size_t i = 1; i < std::size_t(p_person.limb_count); i++) {
		const std::size_t parent = std::size_t(p_skeleton.parents[i]);
		const Vec3 outer =
				p_person.positions[parent] + p_person.pose.orientations[parent].rotate(p_skeleton.joints_in_parent[i]);
		const Vec3 inner = p_person.positions[i] + p_person.pose.orientations[i].rotate(p_skeleton.joints_in_limb[i]);
		widest = std::max(widest, (outer - inner).length());
	}
	return widest;
}

} // namespace fixtures
