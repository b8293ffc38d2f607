// SPDX-License-Identifier: MIT
#include "session/device_setup.hpp"

#include "bus/bytes.hpp"

#include <algorithm>
#include <cstdio>

namespace xbus {

namespace {

/// The likeliest speeds are given more time: a converter or a radio link may hold answers up for long.
constexpr int LIKELY_TRIES = 5;
/// A master that is reset is back after about 750 ms.
constexpr uint64_t REBOOT_USEC = 1000000;
constexpr uint64_t PAUSE_USEC = 500000;
/// Bus errors in a row until the log asks to look at the cables.
constexpr int MAX_BUS_FAILURES = 3;
/// Error codes of the device that ask for something else than asking again.
constexpr uint8_t ERROR_NO_BUS = 0x01;
constexpr uint8_t ERROR_BUS_NOT_READY = 0x02;

bool is_data(Message p_message) {
	return p_message == Message::MT_DATA || p_message == Message::MT_DATA2;
}

} // namespace

DeviceSetup::DeviceSetup(double p_rate_hz, bool p_is_serial, SessionHost &p_host, SessionLog &p_log) :
		_host(p_host), _log(p_log), _speed(p_is_serial, p_host), _choice(p_rate_hz, p_is_serial) {}

void DeviceSetup::open(uint64_t p_now_usec) {
	_now_usec = p_now_usec;
	_speed.begin();
	pause(0);
}

void DeviceSetup::advance(uint64_t p_now_usec, bool p_hears) {
	_now_usec = p_now_usec;
	if (is_measuring() || is_over() || !_exchange.is_due(_now_usec)) {
		return;
	}
	if (_step == SetupStep::PAUSE) {
		go_to(SetupStep::GO_TO_CONFIG);
	} else if (_step == SetupStep::REBOOT) {
		_speed.set_fast();
		pause(0);
	} else if (_exchange.tries() < tries()) {
		_exchange.repeat(_step, _now_usec);
		send(_exchange.request());
	} else {
		fail_step(p_hears);
	}
}

void DeviceSetup::take(const Frame &p_frame, uint64_t p_now_usec) {
	_now_usec = p_now_usec;
	if (p_frame.message == Message::WAKE_UP) {
		wake_up();
	} else if (p_frame.message == Message::ERROR) {
		take_error(p_frame);
	} else if (_step == SetupStep::PAUSE && !_speed.is_serial() && p_frame.message == Message::GO_TO_CONFIG_ACK) {
		// An answer that was long in transit; with a speed to be found it would be one at another speed.
		_has_answered = true;
		go_to(SetupStep::DEVICE_ID);
	} else if (_exchange.waits() && p_frame.message == _exchange.request().reply() && is_answering(p_frame.bus_id)) {
		_has_answered = true;
		_exchange.note_answer(_step, _now_usec);
		take_answer(p_frame);
	} else if (_step == SetupStep::MEASURE && _exchange.tries() > 1 && is_data(p_frame.message)) {
		// It measures already: the answer was lost.
		go_to(SetupStep::MEASURING);
	}
}

bool DeviceSetup::note_sample(uint64_t p_now_usec) {
	_now_usec = p_now_usec;
	if (_step == SetupStep::MEASURE && _exchange.tries() > 1) {
		go_to(SetupStep::MEASURING); // The answer was lost.
	}
	if (is_measuring()) {
		_in_vain = 0;
	}
	return is_measuring();
}

void DeviceSetup::begin_anew(const char *p_why, uint64_t p_now_usec) {
	_now_usec = p_now_usec;
	_is_silent = true;
	start_over(p_why);
}

void DeviceSetup::stop(uint64_t p_now_usec) {
	_now_usec = p_now_usec;
	if (is_over() || _step == SetupStep::STOP) {
		return;
	}
	// Somebody who never answered has nothing to stop.
	go_to(_has_answered ? SetupStep::STOP : SetupStep::STOPPED);
}

SessionState DeviceSetup::state() const {
	switch (_step) {
		case SetupStep::PAUSE:
		case SetupStep::GO_TO_CONFIG:
			return _is_silent ? SessionState::SILENT
							  : (_has_answered ? SessionState::CONFIGURING : SessionState::SEARCHING);
		case SetupStep::MEASURING:
			return SessionState::MEASURING;
		case SetupStep::UNSUPPORTED:
			return SessionState::UNSUPPORTED;
		case SetupStep::STOPPED:
			return SessionState::STOPPED;
		default:
			return SessionState::CONFIGURING;
	}
}

void DeviceSetup::go_to(SetupStep p_step) {
	_step = p_step;
	_exchange.end();
	// A slow device is not asked for what is merely good to know.
	const bool is_needed = p_step == SetupStep::SKIP_FACTOR || !patience(p_step).is_optional;
	if (_exchange.is_slow() && !is_needed && pass_over()) {
		return;
	}
	switch (p_step) {
		case SetupStep::STOPPED:
		case SetupStep::UNSUPPORTED:
		case SetupStep::PAUSE:
			return;
		case SetupStep::REBOOT:
			send(host::reset());
			_exchange.pause_until(_now_usec + REBOOT_USEC);
			return;
		case SetupStep::MEASURING:
			_is_silent = false;
			return;
		default:
			ask(request_of(p_step, _choice, _device.bus_id_of(_tracker)));
	}
}

void DeviceSetup::ask(const Request &p_request) {
	if (!_exchange.begin(p_request, _step, _now_usec)) {
		return; // It was sent before.
	}
	send(p_request);
	if (_exchange.is_slow() && _step == SetupStep::OUTPUT_MODE) {
		send_ahead();
	}
}

void DeviceSetup::send_ahead() {
	const SetupStep step = _step;
	const int tracker = _tracker;
	const int count = 2 * _device.tracker_count - _tracker;
	for (int i = 0; i < count; ++i) {
		_step = step_after_tracker();
		send(request_of(_step, _choice, _device.bus_id_of(_tracker)));
	}
	_exchange.note_sent_ahead(count);
	_step = step;
	_tracker = tracker;
}

int DeviceSetup::tries() const {
	const bool is_likely = _step == SetupStep::GO_TO_CONFIG && _speed.is_likely();
	return is_likely ? LIKELY_TRIES : patience(_step).tries;
}

bool DeviceSetup::pass_over() {
	if (_step == SetupStep::CONFIGURATION || _step == SetupStep::SET_BAUD) {
		choose_outputs();
	} else if (patience(_step).is_optional) {
		go_on();
	} else {
		return false;
	}
	return true;
}

void DeviceSetup::choose_outputs() {
	_tracker = 0;
	_exchange.note_sent_ahead(0);
	if (_device.speaks_mtdata2()) {
		go_to(SetupStep::OUTPUT_CONFIGURATION);
		return;
	}
	double rate_hz = 0.0;
	const bool may_be_raised = !_has_raised_baud && _step != SetupStep::SET_BAUD;
	switch (_choice.choose(_speed.baud(), _device, may_be_raised, rate_hz)) {
		case OutputChoice::Fit::LINE_TOO_SLOW:
			_has_raised_baud = true;
			_log.log(Severity::INFO, "%u bit/s are too slow for %d trackers at %.0f Hz: setting it to %u",
					_speed.baud(), _device.tracker_count, _choice.wanted_hz(), FAST_BAUD);
			go_to(SetupStep::SET_BAUD);
			return;
		case OutputChoice::Fit::FEWER_SAMPLES:
			_log.log(Severity::WARNING, "%u bit/s carry %d trackers at %.0f Hz, not at %.0f", _speed.baud(),
					_device.tracker_count, rate_hz, _choice.wanted_hz());
			break;
		case OutputChoice::Fit::AS_WANTED:
			break;
	}
	go_to(SetupStep::OUTPUT_MODE);
}

SetupStep DeviceSetup::step_after_tracker() {
	if (++_tracker < _device.tracker_count) {
		return _step;
	}
	_tracker = 0;
	return step_after(_step, _device);
}

void DeviceSetup::pause(uint64_t p_usec) {
	_step = SetupStep::PAUSE;
	_exchange.end();
	_exchange.pause_until(_now_usec + p_usec);
}

void DeviceSetup::start_over(const char *p_why) {
	_log.log(Severity::WARNING, "%s: bringing it up anew", p_why);
	++_restarts;
	if (_device.kind == DeviceKind::UNKNOWN && _in_vain % 2 == 0) {
		_device.is_unknown_master = !_device.is_unknown_master;
		++_in_vain;
		pause(0);
		return;
	}
	// What does not help the first time may take its time.
	pause(PAUSE_USEC << std::min(_in_vain, 4U));
	++_in_vain;
}

void DeviceSetup::fail_step(bool p_hears) {
	if (_step == SetupStep::STOP) {
		go_to(SetupStep::STOPPED);
	} else if (_step == SetupStep::GO_TO_CONFIG) {
		next_baud(p_hears);
	} else if (!pass_over()) {
		const char *name = message_name(_exchange.request().message());
		char why[80];
		snprintf(why, sizeof(why), "no answer to %s", name != nullptr ? name : "a message");
		start_over(why);
	}
}

void DeviceSetup::next_baud(bool p_hears) {
	if (_speed.is_serial() && (!p_hears || _is_silent) && _speed.try_next()) {
		pause(0);
		return;
	}
	if (!_log.has_problem()) {
		_log.log(Severity::WARNING, "does not answer%s: is the suit switched on and in reach?",
				_speed.is_serial() ? " at any speed" : "");
	}
	pause(PAUSE_USEC);
}

bool DeviceSetup::is_answering(uint8_t p_bus_id) const {
	return p_bus_id == _exchange.request().bus_id() || p_bus_id == MASTER || !_device.is_master();
}

void DeviceSetup::take_answer(const Frame &p_frame) {
	switch (_step) {
		case SetupStep::STOP:
			go_to(SetupStep::STOPPED);
			return;
		case SetupStep::DEVICE_ID:
			take_device_id(p_frame);
			return;
		case SetupStep::INIT_BUS:
			take_bus(p_frame);
			return;
		case SetupStep::CONFIGURATION:
			choose_outputs();
			return;
		case SetupStep::OUTPUT_MODE:
		case SetupStep::OUTPUT_SETTINGS:
			go_to(step_after_tracker());
			return;
		case SetupStep::DATA_LENGTH:
			take_data_length(p_frame);
			return;
		default:
			go_on();
	}
}

void DeviceSetup::take_device_id(const Frame &p_frame) {
	if (p_frame.size < 4) {
		return; // Asked again when the time is up.
	}
	_device.id = read_u32(p_frame.data);
	_device.kind = device_kind(_device.id);
	if (!_device.has_public_protocol()) {
		_log.log(Severity::WARNING,
				"%08X is %s %s: its protocol and the filter that makes its orientations are not public. Let MVN "
				"run with it and send its motion here (network streamer, UDP port 9763; here --source=mvn)",
				_device.id, _device.kind == DeviceKind::BODY_PACK ? "a" : "an", device_kind_name(_device.kind));
		go_to(SetupStep::UNSUPPORTED);
		return;
	}
	_device.tracker_count = _device.is_master() ? 0 : 1;
	_device.tracker_ids[0] = _device.id;
	go_on();
}

void DeviceSetup::take_bus(const Frame &p_frame) {
	if (p_frame.size == 0) {
		start_over("finds no tracker on its bus (look at the cables)");
		return;
	}
	if (!_device.take_trackers(p_frame.data, p_frame.size)) {
		_log.log(Severity::WARNING, "names its trackers in %zu bytes, which is no list of at most %d", p_frame.size,
				MAX_TRACKERS);
		return; // Asked again when the time is up.
	}
	_bus_failures = 0;
	go_on();
}

void DeviceSetup::take_data_length(const Frame &p_frame) {
	const std::size_t expected = _choice.sample_size(_device);
	if (p_frame.size >= 2 && read_u16(p_frame.data) != expected) {
		_log.log(Severity::WARNING, "says that a sample has %u bytes; by its settings it has %zu",
				read_u16(p_frame.data), expected);
	}
	go_on();
}

void DeviceSetup::take_error(const Frame &p_frame) {
	const uint8_t code = p_frame.size > 0 ? p_frame.data[0] : uint8_t(0);
	const char *text = error_text(code);
	const unsigned faulty = p_frame.size > 1 ? p_frame.data[1] : 0U;
	char where[24] = "";
	if (faulty >= 1 && faulty <= unsigned(_device.tracker_count) && _device.is_master()) {
		snprintf(where, sizeof(where), ", tracker %u", faulty);
	}
	if (_step != SetupStep::STOP && !is_over() && _step != SetupStep::GO_TO_CONFIG) {
		_log.log(Severity::WARNING, "error %02X%s: %s", code, where, text != nullptr ? text : "unknown");
	}
	if (_exchange.waits()) {
		take_setup_error(code);
	}
}

void DeviceSetup::take_setup_error(uint8_t p_code) {
	if (_step == SetupStep::INIT_BUS && p_code == ERROR_NO_BUS && !_has_powered) {
		_has_powered = true;
		go_to(SetupStep::BUS_POWER);
	} else if (_step == SetupStep::INIT_BUS) {
		if (++_bus_failures < MAX_BUS_FAILURES) {
			start_over("its bus failed");
		} else {
			_bus_failures = 0;
			start_over("its bus fails again and again (look at the cables)");
		}
	} else if (p_code == ERROR_BUS_NOT_READY && _device.is_master()) {
		go_to(SetupStep::INIT_BUS);
	} else if (_step == SetupStep::PERIOD || _step == SetupStep::MEASURE || _step == SetupStep::OUTPUT_MODE ||
			_step == SetupStep::OUTPUT_SETTINGS) {
		if (lower_demands(p_code)) {
			choose_outputs();
		} else {
			start_over("refuses its settings");
		}
	} else if (!pass_over()) {
		// Asked again when the time is up.
		_exchange.hasten(_now_usec);
	}
}

bool DeviceSetup::lower_demands(uint8_t p_code) {
	const OutputChoice::Lowered lowered = _choice.lower(p_code, _step == SetupStep::PERIOD);
	if (lowered == OutputChoice::Lowered::RATE) {
		_log.log(Severity::WARNING, "bears no more than %.0f Hz", _choice.outputs().rate_hz());
	}
	return lowered != OutputChoice::Lowered::NOTHING;
}

void DeviceSetup::wake_up() {
	// After a change of speed it is answered at the new one, when that is set.
	if (_step == SetupStep::STOP || _step == SetupStep::REBOOT || is_over()) {
		return;
	}
	send(host::wake_up_ack());
	if (is_measuring()) {
		++_restarts;
		_log.log(Severity::WARNING, "was switched on anew: bringing it up");
	}
	_has_answered = true;
	_has_powered = false;
	go_to(SetupStep::DEVICE_ID);
}

} // namespace xbus
