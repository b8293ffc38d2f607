// SPDX-License-Identifier: MIT
#pragma once

#include "../sealing/messages.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace transport {

/// Notices that a client's address has become another one: a server that knows nobody there says so, with the end of
/// what it was sent. Anybody can say so: whoever has not seen what was sent is not believed, nor is anybody while the
/// server is still heard.
class AddressWatch {
public:
	/// How often a client says at most that it has moved, us: anybody can make it say so.
	static constexpr int64_t MOVED_USEC = 10000;
	/// Whoever hears his server has not moved: so long must it be silent, us. It says something 60 times a
	/// second.
	static constexpr int64_t DEAF_USEC = 50000;
	/// After so much silence a client sends something, so that a server that does not know its address says
	/// so: much of what it sends otherwise are answers. Each pause is twice the one before, us.
	static constexpr int64_t ASK_USEC = 120000;
	static constexpr int MAX_ASKS = 6;

	/// Notes what was sent.
	void note_sent(const Bytes &p_sealed) {
		_echoes[_next_echo] = messages::echo_of(p_sealed);
		_next_echo = (_next_echo + 1) % _echoes.size();
	}

	/// Whether to answer somebody who says that the server knows nobody here.
	/// @param p_heard_usec when something of the server's was opened last
	bool has_moved(const messages::UnknownMessage &p_unknown, int64_t p_heard_usec, int64_t p_now_usec) {
		if (p_now_usec - _moved_usec < MOVED_USEC || p_now_usec - p_heard_usec < DEAF_USEC ||
				std::find(_echoes.begin(), _echoes.end(), p_unknown.echo) == _echoes.end()) {
			return false;
		}
		_moved_usec = p_now_usec;
		return true;
	}

	/// Whether to send something now because the server has been silent.
	bool must_ask(int64_t p_heard_usec, int64_t p_now_usec) {
		if (p_now_usec - p_heard_usec < ASK_USEC) {
			_asks = 0;
		} else if (_asks < MAX_ASKS && p_now_usec >= p_heard_usec + (ASK_USEC << _asks)) {
			_asks++;
			return true;
		}
		return false;
	}
	/// When to ask next, us.
	int64_t due_usec(int64_t p_heard_usec) const {
		return _asks < MAX_ASKS ? p_heard_usec + (ASK_USEC << _asks) : INT64_MAX;
	}

private:
	/// The ends of what was sent last.
	std::array<messages::Echo, 64> _echoes{};
	std::size_t _next_echo = 0;
	int64_t _moved_usec = 0;
	/// Times that silence was broken since the server was heard.
	int _asks = 0;
};

} // namespace transport
