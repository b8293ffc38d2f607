// SPDX-License-Identifier: MIT
#include "clearance/limb_solid.hpp"

#include <algorithm>
#include <utility>

namespace ragdoll {

namespace {

constexpr float TINY = 1e-9f;
constexpr float LIMITLESS = 1e9f; // m
constexpr float OUTWARDS = 0.05f; // Of a face that counts as a way out.
constexpr int STEPS = 8; // Of the search along an axis.
constexpr float FLAT = 1e-5f; // Slope at the place that is nearest, m^2.

float part(const Vec3 &p_vector, int p_axis) {
	return p_axis == 0 ? p_vector.x : (p_axis == 1 ? p_vector.y : p_vector.z);
}

/// How far a coordinate is beyond a box's faces, with its sign; 0 between them.
float beyond(float p_at, float p_half) {
	return std::copysign(std::max(std::fabs(p_at) - p_half, 0.0f), p_at);
}

Vec3 beyond(const Vec3 &p_at, const Vec3 &p_half) {
	return { beyond(p_at.x, p_half.x), beyond(p_at.y, p_half.y), beyond(p_at.z, p_half.z) };
}

Vec3 to_local(const LimbSolid &p_solid, const Vec3 &p_vector) {
	return { p_solid.axes[0].dot(p_vector), p_solid.axes[1].dot(p_vector), p_solid.axes[2].dot(p_vector) };
}

Vec3 to_world(const LimbSolid &p_solid, const Vec3 &p_vector) {
	return p_solid.axes[0] * p_vector.x + p_solid.axes[1] * p_vector.y + p_solid.axes[2] * p_vector.z;
}

/// The share of a way (in a box's axes) at which it is nearest to the box. The squared distance is convex and made of
/// parabolas: Newton's steps find its lowest point, within the part that is left of the way.
float find_nearest(const Vec3 &p_from, const Vec3 &p_way, const Vec3 &p_half) {
	const Vec3 squares = p_way.scaled(p_way);
	float low = -1.0f; // Between these, which have been looked at, it must be.
	float high = 2.0f;
	float share = std::clamp(-p_from.dot(p_way) / std::max(squares.x + squares.y + squares.z, TINY), 0.0f, 1.0f);
	for (int step = 0; step < STEPS; step++) {
		const Vec3 out = beyond(p_from + p_way * share, p_half);
		const float slope = out.dot(p_way);
		if (std::fabs(slope) < FLAT || (slope > 0.0f && share <= 0.0f) || (slope < 0.0f && share >= 1.0f)) {
			break;
		}
		(slope < 0.0f ? low : high) = share;
		const float bend = (out.x != 0.0f ? squares.x : 0.0f) + (out.y != 0.0f ? squares.y : 0.0f) +
				(out.z != 0.0f ? squares.z : 0.0f);
		share = std::clamp(share - slope / std::max(bend, TINY), 0.0f, 1.0f);
		if (share <= low || share >= high) {
			share = 0.5f * (std::max(low, 0.0f) + std::min(high, 1.0f));
		}
	}
	return share;
}

/// The part of a way (in a box's axes) that lies within the box, by its shares.
std::pair<float, float> clip(const Vec3 &p_from, const Vec3 &p_way, const Vec3 &p_half) {
	float first = 0.0f;
	float last = 1.0f;
	for (int axis = 0; axis < 3; axis++) {
		const float way = part(p_way, axis);
		if (std::fabs(way) < TINY) {
			continue;
		}
		const float one = (-part(p_half, axis) - part(p_from, axis)) / way;
		const float other = (part(p_half, axis) - part(p_from, axis)) / way;
		first = std::max(first, std::min(one, other));
		last = std::min(last, std::max(one, other));
	}
	return { std::min(first, last), last };
}

/// The nearest way out of a box for a way that goes through it.
Approach leave_box(const Vec3 &p_from, const Vec3 &p_way, const LimbSolid &p_box, const AxisFreedom &p_freedom) {
	const auto [first, last] = clip(p_from, p_way, p_box.half);
	Approach best;
	best.distance = LIMITLESS; // Where no face is open, there is no way out.
	float least = LIMITLESS;
	for (int face = 0; face < 6; face++) {
		if (p_box.is_closed[face]) {
			continue;
		}
		const int axis = face / 2;
		const float sign = face % 2 == 0 ? -1.0f : 1.0f;
		const float at_first = sign * part(p_from + p_way * first, axis) - part(p_box.half, axis);
		const float at_last = sign * part(p_from + p_way * last, axis) - part(p_box.half, axis);
		const float share = at_first < at_last ? first : last;
		const Vec3 normal = p_box.axes[axis] * sign;
		const float distance = std::min(at_first, at_last);
		const float turns = -distance / std::max(p_freedom.find_lever(normal, share), OUTWARDS);
		if (turns < least) {
			least = turns;
			best.distance = distance;
			best.share = share;
			best.normal = normal;
		}
	}
	return best;
}

Approach approach_box(const SolidAxis &p_mover, const AxisFreedom &p_freedom, const LimbSolid &p_box,
		const Vec3 &p_centre, float p_share) {
	const Vec3 from = to_local(p_box, p_mover.from - p_centre);
	const Vec3 way = to_local(p_box, p_mover.way);
	const float share = p_share >= 0.0f ? p_share : find_nearest(from, way, p_box.half);
	const Vec3 out = beyond(from + way * share, p_box.half);
	Approach result;
	result.distance = out.length();
	result.share = share;
	if (result.distance > 1e-5f) {
		result.normal = to_world(p_box, out * (1.0f / result.distance));
		return result;
	}
	return leave_box(from, way, p_box, p_freedom);
}

Approach between(const SolidAxis &p_mover, float p_share, const SolidAxis &p_pill, float p_other, float p_radius) {
	Approach result;
	result.share = p_share;
	result.other_share = p_other;
	const Vec3 apart = p_mover.at(p_share) - p_pill.at(p_other);
	const float length = apart.length();
	result.distance = length - p_radius;
	if (length > 1e-5f) {
		result.normal = apart * (1.0f / length);
	} else {
		// Through one another: any way across both is as short.
		const Vec3 across = p_mover.way.cross(p_pill.way);
		const float size = across.length();
		result.normal = size > TINY ? across * (1.0f / size) : Vec3{ 0.0f, 0.0f, 1.0f };
	}
	return result;
}

float nearest_share(const Vec3 &p_point, const SolidAxis &p_axis) {
	const float square = p_axis.way.dot(p_axis.way);
	return square > TINY ? std::clamp((p_point - p_axis.from).dot(p_axis.way) / square, 0.0f, 1.0f) : 0.5f;
}

/// The nearest points of two ways (Ericson, Real-Time Collision Detection, 2005, section 5.1.9).
Approach approach_pill(const SolidAxis &p_mover, const SolidAxis &p_pill, float p_radius) {
	const Vec3 apart = p_mover.from - p_pill.from;
	const float a = p_mover.way.dot(p_mover.way);
	const float e = p_pill.way.dot(p_pill.way);
	const float b = p_mover.way.dot(p_pill.way);
	const float c = p_mover.way.dot(apart);
	const float f = p_pill.way.dot(apart);
	const float denominator = a * e - b * b;
	// Of two that are parallel, the middles.
	float share = denominator > 1e-4f * a * e ? std::clamp((b * f - c * e) / denominator, 0.0f, 1.0f) : 0.5f;
	const float other = nearest_share(p_mover.at(share), p_pill);
	share = nearest_share(p_pill.at(other), p_mover);
	return between(p_mover, share, p_pill, other, p_radius);
}

} // namespace

LimbSolid::LimbSolid(const Rig &p_rig, std::size_t p_limb) : limb(int(p_limb)), _local_centre(p_rig[p_limb].centre) {
	const LimbShape &shape = p_rig[p_limb].shape;
	is_box = shape.type == LimbShape::Type::BOX;
	half = shape.half;
	const Vec3 units[3] = { { 1.0f, 0.0f, 0.0f }, { 0.0f, 1.0f, 0.0f }, { 0.0f, 0.0f, 1.0f } };
	int order[3] = { 0, 1, 2 };
	if (is_box) {
		const int longest = half.x > half.y && half.x > half.z ? 0 : (half.z > half.y ? 2 : 1);
		std::swap(order[1], order[longest]);
		half = { part(shape.half, order[0]), part(shape.half, order[1]), part(shape.half, order[2]) };
	}
	for (int axis = 0; axis < 3; axis++) {
		_local_axes[axis] = shape.turn.rotate(units[order[axis]]);
	}
	reach = is_box ? half.length() : half.x + half.y;
}

void LimbSolid::place(const Quat &p_orientation, const Vec3 &p_joint) {
	centre = p_joint + p_orientation.rotate(_local_centre);
}

void LimbSolid::turn_axes(const Quat &p_orientation) {
	axes[1] = p_orientation.rotate(_local_axes[1]);
	if (is_box) {
		axes[0] = p_orientation.rotate(_local_axes[0]);
		axes[2] = p_orientation.rotate(_local_axes[2]);
	}
}

float LimbSolid::find_thickness(const Vec3 &p_direction) const {
	if (!is_box) {
		return half.x;
	}
	const float across = std::fabs(axes[0].dot(p_direction)) * half.x + std::fabs(axes[2].dot(p_direction)) * half.z;
	return std::max(across, std::min(half.x, half.z));
}

float LimbSolid::find_distance(const Vec3 &p_point, const Vec3 &p_centre) const {
	const Vec3 from = p_point - p_centre;
	if (is_box) {
		return beyond(to_local(*this, from), half).length();
	}
	const float along = std::clamp(axes[1].dot(from), -half.y, half.y);
	return (from - axes[1] * along).length() - half.x;
}

SolidAxis LimbSolid::find_axis(const Quat &p_orientation, const Vec3 &p_joint) const {
	const Vec3 axis = _local_axes[1] * half.y;
	return { p_joint + p_orientation.rotate(_local_centre - axis), p_orientation.rotate(axis * 2.0f) };
}

Vec3 LimbSolid::find_outside(int p_face, float p_distance) const {
	const int axis = p_face / 2;
	const float out = part(half, axis) + p_distance;
	return centre + axes[axis] * (p_face % 2 == 0 ? -out : out);
}

Approach approach_point(const Vec3 &p_point, const LimbSolid &p_solid, const SolidAxis &p_axis) {
	const SolidAxis point{ p_point, Vec3() };
	if (p_solid.is_box) {
		return approach_box(point, AxisFreedom(), p_solid, p_axis.at(0.5f), 0.0f);
	}
	return between(point, 0.0f, p_axis, nearest_share(p_point, p_axis), p_solid.half.x);
}

float AxisFreedom::find_lever(const Vec3 &p_direction, float p_share) const {
	const float along_upper = upper_way.dot(p_direction);
	const float along_lower = lower_way.dot(p_direction);
	const float end = low + (high - low) * p_share;
	return 1.0f - along_upper * along_upper + end * end * (1.0f - along_lower * along_lower);
}

Approach approach_axis(
		const SolidAxis &p_mover, const AxisFreedom &p_freedom, const LimbSolid &p_solid, const SolidAxis &p_axis) {
	return p_solid.is_box ? approach_box(p_mover, p_freedom, p_solid, p_axis.at(0.5f), -1.0f)
						  : approach_pill(p_mover, p_axis, p_solid.half.x);
}

} // namespace ragdoll
