// SPDX-License-Identifier: MIT
#pragma once

#include "bus/bytes.hpp"
#include "bus/message.hpp"

#include <array>
#include <type_traits>
#include <utility>

namespace xbus {

/// What a framer has seen. Every byte is counted once: bytes = frame_bytes + skipped_bytes + those that wait.
struct FramerStatistics {
	uint64_t bytes = 0;
	/// Messages handed on and taken.
	uint64_t frames = 0;
	uint64_t frame_bytes = 0;
	/// Bytes that belong to no message.
	uint64_t skipped_bytes = 0;
	/// Stretches of skipped bytes.
	uint64_t stretches = 0;
	/// Starts of messages that turned out to be none, by their reason.
	uint64_t bad_checksums = 0;
	uint64_t refused_lengths = 0;
	uint64_t refused_starts = 0;
	/// Right checksums that the receiver did not take.
	uint64_t refused_frames = 0;
	/// Messages whose rest did not come.
	uint64_t given_up = 0;

	/// Whether so much is wrong with the line that what looks odd is rather corrupted: a byte in a thousand.
	bool is_noisy() const { return skipped_bytes * 1000 > bytes; }
};

/// Finds messages in a stream of bytes, however it is cut. A message that lies whole in a chunk is handed on
/// where it is; only one that a cut goes through is put together in a buffer of fixed size.
///
/// After anything wrong it goes on one byte later: the start of a message inside something broken is found.
class Framer {
public:
	/// Bounds the data bytes of a message; longer lengths are refused at once instead of waited for. The short
	/// form's lengths (to 254) are bounded as well.
	void set_longest(std::size_t p_data_bytes) { _longest = p_data_bytes < MAX_DATA ? p_data_bytes : MAX_DATA; }

	/// Takes the next bytes and calls `p_sink(const Frame &)` for every message. A sink that returns false
	/// refuses the message: it was none, and the search goes on one byte after its start.
	template <class S>
	void feed(const uint8_t *p_bytes, std::size_t p_size, S &&p_sink);

	/// The rest of the message that is waited for did not come in time: goes on behind its first byte. What
	/// is found there is handed on; a later message that is incomplete is waited for in its turn.
	template <class S>
	void give_up(S &&p_sink);

	/// Nothing will come any more: gives up everything that is waited for.
	template <class S>
	void finish(S &&p_sink);

	/// Bytes that wait for the rest of their message.
	std::size_t pending() const { return _end - _begin; }
	const FramerStatistics &statistics() const { return _statistics; }

	/// Forgets what is pending, and all statistics.
	void reset();

private:
	enum class Verdict : uint8_t {
		GOOD,
		BAD,
		SHORT
	};

	/// Whether a message starts at `p_bytes`, a preamble. `r_needed`: bytes of the whole message, or, if there
	/// are too few to decide, the number that decides.
	Verdict _judge(const uint8_t *p_bytes, std::size_t p_size, Frame &r_frame, std::size_t &r_needed);
	Verdict _judge_extended(const uint8_t *p_bytes, std::size_t p_size, Frame &r_frame, std::size_t &r_needed);
	Verdict _judge_whole(
			const uint8_t *p_bytes, std::size_t p_size, std::size_t p_head, Frame &r_frame, std::size_t &r_needed);

	template <class S>
	Verdict _try(const uint8_t *p_bytes, std::size_t p_size, std::size_t &r_needed, S &p_sink);
	/// Works through `p_bytes`; what is left at the end is a message's beginning.
	template <class S>
	std::size_t _scan(const uint8_t *p_bytes, std::size_t p_size, S &p_sink);
	/// Completes what is pending from a new chunk; returns where in the chunk the scan goes on.
	template <class S>
	std::size_t _continue(const uint8_t *p_bytes, std::size_t p_size, S &p_sink);

	/// Drops pending bytes up to the next preamble after the first `p_count`.
	void _drop_pending(std::size_t p_count);
	void _append(const uint8_t *p_bytes, std::size_t p_size);
	void _skip(std::size_t p_count);

