// SPDX-License-Identifier: MIT
#include "check.hpp"
#include "wire.hpp"

#include <random>

namespace test_relay_hostile {

using namespace wire;

TEST(a_million_blind_replayed_and_altered_datagrams_change_nothing) {
	Net net(server_settings("password"));
	Client client(endpoint("192.0.2.1", 4000), client_settings("password"));
	net.clients = { &client };
	net.run(SECOND / 10);
	connect_enet(net, client);
	const uint32_t inner = net.record.inner.back().from;
	std::vector<Bytes> recorded;
	for (uint16_t i = 1; i <= 500; i++) {
		client.relay.take_inner(enet_reliable(0, i, 40));
		recorded.push_back(client.out.front());
		net.exchange();
		net.server.take_inner(inner, enet_acknowledge(0, 0, i), net.now, net.record);
		net.exchange();
	}
	const size_t before = net.record.inner.size();
	net.record.keeps = false;
	std::mt19937_64 random(9);
	Bytes bytes;
	for (int i = 0; i < 1000000; i++) {
		bytes = recorded[random() % recorded.size()];
		const bool from_client = i % 4 != 3;
		if (i % 3 == 1) {
			bytes[random() % bytes.size()] ^= uint8_t(1 + random() % 255);
		} else if (i % 3 == 2) {
			bytes.resize(random() % 128);
			for (uint8_t &byte : bytes) {
				byte = uint8_t(random());
			}
			if (!bytes.empty() && i % 2 == 0) {
				bytes[0] = uint8_t(0x41 + random() % 7);
			}
		}
		net.server.take_outer(from_client ? client.at : endpoint("192.0.2.9", uint16_t(i)), bytes, net.now, net.record);
	}
	net.record.keeps = true;
	CHECK(net.record.inner.size() == before);
	CHECK(net.server.links().confirmed() == 1 && net.server.links().half_open() == 0 && net.server.pending() == 0);
	client.relay.take_inner(ascii("\x80\x07zz\x05\xFF"
								  "aa"));
	net.exchange();
	CHECK(net.record.inner.size() == before + 1);
	net.server.take_inner(inner, ascii("still here"), net.now, net.record);
	net.exchange();
	CHECK(equal(client.inner.back(), ascii("still here")));
}

TEST(a_client_is_not_moved_by_replayed_and_altered_datagrams_either) {
	Net net(server_settings());
	Client client(endpoint("192.0.2.1", 4000), client_settings());
	net.clients = { &client };
	net.run(SECOND / 10);
	connect_enet(net, client);
	const uint32_t inner = net.record.inner.back().from;
	net.server.take_inner(inner, Bytes(60, 1), net.now, net.record);
	const Bytes good = net.record.outer.front().bytes;
	const size_t before = client.inner.size();
	net.exchange();
	std::mt19937 random(2);
	for (int i = 0; i < 100000; i++) {
		Bytes bytes = good;
		if (i % 2 == 1) {
			bytes[random() % bytes.size()] ^= uint8_t(1 + random() % 255);
		}
		client.relay.take_outer(bytes, net.now);
	}
	CHECK(client.inner.size() == before + 1 && is_open(client));
}

TEST(half_open_handshakes_of_its_own_address_keep_nobody_out_for_a_second) {
	Net net(server_settings());
	// Each attacker asks for a cookie, and begins; never more.
	std::deque<Client> attackers;
	Client honest(endpoint("192.0.2.1", 400), client_settings());
	uint16_t port = 1000;
	int64_t joined = 0;
	const int64_t begin = net.now + SECOND;
	for (; joined == 0 && net.now < begin + 5 * SECOND; net.now += 10000) {
		for (int i = 0; i < 50; i++) {
			attackers.emplace_back(endpoint("192.0.2.1", port++), client_settings());
			port = port < 1000 ? 1000 : port;
			Client &one = attackers.back();
			one.relay.look_after(net.now);
			net.server.take_outer(one.at, one.out.front(), net.now, net.record);
			one.out.clear();
			one.relay.take_outer(net.record.outer.front().bytes, net.now);
			net.record.outer.clear();
			net.server.take_outer(one.at, one.out.front(), net.now, net.record);
			net.record.outer.clear();
			attackers.pop_back();
		}
		if (net.now >= begin) {
			honest.relay.look_after(net.now);
			net.clients = { &honest };
			net.exchange();
			joined = net.server.links().half_open() == 1 ? net.now : 0;
		}
	}
	CHECK(joined != 0 && joined - begin < SECOND);
	CHECK(net.server.pending() <= PendingTable::MAX_OF_NETWORK);
}

TEST(a_flood_of_whole_handshakes_evicts_those_who_do_not_connect) {
	Net net(server_settings());
	Client client(endpoint("192.0.2.1", 400), client_settings());
	net.clients = { &client };
	net.run(SECOND / 10);
	connect_enet(net, client);
	for (uint16_t i = 0; i < 3000; i++) {
		Client one(endpoint("192.0.2.77", uint16_t(1000 + i)), client_settings());
		net.clients = { &one };
		one.relay.look_after(net.now);
		net.exchange();
		net.now += 1000;
	}
	CHECK(net.server.links().half_open() <= LinkTable::MAX_HALF_OPEN && net.server.links().confirmed() == 1);
	CHECK(net.server.counts().evicted > 0);
	net.clients = { &client };
	for (int i = 0; i < 6; i++) {
		client.relay.take_inner(enet_acknowledge(7, 0xFF, 1));
		net.run(SECOND);
	}
	CHECK(net.server.links().half_open() == 0 && net.server.links().confirmed() == 1);
}

TEST(without_sealing_half_open_connects_are_ended_at_enet) {
	Net net(server_settings("", false));
	for (int i = 0; i < 3000; i++) {
		const Endpoint at = endpoint("198.51.100." + std::to_string(i % 250), uint16_t(1000 + i));
		net.server.take_outer(at, enet_connect(), net.now, net.record);
		const uint32_t inner = net.record.inner.back().from;
		net.server.take_inner(inner, enet_verify(uint16_t(i), 1), net.now, net.record);
	}
	CHECK(net.server.links().half_open() == LinkTable::MAX_HALF_OPEN);
	size_t ended = 0;
	for (const Inner &one : net.record.inner) {
		ended += one.bytes.size() == 10 ? 1 : 0;
	}
	CHECK(ended == 3000 - LinkTable::MAX_HALF_OPEN);
	CHECK(equal(make_enet_disconnect(0x123, 1), hex("112344FF000000000000")));
}

TEST(connects_of_one_port_hold_one_slot) {
	Net net(server_settings("", false));
	const Endpoint at = endpoint("198.51.100.1", 1000);
	std::vector<uint32_t> connected;
	for (uint64_t i = 0; i < 100; i++) {
		net.server.take_outer(at, enet_connect(8, i), net.now, net.record);
		connected.push_back(net.record.inner.back().from);
	}
	CHECK(net.server.links().half_open() == 1);
	net.record.inner.clear();
	// ENet answers all of them later: all but the last are ended.
	for (size_t i = 0; i < connected.size(); i++) {
		net.server.take_inner(connected[i], enet_verify(uint16_t(i), 1), net.now, net.record);
	}
	CHECK(net.record.inner.size() == 99 && net.record.inner[98].from == connected[98]);
	CHECK(equal(net.record.inner[98].bytes, make_enet_disconnect(98, 1)));
}

TEST(port_0_and_too_few_channels_never_reach_enet) {
	for (const bool seals : { false, true }) {
		Net net(server_settings("", seals));
		net.server.take_outer(endpoint("192.0.2.1", 0), enet_connect(), net.now, net.record);
		CHECK(net.server.counts().from_port_zero == 1 && net.record.inner.empty() && net.record.outer.empty());
	}
	Net net(server_settings("", false));
	for (uint32_t channels : { 1, 2, 7 }) {
		net.server.take_outer(endpoint("192.0.2.1", 40), enet_connect(channels), net.now, net.record);
	}
	CHECK(net.server.counts().too_few_channels == 3 && net.record.inner.empty());
	CHECK(net.server.links().half_open() == 0);
}

TEST(whatever_comes_does_no_harm) {
	std::mt19937_64 random(11);
	for (const bool seals : { false, true }) {
		Net net(server_settings("password", seals));
		Client client(endpoint("192.0.2.1", 4000), client_settings("password", seals));
		net.clients = { &client };
		std::vector<Bytes> seen;
		for (int i = 0; i < 200000; i++, net.now += 100) {
			Bytes bytes(random() % 90);
			for (uint8_t &byte : bytes) {
				byte = uint8_t(random());
			}
			if (!seen.empty() && random() % 2 == 0) {
				bytes = seen[random() % seen.size()];
				if (!bytes.empty()) {
					bytes[random() % bytes.size()] = uint8_t(random());
				}
			}
			const Endpoint from = endpoint("192.0.2." + std::to_string(random() % 4), uint16_t(4000 + random() % 3));
			net.server.take_outer(from, bytes, net.now, net.record);
			client.relay.take_outer(bytes, net.now);
			client.relay.look_after(net.now);
			for (const Inner &inner : net.record.inner) {
				net.server.take_inner(inner.from, enet_verify(uint16_t(i), 1), net.now, net.record);
			}
			net.record.inner.clear();
			for (; !client.out.empty(); client.out.pop_front()) {
				seen.push_back(client.out.front());
			}
			for (; !net.record.outer.empty(); net.record.outer.pop_front()) {
				seen.push_back(net.record.outer.front().bytes);
				client.relay.take_outer(seen.back(), net.now);
			}
			seen.resize(std::min<size_t>(seen.size(), 64));
			if (i % 1000 == 0) {
				net.server.look_after(net.now, net.record);
			}
		}
		CHECK(net.server.links().half_open() + net.server.links().confirmed() <= 12);
		CHECK(net.server.pending() <= 12);
	}
}

} // namespace test_relay_hostile
