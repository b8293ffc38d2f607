// SPDX-License-Identifier: MIT
#include "check.hpp"
#include "wire.hpp"

#include <functional>
#include <random>
#include <sodium.h>

/// Every kind of message that nobody has signed, at every state of both ends, from somebody who sees all
/// that both say: none ends a session, lowers what protects it, or asks anything of the user.
namespace test_every_kind {

using namespace wire;
using messages::Notice;

/// How far a session is when the forger begins.
enum Stage {
	NOTHING,
	COOKIE_SENT,
	REPLY_SENT,
	OPEN,
	CONNECTED,
	STAGES,
};

struct Scene {
	Net net;
	Client client;
	/// All that both ends have said.
	std::vector<Bytes> seen;
	std::mt19937 random{ 5 };

	explicit Scene(const std::string &p_password, bool p_seals = true) :
			net(server_settings(p_password, p_seals)),
			client(endpoint("192.0.2.1", 4000), client_settings(p_password, p_seals)) {}

	/// One way: what the client has said goes to the server.
	void up() {
		client.relay.look_after(net.now);
		for (; !client.out.empty(); client.out.pop_front()) {
			seen.push_back(client.out.front());
			net.server.take_outer(client.at, client.out.front(), net.now, net.record);
		}
	}
	void down() {
		for (; !net.record.outer.empty(); net.record.outer.pop_front()) {
			seen.push_back(net.record.outer.front().bytes);
			client.relay.take_outer(net.record.outer.front().bytes, net.now);
		}
	}
	void go_to(Stage p_stage) {
		for (int step = NOTHING; step < std::min<int>(p_stage, OPEN); step++) {
			up();
			down();
		}
		if (p_stage == CONNECTED) {
			net.clients = { &client };
			net.server.name(connect_enet(net, client), 3);
		}
	}
	messages::ClientId id() const { return read_array<8>(seen.front().data() + 10); }
	/// Whether messages get through in both directions, and ENet's do.
	bool is_alive() {
		net.clients = { &client };
		net.run(3 * SECOND);
		if (net.server.links().confirmed() == 0) {
			net.server.name(connect_enet(net, client), 3);
		}
		const size_t here = net.record.fast.size();
		const size_t there = client.fast.size();
		client.relay.send_fast(ascii("\x05up"));
		net.exchange();
		net.server.send_fast(3, ascii("\x05!"), net.record);
		net.exchange();
		return net.record.fast.size() == here + 1 && client.fast.size() == there + 1;
	}
};

cpace::Share random_share() {
	const cpace::Generator generator = cpace::generator({ ascii("a"), ascii("b"), ascii("c") });
	return cpace::share_of(cpace::sample_scalar(), generator).value_or(cpace::Share());
}

/// All that can be forged with what has been seen.
std::vector<Bytes> forged(Scene &r_scene) {
	std::vector<Bytes> made;
	const messages::ClientId id = r_scene.seen.empty() ? messages::ClientId{} : r_scene.id();
	for (const bool locked : { false, true }) {
		messages::CookieReply cookie;
		cookie.client = id;
		cookie.locked = locked;
		randombytes_buf(cookie.cookie.data(), cookie.cookie.size());
		made.push_back(cookie.encode());
	}
	messages::Reply reply;
	reply.client = id;
	reply.share = random_share();
	made.push_back(reply.encode());
	for (int what = int(Notice::WRONG_PASSWORD); what <= int(Notice::SERVER_SEALS); what++) {
		messages::NoticeMessage notice;
		notice.client = id;
		notice.what = Notice(what);
		notice.version = 99;
		made.push_back(notice.encode());
	}
	messages::UnknownMessage unknown;
	unknown.echo = r_scene.seen.empty() ? messages::Echo{} : messages::echo_of(r_scene.seen.back());
	made.push_back(unknown.encode());
	messages::Init init;
	init.client = id;
	for (const uint32_t version : { 5U, 6U }) {
		for (uint8_t role = 0; role < messages::ROLES; role++) {
			init.version = version;
			init.role = role;
			made.push_back(init.encode());
		}
	}
	messages::Start start;
	start.client = id;
	start.version = 5;
	start.share = reply.share;
	made.push_back(start.encode());
	for (Bytes head : { messages::first_head(id), messages::moved_head(id, {}), Bytes{ 0x80, 0 }, Bytes{ 0xC0, 1 },
				 Bytes{ messages::OPEN_FAST }, Bytes{ messages::OPEN_FAST, Carriage::PROBE, 9, 0 } }) {
		head.resize(head.size() + 40, 7);
		made.push_back(head);
	}
	made.push_back(enet_connect(8, 77));
	made.push_back(enet_verify(3, 1));
	const auto disconnect = make_enet_disconnect(7, 2);
	made.emplace_back(disconnect.begin(), disconnect.end());
	// What was true once.
	made.insert(made.end(), r_scene.seen.begin(), r_scene.seen.end());
	return made;
}

TEST(no_message_that_anybody_can_forge_moves_either_end) {
	for (const std::string password : { "", "secret" }) {
		for (int stage = NOTHING; stage < STAGES; stage++) {
			for (const bool to_server : { false, true }) {
				Scene counting(password);
				counting.go_to(Stage(stage));
				const size_t kinds = forged(counting).size();
				for (size_t kind = 0; kind < kinds; kind++) {
					Scene scene(password);
					scene.go_to(Stage(stage));
					const Bytes bytes = forged(scene)[kind];
					const Key keys = scene.client.relay.keys().exporter;
					for (int times = 0; times < 3; times++) {
						if (to_server) {
							scene.net.server.take_outer(scene.client.at, bytes, scene.net.now, scene.net.record);
						} else {
							scene.client.relay.take_outer(bytes, scene.net.now);
						}
						scene.net.now += 20000;
					}
					const bool holds = scene.is_alive() && scene.client.relay.notice() == 0 &&
							scene.client.relay.is_locked() == !password.empty() &&
							(stage < CONNECTED || scene.client.relay.keys().exporter == keys);
					if (!holds) {
						std::printf("stage %d, to the %s, kind %zu (%02X), password '%s'\n", stage,
								to_server ? "server" : "client", kind, bytes[0], password.c_str());
					}
					CHECK(holds);
				}
			}
		}
	}
}

} // namespace test_every_kind
