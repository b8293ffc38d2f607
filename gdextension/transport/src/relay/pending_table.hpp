// SPDX-License-Identifier: MIT
#pragma once

#include "../sealing/messages.hpp"
#include "../sealing/password_tries.hpp"
#include "../sealing/sealed_channel.hpp"
#include "endpoint.hpp"

#include <list>
#include <optional>
#include <unordered_map>

namespace transport {

/// A handshake whose client has not shown yet that it has the key.
struct Pending {
	Endpoint from;
	messages::Start start;
	cpace::Scalar scalar{};
	cpace::Share share{};
	/// Made with the first datagram that asks for it.
	std::optional<ChannelKeys> keys;
	SealedChannel channel;
	/// Whether something of it could not be opened.
	bool has_failed = false;
	/// Whether it counts as a try of a password, and what has been charged for it.
	bool is_try = false;
	PasswordTries::Try charged;
	int64_t since_usec = 0;
};

/// All of a server's pending handshakes: at most MAX, and MAX_OF_NETWORK of one network; the oldest
/// make room.
class PendingTable {
public:
	static constexpr size_t MAX = 4096;
	static constexpr size_t MAX_OF_NETWORK = 2048;
	static constexpr int64_t KEPT_USEC = 5000000;

	Pending *find(const Endpoint &p_from);
	Pending &add(const Endpoint &p_from);
	void remove(const Endpoint &p_from);
	void look_after(int64_t p_now_usec);
	size_t size() const { return _in_order.size(); }

private:
	using Place = std::list<Pending>::iterator;
	using Network = std::array<uint8_t, 16>;

	void remove_at(Place p_place);
	void make_room(const Network &p_network);

	std::list<Pending> _in_order;
	std::unordered_map<Endpoint, Place, EndpointHash> _by_endpoint;
	std::unordered_map<Network, size_t, NetworkHash> _of_network;
};

} // namespace transport
