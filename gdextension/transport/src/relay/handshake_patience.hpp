// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

namespace transport {

/// Decides when a client's handshake has come to nothing, and when to give up. It may be told why it comes to nothing
/// (a hint), but by anybody: it tries on for a while, and believes it after some handshakes in a row.
class HandshakePatience {
public:
	/// A step that takes longer begins anew from the first one: a cookie may have run out, a server may
	/// have begun anew, us.
	static constexpr int64_t MAX_STEP_USEC = 2000000;
	/// A handshake that is put off again and again begins anew: its cookie runs out, us.
	static constexpr int64_t MAX_HANDSHAKE_USEC = 8000000;
	/// Who is told why the handshake comes to nothing tries on for so long, twice as long each time: a
	/// server that is there needs one round trip to prove the contrary, us.
	static constexpr int64_t HINT_USEC = 500000;
	/// Handshakes that end so before it is believed.
	static constexpr int MAX_HINTED = 3;
	/// Handshakes after which another key is believed: the user is asked.
	static constexpr int MAX_OTHER_KEYS = 2;
	/// Without sealing: for how long nothing else but notices comes, us.
	static constexpr int64_t UNSEALED_USEC = 2000000;

	bool has_begun() const { return _begun_usec != 0; }
	void begin(int64_t p_now_usec) {
		_is_hinted = false;
		_begun_usec = p_now_usec;
	}
	/// A step begins, or is put off.
	void begin_step(int64_t p_now_usec) { _step_usec = p_now_usec; }

	/// Somebody says why the handshake comes to nothing.
	void hint(int64_t p_now_usec) {
		if (!_is_hinted) {
			_is_hinted = true;
			_hinted_usec = p_now_usec;
		}
	}
	/// Something else has come: without sealing that shows that the server is there.
	void forget_hint() { _is_hinted = false; }
	/// Without sealing: ENet went on asking, and a server that takes the connection answers something else.
	bool is_refused(int64_t p_now_usec) const { return _is_hinted && p_now_usec - _hinted_usec > UNSEALED_USEC; }

	/// Whether this handshake has come to nothing.
	bool is_over(int64_t p_now_usec) const {
		const int64_t patience = _is_hinted ? HINT_USEC << std::min(_hinted, MAX_HINTED - 1) : MAX_STEP_USEC;
		const int64_t since = _is_hinted ? _hinted_usec : _step_usec;
		return p_now_usec - since > patience || p_now_usec - _begun_usec > MAX_HANDSHAKE_USEC;
	}
	/// Counts a handshake that is over. Returns whether enough in a row have been told why.
	/// @param p_is_proved the server has proved another key than is known
	/// @param p_was_in who was in a session goes on: its server is there, or comes back
	bool is_hopeless(bool p_is_proved, bool p_was_in) {
		_hinted = _is_hinted ? _hinted + 1 : 0;
		return p_is_proved ? _hinted >= MAX_OTHER_KEYS : _hinted >= MAX_HINTED && !p_was_in;
	}

private:
	/// Whether this handshake has been told why it comes to nothing, and how many before it.
	bool _is_hinted = false;
	int _hinted = 0;
	int64_t _begun_usec = 0;
	int64_t _step_usec = 0;
	int64_t _hinted_usec = 0;
};

} // namespace transport
