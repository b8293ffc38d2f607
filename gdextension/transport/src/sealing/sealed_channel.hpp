// SPDX-License-Identifier: MIT
#pragma once

#include "bytes.hpp"
#include "replay_window.hpp"

namespace transport {

using Key = std::array<uint8_t, 32>;

/// The keys of both directions and what both ends know besides, all from one session key.
struct ChannelKeys {
	Key to_server{};
	Key to_client{};
	/// Bound to this handshake, its password and its role: proves who is at the other end.
	Key exporter{};
	/// What the client may show when it comes back.
	std::array<uint8_t, 16> return_tag{};

	/// BLAKE2b-256, keyed by the session key, of a label each.
	static ChannelKeys derive(const std::array<uint8_t, 64> &p_session_key);
};

/// Seals datagrams and opens those of the other end: ChaCha20-Poly1305 (RFC 8439), the nonce is the
/// datagram's number, the header is authenticated along. What was altered, forged or came before is
/// not opened and changes nothing.
class SealedChannel {
public:
	/// Bytes of a number as it is sent; the rest follows from the newest that has come.
	static constexpr size_t NUMBER_SIZE = 3;
	static constexpr size_t TAG_SIZE = 16;
	/// What sealing adds to a datagram, bytes.
	static constexpr size_t OVERHEAD = 1 + NUMBER_SIZE + TAG_SIZE;

	SealedChannel() = default;
	SealedChannel(const Key &p_sending, const Key &p_receiving) : _sending(p_sending), _receiving(p_receiving) {}

	/// The number with these low bits that is nearest to the one that is expected.
	static uint64_t whole_number(uint64_t p_expected, uint64_t p_low);

	/// Makes r_sealed a head, a number, what is sealed and its tag.
	void seal(const View &p_head, const View &p_plain, Bytes &r_sealed);
	/// Opens what seal() of the other end has made with a head of this size. False if it is not
	/// genuine or has come before.
	bool open(const View &p_sealed, size_t p_head_size, Bytes &r_plain);

private:
	Key _sending{};
	Key _receiving{};
	uint64_t _next_number = 0;
	ReplayWindow _come;
};

} // namespace transport
