// SPDX-License-Identifier: MIT
// What a device is asked for, how long its answers are waited for, and what is asked ahead of a slow one.
#include "session/session.hpp"

#include <algorithm>

namespace xbus {

namespace {

/// The likeliest speeds are given more time: a converter or a radio link may hold answers up for long.
constexpr std::size_t LIKELY_BAUDS = 2;
constexpr int LIKELY_TRIES = 5;
constexpr uint64_t MAX_DELAY_USEC = 1000000;
constexpr uint8_t FAST_BAUD_CODE = 0x00;

} // namespace

Session::Patience Session::patience(Step p_step) {
	switch (p_step) {
		case Step::GO_TO_CONFIG:
		case Step::STOP:
			return { 150000, 3, false };
		case Step::INIT_BUS:
			return { 3000000, 2, false };
		case Step::CONFIGURATION:
			return { 800000, 2, true };
		case Step::BATTERY:
		case Step::DATA_LENGTH:
		case Step::SKIP_FACTOR:
			return { 250000, 2, true };
		case Step::SET_BAUD:
			return { 500000, 2, false };
		case Step::MEASURE:
			return { 1000000, 3, false };
		default:
			return { 500000, 3, false };
	}
}

Request Session::request_for(Step p_step) const {
	const uint8_t bus_id = bus_id_of(_tracker);
	switch (p_step) {
		case Step::DEVICE_ID:
			return host::request_device_id();
		case Step::INIT_BUS:
			return host::init_bus();
		case Step::BUS_POWER:
			return host::set_bus_power(true);
		case Step::CONFIGURATION:
			return host::request_configuration();
		case Step::SET_BAUD:
			return host::set_baud_rate(FAST_BAUD_CODE);
		case Step::OUTPUT_MODE:
			return host::set_output_mode(_outputs.mode, bus_id);
		case Step::OUTPUT_SETTINGS:
			return host::set_output_settings(_outputs.settings, bus_id);
		case Step::PERIOD:
			return host::set_period(_outputs.period);
		case Step::SKIP_FACTOR:
			return host::set_skip_factor(0, MASTER);
		case Step::DATA_LENGTH:
			return host::request_data_length();
		case Step::OUTPUT_CONFIGURATION:
			return output_configuration(_options.rate_hz);
		case Step::BATTERY:
			return host::request_battery_level();
		case Step::MEASURE:
			return host::go_to_measurement();
		default:
			return host::go_to_config();
	}
}

int Session::tries(Step p_step) const {
	const bool is_likely = p_step == Step::GO_TO_CONFIG && (!_options.has_baud || _baud_at < LIKELY_BAUDS);
	return is_likely ? LIKELY_TRIES : patience(p_step).tries;
}

void Session::ask(const Request &p_request) {
	_request = p_request;
	_tries = 0;
	_asked_usec = _now_usec;
	if (!is_sent_ahead(_step)) {
		_ahead = 0;
	}
	if (_ahead > 0) {
		--_ahead; // It was sent before.
		await_answer();
		return;
	}
	send_request();
	if (_delay_usec > SLOW_USEC && _step == Step::OUTPUT_MODE) {
		send_ahead();
	}
}

/// Whether `send_ahead` may have sent a step's request: whatever else is asked ends the set-up of the trackers.
bool Session::is_sent_ahead(Step p_step) {
	return p_step == Step::OUTPUT_MODE || p_step == Step::OUTPUT_SETTINGS || p_step == Step::PERIOD;
}

/// Sends all requests of the trackers' set-up at once, so that their answers are waited for once.
void Session::send_ahead() {
	const Step step = _step;
	const int tracker = _tracker;
	const int count = 2 * _tracker_count - _tracker;
	for (_ahead = 0; _ahead < count; ++_ahead) {
		_step = after_trackers(_step);
		const Request request = request_for(_step);
		_host.send(request.bytes.data(), request.size);
	}
	_step = step;
	_tracker = tracker;
}

uint64_t Session::limit_usec() const {
	return std::max(patience(_step).limit_usec, _delay_usec * 2);
}

/// Notes how long the answer took that came just now.
void Session::note_delay() {
	// The first question of all may have been asked before the device was there.
	if (_step != Step::GO_TO_CONFIG) {
		_delay_usec = std::max(_delay_usec, std::min(_now_usec - _asked_usec, MAX_DELAY_USEC));
	}
}

void Session::await_answer() {
	_waits = true;
	++_tries;
	_deadline_usec = _now_usec + limit_usec();
}

void Session::send_request() {
	await_answer();
	_host.send(_request.bytes.data(), _request.size);
}

} // namespace xbus
