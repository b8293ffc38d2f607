// SPDX-License-Identifier: MIT
#pragma once

#include "../discovery/answering_machine.hpp"
#include "../sealing/server_identity.hpp"
#include "link_table.hpp"
#include "server_handshake.hpp"

namespace transport {

/// A server's end between the network, ENet and what goes beside ENet: opens and seals datagrams after a
/// ServerHandshake, and lets nothing through to ENet that ENet cannot bear. Works on bytes; sockets are RelaySocket's.
class ServerRelay {
public:
	struct Settings {
		bool seals = true;
		uint32_t version = 0;
		ServerHandshake::Passwords passwords;
		ServerIdentity identity;
		EnetLimits limits;
		/// Clients that ENet has a connection with.
		size_t max_confirmed = 3000;
	};

	/// What the rest of the program knows of a client.
	struct Client {
		Endpoint outer;
		uint8_t role = 0;
		Key exporter{};
	};

	explicit ServerRelay(Settings p_settings);
	// The handshake counts in it.
	ServerRelay(const ServerRelay &) = delete;
	ServerRelay &operator=(const ServerRelay &) = delete;

	/// Other passwords, for those who come from now on.
	void set_passwords(const ServerHandshake::Passwords &p_passwords) { _handshake.set_passwords(p_passwords); }
	/// What clients that look for servers are told; nothing: they are not answered. False if it is too long.
	bool set_announcement(const View &p_body) { return _answering.set_body(p_body); }
	/// A datagram has come from the network.
	void take_outer(const Endpoint &p_from, const View &p_bytes, int64_t p_now_usec, RelaySink &r_sink);
	/// ENet has sent a datagram to one of its clients.
	void take_inner(uint32_t p_to, const View &p_bytes, int64_t p_now_usec, RelaySink &r_sink);
	/// The client that stands behind a loopback address is known to the rest of the program by p_peer.
	void name(uint32_t p_inner, int64_t p_peer);
	/// Sends a message beside ENet to one that has a name; others get none.
	void send_fast(int64_t p_peer, const View &p_bytes, RelaySink &r_sink);
	/// Ends what has waited too long. Call it a few times a second.
	void look_after(int64_t p_now_usec, RelaySink &r_sink);
	/// A client by the loopback address that stands for it; false if there is none.
	bool find(uint32_t p_inner, Client &r_client);
	/// A client was admitted: it may make ENet hold more back.
	void admit(uint32_t p_inner);

	const ServerHandshake::Refusal &last_refusal() const { return _handshake.last_refusal(); }
	const RelayCounts &counts() const { return _counts; }
	const LinkTable &links() const { return _links; }
	size_t pending() const { return _handshake.pending(); }

private:
	void take_first(const Endpoint &p_from, const View &p_bytes, int64_t p_now_usec, RelaySink &r_sink);
	void establish(const Pending &p_pending, int64_t p_now_usec, RelaySink &r_sink);
	void prove(Link &r_link, RelaySink &r_sink);
	void take_moved(const Endpoint &p_from, const View &p_bytes, int64_t p_now_usec, RelaySink &r_sink);
	void take_sealed(const Endpoint &p_from, const View &p_bytes, int64_t p_now_usec, RelaySink &r_sink);
	void take_content(Link &r_link, Content p_content, size_t p_size, int64_t p_now_usec, RelaySink &r_sink);
	void take_open(const Endpoint &p_from, const View &p_bytes, int64_t p_now_usec, RelaySink &r_sink);
	bool refuse_open(const Endpoint &p_from, const View &p_bytes, RelaySink &r_sink);
	void hand_in(Link &r_link, const View &p_bytes, int64_t p_now_usec, RelaySink &r_sink);
	void count(EnetGuard::Verdict p_verdict);
	Link *make_link(const Endpoint &p_from, int64_t p_now_usec, RelaySink &r_sink);
	void end(Link &r_link, int64_t p_now_usec, RelaySink &r_sink);
	Carriage::Send sender(Link &r_link, RelaySink &r_sink);
	void end_orphan(uint32_t p_to, const View &p_bytes, RelaySink &r_sink);

	Settings _settings;
	LinkTable _links;
	RelayCounts _counts;
	ServerHandshake _handshake;
	AnsweringMachine _answering;
	int64_t _looked_usec = 0;
	Bytes _opened;
	Bytes _sealed;
};

} // namespace transport
