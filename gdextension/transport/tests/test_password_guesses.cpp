// SPDX-License-Identifier: MIT
#include "check.hpp"
#include "wire.hpp"

#include <random>

/// How many guesses of a password a server answers, whatever those do who guess.
namespace test_password_guesses {

using namespace wire;
using messages::Notice;

/// A way to guess: one guess from an endpoint, as far as the server lets it.
enum class Way {
	/// Another START from the same port follows a wrong proof.
	OTHER_SHARE,
	/// Another port each time.
	OTHER_PORT,
	/// START alone, then another.
	UNFINISHED,
};

/// Lets somebody guess once; several wrong proofs of one exchange are one guess.
void guess(Net &r_net, const Endpoint &p_from, int p_proofs) {
	Client guesser(p_from, client_settings("guess"));
	guesser.relay.look_after(r_net.now);
	for (int step = 0; step < 2 + p_proofs && !guesser.out.empty(); step++) {
		const Bytes question = guesser.out.front();
		guesser.out.clear();
		r_net.server.take_outer(p_from, question, r_net.now, r_net.record);
		for (; !r_net.record.outer.empty(); r_net.record.outer.pop_front()) {
			guesser.relay.take_outer(r_net.record.outer.front().bytes, r_net.now);
		}
	}
}

/// Begun key exchanges and wrong proofs, after guessing for so long from the addresses in turn.
struct Attack {
	Net net{ server_settings("right") };
	uint16_t port = 1000;

	void run(const std::vector<std::string> &p_addresses, int64_t p_usec, Way p_way, int p_a_tick = 5) {
		size_t next = 0;
		for (const int64_t end = net.now + p_usec; net.now < end; net.now += 10000) {
			for (int i = 0; i < p_a_tick; i++) {
				port = p_way == Way::OTHER_PORT ? uint16_t(1000 + (port + 1) % 60000) : port;
				guess(net, endpoint(p_addresses[next], port), p_way == Way::UNFINISHED ? 0 : 2);
				next = (next + 1) % p_addresses.size();
			}
			net.server.look_after(net.now, net.record);
		}
	}

	/// How long somebody with the password needs who comes now, while the attack goes on, us.
	int64_t join(const std::string &p_address, const std::vector<std::string> &p_addresses, Way p_way) {
		Client honest(endpoint(p_address, 400), client_settings("right"));
		const int64_t begin = net.now;
		while (net.server.links().half_open() == 0 && net.now < begin + 20 * SECOND) {
			honest.relay.look_after(net.now);
			net.clients = { &honest };
			net.exchange();
			run(p_addresses, 10000, p_way);
		}
		return net.now - begin;
	}

	uint64_t wrong() const { return net.server.counts().wrong_passwords; }
};

std::vector<std::string> many(const std::string &p_prefix, int p_count, uint64_t p_seed) {
	std::mt19937 random{ uint32_t(p_seed) };
	std::vector<std::string> made;
	for (int i = 0; i < p_count; i++) {
		char text[64];
		std::snprintf(
				text, sizeof(text), "%s:%x:%x::1", p_prefix.c_str(), unsigned(random() & 0xFFFF), unsigned(i + 1));
		made.emplace_back(text);
	}
	return made;
}

TEST(one_address_gets_one_guess_a_second_and_each_is_counted) {
	for (const Way way : { Way::OTHER_SHARE, Way::OTHER_PORT }) {
		Attack attack;
		attack.run({ "192.0.2.1" }, 30 * SECOND, way);
		CHECK(attack.wrong() >= 10 && attack.wrong() <= 30);
		// Each was begun once, and nothing was begun that was not counted.
		CHECK(attack.net.server.counts().handshakes == attack.wrong());
	}
	Attack attack;
	attack.run({ "192.0.2.1" }, 30 * SECOND, Way::UNFINISHED);
	CHECK(attack.net.server.counts().handshakes <= 30 && attack.wrong() == 0);
}

TEST(a_thousand_addresses_of_a_48_get_two_guesses_a_second) {
	Attack attack;
	std::vector<std::string> addresses;
	for (const std::string &each : many("2001:db8", 1000, 1)) {
		addresses.push_back("2001:db8:7:" + each.substr(each.rfind(':', each.rfind("::") - 1) + 1));
	}
	attack.run(addresses, 30 * SECOND, Way::OTHER_PORT);
	CHECK(attack.wrong() >= 30 && attack.wrong() <= 60);
	CHECK(attack.join("2001:db8:8::1", addresses, Way::OTHER_PORT) <= 2 * SECOND);
}

TEST(all_addresses_together_get_ten_guesses_a_second) {
	const std::vector<std::string> addresses = many("2001", 4000, 2);
	Attack attack;
	attack.run(addresses, 30 * SECOND, Way::OTHER_PORT);
	CHECK(attack.wrong() >= 100 && attack.wrong() <= 300);
}

TEST(guessers_everywhere_keep_nobody_out_for_two_seconds) {
	for (const std::string honest : { "192.0.2.1", "2a00:1450::1" }) {
		const std::vector<std::string> addresses = many("2001", 150, 3);
		Attack attack;
		attack.run(addresses, 30 * SECOND, Way::OTHER_PORT);
		CHECK(attack.join(honest, addresses, Way::OTHER_PORT) <= 2 * SECOND);
		// Nor does he get his try back for nothing.
		CHECK(attack.wrong() <= 320);
	}
}

TEST(who_knows_the_password_comes_as_often_as_he_likes) {
	Net net(server_settings("right"));
	for (uint16_t i = 0; i < 50; i++) {
		Client client(endpoint("192.0.2.1", uint16_t(4000 + i)), client_settings("right"));
		net.clients = { &client };
		net.run(SECOND / 20);
		CHECK(client.relay.heard_usec() > 0);
	}
	CHECK(net.server.counts().handshakes_later == 0);
}

} // namespace test_password_guesses
