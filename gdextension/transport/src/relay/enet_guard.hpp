// SPDX-License-Identifier: MIT
#pragma once

#include "enet_reader.hpp"

#include <memory>

namespace transport {

/// What a client may make ENet keep.
struct EnetLimits {
	/// Whether there are any limits but that of the channels.
	bool bounded = false;
	/// Largest packet, bytes.
	uint32_t max_packet = 16384;
	/// What one client may make ENet hold back while something before it is missing, bytes.
	uint32_t max_held = 256 << 10;
	/// The same before it is admitted: enough for what a client says until then.
	uint32_t max_held_arriving = 8 << 10;
	/// What all clients together may make it hold back, bytes.
	uint32_t max_held_in_all = 32 << 20;
	/// What each of them may in any case, so that nobody can take the others' part: the largest packet.
	uint32_t own_part = 20 << 10;
	/// Channels that a client must ask for; with fewer there would be none to answer on.
	uint32_t min_channels = 1;
};

/// Watches what one peer sends ENet, before ENet sees it, and bounds what ENet would keep of it.
///
/// ENet reserves a whole packet with its first fragment, and holds back everything reliable behind a
/// gap. What it has taken in is known by the acknowledgements that it sends.
class EnetGuard {
public:
	enum Verdict {
		PASS,
		/// Not what ENet writes, or not for an end of this kind.
		MALFORMED,
		/// CONNECT with too few channels.
		TOO_FEW_CHANNELS,
		/// A packet that is too large, a fragment that does not fit the others, or one of an
		/// unreliable packet: half of it would be kept for as long as its sender likes.
		BAD_FRAGMENT,
		/// CONNECT of a peer that is connected.
		CONNECTED_ALREADY,
		/// ENet holds enough back for this peer, or for all. It may be sent again later.
		HELD_TOO_MUCH,
	};

	/// r_held_in_all counts what all guards of a server hold together.
	EnetGuard(const EnetLimits &p_limits, uint64_t &r_held_in_all) : _limits(&p_limits), _held_in_all(&r_held_in_all) {}
	~EnetGuard();
	EnetGuard(const EnetGuard &) = delete;
	EnetGuard &operator=(const EnetGuard &) = delete;

	/// Looks at a datagram for ENet. Nothing of one that does not pass must reach ENet.
	Verdict check(const View &p_datagram);
	/// Looks at a datagram of ENet's for this peer.
	void note_sent(const View &p_datagram);
	/// The peer is admitted. Before that it has channel 0 only, and little of it.
	void admit() { _admitted = true; }

	/// What ENet may be holding back at most, bytes.
	uint32_t held() const { return _held; }
	/// Whether a CONNECT has come that ENet has answered, and where its peer then is.
	bool has_peer() const { return _has_peer; }
	uint16_t peer() const { return _peer; }
	uint8_t session() const { return _session; }
	/// Whether a CONNECT is another than the one that has come.
	bool is_another(const EnetCommand &p_connect) const { return p_connect.chosen != _chosen; }
	/// Whether anything but CONNECT has come since.
	bool is_confirmed() const { return _confirmed; }

private:
	/// ENet's reliable numbers of a channel that can be under way at once, at most: further ones are
	/// as if they were lost.
	static constexpr size_t AHEAD = 1024;
	static constexpr size_t CHANNELS = 8;

	struct Slot {
		/// What the packet that begins here takes, bytes; 0: none begins here.
		uint32_t charge = 0;
		/// Numbers that the packet that begins here has.
		uint16_t span = 0;
		/// Number of the first fragment of the packet that this one belongs to.
		uint16_t first = 0;
		bool claimed = false;
		bool acknowledged = false;
	};
	struct Channel {
		/// All numbers up to this one are ENet's, and handed on.
		uint16_t taken = 0;
		std::array<Slot, AHEAD> slots;
		/// Unreliable packets that wait for a reliable one, and for which.
		uint32_t waiting = 0;
		uint16_t waiting_until = 0;
	};

	Verdict check_connect(const EnetCommand &p_command);
	Verdict check_command(const EnetCommand &p_command);
	Verdict check_reliable(uint8_t p_channel, uint16_t p_first, uint16_t p_span, uint32_t p_size);
	Verdict check_fragment(const EnetCommand &p_command);
	Verdict check_unreliable(const EnetCommand &p_command);
	bool hand_on(Channel &r_channel);
	bool charge(uint32_t p_bytes);
	void release(uint32_t p_bytes);
	void restart();
	Channel &channel(uint8_t p_number);
	void take(Channel &r_channel, uint16_t p_number);

	const EnetLimits *_limits;
	uint64_t *_held_in_all;
	uint32_t _held = 0;
	std::array<std::unique_ptr<Channel>, CHANNELS> _channels;
	std::array<uint8_t, 8> _chosen{};
	bool _has_chosen = false;
	uint16_t _peer = 0;
	uint8_t _session = 0;
	bool _has_peer = false;
	bool _confirmed = false;
	bool _admitted = false;
};

} // namespace transport
