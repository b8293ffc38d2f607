// SPDX-License-Identifier: MIT
#pragma once

#include <turret.hpp>

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/vector2.hpp>
#include <godot_cpp/variant/vector3.hpp>

namespace godot {

/// Turns a turret and its gun. Documented in doc_classes/TurretDrive.xml.
class TurretDrive : public RefCounted {
	GDCLASS(TurretDrive, RefCounted)

public:
	bool configure(const Vector2 &p_rates, const Vector2 &p_accelerations, double p_yaw_limit, double p_pitch_min,
			double p_pitch_max);
	void step(const Transform3D &p_hull, const Vector3 &p_hull_rate, double p_yaw, double p_pitch, double p_delta);
	void place(double p_yaw, double p_pitch);
	void set_stabilised(bool p_is_stabilised) { _drive.set_stabilised(p_is_stabilised); }
	bool is_stabilised() const { return _drive.is_stabilised(); }
	double get_yaw() const { return _drive.yaw(); }
	double get_pitch() const { return _drive.pitch(); }
	Vector3 get_aim() const { return { _drive.aim().x, _drive.aim().y, _drive.aim().z }; }

protected:
	static void _bind_methods();

private:
	vehicle::TurretDrive _drive;
};

} // namespace godot
