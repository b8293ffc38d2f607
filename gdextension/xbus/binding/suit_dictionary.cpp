// SPDX-License-Identifier: MIT
#include "suit_dictionary.hpp"

#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>
#include <godot_cpp/variant/vector3.hpp>

namespace godot {

Dictionary suit_frame_dictionary(const xbus::SuitFrame &p_frame, int64_t p_unix_ahead) {
	PackedFloat32Array orientations;
	PackedVector3Array rates;
	PackedVector3Array accelerations;
	PackedByteArray present;
	const int count = p_frame.tracker_count;
	orientations.resize(int64_t(count) * 4);
	rates.resize(count);
	accelerations.resize(count);
	present.resize(count);
	bool has_rates = false;
	bool has_accelerations = false;
	for (int tracker = 0; tracker < count; ++tracker) {
		const xbus::TrackerReading &reading = p_frame.trackers[std::size_t(tracker)];
		present[tracker] = reading.has_orientation ? 1 : 0;
		for (int part = 0; part < 4; ++part) {
			orientations[tracker * 4 + part] = reading.orientation[std::size_t(part)];
		}
		rates[tracker] = Vector3(reading.rate[0], reading.rate[1], reading.rate[2]);
		accelerations[tracker] = Vector3(reading.acceleration[0], reading.acceleration[1], reading.acceleration[2]);
		has_rates = has_rates || reading.has_rate;
		has_accelerations = has_accelerations || reading.has_acceleration;
	}
	Dictionary result;
	result["time_usec"] = int64_t(p_frame.time_usec) + p_unix_ahead;
	result["arrival_usec"] = int64_t(p_frame.arrival_usec) + p_unix_ahead;
	result["counter"] = int64_t(p_frame.counter);
	result["axes"] = int64_t(p_frame.axes);
	result["present"] = present;
	result["orientations"] = orientations;
	result["rates"] = has_rates ? rates : PackedVector3Array();
	result["accelerations"] = has_accelerations ? accelerations : PackedVector3Array();
	return result;
}

} // namespace godot
