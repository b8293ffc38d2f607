// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/array.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/quaternion.hpp>
#include <godot_cpp/variant/rid.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/typed_array.hpp>
#include <godot_cpp/variant/vector3.hpp>

namespace bindings_test {

/// Values in both directions: arguments, results, defaults, properties, signals, enums.
class BindingsProbe : public godot::RefCounted {
	GDCLASS(BindingsProbe, godot::RefCounted)

public:
	enum Mode {
		MODE_IDLE = 0,
		MODE_RUN = 5,
	};

	BindingsProbe() { alive++; }
	~BindingsProbe() override { alive--; }

	int64_t add(int64_t p_a, int64_t p_b) const { return p_a + p_b; }
	double scale(double p_a, double p_b) const { return p_a * p_b * gain; }
	bool flip(bool p_value) const { return !p_value; }
	godot::String greet(const godot::String &p_name) const;
	int64_t utf8_length(const godot::String &p_text) const { return p_text.utf8().length(); }
	godot::StringName echo_name(const godot::StringName &p_name) const { return p_name; }
	godot::Variant echo(const godot::Variant &p_value) const { return p_value; }
	godot::Vector3 cross(const godot::Vector3 &p_a, const godot::Vector3 &p_b) const { return p_a.cross(p_b); }
	godot::Quaternion multiply(const godot::Quaternion &p_a, const godot::Quaternion &p_b) const { return p_a * p_b; }
	godot::PackedByteArray invert(const godot::PackedByteArray &p_bytes) const;
	godot::PackedFloat32Array prefix_sum(const godot::PackedFloat32Array &p_numbers) const;
	godot::Array reversed(const godot::Array &p_array) const;
	godot::Dictionary describe(const godot::Dictionary &p_dictionary) const;
	int64_t count_valid(const godot::TypedArray<godot::RID> &p_rids) const;
	godot::TypedArray<godot::Vector3> corners() const;
	bool guarded(bool p_fail) const;
	godot::Ref<BindingsProbe> make_child() const;
	godot::Ref<BindingsProbe> hold(const godot::Ref<BindingsProbe> &p_probe);
	void release() { held.unref(); }
	godot::Array make_many(int p_count) const;
	godot::Variant call_back(const godot::Callable &p_callable) const { return p_callable.call(3, "a"); }

	void set_gain(double p_gain);
	double get_gain() const { return gain; }
	void set_mode(Mode p_mode) { mode = p_mode; }
	Mode get_mode() const { return mode; }
	static int64_t alive_count() { return alive; }

protected:
	static void _bind_methods();

private:
	static int64_t alive;

	double gain = 1.0;
	Mode mode = MODE_IDLE;
	godot::Ref<BindingsProbe> held;
};

} // namespace bindings_test

VARIANT_ENUM_CAST(bindings_test::BindingsProbe::Mode);
