// SPDX-License-Identifier: MIT
#pragma once

#include "session/line_budget.hpp"
#include "session/session_log.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace xbus {

/// The speed of the line to a device: looks for that of a serial line, the likeliest first. Where the line has
/// no speed, nothing is set and it stays 0.
class LineSpeed {
public:
	LineSpeed(bool p_is_serial, SessionHost &p_host) : _is_serial(p_is_serial), _host(p_host) {}

	/// Sets the likeliest speed.
	void begin() {
		if (_is_serial) {
			set(BAUDS[_at]);
		}
	}
	/// Sets the next speed to try; false where all were tried, and it is the first one again.
	bool try_next() {
		_at = (_at + 1) % BAUDS.size();
		set(BAUDS[_at]);
		return _at != 0;
	}
	/// Sets the speed that a device was asked for where its own was too slow.
	void set_fast() { set(FAST_BAUD); }

	bool is_serial() const { return _is_serial; }
	/// Whether a device is likely to be found at this speed.
	bool is_likely() const { return !_is_serial || _at < LIKELY_BAUDS; }
	/// Bit/s; 0 where the line has no speed.
	uint32_t baud() const { return _baud; }

private:
	/// Speeds at which a master may be found, the likeliest first, bit/s.
	static constexpr std::array<uint32_t, 7> BAUDS = { 460800, 115200, 921600, 230400, 57600, 38400, 19200 };
	static constexpr std::size_t LIKELY_BAUDS = 2;

	void set(uint32_t p_baud) {
		_baud = p_baud;
		_host.set_baud(_baud);
	}

	const bool _is_serial;
	SessionHost &_host;
	std::size_t _at = 0;
	uint32_t _baud = 0;
};

} // namespace xbus
