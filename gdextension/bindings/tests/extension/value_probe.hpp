// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/callable.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>
#include <godot_cpp/variant/typed_array.hpp>

namespace probe {

/// Carries values of every type through the bindings.
class ValueProbe : public godot::RefCounted {
	GDCLASS(ValueProbe, godot::RefCounted)

public:
	enum Mode {
		MODE_IDLE = 0,
		MODE_RUN = 5,
	};
	enum Flags {
		FLAG_A = 1,
		FLAG_B = 4,
	};

	ValueProbe() { alive++; }
	~ValueProbe() override { alive--; }
	static int64_t get_alive() { return alive; }

	int64_t add(int64_t p_left, int64_t p_right) const { return p_left + p_right; }
	int32_t add_small(int32_t p_left, uint8_t p_right) const { return p_left + p_right; }
	double scale(double p_value, double p_factor) const { return p_value * p_factor * _gain; }
	bool flip(bool p_value) const { return !p_value; }
	godot::String greet(const godot::String &p_name) const;
	godot::StringName echo_name(const godot::StringName &p_name) const { return p_name; }
	godot::Variant echo(const godot::Variant &p_value) const { return p_value; }
	godot::Variant call_back(const godot::Callable &p_function) const;
	godot::Callable own_callable() { return godot::Callable(this, "get_gain"); }

	godot::PackedByteArray invert(const godot::PackedByteArray &p_bytes) const;
	godot::PackedFloat32Array prefix_sum(const godot::PackedFloat32Array &p_values) const;
	godot::PackedVector3Array literals() const;
	godot::Array reversed(const godot::Array &p_array) const;
	godot::Dictionary describe(const godot::Dictionary &p_dictionary) const;
	godot::TypedArray<godot::Vector3> doubled(const godot::TypedArray<godot::Vector3> &p_vectors) const;
	godot::TypedArray<godot::Resource> resources(int p_count) const;
	godot::String formatted(const godot::String &p_name, int p_number) const;

	godot::Ref<ValueProbe> make_child() const;
	godot::Array make_many(int p_count) const;
	godot::Ref<ValueProbe> hold(const godot::Ref<ValueProbe> &p_probe);
	void release() { _held.unref(); }

	void set_gain(double p_gain);
	double get_gain() const { return _gain; }
	void set_mode(Mode p_mode) { _mode = p_mode; }
	Mode get_mode() const { return _mode; }
	void set_flags(godot::BitField<Flags> p_flags) { _flags = p_flags; }
	godot::BitField<Flags> get_flags() const { return _flags; }

	/// Leaves early, with an error, by each of the checks.
	int guarded(int p_index, const godot::Object *p_object) const;

protected:
	static void _bind_methods();

private:
	static int64_t alive;

	double _gain = 1.0;
	Mode _mode = MODE_IDLE;
	godot::BitField<Flags> _flags = FLAG_A;
	godot::Ref<ValueProbe> _held;
};

} // namespace probe

VARIANT_ENUM_CAST(probe::ValueProbe::Mode);
VARIANT_BITFIELD_CAST(probe::ValueProbe::Flags);
