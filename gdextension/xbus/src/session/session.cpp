// SPDX-License-Identifier: MIT
#include "session/session.hpp"

#include "bus/requests.hpp"

#include <algorithm>

namespace xbus {

namespace {

/// A message whose rest does not come within this time hides what comes behind it.
constexpr uint64_t REST_USEC = 50000;
/// Bytes that came within this time are of a device that is there now.
constexpr uint64_t HEARD_USEC = 500000;
constexpr uint64_t BATTERY_USEC = 30000000;

} // namespace

Session::Session(const SessionOptions &p_options, SessionHost &p_host) :
		_host(p_host), _log(p_host), _setup(p_options.rate_hz, p_options.has_baud, p_host, _log) {}

void Session::open(uint64_t p_now_usec) {
	_now_usec = p_now_usec;
	_setup.open(_now_usec);
}

void Session::take_bytes(const uint8_t *p_bytes, std::size_t p_size, uint64_t p_now_usec) {
	_now_usec = std::max(_now_usec, p_now_usec);
	_bytes_usec = _now_usec;
	_framer.feed(p_bytes, p_size, [this](const Frame &p_frame) { return judge(p_frame); });
}

void Session::stop(uint64_t p_now_usec) {
	_now_usec = std::max(_now_usec, p_now_usec);
	_setup.stop(_now_usec);
}

void Session::advance(uint64_t p_now_usec) {
	_now_usec = std::max(_now_usec, p_now_usec);
	// A message whose rest does not come hides what comes behind it.
	if (_framer.pending() > 0 && _now_usec - _bytes_usec > REST_USEC) {
		_framer.give_up([this](const Frame &p_frame) { return judge(p_frame); });
	}
	if (_setup.is_measuring()) {
		look_after_stream();
		return;
	}
	_setup.advance(_now_usec, _framer.statistics().frames > 0 && _bytes_usec + HEARD_USEC > _now_usec);
}

void Session::report(uint64_t p_now_usec, SessionReport &r_report) const {
	const KnownDevice &device = _setup.device();
	r_report.state = state();
	r_report.device_id = device.id;
	r_report.kind = device.kind;
	r_report.baud = _setup.baud();
	r_report.rate_hz = _setup.choice().rate_hz(device);
	r_report.battery = _battery;
	r_report.framer = _framer.statistics();
	r_report.stream = _measurement.statistics();
	r_report.errors = _errors;
	r_report.restarts = _setup.restarts();
	r_report.lost_share = _measurement.lost_share();
	r_report.problem = _log.problem();
	r_report.trackers.resize(std::size_t(device.tracker_count));
	for (int tracker = 0; tracker < device.tracker_count; ++tracker) {
		TrackerReport &report = r_report.trackers[std::size_t(tracker)];
		report.device_id = device.tracker_ids[std::size_t(tracker)];
		report.bus_id = device.bus_id_of(tracker);
		report.samples = _measurement.device(report.bus_id);
		report.flow = _measurement.flow(tracker, p_now_usec);
	}
}

bool Session::judge(const Frame &p_frame) {
	switch (_measurement.judge(p_frame, _framer.statistics().is_noisy())) {
		case StreamCheck::Verdict::REFUSED:
			return false;
		case StreamCheck::Verdict::DATA:
			take_data();
			return true;
		default:
			take(p_frame);
			return true;
	}
}

void Session::take(const Frame &p_frame) {
	if (p_frame.message == Message::ERROR) {
		++_errors;
	} else if (p_frame.message == Message::BATTERY_LEVEL && p_frame.bus_id == MASTER && p_frame.size >= 1) {
		_battery = p_frame.data[0] / 255.0;
	}
	const bool was_measuring = _setup.is_measuring();
	_setup.take(p_frame, _now_usec);
	if (_setup.is_measuring() && !was_measuring) {
		begin_measuring();
	}
}

void Session::take_data() {
	const bool was_measuring = _setup.is_measuring();
	if (!_setup.note_sample(_now_usec)) {
		return;
	}
	if (!was_measuring) {
		begin_measuring();
	}
	const SuitFrame &frame = _measurement.take(_now_usec);
	const KnownDevice &device = _setup.device();
	if (device.kind == DeviceKind::XBUS_MASTER || frame.tracker_count <= device.tracker_count) {
		_host.take_frame(frame);
	}
}

void Session::begin_measuring() {
	const KnownDevice &device = _setup.device();
	_log.clear();
	_battery_usec = _now_usec;
	_measurement.begin(device, _setup.choice(), _now_usec);
	// A false length must not hold back what comes behind it.
	_framer.set_longest(std::max<std::size_t>(_measurement.data_size(), Configuration::MAX_BYTES));
	_log.log(Severity::INFO, "%s %08X measures: %d tracker%s at %.0f Hz", device_kind_name(device.kind), device.id,
			device.tracker_count, device.tracker_count == 1 ? "" : "s", _setup.choice().rate_hz(device));
}

void Session::look_after_stream() {
	if (_measurement.refuses_many()) {
		_log.log(Severity::WARNING,
				"sends samples of another length than its settings make (%zu bytes): they are counted and dropped",
				_setup.choice().sample_size(_setup.device()));
	}
	report_damage();
	if (_measurement.is_silent(_now_usec, _setup.choice().rate_hz(_setup.device()))) {
		_setup.begin_anew(
				_measurement.has_refused_all() ? "sends nothing that can be used" : "has fallen silent", _now_usec);
		return;
	}
	if (_battery >= 0.0 && _now_usec > _battery_usec + BATTERY_USEC) {
		_battery_usec = _now_usec;
		const Request request = host::request_battery_level();
		_host.send(request.bytes.data(), request.size);
	}
}

void Session::report_damage() {
	switch (_measurement.find_damage(_setup.device(), _framer.statistics().skipped_bytes, _now_usec)) {
		case StreamHealth::Finding::LINE_DAMAGES:
			_log.log(Severity::WARNING,
					"%.0f %% of its samples are lost, for the line damages bytes: look at plug and cable",
					100.0 * _measurement.lost_share());
			break;
		case StreamHealth::Finding::SAMPLES_LOST:
			_log.log(Severity::WARNING,
					"%.0f %% of its samples are lost: is this machine too busy, or a radio link too weak?",
					100.0 * _measurement.lost_share());
			break;
		case StreamHealth::Finding::WELL_AGAIN:
			_log.clear();
			break;
		case StreamHealth::Finding::NOTHING:
			break;
	}
}

} // namespace xbus
