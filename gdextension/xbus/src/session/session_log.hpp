// SPDX-License-Identifier: MIT
#pragma once

#include "session/suit_frame.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace xbus {

enum class Severity : uint8_t {
	INFO,
	WARNING,
	ERROR
};

/// The world around a session.
class SessionHost {
public:
	virtual ~SessionHost() = default;
	/// Sends bytes to the device; false if they cannot be sent now.
	virtual bool send(const uint8_t *p_bytes, std::size_t p_size) = 0;
	/// Sets the line's speed, bit/s, soon.
	virtual void set_baud(uint32_t p_baud) = 0;
	virtual void take_frame(const SuitFrame &p_frame) = 0;
	/// Something that people should know.
	virtual void say(Severity p_severity, const char *p_text) = 0;
};

/// Tells people what a session does, and remembers what is wrong now. What is said again and again is said
/// once. Nothing is allocated.
class SessionLog {
public:
	explicit SessionLog(SessionHost &p_host) : _host(p_host) {}

	/// Says something in the manner of printf. A warning is the problem from now on.
	void log(Severity p_severity, const char *p_format, ...) __attribute__((format(printf, 3, 4)));
	/// All is well again.
	void clear() { _problem.fill(0); }
	bool has_problem() const { return _problem[0] != 0; }
	/// What is wrong now, or an empty text.
	const char *problem() const { return _problem.data(); }

private:
	SessionHost &_host;
	std::array<char, 240> _problem{};
};

} // namespace xbus
