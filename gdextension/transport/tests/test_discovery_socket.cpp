// SPDX-License-Identifier: MIT
#include "check.hpp"
#include "discovery/answering_machine.hpp"
#include "discovery/discovery_socket.hpp"
#include "relay/relay_socket.hpp"
#include "wire.hpp"

#include <poll.h>

/// Questions and answers over real sockets of this machine.
namespace test_discovery_socket {

using namespace wire;

/// A port that answers.
struct Server {
	RelaySocket socket;
	RelayCounts counts;
	AnsweringMachine machine{ counts };
	Record record;

	explicit Server(const std::string &p_says) {
		socket.open_server("127.0.0.1", 0);
		machine.set_body(ascii(p_says));
	}
	/// Answers the next question.
	void answer() {
		pollfd watched{ socket.outer(), POLLIN, 0 };
		poll(&watched, 1, 10000);
		socket.read_outer(64, [this](const Endpoint &p_from, const View &p_bytes) {
			machine.take(p_from, p_bytes, 1000000, record);
		});
		for (; !record.outer.empty(); record.outer.pop_front()) {
			socket.write_outer(record.outer.front().to, record.outer.front().bytes);
		}
		socket.flush();
	}
};

TEST(a_server_is_found_with_its_delay) {
	Server server("town");
	Server other("yard");
	DiscoverySocket socket;
	CHECK(socket.open());
	CHECK(socket.ask(endpoint("127.0.0.1", server.socket.outer_port()), false));
	CHECK(socket.ask(endpoint("127.0.0.1", other.socket.outer_port()), false));
	server.answer();
	other.answer();
	std::vector<std::pair<uint16_t, Bytes>> found;
	for (int i = 0; i < 100000 && found.size() < 2; i++) {
		socket.take(64, [&](const Endpoint &p_from, const View &p_body, int64_t p_delay_usec) {
			CHECK(p_delay_usec >= 0 && p_delay_usec < OpenQuestions::OPEN_USEC);
			CHECK(p_from.address_text() == "127.0.0.1");
			found.push_back({ p_from.port, Bytes(p_body.data, p_body.data + p_body.size) });
		});
	}
	CHECK(found.size() == 2);
	for (const auto &[port, body] : found) {
		CHECK(body == ascii(port == server.socket.outer_port() ? "town" : "yard"));
	}
}

TEST(nothing_can_be_asked_of_a_socket_that_is_closed) {
	DiscoverySocket socket;
	CHECK(!socket.ask(endpoint("127.0.0.1", 7777), false));
	CHECK(socket.take(64, [](const Endpoint &, const View &, int64_t) { CHECK(false); }) == 0);
	CHECK(socket.open() && socket.ask(endpoint("127.0.0.1", 9), false));
	socket.close();
	CHECK(!socket.ask(endpoint("127.0.0.1", 9), false));
}

TEST(neighbours_are_addresses_of_networks) {
	for (const Endpoint &neighbour : DiscoverySocket::neighbours()) {
		Endpoint read;
		CHECK(read.parse(neighbour.address_text(), 0) && read == neighbour);
		CHECK(neighbour.address_text() != "127.0.0.1");
	}
}

} // namespace test_discovery_socket
