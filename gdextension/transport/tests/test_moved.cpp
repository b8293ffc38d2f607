// SPDX-License-Identifier: MIT
#include "check.hpp"
#include "wire.hpp"

#include <random>

/// A client that goes on from another address, and others who would like to.
namespace test_moved {

using namespace wire;

constexpr int64_t NAME = 9;

struct Session {
	Net net;
	Client client;
	uint32_t inner = 0;

	explicit Session(const std::string &p_password = "") :
			net(server_settings(p_password)), client(endpoint("192.0.2.1", 4000), client_settings(p_password)) {
		net.clients = { &client };
		net.run(SECOND / 10);
		inner = connect_enet(net, client);
		net.server.name(inner, NAME);
		net.record.inner.clear();
		net.record.fast.clear();
		client.fast.clear();
	}

	/// Whether messages arrive in both directions.
	bool is_alive() {
		const size_t here = net.record.fast.size();
		const size_t there = client.fast.size();
		client.relay.send_fast(ascii("\x05up"));
		net.exchange();
		net.server.send_fast(NAME,
				ascii("\x05"
					  "down"),
				net.record);
		net.exchange();
		return net.record.fast.size() == here + 1 && client.fast.size() == there + 1;
	}
};

TEST(a_client_goes_on_from_another_address_after_two_round_trips) {
	Session session;
	CHECK(session.is_alive());
	for (uint16_t i = 0; i < 50; i++) {
		session.net.now += SECOND / 10;
		session.client.at = i % 2 == 0 ? endpoint("198.51.100.7", uint16_t(5000 + i)) : endpoint("192.0.2.1", 4000);
		// The first round trip asks who it is, the second one answers.
		session.client.relay.send_fast(ascii("\x05lost"));
		session.net.exchange();
		CHECK(session.is_alive());
	}
	CHECK(session.net.server.counts().moved == 50 && session.net.server.links().confirmed() == 1);
	CHECK(session.client.relay.state() == ClientRelay::State::OPEN);
	// ENet has noticed nothing.
	session.client.relay.take_inner(enet_reliable(0, 1, 10));
	session.net.exchange();
	CHECK(session.net.record.inner.size() == 1 && session.net.record.inner.back().from == session.inner);
}

TEST(a_client_that_only_listens_finds_out_that_it_has_moved) {
	Session session;
	CHECK(session.is_alive());
	session.client.at = endpoint("198.51.100.7", 5000);
	session.net.run(SECOND / 4);
	CHECK(session.net.server.counts().moved == 1);
	// Nothing is to be said where the server is heard.
	session.net.run(SECOND);
	const uint64_t before = session.net.server.counts().opened;
	for (int i = 0; i < 50; i++) {
		session.net.server.send_fast(NAME, ascii("\x05!"), session.net.record);
		session.net.run(SECOND / 20);
	}
	CHECK(session.net.server.counts().opened <= before + 2);
}

TEST(nobody_else_takes_a_connection_with_him) {
	Session session("secret");
	std::vector<Bytes> seen;
	// Of a client that moves once somebody sees all that it sends.
	session.client.at = endpoint("192.0.2.1", 4001);
	for (int i = 0; i < 3; i++) {
		session.net.now += SECOND / 10;
		session.client.relay.send_fast(ascii("\x05hello"));
		for (; !session.client.out.empty(); session.client.out.pop_front()) {
			seen.push_back(session.client.out.front());
			session.net.server.take_outer(session.client.at, seen.back(), session.net.now, session.net.record);
		}
		for (; !session.net.record.outer.empty(); session.net.record.outer.pop_front()) {
			session.client.relay.take_outer(session.net.record.outer.front().bytes, session.net.now);
		}
	}
	CHECK(session.net.server.counts().moved == 1);
	std::mt19937 random(3);
	const Endpoint thief = endpoint("203.0.113.5", 666);
	for (int i = 0; i < 20000; i++) {
		Bytes bytes = seen[random() % seen.size()];
		if (i % 2 == 1) {
			bytes[random() % bytes.size()] ^= uint8_t(1 + random() % 255);
		}
		session.net.server.take_outer(thief, bytes, session.net.now, session.net.record);
		for (; !session.net.record.outer.empty(); session.net.record.outer.pop_front()) {
			CHECK(!SealedChannel::is_sealed(View(session.net.record.outer.front().bytes)));
			// His own cookie before what he has seen.
			messages::UnknownMessage unknown;
			if (unknown.decode(session.net.record.outer.front().bytes)) {
				for (Bytes moved : seen) {
					if (moved[0] == messages::MOVED) {
						std::copy(unknown.cookie.begin(), unknown.cookie.end(), moved.begin() + 9);
						session.net.server.take_outer(thief, moved, session.net.now, session.net.record);
					}
				}
			}
		}
		session.net.now += 1000;
	}
	CHECK(session.net.server.counts().moved == 1);
	CHECK(session.is_alive());
}

TEST(whoever_says_that_a_client_is_unknown_changes_nothing) {
	Session session;
	std::mt19937 random(8);
	size_t said = 0;
	for (int i = 0; i < 10000; i++) {
		session.client.relay.send_fast(ascii("\x05hello"));
		messages::UnknownMessage forged;
		forged.echo = messages::echo_of(session.client.out.back());
		forged.cookie[0] = uint8_t(random());
		session.net.exchange();
		session.client.relay.take_outer(forged.encode(), session.net.now);
		said += session.client.out.size();
		session.net.exchange();
		session.net.now += 1000;
	}
	// Nor does it make the client loud.
	CHECK(said > 0 && said <= 1001);
	CHECK(session.net.server.counts().moved == 0 && session.is_alive());
}

TEST(nobody_lets_a_client_speak_for_an_address_of_his_own) {
	for (const bool hears : { false, true }) {
		Session session;
		const Endpoint thief = endpoint("203.0.113.5", 666);
		// A cookie of the thief's own, for a datagram of no sense.
		session.net.server.take_outer(thief, Bytes(30, 0xC1), session.net.now, session.net.record);
		messages::UnknownMessage own;
		CHECK(own.decode(session.net.record.outer.front().bytes));
		session.net.record.outer.clear();
		session.net.now += SECOND / 10;
		if (hears) {
			CHECK(session.is_alive());
		}
		session.client.relay.send_fast(ascii("\x05hello"));
		own.echo = messages::echo_of(session.client.out.back());
		session.net.exchange();
		session.client.relay.take_outer(own.encode(), session.net.now);
		// Whoever hears his server says nothing of the kind.
		CHECK(session.client.out.empty() == hears);
		if (!hears) {
			const Bytes moved = session.client.out.front();
			session.net.exchange();
			session.net.server.take_outer(thief, moved, session.net.now, session.net.record);
		}
		CHECK(session.net.server.counts().moved == 0 && session.is_alive());
	}
}

TEST(few_strangers_are_answered_and_never_with_more_than_they_sent) {
	Session session;
	std::mt19937 random(5);
	size_t answers = 0;
	for (int i = 0; i < 30000; i++, session.net.now += 100) {
		Bytes bytes(SealedChannel::OVERHEAD + random() % 40);
		for (uint8_t &byte : bytes) {
			byte = uint8_t(random());
		}
		bytes[0] |= 0x80;
		session.net.server.take_outer(
				endpoint("203.0.113.5", uint16_t(1 + i)), bytes, session.net.now, session.net.record);
		for (; !session.net.record.outer.empty(); session.net.record.outer.pop_front()) {
			CHECK(session.net.record.outer.front().bytes.size() <= bytes.size());
			answers++;
		}
	}
	CHECK(answers > 100 && answers < 1000);
	CHECK(session.is_alive());
}

TEST(a_client_that_is_silent_is_given_up_and_not_for_a_server_that_stood_still) {
	Session session;
	session.net.clients = {};
	session.net.run(5 * SECOND);
	CHECK(session.net.server.links().confirmed() == 1);
	session.net.now += 20 * SECOND;
	session.net.server.look_after(session.net.now, session.net.record);
	CHECK(session.net.server.links().confirmed() == 1);
	session.net.run(2 * SECOND);
	CHECK(session.net.server.links().confirmed() == 0);
}

TEST(a_server_is_known_again_by_its_key) {
	const ServerIdentity::Seed seed{ { 1, 2, 3 } };
	ServerRelay::Settings own = server_settings();
	own.identity = ServerIdentity(seed);
	ClientRelay::Settings settings = client_settings();
	settings.known_key = own.identity.key();
	{
		Net net(own);
		Client client(endpoint("192.0.2.1", 4000), settings);
		net.clients = { &client };
		net.run(SECOND / 10);
		CHECK(client.relay.heard_usec() > 0 && client.relay.server_key() == own.identity.key());
	}
	for (const bool was_here : { false, true }) {
		Net impostor(server_settings());
		settings.return_tag[0] = was_here ? 1 : 0;
		Client client(endpoint("192.0.2.1", 4000), settings);
		client.relay.take_inner(enet_connect());
		impostor.clients = { &client };
		impostor.run(SECOND / 5);
		CHECK(client.relay.heard_usec() == 0 && client.relay.state() != ClientRelay::State::FAILED);
		impostor.run(10 * SECOND);
		CHECK(client.relay.state() == ClientRelay::State::FAILED);
		CHECK(client.relay.notice() == ClientRelay::OTHER_KEY);
		CHECK(client.relay.server_key() != own.identity.key() && client.inner.empty());
	}
	// Who has the password has proved enough.
	ServerRelay::Settings locked = server_settings("secret");
	ClientRelay::Settings knows = client_settings("secret");
	knows.known_key = own.identity.key();
	Net net(locked);
	Client client(endpoint("192.0.2.1", 4000), knows);
	net.clients = { &client };
	net.run(SECOND / 10);
	CHECK(client.relay.heard_usec() > 0 && client.relay.server_key() == locked.identity.key());
}

TEST(a_proof_of_identity_is_of_one_connection_and_one_key) {
	const ServerIdentity identity;
	Key exporter{};
	ServerIdentity::Proof proof = identity.prove(exporter);
	ServerIdentity::Proof read;
	CHECK(read.decode(proof.encode()) && read.is_of(exporter) && read.key == identity.key());
	exporter[5] = 1;
	CHECK(!proof.is_of(exporter));
	exporter[5] = 0;
	const Bytes good = proof.encode();
	for (size_t bit = 0; bit < good.size() * 8; bit++) {
		Bytes bad = good;
		bad[bit / 8] ^= uint8_t(1 << bit % 8);
		CHECK(read.decode(bad) && !read.is_of(exporter));
	}
	CHECK(!read.decode(View(good.data(), good.size() - 1)));
}

} // namespace test_moved
