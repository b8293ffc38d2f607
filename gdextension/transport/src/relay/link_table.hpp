// SPDX-License-Identifier: MIT
#pragma once

#include "../sealing/messages.hpp"
#include "../sealing/sealed_channel.hpp"
#include "carriage.hpp"
#include "endpoint.hpp"
#include "enet_guard.hpp"

#include <list>
#include <map>
#include <unordered_map>

namespace transport {

/// One client, as the relay of a server knows it.
struct Link {
	Link(const EnetLimits &p_limits, uint64_t &r_held_in_all) : guard(p_limits, r_held_in_all) {}

	Endpoint outer;
	/// Loopback address that stands for it at ENet, as a number; used once.
	uint32_t inner = 0;
	messages::ClientId client{};
	uint8_t role = 0;
	ChannelKeys keys;
	SealedChannel channel;
	Carriage carriage;
	/// What the server shows of its identity.
	Bytes identity;
	EnetGuard guard;
	/// By which the rest of the program knows it; 0: it doesn't yet.
	int64_t peer = 0;
	int64_t since_usec = 0;
	int64_t heard_usec = 0;
	bool is_confirmed = false;
};

/// All clients of a server, by both of their addresses, by their ids, and by the rest of the program's. Those with whom
/// ENet has no connection yet are bounded by themselves: the oldest of them make room.
class LinkTable {
public:
	static constexpr size_t MAX_HALF_OPEN = 1024;

	/// With MAX_HALF_OPEN less than ENet's slots.
	explicit LinkTable(size_t p_max_confirmed) : _max_confirmed(p_max_confirmed) {}

	Link *find(const Endpoint &p_outer);
	Link *find_inner(uint32_t p_inner);
	Link *find_client(const messages::ClientId &p_client);
	Link *find_peer(int64_t p_peer);
	/// Null if there are too many.
	Link *add(const Endpoint &p_outer, const EnetLimits &p_limits);
	void remove(const Link &p_link);
	/// Says what a handshake has found out, once.
	void set_client(Link &r_link, const messages::ClientId &p_client);
	/// The rest of the program knows it by this from now on, and no other.
	void set_peer(Link &r_link, int64_t p_peer);
	/// It has another address now, which nobody else has.
	void move(Link &r_link, const Endpoint &p_outer);
	/// ENet has a connection with it, or has none any more.
	void confirm(Link &r_link, bool p_confirmed);
	/// The oldest without a connection, if there are too many, else null.
	Link *oldest_half_open();
	bool is_crowded() const { return _half_open.size() >= MAX_HALF_OPEN; }
	size_t half_open() const { return _half_open.size(); }
	size_t confirmed() const { return _confirmed.size(); }
	/// Of all clients' packets, what ENet holds back, bytes.
	uint64_t held() const { return _held; }
	/// Calls p_call for each; it must not change the table.
	template <typename Call>
	void for_each(Call p_call) {
		for (std::list<Link> *list : { &_half_open, &_confirmed }) {
			for (Link &link : *list) {
				p_call(link);
			}
		}
	}

private:
	using Place = std::list<Link>::iterator;

	// Before the links, whose guards count in it until they end.
	uint64_t _held = 0;
	std::list<Link> _half_open;
	std::list<Link> _confirmed;
	std::unordered_map<Endpoint, Place, EndpointHash> _by_outer;
	std::unordered_map<uint32_t, Place> _by_inner;
	std::map<messages::ClientId, uint32_t> _by_client;
	std::unordered_map<int64_t, uint32_t> _by_peer;
	const size_t _max_confirmed;
	uint32_t _next_inner = 0;
};

} // namespace transport
