// SPDX-License-Identifier: MIT
#include "session/measurement.hpp"

#include <algorithm>

namespace xbus {

namespace {

/// A device that measures and says nothing for so long, or for so many periods, has fallen silent.
constexpr double SILENT_USEC = 1000000.0;
constexpr double SILENT_PERIODS = 20.0;
/// Samples of a wrong length that are worth a line in the log.
constexpr uint64_t MANY = 20;

} // namespace

void Measurement::begin(const KnownDevice &p_device, const OutputChoice &p_choice, uint64_t p_now_usec) {
	_heard_usec = p_now_usec;
	_check.restart();
	_stream.restart(p_choice.rate_hz(p_device));
	if (p_device.is_master()) {
		_check.expect_devices(std::size_t(p_device.tracker_count));
		_check.expect_master(p_choice.master_format(p_device.tracker_count));
	} else if (!p_device.speaks_mtdata2()) {
		_check.expect_tracker(p_choice.tracker_format());
	}
	_health.restart();
	_refused = _reported_refused = _check.statistics().wrong_sizes;
}

const SuitFrame &Measurement::take(uint64_t p_now_usec) {
	_heard_usec = p_now_usec;
	_stream.take(_check, p_now_usec, _frame);
	return _frame;
}

bool Measurement::is_silent(uint64_t p_now_usec, double p_rate_hz) const {
	const auto patience_usec = uint64_t(std::max(SILENT_USEC, SILENT_PERIODS * 1e6 / p_rate_hz));
	return p_now_usec > _heard_usec + patience_usec;
}

bool Measurement::refuses_many() {
	const uint64_t refused = _check.statistics().wrong_sizes;
	if (refused < _reported_refused + MANY) {
		return false;
	}
	_reported_refused = refused;
	return true;
}

StreamHealth::Finding Measurement::find_damage(const KnownDevice &p_device, uint64_t p_bad_bytes, uint64_t p_now_usec) {
	if (!_health.is_due(p_now_usec)) {
		return StreamHealth::Finding::NOTHING;
	}
	uint64_t received = 0;
	uint64_t lost = 0;
	for (int tracker = 0; tracker < p_device.tracker_count; ++tracker) {
		received += _check.device(p_device.bus_id_of(tracker)).received;
		lost += _check.device(p_device.bus_id_of(tracker)).lost;
	}
	return _health.judge(p_now_usec, received, lost, p_bad_bytes);
}

} // namespace xbus
