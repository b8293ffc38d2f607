// SPDX-License-Identifier: MIT
#pragma once

#include <root/residual_meter.hpp>

#include <godot_cpp/variant/rid.hpp>

namespace godot {

/// What the hips' joint holds on to: a body without a shape that stands for the world, and weighs what the joint does.
///
/// The engine does not tell the forces of its joints. The anchor is a free body, but so heavy that it yields by less
/// than a nanometre a step; what the joint did to it in the step it has as velocity, which is read and taken away
/// again. Force = mass x velocity / step (Newton's third law).
class WorldAnchor {
public:
	WorldAnchor() = default;
	~WorldAnchor() { free(); }
	WorldAnchor(const WorldAnchor &) = delete;
	WorldAnchor &operator=(const WorldAnchor &) = delete;

	void make(const RID &p_space);
	void free();
	const RID &get_rid() const { return _body; }
	/// What the joint did to the person in the last step, of p_delta_s seconds; about p_at, m. Zero where the space
	/// has not stepped since.
	ragdoll::Residual weigh(const ragdoll::Vec3 &p_at, float p_delta_s);

private:
	RID _body;
};

} // namespace godot
