// SPDX-License-Identifier: MIT
#include "check.hpp"
#include "hex.hpp"
#include "relay/relay_socket.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace test_relay_socket {

using namespace transport;

namespace {

/// A bound UDP socket on loopback.
class Port {
public:
	explicit Port(const char *p_address = "127.0.0.1", uint16_t p_port = 0) {
		sockaddr_in at = address(p_address, p_port);
		bound = bind(descriptor, reinterpret_cast<const sockaddr *>(&at), sizeof(at)) == 0;
	}
	~Port() { close(descriptor); }
	Port(const Port &) = delete;
	Port &operator=(const Port &) = delete;

	static sockaddr_in address(const char *p_address, uint16_t p_port) {
		sockaddr_in at{};
		at.sin_family = AF_INET;
		at.sin_port = htons(p_port);
		inet_pton(AF_INET, p_address, &at.sin_addr);
		return at;
	}
	uint16_t number() const {
		sockaddr_in at{};
		socklen_t size = sizeof(at);
		getsockname(descriptor, reinterpret_cast<sockaddr *>(&at), &size);
		return ntohs(at.sin_port);
	}
	void send(const char *p_address, uint16_t p_port, const Bytes &p_bytes) const {
		const sockaddr_in to = address(p_address, p_port);
		sendto(descriptor, p_bytes.data(), p_bytes.size(), 0, reinterpret_cast<const sockaddr *>(&to), sizeof(to));
	}
	/// What has come, and from where; nothing after a while.
	Bytes receive(sockaddr_in &r_from, int p_wait_ms = 5000) const {
		pollfd watched{ descriptor, POLLIN, 0 };
		if (poll(&watched, 1, p_wait_ms) <= 0) {
			return {};
		}
		Bytes bytes(5000);
		socklen_t size = sizeof(r_from);
		const ssize_t count =
				recvfrom(descriptor, bytes.data(), bytes.size(), 0, reinterpret_cast<sockaddr *>(&r_from), &size);
		bytes.resize(count > 0 ? size_t(count) : 0);
		return bytes;
	}

	int descriptor = socket(AF_INET, SOCK_DGRAM, 0);
	bool bound = false;
};

struct Taken {
	std::vector<Endpoint> from;
	std::vector<uint32_t> to;
	std::vector<Bytes> bytes;
};

void read_outer(RelaySocket &r_socket, Taken &r_taken) {
	pollfd watched{ r_socket.outer(), POLLIN, 0 };
	poll(&watched, 1, 5000);
	r_socket.read_outer(1000, [&r_taken](const Endpoint &p_from, const View &p_bytes) {
		r_taken.from.push_back(p_from);
		r_taken.bytes.emplace_back(p_bytes.data, p_bytes.data + p_bytes.size);
	});
}

size_t read_inner(RelaySocket &r_socket, Taken &r_taken) {
	return r_socket.read_inner([&r_taken](uint32_t p_to, const View &p_bytes) {
		r_taken.to.push_back(p_to);
		r_taken.bytes.emplace_back(p_bytes.data, p_bytes.data + p_bytes.size);
	});
}

} // namespace

TEST(addresses_are_read_and_written) {
	Endpoint at;
	for (const char *text : { "192.0.2.77", "2001:db8::1", "::1" }) {
		CHECK(at.parse(text, 7) && at.address_text() == text && at.port == 7);
	}
	CHECK(at.parse("::ffff:10.1.2.3", 1) && at.address_text() == "10.1.2.3");
	CHECK(!at.parse("localhost", 1) && !at.parse("", 1));
	CHECK(at.parse("fe80::1%lo", 1) && at.scope > 0 && at.address_text() == "fe80::1%lo");
	CHECK(at.parse("fe80::1%1", 1) && at.scope == 1);
	CHECK(!at.parse("fe80::1%", 1) && !at.parse("fe80::1%no such link", 1) && !at.parse("127.0.0.1%lo", 1));
	Endpoint one;
	Endpoint other;
	one.parse("2001:db8::1", 1);
	other.parse("2001:db8::2:3:4", 9);
	CHECK(network_of(one) == network_of(other));
	one.parse("192.0.2.1", 1);
	other.parse("192.0.2.2", 1);
	CHECK(network_of(one) != network_of(other));
}

