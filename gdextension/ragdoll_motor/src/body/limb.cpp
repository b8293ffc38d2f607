// SPDX-License-Identifier: MIT
#include "body/limb.hpp"

#include <cstdarg>
#include <cstdio>
#include <unordered_set>

namespace ragdoll {

namespace {

constexpr float FURTHEST_M = 100.0f;
constexpr float THINNEST = 1e-3f; // m
constexpr float MIN_FRACTION = 1e-5f;
constexpr double LIGHTEST = 1.0;
constexpr double HEAVIEST = 1000.0;

std::string format(const char *p_format, ...) __attribute__((format(printf, 1, 2)));

std::string format(const char *p_format, ...) {
	char text[512];
	va_list arguments;
	va_start(arguments, p_format);
	std::vsnprintf(text, sizeof(text), p_format, arguments);
	va_end(arguments);
	return text;
}

/// A bone's name as it may stand in a message.
std::string shortened(const std::string &p_name) {
	return p_name.size() > 80 ? p_name.substr(0, 80) + "..." : p_name;
}

float box_moment(float p_mass, float p_first, float p_second) {
	return p_mass / 12.0f * (p_first * p_first + p_second * p_second);
}

std::string find_rotation_fault(const std::string &p_bone, const char *p_name, const Quat &p_rotation) {
	if (!p_rotation.is_finite()) {
		return p_bone + "'s " + p_name + " is not finite";
	}
	const float norm = std::sqrt(p_rotation.dot(p_rotation));
	if (!(std::fabs(norm - 1.0f) <= 0.01f)) {
		return p_bone + format("'s %s is not a rotation (norm %f instead of 1)", p_name, double(norm));
	}
	return "";
}

std::string find_size_fault(const Limb &p_limb) {
	if (p_limb.type != Limb::PILL && p_limb.type != Limb::BOX) {
		return format("'s type is %d instead of PILL (0) or BOX (1)", int(p_limb.type));
	}
	if (p_limb.type == Limb::PILL) {
		const bool is_fine =
				p_limb.radius >= THINNEST && p_limb.radius < 2.0f && p_limb.length >= 0.0f && p_limb.length < 4.0f;
		return is_fine ? ""
					   : "'s radius or length is no size of a limb (radius above 0, 1 mm to 2 m, length below 4 m)";
	}
	const Vec3 &size = p_limb.size;
	const bool is_fine = size.x >= THINNEST && size.y >= THINNEST && size.z >= THINNEST && size.length() < 4.0f;
	return is_fine ? "" : "'s sizes must be above 0 and those of a limb (1 mm to 4 m)";
}

std::string find_contact_fault(const Limb &p_limb) {
	if (!(p_limb.contact_radius >= 0.0f && p_limb.contact_radius < 2.0f)) {
		return format("'s contact_radius is %f instead of 0 to 2 m", double(p_limb.contact_radius));
	}
	if (p_limb.contact_points.size() > MAX_CONTACT_POINTS) {
		return format(
				" has %zu contact points, at most %zu can be used", p_limb.contact_points.size(), MAX_CONTACT_POINTS);
	}
	for (const Vec3 &point : p_limb.contact_points) {
		if (!point.is_finite()) {
			return " has a contact point that is not finite";
		}
	}
	return "";
}

std::string find_angle_fault(const Limb &p_limb) {
	const float low[3] = { p_limb.min_angles.x, p_limb.min_angles.y, p_limb.min_angles.z };
	const float high[3] = { p_limb.max_angles.x, p_limb.max_angles.y, p_limb.max_angles.z };
	for (int axis = 0; axis < 3; axis++) {
		// A hair beyond half a circle, as an editor rounds.
		if (!(low[axis] >= -PI - 1e-3f && low[axis] <= high[axis] && high[axis] <= PI + 1e-3f)) {
			return format(
					"'s %c angles are %f to %f rad: min_angles must not be above max_angles, both within half a circle",
					"XYZ"[axis], double(low[axis]), double(high[axis]));
		}
	}
	return "";
}

} // namespace

Vec3 shape_inertia(const Limb &p_limb, float p_mass) {
	if (p_limb.type == Limb::BOX) {
		const Vec3 &size = p_limb.size;
		return { box_moment(p_mass, size.y, size.z), box_moment(p_mass, size.x, size.z),
			box_moment(p_mass, size.x, size.y) };
	}
	// A cylinder with two half balls, by volume.
	const float square = p_limb.radius * p_limb.radius;
	const float half = p_limb.length / 2.0f;
	const float cylinder = PI * square * p_limb.length;
	const float ball = 4.0f / 3.0f * PI * square * p_limb.radius;
	const float density = p_mass / (cylinder + ball);
	const float along = density * square * (cylinder / 2.0f + 0.4f * ball);
	const float across = density *
			(cylinder * (square / 4.0f + p_limb.length * p_limb.length / 12.0f) +
					ball * (0.4f * square + half * half + 0.75f * p_limb.radius * half));
	return { across, along, across };
}

Vec3 body_inertia(const Limb &p_limb, float p_mass) {
	const Vec3 own = shape_inertia(p_limb, p_mass);
	// The diagonal of R I R^T, whose entry for an axis is that of I along the axis seen by the shape.
	const Quat to_shape = p_limb.orientation.inverse() * p_limb.rest_orientation;
	const Vec3 axes[3] = { to_shape.rotate({ 1, 0, 0 }), to_shape.rotate({ 0, 1, 0 }), to_shape.rotate({ 0, 0, 1 }) };
	float moments[3] = {};
	for (int i = 0; i < 3; i++) {
		moments[i] = axes[i].x * axes[i].x * own.x + axes[i].y * axes[i].y * own.y + axes[i].z * axes[i].z * own.z;
	}
	return { moments[0], moments[1], moments[2] };
}

Quat joint_axes(const Limb &p_limb) {
	const Quat to_reset = p_limb.reset_orientation * p_limb.rest_orientation.inverse();
	const Vec3 along = to_reset.rotate(p_limb.position - p_limb.anchor);
	const float h = std::sqrt(0.5f);
	if (std::fabs(along.y) >= std::fabs(along.x) && std::fabs(along.y) >= std::fabs(along.z)) {
		// Y is the front (model's Z): X up gives Z = model's X, X down gives Z = model's -X.
		return along.y >= 0.0f ? Quat{ 0.5f, 0.5f, 0.5f, 0.5f } : Quat{ 0.5f, -0.5f, -0.5f, 0.5f };
	}
	if (std::fabs(along.x) >= std::fabs(along.z)) {
		return along.x >= 0.0f ? Quat{} : Quat{ 0.0f, 1.0f, 0.0f, 0.0f };
	}
	return along.z >= 0.0f ? Quat{ 0.0f, -h, 0.0f, h } : Quat{ 0.0f, h, 0.0f, h };
}

std::string find_fault(const Limb &p_limb) {
	if (p_limb.bone.empty()) {
		return "it names no bone";
	}
	const std::string bone = shortened(p_limb.bone);
	if (p_limb.group.empty()) {
		return bone + " is in no strength group (such as trunk or left_arm)";
	}
	if (!p_limb.position.is_finite() || !p_limb.anchor.is_finite()) {
		return bone + " has a position that is not finite";
	}
	if (!(p_limb.position.length() < FURTHEST_M && p_limb.anchor.length() < FURTHEST_M)) {
		return bone +
				format(" has a position or anchor further than %.0f m from the model's origin", double(FURTHEST_M));
	}
	const std::pair<const char *, const Quat *> rotations[3] = { { "orientation", &p_limb.orientation },
		{ "rest_orientation", &p_limb.rest_orientation }, { "reset_orientation", &p_limb.reset_orientation } };
	for (const auto &[name, rotation] : rotations) {
		const std::string fault = find_rotation_fault(bone, name, *rotation);
		if (!fault.empty()) {
			return fault;
		}
	}
	if (!(p_limb.mass_fraction >= MIN_FRACTION && p_limb.mass_fraction <= 1.0f)) {
		return bone +
				format("'s mass_fraction is %f instead of %g to 1", double(p_limb.mass_fraction), double(MIN_FRACTION));
	}
	// The root hangs on nothing: its torque is that of the joint to the world.
	const float least = p_limb.parent_bone.empty() ? 0.0f : 1e-6f;
	if (!(p_limb.max_torque >= least && std::isfinite(p_limb.max_torque))) {
		return bone + format("'s max_torque is %f N m instead of above 0", double(p_limb.max_torque));
	}
	for (const auto &find : { find_size_fault, find_contact_fault, find_angle_fault }) {
		const std::string fault = find(p_limb);
		if (!fault.empty()) {
			return bone + fault;
		}
	}
	return "";
}

std::string find_fault(const std::vector<Limb> &p_limbs, double p_mass) {
	if (p_limbs.empty()) {
		return "there are no limbs";
	}
	if (p_limbs.size() > MAX_LIMBS) {
		return format("there are %zu limbs, at most %zu can be simulated", p_limbs.size(), MAX_LIMBS);
	}
	if (!(p_mass >= LIGHTEST && p_mass <= HEAVIEST)) {
		return format("the mass is %f kg instead of %.0f to %.0f", p_mass, LIGHTEST, HEAVIEST);
	}
	std::unordered_set<std::string> seen;
	double total = 0.0;
	for (std::size_t i = 0; i < p_limbs.size(); i++) {
		const Limb &limb = p_limbs[i];
		if (limb.bone.empty()) {
			return format("limb %zu: it names no bone", i);
		}
		const std::string bone = shortened(limb.bone);
		if (seen.count(limb.bone) > 0) {
			return bone + " is there twice";
		}
		if (seen.empty() != limb.parent_bone.empty()) {
			return bone + ": the first limb, and only the first, must be without a parent";
		}
		if (!limb.parent_bone.empty() && seen.count(limb.parent_bone) == 0) {
			return bone + " comes before its parent " + shortened(limb.parent_bone);
		}
		const std::string fault = find_fault(limb);
		if (!fault.empty()) {
			return fault;
		}
		seen.insert(limb.bone);
		total += double(limb.mass_fraction);
	}
	if (!(std::fabs(total - 1.0) <= 0.01)) {
		return format("the mass fractions add up to %f instead of 1", total);
	}
	return "";
}

} // namespace ragdoll
