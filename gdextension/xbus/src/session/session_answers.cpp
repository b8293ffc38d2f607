// SPDX-License-Identifier: MIT
// What a device answers, and what is done about errors.
#include "session/session.hpp"

#include "bus/bytes.hpp"

#include <algorithm>
#include <cstdio>

namespace xbus {

namespace {

/// Bus errors in a row until the log asks to look at the cables.
constexpr int MAX_BUS_FAILURES = 3;

/// Error codes of the device that ask for something else than asking again.
constexpr uint8_t ERROR_NO_BUS = 0x01;
constexpr uint8_t ERROR_BUS_NOT_READY = 0x02;
constexpr uint8_t ERROR_PERIOD = 0x03;
constexpr uint8_t ERROR_PERIOD_TOO_SHORT = 0x18;
constexpr uint8_t ERROR_TIMER_OVERFLOW = 0x1E;
constexpr uint8_t ERROR_BUFFER_FULL = 0x23;

} // namespace

void Session::take_answer(const Frame &p_frame) {
	switch (_step) {
		case Step::STOP:
			go_to(Step::STOPPED);
			return;
		case Step::DEVICE_ID:
			take_device_id(p_frame);
			return;
		case Step::INIT_BUS:
			take_bus(p_frame);
			return;
		case Step::CONFIGURATION:
			choose_outputs();
			return;
		case Step::OUTPUT_MODE:
		case Step::OUTPUT_SETTINGS:
			go_to(after_trackers(_step));
			return;
		case Step::DATA_LENGTH:
			take_data_length(p_frame);
			return;
		default:
			go_to(step_after(_step));
	}
}

void Session::take_device_id(const Frame &p_frame) {
	if (p_frame.size < 4) {
		return; // Asked again when the time is up.
	}
	_device_id = read_u32(p_frame.data);
	_kind = device_kind(_device_id);
	switch (_kind) {
		case DeviceKind::AWINDA_STATION:
		case DeviceKind::AWINDA_DONGLE:
		case DeviceKind::BODY_PACK:
		case DeviceKind::MTW2_MTX2:
			log(Severity::WARNING,
					"%08X is %s %s: its protocol and the filter that makes its orientations are not public. Let MVN "
					"run with it and send its motion here (network streamer, UDP port 9763; here --mvn)",
					_device_id, _kind == DeviceKind::BODY_PACK ? "a" : "an", device_kind_name(_kind));
			go_to(Step::UNSUPPORTED);
			return;
		default:
			break;
	}
	_tracker_count = is_master() ? 0 : 1;
	_tracker_ids[0] = _device_id;
	go_to(step_after(_step));
}

void Session::take_bus(const Frame &p_frame) {
	const std::size_t count = p_frame.size / 4;
	if (p_frame.size % 4 != 0 || count > std::size_t(MAX_TRACKERS)) {
		log(Severity::WARNING, "names its trackers in %zu bytes, which is no list of at most %d", p_frame.size,
				MAX_TRACKERS);
		return; // Asked again when the time is up.
	}
	if (count == 0) {
		start_over("finds no tracker on its bus (look at the cables)");
		return;
	}
	for (std::size_t tracker = 0; tracker < count; ++tracker) {
		_tracker_ids[tracker] = read_u32(p_frame.data + 4 * tracker);
	}
	_tracker_count = int(count);
	_bus_failures = 0;
	go_to(step_after(_step));
}

/// Asks for as much as the line carries; a slow line is made faster once, else the rate goes down.
void Session::choose_outputs() {
	_tracker = 0;
	_ahead = 0;
	if (speaks_mtdata2()) {
		go_to(Step::OUTPUT_CONFIGURATION);
		return;
	}
	auto demand = std::size_t(_demands);
	while (demand + 1 < DEMANDS.size() && !fits(_baud, DEMANDS[demand].block, _tracker_count, _options.rate_hz)) {
		++demand;
	}
	const Demand &chosen = DEMANDS[demand];
	const double rate = rate_that_fits(_baud, chosen.block, _tracker_count, _options.rate_hz);
	if (rate < _options.rate_hz && _baud < FAST_BAUD && !_has_raised_baud && _step != Step::SET_BAUD) {
		_has_raised_baud = true;
		log(Severity::INFO, "%u bit/s are too slow for %d trackers at %.0f Hz: setting it to %u", _baud, _tracker_count,
				_options.rate_hz, FAST_BAUD);
		go_to(Step::SET_BAUD);
		return;
	}
	if (rate < _options.rate_hz) {
		log(Severity::WARNING, "%u bit/s carry %d trackers at %.0f Hz, not at %.0f", _baud, _tracker_count, rate,
				_options.rate_hz);
	}
	_outputs.mode = chosen.mode;
	_outputs.settings = chosen.settings | (is_master() ? 0U : SETTINGS_COUNTER);
	_outputs.period = std::max(period_of(rate), _outputs.period);
	go_to(Step::OUTPUT_MODE);
}

Session::Step Session::after_trackers(Step p_step) {
	if (++_tracker < _tracker_count) {
		return p_step;
	}
	_tracker = 0;
	return step_after(p_step);
}

void Session::take_data_length(const Frame &p_frame) {
	const std::size_t expected = expected_size();
	if (p_frame.size >= 2 && read_u16(p_frame.data) != expected) {
		log(Severity::WARNING, "says that a sample has %u bytes; by its settings it has %zu", read_u16(p_frame.data),
				expected);
	}
	go_to(step_after(_step));
}

void Session::take_error(const Frame &p_frame) {
	++_errors;
	const uint8_t code = p_frame.size > 0 ? p_frame.data[0] : uint8_t(0);
	const char *text = error_text(code);
	const unsigned faulty = p_frame.size > 1 ? p_frame.data[1] : 0U;
	char where[24] = "";
	if (faulty >= 1 && faulty <= unsigned(_tracker_count) && is_master()) {
		snprintf(where, sizeof(where), ", tracker %u", faulty);
	}
	if (_step != Step::STOP && !is_stopped() && _step != Step::GO_TO_CONFIG) {
		log(Severity::WARNING, "error %02X%s: %s", code, where, text != nullptr ? text : "unknown");
	}
	if (_waits) {
		take_setup_error(code);
	}
}

void Session::take_setup_error(uint8_t p_code) {
	if (_step == Step::INIT_BUS && p_code == ERROR_NO_BUS && !_has_powered) {
		_has_powered = true;
		go_to(Step::BUS_POWER);
	} else if (_step == Step::INIT_BUS) {
		if (++_bus_failures < MAX_BUS_FAILURES) {
			start_over("its bus failed");
		} else {
			_bus_failures = 0;
			start_over("its bus fails again and again (look at the cables)");
		}
	} else if (p_code == ERROR_BUS_NOT_READY && is_master()) {
		go_to(Step::INIT_BUS);
	} else if (_step == Step::PERIOD || _step == Step::MEASURE || _step == Step::OUTPUT_MODE ||
			_step == Step::OUTPUT_SETTINGS) {
		if (lower_demands(p_code)) {
			choose_outputs();
		} else {
			start_over("refuses its settings");
		}
	} else if (!pass_over()) {
		// Asked again when the time is up.
		_deadline_usec = std::min(_deadline_usec, _now_usec + 100000);
	}
}

/// Asks for less the next time; false if that is the least already.
bool Session::lower_demands(uint8_t p_code) {
	const bool is_about_period = _step == Step::PERIOD && p_code == ERROR_PERIOD;
	if (_demands + 1 < int(DEMANDS.size()) && !is_about_period) {
		++_demands;
		return true;
	}
	const bool is_too_fast = p_code == ERROR_PERIOD || p_code == ERROR_PERIOD_TOO_SHORT ||
			p_code == ERROR_TIMER_OVERFLOW || p_code == ERROR_BUFFER_FULL;
	if (is_too_fast && _outputs.period > 0 && _outputs.period <= MAX_PERIOD / 2) {
		_outputs.period = uint16_t(_outputs.period * 2);
		log(Severity::WARNING, "bears no more than %.0f Hz", _outputs.rate_hz());
		return true;
	}
	return false;
}

} // namespace xbus