	std::size_t _longest = MAX_DATA;
	std::array<uint8_t, MAX_FRAME> _buffer{};
	std::size_t _begin = 0;
	std::size_t _end = 0;
	bool _in_stretch = false;
	FramerStatistics _statistics;
};

inline void Framer::_skip(std::size_t p_count) {
	_statistics.skipped_bytes += p_count;
	_statistics.stretches += _in_stretch || p_count == 0 ? 0U : 1U;
	_in_stretch = _in_stretch || p_count > 0;
}

inline Framer::Verdict Framer::_judge_whole(
		const uint8_t *p_bytes, std::size_t p_size, std::size_t p_head, Frame &r_frame, std::size_t &r_needed) {
	if (r_frame.size > _longest) {
		_statistics.refused_lengths++;
		return Verdict::BAD;
	}
	r_needed = p_head + r_frame.size + 1;
	if (p_size < r_needed) {
		return Verdict::SHORT;
	}
	r_frame.data = p_bytes + p_head;
	if (sum_bytes(p_bytes + 1, r_needed - 1) != 0) {
		_statistics.bad_checksums++;
		return Verdict::BAD;
	}
	return Verdict::GOOD;
}

inline Framer::Verdict Framer::_judge_extended(
		const uint8_t *p_bytes, std::size_t p_size, Frame &r_frame, std::size_t &r_needed) {
	constexpr std::size_t HEAD = 6;
	if (p_size < HEAD) {
		r_needed = HEAD;
		return Verdict::SHORT;
	}
	r_frame.size = read_u16(p_bytes + 4);
	return _judge_whole(p_bytes, p_size, HEAD, r_frame, r_needed);
}

inline Framer::Verdict Framer::_judge(
		const uint8_t *p_bytes, std::size_t p_size, Frame &r_frame, std::size_t &r_needed) {
	constexpr std::size_t HEAD = 4;
	if (p_size < HEAD) {
		r_needed = HEAD;
		return Verdict::SHORT;
	}
	// Nobody asks everybody for a device identifier: these are zeros behind a false preamble.
	if (p_bytes[1] == BROADCAST && p_bytes[2] == 0) {
		_statistics.refused_starts++;
		return Verdict::BAD;
	}
	r_frame.bus_id = p_bytes[1];
	r_frame.message = Message(p_bytes[2]);
	if (p_bytes[3] == EXTENDED) {
		return _judge_extended(p_bytes, p_size, r_frame, r_needed);
	}
	r_frame.size = p_bytes[3];
	return _judge_whole(p_bytes, p_size, HEAD, r_frame, r_needed);
}

template <class S>
Framer::Verdict Framer::_try(const uint8_t *p_bytes, std::size_t p_size, std::size_t &r_needed, S &p_sink) {
	Frame frame;
	const Verdict verdict = _judge(p_bytes, p_size, frame, r_needed);
	if (verdict != Verdict::GOOD) {
		return verdict;
	}
	if constexpr (std::is_same_v<decltype(p_sink(std::declval<const Frame &>())), bool>) {
		if (!p_sink(std::as_const(frame))) {
			_statistics.refused_frames++;
			return Verdict::BAD;
		}
	} else {
		p_sink(std::as_const(frame));
	}
	_statistics.frames++;
	_statistics.frame_bytes += r_needed;
	_in_stretch = false;
	return Verdict::GOOD;
}

template <class S>
std::size_t Framer::_scan(const uint8_t *p_bytes, std::size_t p_size, S &p_sink) {
	std::size_t at = 0;
	while (at < p_size) {
		if (p_bytes[at] != PREAMBLE) {
			const void *found = std::memchr(p_bytes + at, PREAMBLE, p_size - at);
			const std::size_t next =
					found == nullptr ? p_size : std::size_t(static_cast<const uint8_t *>(found) - p_bytes);
			_skip(next - at);
			at = next;
			continue;
		}
		std::size_t needed = 0;
		const Verdict verdict = _try(p_bytes + at, p_size - at, needed, p_sink);
		if (verdict == Verdict::SHORT) {
			break;
		}
		if (verdict == Verdict::GOOD) {
			at += needed;
		} else {
			_skip(1);
			at++;
		}
	}
	return at;
}

template <class S>
std::size_t Framer::_continue(const uint8_t *p_bytes, std::size_t p_size, S &p_sink) {
	std::size_t taken = 0;
	while (pending() > 0) {
		// What is pending came with this chunk: it can be read where it lies.
		if (pending() <= taken) {
			const std::size_t back = pending();
			_begin = _end = 0;
			return taken - back;
		}
		std::size_t needed = 0;
		const Verdict verdict = _try(_buffer.data() + _begin, pending(), needed, p_sink);
		if (verdict == Verdict::SHORT) {
			const std::size_t more = needed - pending();
			const std::size_t here = more < p_size - taken ? more : p_size - taken;
			if (here == 0) {
				break;
			}
			_append(p_bytes + taken, here);
			taken += here;
		} else if (verdict == Verdict::GOOD) {
			_begin += needed;
			_drop_pending(0);
		} else {
			_drop_pending(1);
		}
	}
	return taken;
}

template <class S>
void Framer::feed(const uint8_t *p_bytes, std::size_t p_size, S &&p_sink) {
	_statistics.bytes += p_size;
	std::size_t at = _continue(p_bytes, p_size, p_sink);
	if (pending() == 0 && at < p_size) {
		at += _scan(p_bytes + at, p_size - at, p_sink);
		_append(p_bytes + at, p_size - at);
	}
}

template <class S>
void Framer::give_up(S &&p_sink) {
	if (pending() > 0) {
		_statistics.given_up++;
		_drop_pending(1);
		_continue(nullptr, 0, p_sink);
	}
}

template <class S>
void Framer::finish(S &&p_sink) {
	while (pending() > 0) {
		give_up(p_sink);
	}
}

} // namespace xbus
