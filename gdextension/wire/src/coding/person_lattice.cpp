// SPDX-License-Identifier: MIT
#include "coding/person_lattice.hpp"

#include <algorithm>
#include <cmath>

namespace wire {

namespace {

// A chart is kept while the component that it drops is at least this.
constexpr float MIN_DROPPED = 0.42f;

// No point is farther from the lattice than sqrt(5) / 2 units; a little of the margin for what floats
// round off is used.
constexpr float REACH = 1.127f;
// Makes what is too far away dearer than all that is near enough.
constexpr float FAR = 1e9f;

std::array<float, 4> to_array(const Quat &p_rotation) {
	return { p_rotation.x, p_rotation.y, p_rotation.z, p_rotation.w };
}

int find_chart(const std::array<float, 4> &p_values, const RotationCode *p_previous) {
	if (p_previous != nullptr && std::fabs(p_values[p_previous->dropped % 4]) >= MIN_DROPPED) {
		return p_previous->dropped % 4;
	}
	int largest = 3;
	for (int i = 0; i < 3; i++) {
		if (std::fabs(p_values[std::size_t(i)]) > std::fabs(p_values[std::size_t(largest)])) {
			largest = i;
		}
	}
	return largest;
}

// Of the points that are near enough the one that is nearest to where the limb was: it is the cheapest
// one to say. Without that, the nearest one.
void choose(
		const std::array<float, 3> &p_point, const RotationCode *p_previous, int p_resolution, RotationCode &r_code) {
	const float whole = float(p_resolution) * float(p_resolution);
	const float square = p_point[0] * p_point[0] + p_point[1] * p_point[1] + p_point[2] * p_point[2];
	// The farther out, the less a unit turns.
	const float stretch = (whole + square) / whole;
	const float most = REACH * REACH * stretch * stretch;
	float best = 1e30f;
	std::array<int16_t, 3> parts{};
	for (int odd = 0; odd < 2; odd++) {
		std::array<int, 3> low{};
		for (std::size_t i = 0; i < 3; i++) {
			low[i] = 2 * int(std::floor((p_point[i] - float(odd)) * 0.5f)) + odd;
		}
		for (uint32_t corner = 0; corner < 8; corner++) {
			float away = 0.0f;
			float cost = 0.0f;
			for (std::size_t i = 0; i < 3; i++) {
				const int part = low[i] + 2 * int((corner >> i) & 1U);
				parts[i] = int16_t(part);
				const float off = p_point[i] - float(part);
				away += off * off;
				const float change = p_previous != nullptr ? float(part - p_previous->parts[i]) : 0.0f;
				cost += change * change;
			}
			cost = p_previous == nullptr || away > most ? FAR * away : cost;
			if (cost < best) {
				best = cost;
				r_code.parts = parts;
			}
		}
	}
}

} // namespace

int PersonLattice::resolution_for(double p_max_error_deg) {
	// A point is at most sqrt(5) / 2 units from the lattice, a unit is at most 2 / resolution of a
	// quaternion's component, and that is half as much of an angle. 1 % is for what floats round off.
	const double radians = p_max_error_deg * 3.14159265358979 / 180.0;
	const double units = 1.01 * 2.0 * std::sqrt(5.0) / std::max(radians, 1e-9);
	return int(std::min(std::max(std::ceil(units), double(MIN_RESOLUTION)), double(MAX_RESOLUTION)));
}

PersonLattice::PersonLattice(int p_resolution) :
		_lattice_resolution(std::min(std::max(p_resolution, MIN_RESOLUTION), MAX_RESOLUTION)) {}

RotationCode PersonLattice::nearest(const Quat &p_rotation, const RotationCode *p_previous) const {
	const std::array<float, 4> values = to_array(p_rotation);
	RotationCode code;
	const int chart = find_chart(values, p_previous);
	code.dropped = uint8_t(chart);
	const float sign = values[std::size_t(chart)] < 0.0f ? -1.0f : 1.0f;
	const float scale = sign * float(_lattice_resolution) / (1.0f + std::fabs(values[std::size_t(chart)]));
	std::array<float, 3> point{};
	int at = 0;
	for (int i = 0; i < 4; i++) {
		if (i != chart) {
			point[std::size_t(at++)] = values[std::size_t(i)] * scale;
		}
	}
	const bool same_chart = p_previous != nullptr && p_previous->dropped == code.dropped;
	choose(point, same_chart ? p_previous : nullptr, _lattice_resolution, code);
	return code;
}

Quat PersonLattice::rotation(const RotationCode &p_code) const {
	std::array<int64_t, 4> components{};
	const float scale = 1.0f / float(components_of(p_code, _lattice_resolution, components));
	return { float(components[0]) * scale, float(components[1]) * scale, float(components[2]) * scale,
		float(components[3]) * scale };
}

bool PersonLattice::quantise(const PersonPose &p_pose, const Skeleton &p_skeleton, const PersonState *p_previous,
		PersonState &r_state) const {
	constexpr float MAX_METRES = float(MAX_ROOT) / 1000.0f;
	const std::array<float, 3> root{ p_pose.root.x, p_pose.root.y, p_pose.root.z };
	for (const float value : root) {
		if (!(std::fabs(value) < MAX_METRES)) {
			return false;
		}
	}
	const std::size_t count = std::size_t(p_skeleton.limb_count);
	for (std::size_t i = 0; i < count; i++) {
		if (!is_rotation(p_pose.orientations[i])) {
			return false;
		}
	}
	std::array<Quat, MAX_LIMBS> restored{};
	for (std::size_t i = 0; i < 3; i++) {
		r_state.root[i] = int32_t(std::lround(double(root[i]) * 1000.0));
	}
	for (std::size_t i = 0; i < count; i++) {
		const Quat wanted = p_pose.orientations[i].normalized();
		const bool is_root = p_skeleton.parents[i] < 0;
		const Quat parent = is_root ? Quat() : restored[std::size_t(p_skeleton.parents[i])];
		const RotationCode previous = p_previous != nullptr ? p_previous->limbs[i] : RotationCode();
		r_state.limbs[i] =
				nearest((parent.inverse() * wanted).normalized(), p_previous != nullptr ? &previous : nullptr);
		restored[i] = (parent * rotation(r_state.limbs[i])).normalized();
	}
	return true;
}

void PersonLattice::restore(const PersonState &p_state, const Skeleton &p_skeleton, PersonPose &r_pose) const {
	r_pose.root = { float(double(p_state.root[0]) * 0.001), float(double(p_state.root[1]) * 0.001),
		float(double(p_state.root[2]) * 0.001) };
	for (std::size_t i = 0; i < std::size_t(p_skeleton.limb_count); i++) {
		const Quat relative = rotation(p_state.limbs[i]);
		const int parent = p_skeleton.parents[i];
		r_pose.orientations[i] =
				parent < 0 ? relative : (r_pose.orientations[std::size_t(parent)] * relative).normalized();
	}
}

} // namespace wire
