// SPDX-License-Identifier: MIT
#include "check.hpp"
#include "wire.hpp"

#include <random>

namespace test_handshake {

using namespace wire;
using messages::Notice;

TEST(two_round_trips_open_a_channel_in_both_directions) {
	for (const std::string password : { "", "open sesame" }) {
		Net net(server_settings(password));
		Client client(endpoint("192.0.2.1", 4000), client_settings(password));
		net.clients = { &client };
		client.relay.look_after(net.now);
		CHECK(client.out.size() == 1 && client.out.front().size() == messages::INIT_SIZE);
		net.exchange();
		CHECK(is_open(client) && client.relay.is_locked() == !password.empty());
		client.relay.take_inner(enet_connect());
		net.exchange();
		CHECK(net.record.inner.size() == 1 && equal(net.record.inner.front().bytes, enet_connect()));
		const uint32_t inner = net.record.inner.front().from;
		ServerRelay::Client found;
		CHECK(net.server.find(inner, found) && found.role == 1 && found.outer == client.at);
		CHECK(found.exporter == client.relay.keys().exporter);
		net.server.take_inner(inner, ascii("hello"), net.now, net.record);
		CHECK(net.record.outer.front().bytes.size() == 5 + SealedChannel::OVERHEAD);
		net.exchange();
		CHECK(client.inner.size() == 1 && equal(client.inner.front(), ascii("hello")));
		CHECK(client.relay.notice() == 0 && net.server.pending() == 0);
	}
}

TEST(the_handshake_bears_loss_and_repetition) {
	std::mt19937 random(3);
	for (int round = 0; round < 50; round++) {
		Net net(server_settings("password"));
		Client client(endpoint("192.0.2.1", 4000), client_settings("password"));
		for (int i = 0; i < 500 && net.server.links().half_open() == 0; i++, net.now += 10000) {
			client.relay.look_after(net.now);
			for (; !client.out.empty(); client.out.pop_front()) {
				for (unsigned copies = random() % 3; copies > 0; copies--) {
					net.server.take_outer(client.at, client.out.front(), net.now, net.record);
				}
			}
			for (; !net.record.outer.empty(); net.record.outer.pop_front()) {
				for (unsigned copies = random() % 3; copies > 0; copies--) {
					client.relay.take_outer(net.record.outer.front().bytes, net.now);
				}
			}
		}
		CHECK(net.server.links().half_open() == 1 && is_open(client));
	}
}

TEST(what_tells_a_client_that_it_has_the_key_is_sent_again_where_it_was_lost) {
	Net net(server_settings());
	Client client(endpoint("192.0.2.1", 4000), client_settings());
	net.clients = { &client };
	client.relay.look_after(net.now);
	for (int i = 0; i < 3; i++) {
		const Bytes question = client.out.front();
		client.out.clear();
		net.server.take_outer(client.at, question, net.now, net.record);
		if (i < 2) {
			client.relay.take_outer(net.record.outer.front().bytes, net.now);
		}
		net.record.outer.clear();
	}
	CHECK(net.server.links().half_open() == 1 && client.relay.look_after(net.now) != INT64_MAX);
	net.run(SECOND / 20);
	CHECK(client.relay.look_after(net.now) == INT64_MAX && net.server.links().half_open() == 1);
}

TEST(no_answer_is_longer_than_its_question) {
	Net net(server_settings("password"));
	Client client(endpoint("192.0.2.1", 4000), client_settings("password"));
	client.relay.look_after(net.now);
	for (int i = 0; i < 3; i++) {
		const Bytes question = client.out.front();
		client.out.clear();
		net.server.take_outer(client.at, question, net.now, net.record);
		CHECK(net.record.outer.size() == 1 && net.record.outer.front().bytes.size() <= question.size());
		client.relay.take_outer(net.record.outer.front().bytes, net.now);
		net.record.outer.clear();
	}
	net.server.take_outer(endpoint("192.0.2.2", 1), enet_connect(), net.now, net.record);
	CHECK(net.record.outer.size() == 1 && net.record.outer.front().bytes.size() < enet_connect().size());
}

TEST(nothing_is_kept_before_a_valid_cookie) {
	Net net(server_settings());
	Client client(endpoint("192.0.2.1", 4000), client_settings());
	client.relay.look_after(net.now);
	net.server.take_outer(client.at, client.out.front(), net.now, net.record);
	client.out.clear();
	client.relay.take_outer(net.record.outer.front().bytes, net.now);
	const Bytes start = client.out.front();
	CHECK(net.server.pending() == 0);
	net.server.take_outer(endpoint("192.0.2.1", 4001), start, net.now, net.record);
	net.server.take_outer(endpoint("192.0.2.2", 4000), start, net.now, net.record);
	net.server.take_outer(client.at, start, net.now + 3 * CookieJar::PERIOD_USEC, net.record);
	for (size_t i = 1; i < 30; i++) {
		Bytes altered = start;
		altered[i] ^= 1;
		net.server.take_outer(client.at, altered, net.now, net.record);
	}
	CHECK(net.server.pending() == 0 && net.server.counts().bad_cookies == 32);
	net.server.take_outer(client.at, start, net.now + CookieJar::PERIOD_USEC, net.record);
	CHECK(net.server.pending() == 1);
}

TEST(a_wrong_password_is_said_counted_and_believed_in_the_end) {
	Net net(server_settings("right"));
	Client client(endpoint("192.0.2.1", 4000), client_settings("wrong"));
	net.clients = { &client };
	net.run(SECOND / 5);
	CHECK(client.relay.notice() == int(Notice::WRONG_PASSWORD) && client.relay.state() != ClientRelay::State::FAILED);
	CHECK(net.server.counts().wrong_passwords == 1);
	net.run(5 * SECOND);
	CHECK(client.relay.state() == ClientRelay::State::FAILED);
	CHECK(client.relay.notice() == int(Notice::WRONG_PASSWORD));
	CHECK(net.server.counts().wrong_passwords == 3 && net.server.links().half_open() == 0);
	// Others are none the worse for it.
	Client other(endpoint("192.0.2.2", 4000), client_settings("right"));
	net.clients = { &other };
	net.run(SECOND / 5);
	CHECK(net.server.links().half_open() == 1);
}

TEST(many_with_the_password_join_from_one_address) {
	Net net(server_settings("right"));
	std::deque<Client> clients;
	for (uint16_t i = 0; i < 60; i++) {
		clients.emplace_back(endpoint("192.0.2.1", uint16_t(4000 + i)), client_settings("right"));
		net.clients.push_back(&clients.back());
	}
	net.run(3 * SECOND);
	CHECK(net.server.links().half_open() == 60);
}

TEST(who_was_here_returns_though_his_address_has_used_up_its_tries) {
	Net net(server_settings("right"));
	Client before(endpoint("192.0.2.1", 4000), client_settings("right"));
	net.clients = { &before };
	net.run(SECOND / 10);
	connect_enet(net, before);
	CHECK(net.server.links().confirmed() == 1);
	std::deque<Client> guessers;
	for (uint16_t i = 0; i < 6; i++) {
		guessers.emplace_back(endpoint("192.0.2.1", uint16_t(5000 + i)), client_settings("wrong"));
		net.clients = { &guessers.back() };
		net.run(SECOND / 10);
	}
	ClientRelay::Settings settings = client_settings("right");
	settings.return_tag = before.relay.keys().return_tag;
	Client back(endpoint("192.0.2.1", 4001), settings);
	Client thief(endpoint("192.0.2.1", 4002), settings);
	for (Client *client : { &back, &thief }) {
		net.clients = { client };
		net.run(SECOND / 10);
	}
	CHECK(is_open(back) && back.relay.notice() == 0);
	CHECK(!is_open(thief) && thief.relay.notice() == int(Notice::LATER));
}

TEST(ends_that_do_not_fit_are_told_so) {
	const Endpoint at = endpoint("192.0.2.1", 4000);
	{
		Net net(server_settings());
		ClientRelay::Settings settings = client_settings();
		settings.version = 6;
		Client client(at, settings);
		net.clients = { &client };
		net.run(SECOND / 10);
		CHECK(client.relay.notice() == int(Notice::OTHER_VERSION) && client.relay.server_version() == 5);
	}
	{
		Net net(server_settings("", false));
		Client client(at, client_settings());
		net.clients = { &client };
		net.run(SECOND / 10);
		CHECK(client.relay.notice() == int(Notice::SERVER_IS_OPEN));
		CHECK(client.relay.state() == ClientRelay::State::OPENING);
		net.run(5 * SECOND);
		CHECK(client.relay.state() == ClientRelay::State::FAILED);
	}
	{
		Net net(server_settings());
		Client client(at, client_settings("", false));
		net.clients = { &client };
		for (int i = 0; i < 6; i++) {
			CHECK(client.relay.state() == ClientRelay::State::OPEN);
			client.relay.take_inner(enet_connect());
			net.exchange();
			CHECK(client.relay.notice() == int(Notice::SERVER_SEALS));
			net.now += SECOND / 2;
		}
		CHECK(client.relay.state() == ClientRelay::State::FAILED);
	}
}

TEST(nobody_who_is_blind_can_forge_a_notice) {
	Net net(server_settings());
	Client client(endpoint("192.0.2.1", 4000), client_settings());
	client.relay.look_after(net.now);
	messages::NoticeMessage notice;
	notice.what = Notice::WRONG_PASSWORD;
	std::mt19937_64 random(5);
	for (int i = 0; i < 10000; i++) {
		const uint64_t guess = random();
		std::memcpy(notice.client.data(), &guess, 8);
		client.relay.take_outer(notice.encode(), net.now);
	}
	CHECK(client.relay.notice() == 0 && client.relay.state() == ClientRelay::State::OPENING);
	net.clients = { &client };
	net.run(SECOND / 10);
	CHECK(is_open(client));
}

TEST(a_role_of_another_password_is_another_channel) {
	ServerRelay::Settings settings = server_settings("trainees");
	settings.passwords[2] = ascii("instructors");
	Net net(settings);
	ClientRelay::Settings wanted = client_settings("trainees");
	wanted.role = 2;
	Client client(endpoint("192.0.2.1", 4000), wanted);
	net.clients = { &client };
	net.run(SECOND / 2);
	CHECK(client.relay.notice() == int(Notice::WRONG_PASSWORD));
}

} // namespace test_handshake
