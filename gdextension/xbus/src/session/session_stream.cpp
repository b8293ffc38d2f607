// SPDX-License-Identifier: MIT
#include "session/session.hpp"

#include "bus/data_item.hpp"

#include <algorithm>

namespace xbus {

namespace {

/// A device that measures and says nothing for so long is brought up anew.
constexpr uint64_t SILENT_USEC = 1000000;
constexpr double SILENT_PERIODS = 20.0;
constexpr uint64_t BATTERY_USEC = 30000000;
/// Damage on the line is judged over so long, and told from so much on.
constexpr uint64_t JUDGE_USEC = 5000000;
constexpr double MUCH_LOST = 0.01;

} // namespace

void Session::begin_measuring() {
	_problem.fill(0);
	_is_silent = false;
	_heard_usec = _now_usec;
	_battery_usec = _now_usec;
	_check.restart();
	_stream.restart(rate_hz());
	if (is_master()) {
		_check.expect_devices(std::size_t(_tracker_count));
		_check.expect_master(master_format());
	} else if (!speaks_mtdata2()) {
		_check.expect_tracker(tracker_format());
	}
	// A false length must not hold back what comes behind it.
	_framer.set_longest(std::max<std::size_t>(_check.data_size(), Configuration::MAX_BYTES));
	_judged_usec = 0;
	_refused = _reported_refused = _check.statistics().wrong_sizes;
	log(Severity::INFO, "%s %08X measures: %d tracker%s at %.0f Hz", device_kind_name(_kind), _device_id,
			_tracker_count, _tracker_count == 1 ? "" : "s", rate_hz());
}

void Session::take_data() {
	if (_step == Step::MEASURE && _tries > 1) {
		go_to(Step::MEASURING); // The answer was lost.
	}
	if (_step != Step::MEASURING) {
		return;
	}
	_heard_usec = _now_usec;
	_in_vain = 0;
	_stream.take(_check, _now_usec, _frame);
	if (_kind == DeviceKind::XBUS_MASTER || _frame.tracker_count <= _tracker_count) {
		_host.take_frame(_frame);
	}
}

void Session::look_after_stream() {
	note_refusals();
	note_damage();
	const auto patience_usec = uint64_t(std::max(double(SILENT_USEC), SILENT_PERIODS * 1e6 / rate_hz()));
	if (_now_usec > _heard_usec + patience_usec) {
		_is_silent = true;
		start_over(_check.statistics().wrong_sizes > _refused ? "sends nothing that can be used" : "has fallen silent");
		return;
	}
	if (_battery >= 0.0 && _now_usec > _battery_usec + BATTERY_USEC) {
		_battery_usec = _now_usec;
		const Request request = host::request_battery_level();
		_host.send(request.bytes.data(), request.size);
	}
}

/// A device that sends something else than it was set to.
void Session::note_refusals() {
	constexpr uint64_t MANY = 20;
	const uint64_t refused = _check.statistics().wrong_sizes;
	if (refused >= _reported_refused + MANY) {
		_reported_refused = refused;
		log(Severity::WARNING,
				"sends samples of another length than its settings make (%zu bytes): they are counted and dropped",
				expected_size());
	}
}

/// Tells of a line that damages bytes, by the part of the samples that is lost.
void Session::note_damage() {
	if (_judged_usec != 0 && _now_usec < _judged_usec + JUDGE_USEC) {
		return;
	}
	uint64_t received = 0;
	uint64_t lost = 0;
	for (int tracker = 0; tracker < _tracker_count; ++tracker) {
		received += _check.device(bus_id_of(tracker)).received;
		lost += _check.device(bus_id_of(tracker)).lost;
	}
	const uint64_t bad_bytes = _framer.statistics().skipped_bytes;
	if (_judged_usec != 0) {
		const double came = double(received - _judged_received);
		const double missed = double(lost - _judged_lost);
		const bool lost_much = _lost_share > MUCH_LOST;
		_lost_share = came + missed > 0.0 ? missed / (came + missed) : 0.0;
		if (_lost_share > MUCH_LOST && bad_bytes > _judged_bad_bytes) {
			log(Severity::WARNING,
					"%.0f %% of its samples are lost, for the line damages bytes: look at plug and cable",
					100.0 * _lost_share);
		} else if (_lost_share > MUCH_LOST) {
			log(Severity::WARNING,
					"%.0f %% of its samples are lost: is this machine too busy, or a radio link too weak?",
					100.0 * _lost_share);
		} else if (lost_much) {
			_problem.fill(0);
		}
	}
	_judged_usec = _now_usec;
	_judged_received = received;
	_judged_lost = lost;
	_judged_bad_bytes = bad_bytes;
}

MasterFormat Session::master_format() const {
	MasterFormat format;
	for (int tracker = 0; tracker < _tracker_count; ++tracker) {
		format.add(tracker_format());
	}
	return format;
}

std::size_t Session::expected_size() const {
	return is_master() ? master_format().size() : tracker_format().size();
}

/// What a tracker of the newer kind is asked for.
Request Session::output_configuration(double p_rate_hz) {
	constexpr uint16_t ALWAYS = 0xFFFF;
	const auto rate = uint16_t(std::clamp(p_rate_hz + 0.5, 1.0, 400.0));
	const std::array<OutputRequest, 7> outputs = { {
			{ item::PACKET_COUNTER, ALWAYS },
			{ item::SAMPLE_TIME_FINE, ALWAYS },
			{ item::QUATERNION, rate },
			{ item::RATE_OF_TURN, rate },
			{ item::ACCELERATION, rate },
			// No magnetometer measures faster.
			{ item::MAGNETIC_FIELD, std::min<uint16_t>(rate, 100) },
			{ item::STATUS_WORD, ALWAYS },
	} };
	return host::set_output_configuration(outputs.data(), outputs.size());
}

void Session::report(uint64_t p_now_usec, SessionReport &r_report) const {
	r_report.state = state();
	r_report.device_id = _device_id;
	r_report.kind = _kind;
	r_report.baud = _baud;
	r_report.rate_hz = rate_hz();
	r_report.battery = _battery;
	r_report.framer = _framer.statistics();
	r_report.stream = _check.statistics();
	r_report.errors = _errors;
	r_report.restarts = _restarts;
	r_report.lost_share = _lost_share;
	r_report.problem = _problem.data();
	r_report.trackers.resize(std::size_t(_tracker_count));
	for (int tracker = 0; tracker < _tracker_count; ++tracker) {
		TrackerReport &report = r_report.trackers[std::size_t(tracker)];
		report.device_id = _tracker_ids[std::size_t(tracker)];
		report.bus_id = bus_id_of(tracker);
		report.samples = _check.device(report.bus_id);
		report.flow = _stream.flow(tracker, p_now_usec);
	}
}

} // namespace xbus
