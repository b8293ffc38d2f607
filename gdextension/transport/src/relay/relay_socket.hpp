// SPDX-License-Identifier: MIT
#pragma once

#include "../sealing/bytes.hpp"
#include "endpoint.hpp"

#include <functional>
#include <memory>

namespace transport {

/// The two UDP sockets of a relay: the outer one faces the network, the inner one faces ENet over
/// loopback, where every address of 127.0.0.0/8 with its port stands for another end. Datagrams go in
/// batches. Linux only; everything that depends on that is in here.
///
/// The kernel lets nobody else speak to either end of the inner way: each takes only what comes from
/// the other's port, and nobody else can have that.
class RelaySocket {
public:
	using TakeOuter = std::function<void(const Endpoint &, const View &)>;
	using TakeInner = std::function<void(uint32_t, const View &)>;

	RelaySocket();
	~RelaySocket();
	RelaySocket(const RelaySocket &) = delete;
	RelaySocket &operator=(const RelaySocket &) = delete;

	/// Opens both; "*" for all addresses. Returns an errno, 0: it worked.
	int open_server(const std::string &p_address, uint16_t p_port);
	int open_client(const Endpoint &p_server);
	/// Opens a client's outer socket again, under the same descriptor, where the way to the server begins
	/// at another address of this machine than when it was opened: another network has taken the place of
	/// the one before. Returns whether it has.
	bool follow_route(const Endpoint &p_server);
	/// Ties the inner socket and ENet's, of that descriptor, to each other. False if it cannot be.
	bool tie(int p_enet, uint16_t p_enet_port);
	void close();

	int outer() const;
	uint16_t outer_port() const;
	uint16_t inner_port() const;

	/// Reads what has come, at most about so many datagrams. Returns how many.
	size_t read_outer(size_t p_max, const TakeOuter &p_take);
	size_t read_inner(const TakeInner &p_take);
	/// Queues a datagram; a full batch leaves by itself.
	void write_outer(const Endpoint &p_to, const View &p_bytes);
	void write_inner(uint32_t p_from, const View &p_bytes);
	/// Sends what is queued.
	void flush();
	/// Whether ENet can take some more without losing anything.
	bool has_room() const;

private:
	struct Batch;

	static void close(int &r_descriptor);

	int _outer = -1;
	int _inner = -1;
	int _enet = -1;
	bool _outer_v6 = false;
	bool _connected = false;
	uint16_t _enet_port = 0;
	std::unique_ptr<Batch> _reading;
	std::unique_ptr<Batch> _to_outer;
	std::unique_ptr<Batch> _to_inner;
};

} // namespace transport
