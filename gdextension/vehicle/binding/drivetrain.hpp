// SPDX-License-Identifier: MIT
#pragma once

#include <engine.hpp>

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/packed_vector2_array.hpp>

namespace godot {

/// Engine, gearbox, brakes and steering of a vehicle. Documented in doc_classes/VehicleDrivetrain.xml.
class VehicleDrivetrain : public RefCounted {
	GDCLASS(VehicleDrivetrain, RefCounted)

public:
	void set_engine(const PackedVector2Array &p_curve, double p_idle_rpm, double p_max_rpm, double p_inertia,
			double p_friction, double p_response);
	double get_rpm() const { return _engine.rpm(); }
	double get_load() const { return _engine.load(); }
	void set_running(bool p_running) { _engine.set_running(p_running); }
	bool is_running() const { return _engine.is_running(); }

protected:
	static void _bind_methods();

private:
	vehicle::Engine _engine;
};

} // namespace godot
