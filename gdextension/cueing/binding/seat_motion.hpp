// SPDX-License-Identifier: MIT
#pragma once

#include <motion_estimator.hpp>

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/vector3.hpp>

namespace godot {

/// Specific force and rates of what moves. Documented in doc_classes/SeatMotion.xml.
class SeatMotion : public RefCounted {
	GDCLASS(SeatMotion, RefCounted)

public:
	bool push_state(double p_time, const Transform3D &p_transform);
	bool estimate(double p_time);
	void clear() { _core.clear(); }
	Vector3 get_specific_force() const;
	Vector3 get_rates() const;
	Vector3 get_velocity() const;

protected:
	static void _bind_methods();

private:
	cueing::MotionEstimator _core;
	cueing::SeatMotion _motion;
};

} // namespace godot
