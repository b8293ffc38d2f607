// SPDX-License-Identifier: MIT
#pragma once

#include <base/vectors.hpp>

#include <godot_cpp/classes/physics_server3d.hpp>
#include <godot_cpp/variant/rid.hpp>
#include <godot_cpp/variant/transform3d.hpp>

// What RagdollBodies and RootAssist do with the engine's 6DOF joints alike.
namespace godot {

inline PhysicsServer3D *server() {
	return PhysicsServer3D::get_singleton();
}

/// Makes a joint whose motors, and nothing else, hold body B where they are told.
RID make_motor_joint(const RID &p_a, const Transform3D &p_frame_a, const RID &p_b, const Transform3D &p_frame_b);

/// Lets the angular motors of a joint turn with a velocity about the joint's axes, rad/s.
void set_motor_velocity(const RID &p_joint, const ragdoll::Vec3 &p_velocity);

/// Limits the torque of a joint's angular motors (N m), if it is another one than was written last.
void set_motor_torque(const RID &p_joint, float p_torque, float &r_written);

} // namespace godot
