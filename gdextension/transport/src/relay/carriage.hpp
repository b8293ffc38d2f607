// SPDX-License-Identifier: MIT
#pragma once

#include "../sealing/path_mtu.hpp"
#include "../sealing/sealed_channel.hpp"

#include <functional>
#include <vector>

namespace transport {

/// How what two ends of an open connection send each other is packed into datagrams that the path
/// carries: whole, or in parts where it is too large. What both ends of a path say to each other about
/// that is here, too. Works on what is in a datagram; sealing is the caller's.
///
/// A message beside ENet begins with its kind. Those from 0x60 to 0x6F are the transport's own:
/// PART: u16 number, u8 index of the part | parts << 3 | content << 6, then its bytes.
/// IDENTITY: see ServerIdentity. PROBE: u16 bytes of the datagram that it makes, zeros.
/// PROBED: u16 of a PROBE that has come.
class Carriage {
public:
	/// Sends the content of one datagram.
	using Send = std::function<void(Content, const View &)>;

	enum Kind : uint8_t {
		PART = 0x60,
		IDENTITY = 0x61,
		PROBE = 0x62,
		PROBED = 0x63,
	};
	/// First and last kind that is the transport's own.
	static constexpr uint8_t FIRST_KIND = 0x60;
	static constexpr uint8_t LAST_KIND = 0x6F;
	/// Bytes before what a part holds.
	static constexpr size_t PART_HEAD = 4;
	/// Bytes of the largest whole: larger ones nobody sends.
	static constexpr size_t MAX_WHOLE = 2048;
	/// Wholes that are put together at once; the oldest makes room.
	static constexpr size_t MAX_OPEN = 4;

	/// Bytes that sealing adds to what is in a datagram.
	explicit Carriage(size_t p_overhead = SealedChannel::OVERHEAD) : _overhead(p_overhead) {}

	/// Sends something, in parts if the path wants it so.
	void send(Content p_content, const View &p_bytes, const Send &p_send);
	/// Takes what a datagram held. True if r_content and r_bytes are something whole for others.
	bool take(Content &r_content, Bytes &r_bytes, size_t p_datagram_size, int64_t p_now_usec, const Send &p_send);
	/// Sends the probes that are due.
	void look_after(int64_t p_now_usec, const Send &p_send);
	/// The path is another one.
	void restart(int64_t p_now_usec) { _mtu.restart(p_now_usec); }
	const PathMtu &mtu() const { return _mtu; }

private:
	/// Something of which parts have come.
	struct Whole {
		uint16_t number = 0;
		uint8_t content_and_count = 0;
		size_t missing = 0;
		std::vector<Bytes> parts;
	};

	bool take_part(Content &r_content, Bytes &r_bytes);
	Whole &whole_of(uint16_t p_number, uint8_t p_content_and_count);

	size_t _overhead;
	PathMtu _mtu;
	uint16_t _next_number = 0;
	std::vector<Whole> _open;
	Bytes _part;
};

} // namespace transport
