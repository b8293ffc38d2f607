// SPDX-License-Identifier: MIT
#pragma once

#include <quaternion.hpp>

namespace vehicle {

/// How a turret and its gun can move.
struct TurretSettings {
	float yaw_rate = 0.7f; ///< Of the turret at most, rad/s.
	float yaw_acceleration = 2.0f; ///< rad/s^2.
	float yaw_limit = 0.0f; ///< To either side, rad; 0: all the way round.
	float pitch_rate = 0.7f; ///< Of the gun at most, rad/s.
	float pitch_acceleration = 6.0f; ///< rad/s^2.
	float pitch_min = -0.157f; ///< Depression, rad.
	float pitch_max = 0.349f; ///< Elevation, rad.
	float foresight = 0.5f; ///< Share of the last change of the hull's speed that is expected to come again.
};

/// Turns a turret and its gun with limited rates and accelerations, and holds the aim in the world while the hull
/// moves below: a two-axis stabiliser with rate gyros (feed-forward of the hull's angular velocity).
/// Angles are those of the hull's frame: yaw about +Y from ahead (-Z), anticlockwise; pitch up.
class TurretDrive {
public:
	TurretSettings settings;

	/// One step. The hull's orientation in the world and its angular velocity (rad/s, world) are those before the
	/// step; p_yaw and p_pitch are the gunner's, -1 to 1 of the greatest rate, left and up positive.
	void step(const kinematics::Quat &p_hull, const kinematics::Vec3 &p_hull_rate, float p_yaw, float p_pitch,
			float p_delta);
	/// Whether the aim is held in the world; without it turret and gun keep their angles to the hull.
	void set_stabilised(bool p_is_stabilised);
	bool is_stabilised() const { return _is_stabilised; }
	/// Puts both at angles, at rest.
	void place(float p_yaw, float p_pitch);
	float yaw() const { return _yaw; }
	float pitch() const { return _pitch; }
	/// Where the gun is to point in the world, a unit vector; of use while it is stabilised.
	kinematics::Vec3 aim() const { return _aim; }

private:
	void _follow_gunner(float p_yaw, float p_pitch, float p_delta);
	void _hold_aim(const kinematics::Quat &p_hull, const kinematics::Vec3 &p_hull_rate, float p_delta);

	float _yaw = 0.0f;
	float _pitch = 0.0f;
	float _yaw_speed = 0.0f;
	float _pitch_speed = 0.0f;
	float _yaw_order = 0.0f; ///< What the gunner's hand asks for, as fast as the drives can follow, rad/s.
	float _pitch_order = 0.0f;
	bool _is_stabilised = true;
	bool _has_aim = false;
	float _target_yaw = 0.0f; ///< Where turret and gun were to be after the last step, rad.
	float _target_pitch = 0.0f;
	kinematics::Vec3 _aim{ 0.0f, 0.0f, -1.0f };
	kinematics::Vec3 _last_rate;
};

} // namespace vehicle
