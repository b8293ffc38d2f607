// SPDX-License-Identifier: MIT
#include "check.hpp"
#include "wire.hpp"

#include <algorithm>
#include <random>

/// What is packed into datagrams that the path carries, and how it is found out what it carries.
namespace test_carriage {

using namespace wire;

struct Sent {
	Content content;
	Bytes bytes;
};

Carriage::Send into(std::vector<Sent> &r_sent) {
	return [&r_sent](Content p_content, const View &p_bytes) {
		r_sent.push_back({ p_content, Bytes(p_bytes.data, p_bytes.data + p_bytes.size) });
	};
}

Bytes noise(size_t p_size, std::mt19937 &r_random) {
	Bytes made(p_size);
	for (uint8_t &byte : made) {
		byte = uint8_t(r_random());
	}
	return made;
}

TEST(what_is_too_large_for_the_path_comes_in_parts_and_whole_again) {
	std::mt19937 random(1);
	for (const Content content : { Content::ENET, Content::FAST }) {
		for (const size_t size : { 1, 510, 511, 600, 1020, 1200, 1392, 2048 }) {
			Carriage from;
			Carriage to;
			std::vector<Sent> sent;
			Bytes whole = noise(size, random);
			whole[0] = 7;
			from.send(content, whole, into(sent));
			std::shuffle(sent.begin(), sent.end(), random);
			size_t wholes = 0;
			for (const Sent &one : sent) {
				CHECK(one.bytes.size() + SealedChannel::OVERHEAD <= PathMtu::SIZES.front());
				Content taken = one.content;
				Bytes bytes = one.bytes;
				std::vector<Sent> answers;
				if (to.take(taken, bytes, bytes.size(), 0, into(answers))) {
					wholes++;
					CHECK(taken == content && equal(bytes, whole));
				}
				CHECK(answers.empty());
			}
			CHECK(wholes == 1 && sent.size() == (size <= 510 ? 1 : (size + 505) / 506));
		}
	}
	std::vector<Sent> sent;
	Carriage().send(Content::ENET, Bytes(2049), into(sent));
	CHECK(sent.empty());
}

TEST(parts_that_never_come_cost_little_and_hold_nothing_up) {
	Carriage from;
	Carriage to;
	std::vector<Sent> none;
	size_t wholes = 0;
	for (int i = 0; i < 1000; i++) {
		std::vector<Sent> sent;
		from.send(Content::FAST, Bytes(1000, 9), into(sent));
		const bool is_lost = i % 3 != 0;
		for (size_t part = is_lost ? 1 : 0; part < sent.size(); part++) {
			Content content = sent[part].content;
			wholes += to.take(content, sent[part].bytes, 0, 0, into(none)) ? 1 : 0;
		}
	}
	CHECK(wholes == 334);
}

TEST(no_part_is_believed_that_nobody_sends) {
	std::mt19937 random(4);
	Carriage to;
	std::vector<Sent> answers;
	for (int i = 0; i < 200000; i++) {
		Bytes bytes = noise(1 + random() % 40, random);
		bytes[0] = uint8_t(Carriage::FIRST_KIND + random() % 5);
		if (random() % 50 == 0) {
			bytes.resize(4000);
		}
		Content content = Content::FAST;
		if (to.take(content, bytes, bytes.size(), i, into(answers))) {
			CHECK(bytes.size() <= Carriage::MAX_WHOLE && !bytes.empty());
			CHECK(content == Content::ENET || bytes[0] < Carriage::FIRST_KIND || bytes[0] > Carriage::LAST_KIND);
		}
		CHECK(to.mtu().limit() >= PathMtu::SIZES.front());
	}
}

TEST(a_size_is_found_that_the_path_carries) {
	for (const size_t mtu : { 528, 600, 1231, 1232, 1400, 1452, 9000 }) {
		for (const int lost_of_10 : { 0, 2 }) {
			std::mt19937 random(6);
			PathMtu path;
			for (int64_t now = 0; now < 8 * SECOND; now += 10000) {
				path.look_after(now, [&](size_t p_size) {
					if (p_size <= mtu && int(random() % 10) >= lost_of_10) {
						path.take_answer(p_size, now + 5000);
					}
				});
			}
			const auto larger = std::upper_bound(PathMtu::SIZES.begin(), PathMtu::SIZES.end(), mtu);
			CHECK(path.limit() == *(larger - 1) && path.is_settled());
		}
	}
}

TEST(a_path_that_grows_narrow_is_noticed_and_one_that_grows_wide_too) {
	PathMtu path;
	size_t mtu = 1452;
	size_t probes = 0;
	int64_t now = 0;
	const auto run = [&](int64_t p_usec, bool p_uses) {
		for (const int64_t end = now + p_usec; now < end; now += 10000) {
			if (p_uses) {
				path.note_sent(1000);
			}
			path.look_after(now, [&](size_t p_size) {
				probes++;
				if (p_size <= mtu) {
					path.take_answer(p_size, now);
				}
			});
		}
	};
	run(SECOND, true);
	CHECK(path.limit() == 1452);
	probes = 0;
	run(60 * SECOND, false);
	// Who sends nothing large need not know.
	CHECK(probes <= 1);
	mtu = 548;
	run(5 * SECOND, true);
	CHECK(path.limit() == 528);
	run(60 * SECOND, true);
	mtu = 1300;
	run(31 * SECOND, true);
	CHECK(path.limit() == 1232);
}

TEST(everything_gets_through_where_the_network_drops_what_is_large) {
	for (const bool seals : { true, false }) {
		for (const size_t mtu : { 528, 1232 }) {
			Net net(server_settings("", seals));
			net.mtu = mtu;
			Client client(endpoint("192.0.2.1", 4000), client_settings("", seals));
			net.clients = { &client };
			net.run(SECOND / 10);
			const uint32_t inner = connect_enet(net, client);
			net.server.name(inner, 5);
			net.server.admit(inner);
			for (int i = 0; i < 8; i++) {
				client.relay.take_inner(enet_acknowledge(7, 0xFF, 1));
				net.run(SECOND);
			}
			CHECK(client.relay.mtu().is_settled() && client.relay.mtu().limit() == mtu);
			net.record.inner.clear();
			client.inner.clear();
			for (uint16_t i = 1; i <= 50; i++) {
				client.relay.take_inner(enet_reliable(0, i, 1300));
				net.server.take_inner(inner, enet_reliable(0, i, 1350), net.now, net.record);
				client.relay.send_fast(Bytes(1200, 3));
				net.server.send_fast(5, Bytes(1200, 4), net.record);
				net.exchange();
				net.server.take_inner(inner, enet_acknowledge(0, 0, i), net.now, net.record);
			}
			CHECK(net.record.inner.size() == 50 && equal(net.record.inner.back().bytes, enet_reliable(0, 50, 1300)));
			CHECK(client.fast.size() == 50 && equal(client.fast.back(), Bytes(1200, 4)));
			CHECK(net.record.fast.size() == 50 && net.record.fast.back().first == 5);
			CHECK(equal(net.record.fast.back().second, Bytes(1200, 3)));
			CHECK(client.inner.size() >= 50);
		}
	}
}

} // namespace test_carriage
