// SPDX-License-Identifier: MIT
#pragma once

#include <motion_cueing.hpp>

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/vector3.hpp>

namespace godot {

/// Classical washout within a platform's limits. Documented in doc_classes/MotionCueing.xml.
class MotionCueing : public RefCounted {
	GDCLASS(MotionCueing, RefCounted)

public:
	/// Direction of a high-pass for translation.
	enum Direction {
		DIRECTION_HORIZONTAL,
		DIRECTION_VERTICAL,
	};

	void set_translation_limits(const Vector3 &p_travel, const Vector3 &p_speed, const Vector3 &p_acceleration);
	void set_rotation_limits(const Vector3 &p_angle, const Vector3 &p_rate, const Vector3 &p_acceleration);
	void set_translation(Direction p_direction, double p_scale, double p_limit, double p_frequency, double p_damping,
			double p_third_pole);
	void set_tilt(double p_frequency, double p_damping, double p_max_rate, double p_max_angle);
	void set_rotation(double p_scale, double p_limit, double p_frequency, double p_damping, int64_t p_order);
	void set_ramps(double p_dead_man, double p_leave, double p_enter, double p_teleport);
	void reset() { _core.reset(); }
	void set_paused(bool p_paused) { _core.set_paused(p_paused); }
	void teleport() { _core.teleport(); }
	void step(const Vector3 &p_specific_force, const Vector3 &p_rates, double p_seconds);
	void step_without_news(double p_seconds);
	Vector3 get_position() const;
	Vector3 get_attitude() const;
	Vector3 get_filtered_position() const;
	Vector3 get_filtered_velocity() const;
	Vector3 get_filtered_acceleration() const;
	Vector3 get_filtered_attitude() const;
	Vector3 get_tilt() const;
	double get_gain() const { return _core.gain(); }

	const cueing::MotionCueing &core() const { return _core; }

protected:
	static void _bind_methods();

private:
	cueing::MotionCueing _core;
	std::array<cueing::AxisLimits, 3> _travel{};
	std::array<cueing::AxisLimits, 3> _attitude{};
};

} // namespace godot

VARIANT_ENUM_CAST(godot::MotionCueing::Direction);
