// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace transport {

/// Finds out how large a datagram may be on the way to the other end: probes of some sizes, of which
/// the other end says that they have come (Packetization Layer Path MTU Discovery, RFC 8899). Networks
/// that drop what is too large seldom say so.
///
/// It begins with the smallest size, which every network carries, and goes back to it where a size that
/// was good comes to nothing.
class PathMtu {
public:
	/// Bytes of a UDP datagram: what fits into packets of 576, 1280 and 1500 bytes with the headers of
	/// IPv6 and UDP.
	static constexpr std::array<size_t, 3> SIZES{ { 528, 1232, 1452 } };
	/// Probes of a size in a row before it counts as too large.
	static constexpr int TRIES = 6;
	/// Between the first two of them; each pause is twice the one before, us.
	static constexpr int64_t PAUSE_USEC = 60000;
	/// When larger sizes are tried again, us.
	static constexpr int64_t AGAIN_USEC = 30000000;
	/// How often a size is looked at again while it is used, us.
	static constexpr int64_t CHECK_USEC = 2000000;
	/// How soon an answer must come then, us.
	static constexpr int64_t CHECK_PAUSE_USEC = 300000;

	/// Bytes that a datagram may have.
	size_t limit() const { return SIZES[_good]; }
	/// Whether the search is over, so that limit() is what the path carries.
	bool is_settled() const { return _good + 1 == SIZES.size() || _tries >= TRIES; }

	/// A datagram of so many bytes was sent.
	void note_sent(size_t p_size) { _is_used = _is_used || p_size > SIZES.front(); }
	/// When something is due, us.
	int64_t due_usec() const { return _due_usec; }
	/// Calls p_send with the size of each probe that is due.
	template <typename Send>
	void look_after(int64_t p_now_usec, Send p_send) {
		if (p_now_usec < _due_usec) {
			return;
		}
		if (_unanswered >= TRIES) {
			restart(p_now_usec);
		}
		if (!is_settled() || p_now_usec >= _again_usec) {
			search(p_now_usec, p_send);
		} else if (_good > 0 && _is_used) {
			_unanswered++;
			_due_usec = p_now_usec + CHECK_PAUSE_USEC;
			p_send(SIZES[_good]);
		} else {
			_due_usec = p_now_usec + CHECK_USEC;
		}
	}
	/// The other end says that a probe of this size has come.
	void take_answer(size_t p_size, int64_t p_now_usec) {
		for (size_t i = 0; i < SIZES.size(); i++) {
			if (SIZES[i] != p_size) {
				continue;
			}
			if (i >= _good) {
				_good = i;
				_unanswered = 0;
				_is_used = false;
				_due_usec = is_settled() ? p_now_usec + CHECK_USEC : _due_usec;
			}
		}
	}
	/// The path is another one.
	void restart(int64_t p_now_usec) {
		*this = PathMtu();
		_due_usec = p_now_usec;
	}

private:
	template <typename Send>
	void search(int64_t p_now_usec, Send p_send) {
		if (_tries >= TRIES) {
			_tries = 0;
		}
		for (size_t i = SIZES.size() - 1; i > _good; i--) {
			p_send(SIZES[i]);
		}
		_due_usec = p_now_usec + (PAUSE_USEC << _tries);
		_again_usec = p_now_usec + AGAIN_USEC;
		_tries++;
	}

	size_t _good = 0;
	/// Times that larger sizes have been tried.
	int _tries = 0;
	/// Probes of the good size since the last answer.
	int _unanswered = 0;
	/// Whether anything larger than the smallest size was sent since.
	bool _is_used = false;
	int64_t _due_usec = 0;
	int64_t _again_usec = 0;
};

} // namespace transport
