// SPDX-License-Identifier: MIT
#include "session/session.hpp"

#include <algorithm>
#include <cstdarg>
#include <cstdio>

namespace xbus {

namespace {

/// Speeds at which a master may be found, the likeliest first, bit/s.
constexpr std::array<uint32_t, 7> BAUDS = { 460800, 115200, 921600, 230400, 57600, 38400, 19200 };
/// A master that is reset is back after about 750 ms.
constexpr uint64_t REBOOT_USEC = 1000000;
constexpr uint64_t PAUSE_USEC = 500000;

bool is_data(Message p_message) {
	return p_message == Message::MT_DATA || p_message == Message::MT_DATA2;
}

} // namespace

const char *state_text(SessionState p_state) {
	switch (p_state) {
		case SessionState::SEARCHING:
			return "searching";
		case SessionState::CONFIGURING:
			return "being set up";
		case SessionState::MEASURING:
			return "measuring";
		case SessionState::SILENT:
			return "silent";
		case SessionState::UNSUPPORTED:
			return "not supported";
		default:
			return "stopped";
	}
}

Session::Session(const SessionOptions &p_options, SessionHost &p_host) : _options(p_options), _host(p_host) {
	if (_options.has_baud) {
		// A serial line damages bytes now and then, and an eight-bit checksum lets one damaged message in 255
		// through. Of orientations alone nearly all of those are found (docs/xbus.md), of rates and accelerations
		// not.
		_demands = int(DEMANDS.size()) - 1;
	}
}

void Session::open(uint64_t p_now_usec) {
	_now_usec = p_now_usec;
	if (_options.has_baud) {
		_baud = BAUDS[_baud_at];
		_host.set_baud(_baud);
	}
	pause(0);
}

void Session::take_bytes(const uint8_t *p_bytes, std::size_t p_size, uint64_t p_now_usec) {
	_now_usec = std::max(_now_usec, p_now_usec);
	_bytes_usec = _now_usec;
	_framer.feed(p_bytes, p_size, [this](const Frame &p_frame) { return judge(p_frame); });
}

void Session::stop(uint64_t p_now_usec) {
	_now_usec = std::max(_now_usec, p_now_usec);
	if (is_stopped() || _step == Step::STOP) {
		return;
	}
	// Somebody who never answered has nothing to stop.
	go_to(_has_answered ? Step::STOP : Step::STOPPED);
}

SessionState Session::state() const {
	switch (_step) {
		case Step::PAUSE:
		case Step::GO_TO_CONFIG:
			return _is_silent ? SessionState::SILENT
							  : (_has_answered ? SessionState::CONFIGURING : SessionState::SEARCHING);
		case Step::MEASURING:
			return SessionState::MEASURING;
		case Step::UNSUPPORTED:
			return SessionState::UNSUPPORTED;
		case Step::STOPPED:
			return SessionState::STOPPED;
		default:
			return SessionState::CONFIGURING;
	}
}

void Session::go_to(Step p_step) {
	_step = p_step;
	_waits = false;
	// A slow device is not asked for what is merely good to know.
	const bool is_needed = p_step == Step::SKIP_FACTOR || !patience(p_step).is_optional;
	if (_delay_usec > SLOW_USEC && !is_needed && pass_over()) {
		return;
	}
	switch (p_step) {
		case Step::STOPPED:
		case Step::UNSUPPORTED:
		case Step::PAUSE:
			return;
		case Step::REBOOT: {
			const Request reset = host::reset();
			_host.send(reset.bytes.data(), reset.size);
			_deadline_usec = _now_usec + REBOOT_USEC;
			return;
		}
		case Step::MEASURING:
			begin_measuring();
			return;
		default:
			ask(request_for(p_step));
	}
}

Session::Step Session::step_after(Step p_step) const {
	switch (p_step) {
		case Step::GO_TO_CONFIG:
			return Step::DEVICE_ID;
		case Step::DEVICE_ID:
			return is_master() ? Step::INIT_BUS : Step::CONFIGURATION;
		case Step::BUS_POWER:
			return Step::INIT_BUS;
		case Step::INIT_BUS:
			return Step::CONFIGURATION;
		case Step::CONFIGURATION:
			return speaks_mtdata2() ? Step::OUTPUT_CONFIGURATION : Step::OUTPUT_MODE;
		case Step::SET_BAUD:
			return Step::REBOOT;
		case Step::OUTPUT_MODE:
			return Step::OUTPUT_SETTINGS;
		case Step::OUTPUT_SETTINGS:
			return Step::PERIOD;
		case Step::PERIOD:
			return is_master() ? Step::DATA_LENGTH : Step::SKIP_FACTOR;
		case Step::SKIP_FACTOR:
			return Step::DATA_LENGTH;
		case Step::DATA_LENGTH:
			return is_master() ? Step::BATTERY : Step::MEASURE;
		case Step::OUTPUT_CONFIGURATION:
		case Step::BATTERY:
			return Step::MEASURE;
		case Step::MEASURE:
			return Step::MEASURING;
		default:
			return Step::STOPPED;
	}
}

bool Session::speaks_mtdata2() const {
	const bool is_unknown_tracker = _kind == DeviceKind::UNKNOWN && !_is_unknown_master;
	return _kind == DeviceKind::MTI_10 || _kind == DeviceKind::MTI_100 || is_unknown_tracker;
}

void Session::advance(uint64_t p_now_usec) {
	_now_usec = std::max(_now_usec, p_now_usec);
	// A message whose rest does not come hides what comes behind it.
	if (_framer.pending() > 0 && _now_usec - _bytes_usec > 50000) {
		_framer.give_up([this](const Frame &p_frame) { return judge(p_frame); });
	}
	if (_step == Step::MEASURING) {
		look_after_stream();
		return;
	}
	if (is_stopped() || _now_usec < _deadline_usec) {
		return;
	}
	if (_step == Step::PAUSE) {
		go_to(Step::GO_TO_CONFIG);
	} else if (_step == Step::REBOOT) {
		_baud = FAST_BAUD;
		_host.set_baud(_baud);
		pause(0);
	} else if (_tries < tries(_step)) {
		_ahead = 0;
		send_request();
	} else {
		fail_step();
	}
}

void Session::fail_step() {
	if (_step == Step::STOP) {
		go_to(Step::STOPPED);
	} else if (_step == Step::GO_TO_CONFIG) {
		next_baud();
	} else if (!pass_over()) {
		const char *name = message_name(_request.message());
		char why[80];
		snprintf(why, sizeof(why), "no answer to %s", name != nullptr ? name : "a message");
		start_over(why);
	}
}

/// Goes on without an answer, where that is possible.
bool Session::pass_over() {
	if (_step == Step::CONFIGURATION || _step == Step::SET_BAUD) {
		choose_outputs();
	} else if (patience(_step).is_optional) {
		go_to(step_after(_step));
	} else {
		return false;
	}
	return true;
}

void Session::next_baud() {
	const bool hears = _has_answered || _framer.statistics().frames > 0;
	if (_options.has_baud && !(hears && _bytes_usec + PAUSE_USEC > _now_usec && !_is_silent)) {
		_baud_at = (_baud_at + 1) % BAUDS.size();
		_baud = BAUDS[_baud_at];
		_host.set_baud(_baud);
		if (_baud_at != 0) {
			pause(0);
			return;
		}
	}
	if (_problem[0] == 0) {
		log(Severity::WARNING, "does not answer%s: is the suit switched on and in reach?",
				_options.has_baud ? " at any speed" : "");
	}
	pause(PAUSE_USEC);
}

/// Begins once more after so many microseconds; with 0 as soon as a speed that was set is in force.
void Session::pause(uint64_t p_usec) {
	_step = Step::PAUSE;
	_waits = false;
	_deadline_usec = _now_usec + p_usec;
}

void Session::start_over(const char *p_why) {
	log(Severity::WARNING, "%s: bringing it up anew", p_why);
	++_restarts;
	if (_kind == DeviceKind::UNKNOWN && _in_vain % 2 == 0) {
		_is_unknown_master = !_is_unknown_master;
		++_in_vain;
		pause(0);
		return;
	}
	// What does not help the first time may take its time.
	pause(PAUSE_USEC << std::min(_in_vain, 4U));
	++_in_vain;
}

bool Session::judge(const Frame &p_frame) {
	switch (_check.take(p_frame, _framer.statistics().is_noisy())) {
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
	switch (p_frame.message) {
		case Message::WAKE_UP:
			wake_up();
			return;
		case Message::ERROR:
			take_error(p_frame);
			return;
		case Message::BATTERY_LEVEL:
			if (p_frame.bus_id == MASTER && p_frame.size >= 1) {
				_battery = p_frame.data[0] / 255.0;
			}
			break;
		default:
			break;
	}
	if (_step == Step::PAUSE && !_options.has_baud && p_frame.message == Message::GO_TO_CONFIG_ACK) {
		// An answer that was long in transit; with a speed to be found it would be one at another speed.
		_has_answered = true;
		go_to(Step::DEVICE_ID);
	} else if (_waits && p_frame.message == _request.reply() && is_answering(p_frame.bus_id)) {
		_has_answered = true;
		note_delay();
		take_answer(p_frame);
	} else if (_step == Step::MEASURE && _tries > 1 && is_data(p_frame.message)) {
		// It measures already: the answer was lost.
		go_to(Step::MEASURING);
	}
}

/// Whether the request may be answered by whom this identifier names: who was asked, the master in the name of
/// a tracker, or a tracker that stands alone and calls itself by a number.
bool Session::is_answering(uint8_t p_bus_id) const {
	return p_bus_id == _request.bus_id() || p_bus_id == MASTER || !is_master();
}

void Session::wake_up() {
	// After a change of speed it is answered at the new one, when that is set.
	if (_step == Step::STOP || _step == Step::REBOOT || is_stopped()) {
		return;
	}
	const Request answer = host::wake_up_ack();
	_host.send(answer.bytes.data(), answer.size);
	if (_step == Step::MEASURING) {
		++_restarts;
		log(Severity::WARNING, "was switched on anew: bringing it up");
	}
	_has_answered = true;
	_has_powered = false;
	go_to(Step::DEVICE_ID);
}

void Session::log(Severity p_severity, const char *p_format, ...) {
	std::array<char, 240> text{};
	va_list arguments;
	va_start(arguments, p_format);
	vsnprintf(text.data(), text.size(), p_format, arguments);
	va_end(arguments);
	// What is said again and again is said once.
	if (p_severity == Severity::INFO || text != _problem) {
		_host.say(p_severity, text.data());
	}
	if (p_severity != Severity::INFO) {
		_problem = text;
	}
}

} // namespace xbus
