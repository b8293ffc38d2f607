// SPDX-License-Identifier: MIT
#pragma once

#include "open_questions.hpp"

#include <functional>
#include <vector>

namespace transport {

/// A client's sockets for looking for servers, one for IPv4 and one for IPv6. Linux only, like RelaySocket.
class DiscoverySocket {
public:
	/// Where an answer came from, what it says, and how long it took, us.
	using Take = std::function<void(const Endpoint &, const View &, int64_t)>;

	DiscoverySocket() = default;
	~DiscoverySocket() { close(); }
	DiscoverySocket(const DiscoverySocket &) = delete;
	DiscoverySocket &operator=(const DiscoverySocket &) = delete;

	/// Opens what the machine has. False if it has neither.
	bool open();
	void close();
	/// Asks one address, or all of a network at one of neighbours(); false if it cannot be sent there.
	bool ask(const Endpoint &p_to, bool p_to_all);
	/// Hands over the answers that have come, of at most so many datagrams. Returns how many there were.
	size_t take(size_t p_max, const Take &p_take);

	/// Addresses at which all machines of this one's networks listen: broadcast of each IPv4 network, and all nodes
	/// of each IPv6 link.
	static std::vector<Endpoint> neighbours();

private:
	size_t take_from(int p_socket, size_t p_max, const Take &p_take);

	int _v4 = -1;
	int _v6 = -1;
	OpenQuestions _open;
};

} // namespace transport
