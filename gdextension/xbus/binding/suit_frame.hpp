// SPDX-License-Identifier: MIT
#pragma once

#include <session/suit_frame.hpp>

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>

#include <cstdint>

namespace godot {

/// A sample of all trackers of a device. Documented in doc_classes/SuitFrame.xml.
class SuitFrame : public RefCounted {
	GDCLASS(SuitFrame, RefCounted)

public:
	/// In the order of `xbus::Axes`.
	enum Axes {
		AXES_EAST_NORTH_UP,
		AXES_NORTH_EAST_DOWN,
		AXES_NORTH_WEST_UP,
		AXES_UNKNOWN,
	};

	/// `p_unix_ahead_usec`: Unix time less the frame's, µs.
	static Ref<SuitFrame> make(const xbus::SuitFrame &p_frame, int64_t p_unix_ahead_usec);

	int64_t get_time_usec() const { return _time_usec; }
	int64_t get_counter() const { return _counter; }
	Axes get_axes() const { return _axes; }
	PackedByteArray get_present() const { return _present; }
	PackedFloat32Array get_orientations() const { return _orientations; }
	PackedVector3Array get_rates() const { return _rates; }
	PackedVector3Array get_accelerations() const { return _accelerations; }
	PackedVector3Array get_magnetics() const { return _magnetics; }

protected:
	static void _bind_methods();

private:
	int64_t _time_usec = 0;
	int64_t _counter = 0;
	Axes _axes = AXES_UNKNOWN;
	PackedByteArray _present;
	PackedFloat32Array _orientations;
	PackedVector3Array _rates;
	PackedVector3Array _accelerations;
	PackedVector3Array _magnetics;
};

} // namespace godot

VARIANT_ENUM_CAST(SuitFrame::Axes);
