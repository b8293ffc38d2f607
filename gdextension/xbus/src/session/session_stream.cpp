// SPDX-License-Identifier: MIT
#include "session/session.hpp"

namespace xbus {

namespace {

/// A device that measures and says nothing for so long is brought up anew.
constexpr uint64_t SILENT_USEC = 1000000;
constexpr double SILENT_PERIODS = 20.0;
constexpr uint64_t BATTERY_USEC = 30000000;
constexpr uint64_t RESET_LIMIT_USEC = 300000;

} // namespace

void Session::begin_measuring() {
	_problem.fill(0);
	_is_silent = false;
	_heard_usec = _now_usec;
	_battery_usec = _now_usec;
	_resets_left = 0;
	if (speaks_mtdata2()) {
		_stream.expect_mtdata2(_options.rate_hz);
	} else {
		_stream.expect_mtdata(_outputs, _tracker_count, is_master());
	}
	_framer.set_longest(_stream.longest_message());
	tell(Severity::INFO, "%s %08X measures: %d tracker%s at %.0f Hz", device_kind_name(_kind), _device_id,
			_tracker_count, _tracker_count == 1 ? "" : "s",
			speaks_mtdata2() ? _options.rate_hz : _outputs.rate_hz());
}

void Session::take_data(const Frame &p_frame) {
	if (_step == Step::MEASURE && _waits && _tries > 0) {
		// The acknowledgement was lost, but the device is on its way.
		go_to(Step::MEASURING);
	}
	if (_step == Step::MEASURING && _stream.take(p_frame, _now_usec, _frame)) {
		_host.take_frame(_frame);
	}
}

void Session::look_after_stream() {
	const double period_usec = 1e6 / (speaks_mtdata2() ? _options.rate_hz : _outputs.rate_hz());
	const auto patience_usec = uint64_t(std::max(double(SILENT_USEC), SILENT_PERIODS * period_usec));
	if (_now_usec > _heard_usec + patience_usec) {
		_is_silent = true;
		start_over("has fallen silent", 0);
		return;
	}
	if (_waits && _now_usec > _deadline_usec) {
		ask_resets();
	}
	if (!_waits && _battery >= 0.0 && _now_usec > _battery_usec + BATTERY_USEC) {
		_battery_usec = _now_usec;
		const Request request = host::request_battery_level();
		_host.send(request.bytes.data(), request.size);
	}
}

void Session::reset_orientation(ResetMethod p_method) {
	if (_step != Step::MEASURING) {
		tell(Severity::WARNING, "does not measure: its trackers can't be reset now");
		return;
	}
	_reset_method = p_method;
	_resets_left = _tracker_count;
	ask_resets();
}

/// Asks the next tracker, one after the other; who does not answer is passed over.
void Session::ask_resets() {
	_waits = false;
	if (_resets_left <= 0) {
		return;
	}
	_tracker = _tracker_count - _resets_left;
	--_resets_left;
	ask(host::reset_orientation(_reset_method, bus_id_of(_tracker)));
	_deadline_usec = _now_usec + RESET_LIMIT_USEC;
}

} // namespace xbus
