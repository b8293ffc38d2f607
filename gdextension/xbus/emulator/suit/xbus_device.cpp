// SPDX-License-Identifier: MIT
#include "suit/xbus_device.hpp"

#include "bus/bytes.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace emulator {
namespace {

using xbus::Frame;
using xbus::Message;

constexpr Usec WAKE_UP_TIME = SECOND / 2;
constexpr Usec REBOOT_TIME = 3 * SECOND / 4;
/// How long a message from the host may take.
constexpr Usec RECEIVE_TIME = SECOND / 5;
/// Bytes that a device keeps for a slow line.
constexpr std::size_t BUFFER = 8192;

constexpr uint8_t ERROR_MESSAGE = 0x04;
constexpr uint8_t ERROR_BAUD = 0x20;
constexpr uint8_t ERROR_BUFFER = 0x2A;

std::string describe(const Frame &p_frame) {
	std::array<char, 96> line{};
	const char *name = xbus::message_name(p_frame.message);
	int at = snprintf(line.data(), line.size(), "message %02x %02x %s", p_frame.bus_id, unsigned(p_frame.message),
			name == nullptr ? "unknown" : name);
	for (std::size_t i = 0; i < p_frame.size && i < 12; i++) {
		at += snprintf(line.data() + at, line.size() - std::size_t(at), i == 0 ? " %02x" : "%02x", p_frame.data[i]);
	}
	return line.data();
}

} // namespace

void append_u16(Data &r_data, unsigned p_value) {
	r_data.push_back(uint8_t(p_value >> 8U));
	r_data.push_back(uint8_t(p_value));
}

void append_u32(Data &r_data, uint32_t p_value) {
	append_u16(r_data, p_value >> 16U);
	append_u16(r_data, p_value & 0xFFFFU);
}

XbusDevice::XbusDevice(MotionStream p_stream, uint64_t p_seed) : _stream(std::move(p_stream)), _random(p_seed) {}

void XbusDevice::_log_state(Usec p_now, const std::string &p_text) const {
	if (_log) {
		_log(p_now, p_text);
	}
}

void XbusDevice::power(bool p_on, Usec p_now) {
	forget();
	_framer.reset();
	restart();
	_deadline = NEVER;
	_state = State::OFF;
	if (p_on) {
		_baud = _next_baud;
		_state = State::WAKE_UP;
		_deadline = p_now + WAKE_UP_TIME;
		reply(xbus::MASTER, Message::WAKE_UP, {}, p_now, 0);
	}
}

void XbusDevice::set_motion(double p_seconds, bool p_runs, Usec p_since) {
	_motion_s = p_seconds;
	_motion_since = p_since;
	_motion_runs = p_runs;
}

void XbusDevice::reply(uint8_t p_bus_id, Message p_message, const Data &p_data, Usec p_now, Usec p_delay) {
	Chunk chunk;
	chunk.time = p_now + p_delay;
	chunk.bytes.resize(p_data.size() + 7);
	chunk.bytes.resize(xbus::write_frame(p_bus_id, p_message, p_data.data(), p_data.size(), chunk.bytes.data()));
	send(std::move(chunk));
}

void XbusDevice::reply_error(uint8_t p_code, Usec p_now, uint8_t p_bus_id) {
	Data data = { p_code };
	if (p_bus_id != 0) {
		data.push_back(p_bus_id);
	}
	reply(xbus::MASTER, Message::ERROR, data, p_now);
	_log_state(p_now, "error " + std::to_string(p_code));
}

void XbusDevice::send_error(uint8_t p_code, Usec p_now) {
	if (_state != State::OFF && _state != State::REBOOT) {
		reply_error(p_code, p_now);
	}
}

bool XbusDevice::exchange(const Frame &p_frame, unsigned &r_value, std::size_t p_bytes, Usec p_now) {
	const Message answer = xbus::acknowledgement(p_frame.message);
	if (p_frame.size != 0 && p_frame.size != p_bytes) {
		return false;
	}
	Data data;
	if (p_frame.size == 0) {
		append_u32(data, r_value);
		data.erase(data.begin(), data.begin() + ptrdiff_t(4 - p_bytes));
	} else {
		r_value = 0;
		for (std::size_t i = 0; i < p_bytes; i++) {
			r_value = r_value << 8U | p_frame.data[i];
		}
	}
	reply(p_frame.bus_id, answer, data, p_now);
	return true;
}

bool XbusDevice::change_baud(const Frame &p_frame, Usec p_now) {
	if (p_frame.size == 0) {
		uint8_t code = 0;
		xbus::baud_code(_next_baud, code);
		reply(p_frame.bus_id, Message::SET_BAUD_RATE_ACK, { code }, p_now);
		return true;
	}
	const uint32_t rate = p_frame.size == 1 ? xbus::baud_rate(p_frame.data[0]) : 0;
	if (rate == 0) {
		reply_error(ERROR_BAUD, p_now);
		return true;
	}
	// It takes effect with the next reset.
	_next_baud = rate;
	reply(p_frame.bus_id, Message::SET_BAUD_RATE_ACK, {}, p_now);
	return true;
}

void XbusDevice::receive(const uint8_t *p_bytes, std::size_t p_size, Usec p_now) {
	if (faults.answer_delay > 0) {
		Chunk chunk;
		chunk.time = p_now + faults.answer_delay;
		chunk.bytes.assign(p_bytes, p_bytes + p_size);
		_heard.push_back(std::move(chunk));
	} else {
		_read(p_bytes, p_size, p_now);
	}
}

