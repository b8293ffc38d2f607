// SPDX-License-Identifier: MIT
#pragma once

#include <body/rig.hpp>
#include <root/root_drive.hpp>

#include <godot_cpp/variant/rid.hpp>
#include <godot_cpp/variant/transform3d.hpp>

namespace godot {

/// What keeps a body upright in the two root modes that are here for comparison only (see
/// src/comparison/comparison.hpp): the weight of PENDULUM (thesis 8.4.3) and the trunk's joint to the world of
/// SELF_RIGHTING (thesis 8.4.4).
class RootAssist {
public:
	/// A limb's body, and where its joint is on it.
	struct Handle {
		RID body;
		Transform3D frame;
		ragdoll::Quat axes; ///< Of the joint, in the limb's frame.
	};
	/// What it is made of.
	struct Parts {
		RID space;
		RID anchor; ///< A static body.
		Handle root;
		Handle trunk; ///< No body where the ragdoll has no trunk besides the root.
		float mass = 0.0f; ///< Of the whole body, kg.
		const ragdoll::RigState *state = nullptr; ///< Null where it is not known: PENDULUM has no weight then.
	};

	/// Makes what a mode needs.
	RootAssist(ragdoll::RootMode p_mode, const Parts &p_parts);
	~RootAssist();
	RootAssist(const RootAssist &) = delete;
	RootAssist &operator=(const RootAssist &) = delete;

	ragdoll::RootMode get_mode() const { return _mode; }
	/// Drives what there is in a step.
	void drive(const ragdoll::RootCommand &p_command);

private:
	void make_pendulum(const Parts &p_parts);
	void make_trunk_joint(const Parts &p_parts);

	ragdoll::RootMode _mode;
	RID _pendulum;
	RID _joint;
	ragdoll::Quat _axes; // Of the joint, in its limb's frame.
	float _torque = -1.0f; // That was written last, N m.
};

} // namespace godot
