// SPDX-License-Identifier: MIT
#pragma once

#include <base/vectors.hpp>
#include <joint/joint_drive.hpp>

#include <godot_cpp/variant/rid.hpp>

#include <array>
#include <cstdint>

namespace godot {

/// The engine's 6DOF joint that holds one limb, and what it was told last: only what changes is told again.
class LimbJoint {
public:
	/// What moves the joint about its axes.
	enum class Drive : std::uint8_t {
		UNKNOWN,
		MOTOR,
		SPRING,
		FREE
	};

	LimbJoint() = default;
	/// @param p_axes of the joint, in the limb's frame
	/// @param p_rest the parent's reset orientation to the limb's
	LimbJoint(const RID &p_joint, const ragdoll::Quat &p_axes, const ragdoll::Quat &p_rest) :
			_joint(p_joint), _axes(p_axes), _rest_inverse(p_rest.inverse()) {}

	const RID &get_rid() const { return _joint; }
	void set_drive(Drive p_drive);
	/// Lets the joint hold the parent no longer, or again.
	void set_loose(bool p_loose);
	/// Limits the motors' torque, N m.
	void set_torque(float p_torque);
	/// Lowers the motors' torque to a share of what was set.
	void weaken(float p_share);
	/// Lets the motors turn with a velocity about the limb's axes, rad/s.
	void turn(const ragdoll::Vec3 &p_velocity);
	/// Lets the springs pull to the command's target.
	void pull(const ragdoll::LimbCommand &p_command);

private:
	RID _joint;
	ragdoll::Quat _axes;
	ragdoll::Quat _rest_inverse;
	Drive _drive = Drive::UNKNOWN;
	bool _is_loose = false;
	float _torque = -1.0f;
	ragdoll::Vec3 _stiffness{ -1.0f, 0.0f, 0.0f };
	ragdoll::Vec3 _damping;
	std::array<float, 3> _velocity{ { 0.0f, 0.0f, 0.0f } };
};

} // namespace godot