TEST(datagrams_go_through_both_sockets) {
	const Port enet;
	const Port client("127.0.0.3");
	RelaySocket relay;
	CHECK(relay.open_server("*", 0) == 0 && relay.tie(enet.descriptor, enet.number()));
	for (uint8_t i = 0; i < 200; i++) {
		client.send("127.0.0.1", relay.outer_port(), Bytes(i + 1U, i));
	}
	Taken taken;
	while (taken.bytes.size() < 200) {
		const size_t before = taken.bytes.size();
		read_outer(relay, taken);
		if (taken.bytes.size() == before) {
			break;
		}
	}
	CHECK(taken.bytes.size() == 200 && taken.bytes[199].size() == 200);
	CHECK(taken.from[0].address_text() == "127.0.0.3" && taken.from[0].port == client.number());
	relay.write_outer(taken.from[0], hex("0102"));
	relay.write_inner(0x7F0B0C0D, hex("0304"));
	relay.flush();
	sockaddr_in from{};
	CHECK(equal(client.receive(from), hex("0102")) && ntohs(from.sin_port) == relay.outer_port());
	CHECK(equal(enet.receive(from), hex("0304")));
	CHECK(ntohl(from.sin_addr.s_addr) == 0x7F0B0C0D && ntohs(from.sin_port) == relay.inner_port());
	enet.send("127.11.12.14", relay.inner_port(), hex("05"));
	Taken inner;
	CHECK(read_inner(relay, inner) == 1 && inner.to[0] == 0x7F0B0C0E && equal(inner.bytes[0], hex("05")));
	CHECK(relay.has_room());
}

TEST(nobody_else_can_speak_to_either_end_of_the_inner_way) {
	const Port enet;
	RelaySocket relay;
	CHECK(relay.open_server("127.0.0.1", 0) == 0 && relay.tie(enet.descriptor, enet.number()));
	const Port stranger("127.0.0.9");
	stranger.send("127.0.0.1", enet.number(), hex("66"));
	stranger.send("127.0.0.1", relay.inner_port(), hex("66"));
	stranger.send("127.1.0.1", relay.inner_port(), hex("66"));
	const Port twin("127.0.0.2", enet.number());
	CHECK(twin.bound);
	twin.send("127.1.0.1", relay.inner_port(), hex("66"));
	// Nobody can have the relay's own port, at any address.
	const Port thief("127.0.0.5", relay.inner_port());
	CHECK(!thief.bound);
	sockaddr_in from{};
	CHECK(enet.receive(from, 50).empty());
	Taken inner;
	CHECK(read_inner(relay, inner) == 0);
	relay.write_inner(0x7F010001, hex("07"));
	relay.flush();
	CHECK(equal(enet.receive(from), hex("07")));
}

TEST(a_port_in_use_is_an_error_and_a_client_hears_only_its_server) {
	RelaySocket relay;
	CHECK(relay.open_server("127.0.0.1", 0) == 0);
	RelaySocket second;
	CHECK(second.open_server("127.0.0.1", relay.outer_port()) == EADDRINUSE);
	CHECK(second.open_server("no address", 0) == EINVAL);
	const Port server;
	const Port stranger;
	Endpoint at;
	at.parse("127.0.0.1", server.number());
	RelaySocket client;
	CHECK(client.open_client(at) == 0);
	client.write_outer(at, hex("01"));
	client.flush();
	sockaddr_in from{};
	CHECK(equal(server.receive(from), hex("01")));
	stranger.send("127.0.0.1", client.outer_port(), hex("66"));
	server.send("127.0.0.1", client.outer_port(), hex("02"));
	Taken taken;
	read_outer(client, taken);
	CHECK(taken.bytes.size() == 1 && equal(taken.bytes[0], hex("02")));
}

} // namespace test_relay_socket
