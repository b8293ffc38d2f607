// SPDX-License-Identifier: MIT
#include "session/suit_stream.hpp"

#include <algorithm>

namespace xbus {

namespace {

/// Span over which a rate is measured, µs.
constexpr uint64_t METER_USEC = 1000000;
/// A counter that goes back or leaps by more has begun anew.
constexpr uint32_t MAX_STEP = 3000;

std::array<float, 3> narrow(const Sample::Vector &p_vector) {
	return { float(p_vector[0]), float(p_vector[1]), float(p_vector[2]) };
}

} // namespace

void SuitStream::restart(double p_rate_hz) {
	_period_usec = 1e6 / std::max(p_rate_hz, 0.1);
	_clock.reset();
	_has_last = false;
}

void SuitStream::take(const StreamCheck &p_check, uint64_t p_now_usec, SuitFrame &r_frame) {
	for (TrackerReading &reading : r_frame.trackers) {
		reading.has_orientation = reading.has_rate = reading.has_acceleration = reading.has_magnetic = false;
	}
	r_frame.tracker_count = 0;
	for (std::size_t index = 0; index < p_check.sample_count(); ++index) {
		const Sample &sample = p_check.sample(index);
		const int tracker = sample.bus_id >= 1 && sample.bus_id <= MAX_TRACKERS ? sample.bus_id - 1 : 0;
		if (sample.present != 0) {
			r_frame.axes = sample.axes;
			read(sample, r_frame.trackers[std::size_t(tracker)]);
			meter(tracker, p_now_usec);
		}
		r_frame.tracker_count = std::max(r_frame.tracker_count, tracker + 1);
	}
	r_frame.counter = p_check.sample_count() > 0 ? count_on(p_check.sample(0)) : _counter;
	r_frame.arrival_usec = p_now_usec;
	r_frame.time_usec = _clock.timestamp(int64_t(double(r_frame.counter) * _period_usec), p_now_usec);
}

TrackerFlow SuitStream::flow(int p_tracker, uint64_t p_now_usec) const {
	const Meter &meter = _meters[std::size_t(p_tracker)];
	TrackerFlow flow;
	flow.newest_usec = meter.newest_usec;
	const bool is_fresh = meter.newest_usec != 0 && p_now_usec < meter.newest_usec + 2 * METER_USEC;
	flow.rate_hz = is_fresh ? meter.rate_hz : 0.0;
	return flow;
}

uint64_t SuitStream::count_on(const Sample &p_sample) {
	uint32_t step = 1;
	if (p_sample.has(Field::COUNTER)) {
		const uint32_t mask = p_sample.counter_bits >= 32 ? UINT32_MAX : (1U << p_sample.counter_bits) - 1U;
		if (_has_last) {
			const uint32_t forward = (p_sample.counter - _last) & mask;
			step = forward <= MAX_STEP ? forward : 1U;
		}
		_last = p_sample.counter;
		_has_last = true;
	}
	_counter += step;
	return _counter;
}

void SuitStream::meter(int p_tracker, uint64_t p_now_usec) {
	Meter &meter = _meters[std::size_t(p_tracker)];
	meter.newest_usec = p_now_usec;
	const uint64_t span = p_now_usec - meter.began_usec;
	if (meter.began_usec == 0 || span > 3 * METER_USEC) {
		meter = { p_now_usec, p_now_usec, 0, meter.rate_hz };
		return;
	}
	++meter.count;
	if (span >= METER_USEC) {
		meter.rate_hz = meter.count * 1e6 / double(span);
		meter.began_usec = p_now_usec;
		meter.count = 0;
	}
}

void SuitStream::read(const Sample &p_sample, TrackerReading &r_reading) {
	std::array<double, 4> turn{};
	r_reading.has_orientation = p_sample.orientation(turn);
	if (r_reading.has_orientation) {
		r_reading.orientation = { float(turn[0]), float(turn[1]), float(turn[2]), float(turn[3]) };
	}
	r_reading.has_rate = p_sample.has(Field::RATE_OF_TURN);
	if (r_reading.has_rate) {
		r_reading.rate = narrow(p_sample.rate_of_turn);
	}
	r_reading.has_acceleration = p_sample.has(Field::ACCELERATION);
	if (r_reading.has_acceleration) {
		r_reading.acceleration = narrow(p_sample.acceleration);
	}
	r_reading.has_magnetic = p_sample.has(Field::MAGNETIC_FIELD);
	if (r_reading.has_magnetic) {
		r_reading.magnetic = narrow(p_sample.magnetic_field);
	}
}

} // namespace xbus
