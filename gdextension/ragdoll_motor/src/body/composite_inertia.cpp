// SPDX-License-Identifier: MIT
#include "body/composite_inertia.hpp"

namespace ragdoll {

void CompositeInertia::Composite::add(const Composite &p_other) {
	mass += p_other.mass;
	first = first + p_other.first;
	diagonal = diagonal + p_other.diagonal;
	products = products + p_other.products;
}

void CompositeInertia::Composite::set_body(const Vec3 &p_moments, const Axes &p_axes, const Vec3 &p_centre) {
	// R diag(I) R^T by the columns of R, and Steiner's theorem.
	const auto &[x, y, z] = p_axes;
	const Vec3 &c = p_centre;
	const Vec3 square = c.scaled(c) * mass;
	first = c * mass;
	diagonal = x.scaled(x) * p_moments.x + y.scaled(y) * p_moments.y + z.scaled(z) * p_moments.z +
			Vec3{ square.y + square.z, square.x + square.z, square.x + square.y };
	const auto crossed = [](const Vec3 &p_v) { return Vec3{ p_v.y * p_v.z, p_v.x * p_v.z, p_v.x * p_v.y }; };
	products = crossed(x) * p_moments.x + crossed(y) * p_moments.y + crossed(z) * p_moments.z - crossed(c) * mass;
}

Vec3 CompositeInertia::Composite::moments_about(const Vec3 &p_point, const Axes &p_axes) const {
	// Steiner's theorem from one point to another, neither of which is the centre: I about p is
	// I about 0 - 2 (first . p) + m (p . p), with the products likewise.
	const Vec3 &p = p_point;
	const Vec3 both = first.scaled(p) * 2.0f - p.scaled(p) * mass;
	const Vec3 d = diagonal - Vec3{ both.y + both.z, both.x + both.z, both.x + both.y };
	const Vec3 o = products +
			Vec3{ first.y * p.z + first.z * p.y, first.x * p.z + first.z * p.x, first.x * p.y + first.y * p.x } -
			Vec3{ p.y * p.z, p.x * p.z, p.x * p.y } * mass;
	const auto along = [&](const Vec3 &p_axis) {
		return d.dot(p_axis.scaled(p_axis)) +
				2.0f * (o.x * p_axis.y * p_axis.z + o.y * p_axis.x * p_axis.z + o.z * p_axis.x * p_axis.y);
	};
	return { along(p_axes.x), along(p_axes.y), along(p_axes.z) };
}

void CompositeInertia::find(const Rig &p_rig, const RigState &p_state) {
	for (std::size_t i = 0; i < p_rig.size(); i++) {
		_composites[i].mass = p_rig[i].mass;
		const Quat &turn = p_state.orientations[i];
		const Vec3 x = turn.rotate({ 1.0f, 0.0f, 0.0f });
		const Vec3 y = turn.rotate({ 0.0f, 1.0f, 0.0f });
		_axes[i] = { x, y, x.cross(y) };
		_composites[i].set_body(p_rig[i].inertia, _axes[i], p_state.centres[i] - p_state.root);
	}
	for (std::size_t i = p_rig.size(); i-- > 0;) {
		_moments[i] = _composites[i].moments_about(p_rig.joint_of(p_state, i) - p_state.root, _axes[i]);
		if (p_rig[i].parent >= 0) {
			_composites[std::size_t(p_rig[i].parent)].add(_composites[i]);
		}
	}
}

} // namespace ragdoll
