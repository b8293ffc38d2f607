// SPDX-License-Identifier: MIT
#include "check.hpp"
#include "wire.hpp"

#include <sodium.h>

/// What somebody can do to a client who sees its handshake and forges what nobody has signed.
namespace test_handshake_forged {

using namespace wire;
using messages::Notice;

using Forge = std::function<void(Client &, int64_t)>;

/// The client's number, as everybody on its network sees it.
messages::ClientId seen_of(const Bytes &p_sent) {
	messages::Init init;
	messages::Start start;
	if (init.decode(View(p_sent))) {
		return init.client;
	}
	return start.decode(View(p_sent)) ? start.client : read_array<8>(p_sent.data() + 1);
}

/// How long a client needs while all that it sends is answered by a forger first, us; 20 s: for ever.
int64_t join(Net &r_net, Client &r_client, const std::function<void(const messages::ClientId &)> &p_forge) {
	const int64_t begin = r_net.now;
	while (r_net.now < begin + 20 * SECOND) {
		r_client.relay.look_after(r_net.now);
		if (r_client.relay.heard_usec() > 0 || r_client.relay.state() == ClientRelay::State::FAILED) {
			break;
		}
		while (!r_client.out.empty()) {
			const Bytes bytes = r_client.out.front();
			r_client.out.pop_front();
			p_forge(seen_of(bytes));
			r_net.server.take_outer(r_client.at, bytes, r_net.now, r_net.record);
			for (; !r_net.record.outer.empty(); r_net.record.outer.pop_front()) {
				r_client.relay.take_outer(r_net.record.outer.front().bytes, r_net.now);
			}
		}
		r_net.now += 5000;
	}
	return r_net.now - begin;
}

Bytes notice(const messages::ClientId &p_client, Notice p_what) {
	messages::NoticeMessage made;
	made.client = p_client;
	made.what = p_what;
	made.version = 77;
	return made.encode();
}

TEST(no_forged_notice_ends_or_delays_a_handshake) {
	for (const std::string password : { "", "secret" }) {
		for (int kind = 1; kind <= 5; kind++) {
			Net net(server_settings(password));
			Client client(endpoint("192.0.2.1", 4000), client_settings(password));
			const auto forge = [&](const messages::ClientId &p_client) {
				for (int i = 0; i < 3; i++) {
					client.relay.take_outer(notice(p_client, Notice(kind)), net.now);
				}
			};
			CHECK(join(net, client, forge) < SECOND);
			CHECK(is_open(client) && client.relay.notice() == 0 && net.server.links().half_open() == 1);
			// Nor one that comes when the channel is open.
			forge(seen_of(notice({}, Notice::LATER)));
			CHECK(is_open(client));
		}
	}
}

TEST(a_forged_reply_does_not_take_the_place_of_the_true_one) {
	Net net(server_settings("secret"));
	Client client(endpoint("192.0.2.1", 4000), client_settings("secret"));
	const auto forge = [&](const messages::ClientId &p_client) {
		messages::Reply reply;
		reply.client = p_client;
		reply.share =
				*cpace::share_of(cpace::sample_scalar(), cpace::generator({ ascii("x"), ascii("y"), ascii("z") }));
		client.relay.take_outer(reply.encode(), net.now);
	};
	client.relay.take_inner(enet_connect());
	CHECK(join(net, client, forge) < SECOND / 2);
	CHECK(is_open(client) && net.server.links().half_open() == 1);
}

TEST(an_impostor_learns_of_few_guesses_of_a_clients_password) {
	Net net(server_settings("secret"));
	ClientRelay::Settings settings = client_settings("secret");
	settings.return_tag.fill(7);
	Client client(endpoint("192.0.2.1", 4000), settings);
	size_t proofs = 0;
	for (const int64_t end = net.now + 30 * SECOND; net.now < end; net.now += 10000) {
		client.relay.look_after(net.now);
		for (; !client.out.empty(); client.out.pop_front()) {
			const Bytes &bytes = client.out.front();
			const messages::ClientId id = seen_of(bytes);
			if (bytes[0] == messages::INIT) {
				messages::CookieReply cookie;
				cookie.client = id;
				client.relay.take_outer(cookie.encode(), net.now);
				continue;
			}
			const size_t before = client.out.size();
			messages::Reply reply;
			reply.client = id;
			reply.share = cpace::share_of(
					cpace::sample_scalar(), cpace::generator({ ascii("guess"), ascii("y"), ascii("z") }))
								  .value_or(cpace::Share());
			client.relay.take_outer(reply.encode(), net.now);
			// A reply that is taken is answered at once.
			proofs += client.out.size() > before ? 1 : 0;
		}
	}
	CHECK(proofs >= 6 && proofs <= 6 + 15);
}

TEST(a_forged_cookie_is_tried_and_left_again) {
	Net net(server_settings("secret"));
	Client client(endpoint("192.0.2.1", 4000), client_settings("secret"));
	bool is_first = true;
	const auto forge = [&](const messages::ClientId &p_client) {
		for (int i = 0; is_first && i < 2; i++) {
			messages::CookieReply reply;
			reply.client = p_client;
			randombytes_buf(reply.cookie.data(), reply.cookie.size());
			client.relay.take_outer(reply.encode(), net.now);
		}
		is_first = false;
	};
	CHECK(join(net, client, forge) < SECOND);
	CHECK(is_open(client) && client.relay.is_locked());
}

TEST(who_has_a_password_opens_nothing_with_a_server_that_asks_for_none) {
	Net impostor(server_settings(""));
	Client client(endpoint("192.0.2.1", 4000), client_settings("secret"));
	client.relay.take_inner(enet_connect());
	impostor.clients = { &client };
	impostor.run(10 * SECOND);
	CHECK(impostor.server.links().half_open() == 0 && impostor.record.inner.empty());
	CHECK(client.relay.state() == ClientRelay::State::FAILED);
	CHECK(client.relay.notice() == ClientRelay::ASKS_FOR_NO_PASSWORD);
}

TEST(a_cookie_that_says_that_no_password_is_needed_lowers_nothing) {
	Net net(server_settings("secret"));
	Client client(endpoint("192.0.2.1", 4000), client_settings("secret"));
	net.clients = { &client };
	client.relay.look_after(net.now);
	net.server.take_outer(client.at, client.out.front(), net.now, net.record);
	client.out.clear();
	messages::CookieReply reply;
	CHECK(reply.decode(View(net.record.outer.front().bytes)) && reply.locked);
	net.record.outer.clear();
	reply.locked = false;
	client.relay.take_outer(reply.encode(), net.now);
	net.run(SECOND / 5);
	CHECK(is_open(client) && client.relay.is_locked() && net.server.links().half_open() == 1);
}

TEST(who_was_in_a_session_never_gives_up) {
	Net net(server_settings("secret"));
	ClientRelay::Settings settings = client_settings("secret");
	settings.return_tag.fill(7);
	Client client(endpoint("192.0.2.1", 4000), settings);
	for (int64_t end = net.now + 60 * SECOND; net.now < end; net.now += 50000) {
		client.relay.look_after(net.now);
		while (!client.out.empty()) {
			const Bytes bytes = client.out.front();
			client.out.pop_front();
			client.relay.take_outer(notice(seen_of(bytes), Notice::WRONG_PASSWORD), net.now);
		}
	}
	CHECK(client.relay.state() != ClientRelay::State::FAILED);
	CHECK(join(net, client, [](const messages::ClientId &) {}) < 3 * SECOND);
	CHECK(is_open(client));
}

TEST(a_proof_that_somebody_forged_does_not_take_the_place_of_the_true_one) {
	Net net(server_settings("secret"));
	Client client(endpoint("192.0.2.1", 4000), client_settings("secret"));
	const auto forge = [&](const messages::ClientId &p_client) {
		for (int i = 0; i < 5; i++) {
			Bytes first = messages::first_head(p_client);
			first.resize(60, uint8_t(i));
			net.server.take_outer(client.at, first, net.now, net.record);
		}
	};
	CHECK(join(net, client, forge) < SECOND);
	CHECK(is_open(client) && net.server.counts().wrong_passwords <= 1);
}

} // namespace test_handshake_forged