void XbusDevice::_read(const uint8_t *p_bytes, std::size_t p_size, Usec p_now) {
	const auto take = [this, p_now](const Frame &p_frame) { _take(p_frame, p_now); };
	if (p_now - _last_received > RECEIVE_TIME) {
		_framer.finish([](const Frame & /*p_frame*/) {});
	}
	_last_received = p_now;
	_framer.feed(p_bytes, p_size, take);
}

void XbusDevice::_take(const Frame &p_frame, Usec p_now) {
	_log_state(p_now, describe(p_frame));
	if (faults.is_mute || _state == State::OFF || _state == State::REBOOT) {
		return;
	}
	const auto refused = faults.errors.find(uint8_t(p_frame.message));
	if (refused != faults.errors.end()) {
		reply_error(refused->second, p_now, p_frame.bus_id == xbus::MASTER ? 0 : p_frame.bus_id);
		return;
	}
	_take_common(p_frame, p_now);
}

void XbusDevice::_take_common(const Frame &p_frame, Usec p_now) {
	switch (p_frame.message) {
		case Message::WAKE_UP_ACK:
			if (_state == State::WAKE_UP) {
				_go_to_config(p_now);
			}
			return;
		case Message::GO_TO_CONFIG:
			if (_state == State::MEASUREMENT && !_only_on_request) {
				// The message in transit is cut short.
				Data data = sample(motion_time(p_now), _counter);
				reply(xbus::MASTER, sample_message(), data, p_now, 0);
				halve_last();
			}
			_go_to_config(p_now);
			reply(p_frame.bus_id, Message::GO_TO_CONFIG_ACK, {}, p_now);
			return;
		case Message::RESET:
			reply(p_frame.bus_id, Message::RESET_ACK, {}, p_now);
			_state = State::REBOOT;
			_deadline = p_now + REBOOT_TIME;
			return;
		case Message::GO_TO_MEASUREMENT:
			if (_state != State::MEASUREMENT) {
				_go_to_measurement(p_now, true);
				return;
			}
			break;
		default:
			break;
	}
	const bool is_allowed = _state != State::MEASUREMENT || is_allowed_while_measuring(p_frame);
	if (!is_allowed || handle(p_frame, p_now) == Answer::UNKNOWN) {
		reply_error(ERROR_MESSAGE, p_now);
	}
}

void XbusDevice::_go_to_config(Usec p_now) {
	_state = State::CONFIG;
	_deadline = NEVER;
	_log_state(p_now, "state config");
}

void XbusDevice::_go_to_measurement(Usec p_now, bool p_is_asked) {
	uint8_t bus_id = 0;
	const uint8_t error = start_measuring(bus_id);
	if (error != 0) {
		reply_error(error, p_now, bus_id);
		return;
	}
	if (p_is_asked) {
		reply(xbus::MASTER, Message::GO_TO_MEASUREMENT_ACK, {}, p_now);
	} else {
		reply(xbus::MASTER, Message::CONFIGURATION, configuration(), p_now);
	}
	_state = State::MEASUREMENT;
	_deadline = NEVER;
	_measuring_since = p_now + 200;
	_sample_number = 0;
	_log_state(p_now, "state measurement");
	if (_on_measuring) {
		_on_measuring(p_now);
	}
}

bool XbusDevice::is_overflowing() const {
	return waiting() > BUFFER;
}

void XbusDevice::_sample(Usec p_now) {
	_sample_number++;
	const uint16_t counter = _counter++;
	if (faults.is_frozen || _only_on_request) {
		return;
	}
	if (is_overflowing()) {
		if (_stops_on_overflow) {
			_go_to_config(p_now);
		}
		if (_stops_on_overflow || _error_mode >= 2) {
			reply_error(ERROR_BUFFER, p_now);
		}
		return;
	}
	_samples++;
	reply(xbus::MASTER, sample_message(), sample(motion_time(p_now), counter), p_now, 0);
	mark_last(counter);
	if (faults.error_every > 0 && _samples % uint64_t(faults.error_every) == 0 && _error_mode >= 2) {
		reply_error(faults.error_code, p_now);
		if (_error_mode == 3) {
			_go_to_config(p_now);
		}
	}
}

Usec XbusDevice::next_event() const {
	const Usec own = _next_own();
	return _heard.empty() ? own : std::min(own, _heard.front().time);
}

Usec XbusDevice::_next_own() const {
	if (_state != State::MEASUREMENT) {
		return _deadline;
	}
	return _measuring_since + (_sample_number + 1) * sample_ticks() * SECOND / TICKS;
}

void XbusDevice::advance(Usec p_now) {
	for (Usec time = next_event(); time <= p_now; time = next_event()) {
		if (!_heard.empty() && _heard.front().time <= time) {
			const Chunk chunk = std::move(_heard.front());
			_heard.pop_front();
			_read(chunk.bytes.data(), chunk.bytes.size(), time);
		} else if (_state == State::MEASUREMENT) {
			_sample(time);
		} else if (_state == State::REBOOT) {
			power(true, time);
		} else if (_state == State::WAKE_UP && measures_by_itself()) {
			_deadline = NEVER;
			_go_to_measurement(time, false);
		} else {
			_go_to_config(time);
		}
	}
}

} // namespace emulator
