// SPDX-License-Identifier: MIT
#include "suit_frame.hpp"

#include <godot_cpp/variant/vector3.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

namespace godot {

namespace {

static_assert(SuitFrame::AXES_UNKNOWN == int(xbus::Axes::UNKNOWN), "The axes are not those of the bus.");

/// One vector of each tracker, or nothing where no tracker sends it.
PackedVector3Array vectors_of(const xbus::SuitFrame &p_frame, std::array<float, 3> xbus::TrackerReading::*p_vector,
		bool xbus::TrackerReading::*p_has) {
	const auto end = p_frame.trackers.begin() + p_frame.tracker_count;
	PackedVector3Array vectors;
	if (!std::any_of(p_frame.trackers.begin(), end, [&](const auto &p_reading) { return p_reading.*p_has; })) {
		return vectors;
	}
	vectors.resize(p_frame.tracker_count);
	std::transform(p_frame.trackers.begin(), end, vectors.ptrw(), [&](const auto &p_reading) {
		const std::array<float, 3> &vector = p_reading.*p_vector;
		return Vector3(vector[0], vector[1], vector[2]);
	});
	return vectors;
}

} // namespace

Ref<SuitFrame> SuitFrame::make(const xbus::SuitFrame &p_frame, int64_t p_unix_ahead_usec) {
	Ref<SuitFrame> frame;
	frame.instantiate();
	frame->_time_usec = int64_t(p_frame.time_usec) + p_unix_ahead_usec;
	frame->_counter = int64_t(p_frame.counter);
	frame->_axes = Axes(p_frame.axes);
	frame->_present.resize(p_frame.tracker_count);
	frame->_orientations.resize(int64_t(p_frame.tracker_count) * 4);
	uint8_t *present = frame->_present.ptrw();
	float *orientations = frame->_orientations.ptrw();
	for (std::size_t tracker = 0; tracker < std::size_t(p_frame.tracker_count); ++tracker) {
		const xbus::TrackerReading &reading = p_frame.trackers[tracker];
		present[tracker] = reading.has_orientation ? 1 : 0;
		std::copy(reading.orientation.begin(), reading.orientation.end(), orientations + tracker * 4);
	}
	frame->_rates = vectors_of(p_frame, &xbus::TrackerReading::rate, &xbus::TrackerReading::has_rate);
	frame->_accelerations =
			vectors_of(p_frame, &xbus::TrackerReading::acceleration, &xbus::TrackerReading::has_acceleration);
	frame->_magnetics = vectors_of(p_frame, &xbus::TrackerReading::magnetic, &xbus::TrackerReading::has_magnetic);
	return frame;
}

void SuitFrame::_bind_methods() {
	ClassDB::bind_method(D_METHOD("get_time_usec"), &SuitFrame::get_time_usec);
	ClassDB::bind_method(D_METHOD("get_counter"), &SuitFrame::get_counter);
	ClassDB::bind_method(D_METHOD("get_axes"), &SuitFrame::get_axes);
	ClassDB::bind_method(D_METHOD("get_present"), &SuitFrame::get_present);
	ClassDB::bind_method(D_METHOD("get_orientations"), &SuitFrame::get_orientations);
	ClassDB::bind_method(D_METHOD("get_rates"), &SuitFrame::get_rates);
	ClassDB::bind_method(D_METHOD("get_accelerations"), &SuitFrame::get_accelerations);
	ClassDB::bind_method(D_METHOD("get_magnetics"), &SuitFrame::get_magnetics);
	BIND_ENUM_CONSTANT(AXES_EAST_NORTH_UP);
	BIND_ENUM_CONSTANT(AXES_NORTH_EAST_DOWN);
	BIND_ENUM_CONSTANT(AXES_NORTH_WEST_UP);
	BIND_ENUM_CONSTANT(AXES_UNKNOWN);
}

} // namespace godot
