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

/// What a sealed datagram holds.
enum class Content : uint8_t {
	/// A datagram of ENet's.
	ENET = 0,
	/// A message beside ENet, see carriage.hpp.
	FAST = 1,
};

/// Seals datagrams and opens those of the other end: ChaCha20-Poly1305 (RFC 8439), the nonce is the
/// datagram's number, the header is authenticated along. What was altered, forged or came before is
/// not opened and changes nothing.
///
/// Numbers have 64 bits. Of each some low bits are sent, and the rest follows from the newest that has
/// come, as in QUIC (RFC 9000, 17.1): 14 bits in two bytes, of which the first has bit 7 and says what
/// the datagram holds by bit 6; or 24 bits behind a head of its own.
class SealedChannel {
public:
	static constexpr size_t HEAD_SIZE = 2;
	static constexpr size_t TAG_SIZE = 16;
	/// What sealing adds to a datagram, bytes.
	static constexpr size_t OVERHEAD = HEAD_SIZE + TAG_SIZE;
	/// Low bits of a number that are sent: seconds of the fastest sender, beyond which the other end
	/// counts as lost anyhow.
	static constexpr int NUMBER_BITS = 14;
	/// The same behind a head of its own.
	static constexpr int LONG_NUMBER_BITS = 24;

	SealedChannel() = default;
	SealedChannel(const Key &p_sending, const Key &p_receiving) : _sending(p_sending), _receiving(p_receiving) {}

	/// Whether a datagram begins as seal() begins it.
	static bool is_sealed(const View &p_datagram) { return p_datagram.size >= OVERHEAD && p_datagram.data[0] >= 0x80; }
	/// The number with so many low bits that is nearest to the one that is expected.
	static uint64_t whole_number(uint64_t p_expected, uint64_t p_low, int p_bits);

	/// Makes r_sealed the head, what is sealed and its tag.
	void seal(Content p_content, const View &p_plain, Bytes &r_sealed);
	/// The same with a head of its own before the number.
	void seal(const View &p_head, const View &p_plain, Bytes &r_sealed);
	/// Opens what seal() of the other end has made. False if it is not genuine or has come before.
	bool open(const View &p_sealed, Content &r_content, Bytes &r_plain);
	/// The same with a head of its own, of this size.
	bool open(const View &p_sealed, size_t p_head_size, Bytes &r_plain);

private:
	void encrypt(size_t p_head_size, const View &p_plain, Bytes &r_sealed);
	bool decrypt(const View &p_sealed, size_t p_head_size, uint64_t p_number, Bytes &r_plain);

	Key _sending{};
	Key _receiving{};
	uint64_t _next_number = 0;
	ReplayWindow _come;
};

} // namespace transport
