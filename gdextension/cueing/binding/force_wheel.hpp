// SPDX-License-Identifier: MIT
#pragma once

#include <evdev/force_driver.hpp>

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/string.hpp>

namespace godot {

/// Force feedback of wheels and sticks on Linux. Documented in doc_classes/ForceWheel.xml.
class ForceWheel : public RefCounted {
	GDCLASS(ForceWheel, RefCounted)

public:
	/// What a device can do.
	enum Force {
		FORCE_CONSTANT,
		FORCE_SPRING,
		FORCE_DAMPER,
		FORCE_PERIODIC,
	};

	static PackedStringArray list_devices();
	void open(const String &p_path);
	void close() { _core.close(); }
	bool is_open() const { return _core.is_open(); }
	bool can(Force p_force) const;
	String get_trouble() const;
	void set_gain(double p_gain) { _core.set_gain(p_gain); }
	void set_constant(double p_level) { _forces.constant = p_level; }
	void set_spring(double p_strength, double p_centre, double p_dead_band);
	void set_damper(double p_strength) { _forces.damper = p_strength; }
	void set_periodic(double p_strength, double p_frequency);
	void apply() { _core.set_forces(_forces); }

protected:
	static void _bind_methods();

private:
	cueing::ForceDriver _core;
	cueing::WheelForces _forces;
};

} // namespace godot

VARIANT_ENUM_CAST(godot::ForceWheel::Force);
