// SPDX-License-Identifier: MIT
#include "check.hpp"
#include "hex.hpp"
#include "sealing/sealed_channel.hpp"

#include <algorithm>
#include <random>

namespace test_sealed_channel {

using namespace transport;

namespace {

const Bytes ONE{ 0x47 };

Key key_of(uint8_t p_byte) {
	Key made{};
	made.fill(p_byte);
	return made;
}

struct Ends {
	SealedChannel client{ key_of(1), key_of(2) };
	SealedChannel server{ key_of(2), key_of(1) };
};

Bytes sealed(SealedChannel &r_channel, const View &p_plain) {
	Bytes made;
	r_channel.seal(Content::FAST, p_plain, made);
	return made;
}

bool opens(SealedChannel &r_channel, const View &p_sealed, Bytes &r_opened) {
	Content content = Content::ENET;
	return r_channel.open(p_sealed, content, r_opened) && content == Content::FAST;
}

} // namespace

TEST(what_is_sealed_is_opened_at_the_other_end) {
	Ends ends;
	Bytes opened;
	for (size_t size : { 0, 1, 200, 1200, 4096 }) {
		const Bytes plain(size, uint8_t(size));
		const Bytes datagram = sealed(ends.client, plain);
		CHECK(datagram.size() == size + SealedChannel::OVERHEAD);
		CHECK(opens(ends.server, datagram, opened));
		CHECK(equal(opened, plain));
	}
	CHECK(SealedChannel::OVERHEAD == 18);
	// Nobody takes what he has sealed himself for the other end's.
	CHECK(!opens(ends.client, sealed(ends.client, ONE), opened));
}

TEST(every_altered_bit_is_noticed) {
	Ends ends;
	Bytes opened;
	const Bytes good = sealed(ends.client, Bytes(20, 7));
	for (size_t bit = 0; bit < good.size() * 8; bit++) {
		Bytes bad = good;
		bad[bit / 8] ^= uint8_t(1 << bit % 8);
		CHECK(!opens(ends.server, bad, opened));
	}
	for (size_t size = 0; size < good.size(); size++) {
		CHECK(!opens(ends.server, View(good.data(), size), opened));
	}
	CHECK(opens(ends.server, good, opened));
}

TEST(nothing_is_opened_twice_in_whatever_order_it_comes) {
	Ends ends;
	Bytes opened;
	std::vector<Bytes> datagrams;
	datagrams.reserve(5000);
	for (int i = 0; i < 5000; i++) {
		datagrams.push_back(sealed(ends.client, Bytes(4, uint8_t(i))));
	}
	std::mt19937 random(1);
	for (size_t begin = 0; begin < datagrams.size(); begin += 1000) {
		std::shuffle(datagrams.begin() + ptrdiff_t(begin), datagrams.begin() + ptrdiff_t(begin + 1000), random);
	}
	int good = 0;
	for (const Bytes &datagram : datagrams) {
		good += opens(ends.server, datagram, opened) ? 1 : 0;
	}
	CHECK(good == 5000);
	int again = 0;
	for (const Bytes &datagram : datagrams) {
		again += opens(ends.server, datagram, opened) ? 1 : 0;
	}
	CHECK(again == 0);
}

TEST(what_is_older_than_the_window_is_not_opened) {
	Ends ends;
	Bytes opened;
	const Bytes first = sealed(ends.client, ONE);
	const Bytes second = sealed(ends.client, ONE);
	for (uint64_t i = 2; i < ReplayWindow::SIZE; i++) {
		sealed(ends.client, ONE);
	}
	CHECK(opens(ends.server, sealed(ends.client, ONE), opened));
	CHECK(!opens(ends.server, first, opened));
	CHECK(opens(ends.server, second, opened));
}

TEST(whole_numbers_follow_from_their_low_bits) {
	for (const int bits : { SealedChannel::NUMBER_BITS, SealedChannel::LONG_NUMBER_BITS }) {
		const uint64_t sent = uint64_t(1) << bits;
		const uint64_t half = sent / 2;
		for (uint64_t expected : { uint64_t(0), half, sent - 1, sent, sent + 5, 7 * sent + half, uint64_t(1) << 40 }) {
			for (int64_t distance :
					{ int64_t(0), int64_t(1), int64_t(-1), int64_t(3000), int64_t(-3000), int64_t(half - 1) }) {
				const uint64_t number = expected + uint64_t(distance);
				if (distance >= 0 || expected >= uint64_t(-distance)) {
					CHECK(SealedChannel::whole_number(expected, number % sent, bits) == number);
				}
			}
		}
	}
}

TEST(what_comes_after_a_long_gap_is_opened) {
	Ends ends;
	Bytes opened;
	for (const int lost : { 1, 100, 8000 }) {
		for (int round = 0; round < 20; round++) {
			for (int i = 0; i < lost; i++) {
				sealed(ends.client, ONE);
			}
			CHECK(opens(ends.server, sealed(ends.client, ONE), opened));
		}
	}
}

TEST(both_kinds_of_heads_count_in_the_same_numbers) {
	Ends ends;
	Bytes named;
	Bytes opened;
	const Bytes first = sealed(ends.client, ONE);
	ends.client.seal(ONE, Bytes(3, 3), named);
	const Bytes last = sealed(ends.client, ONE);
	CHECK(opens(ends.server, last, opened) && opens(ends.server, first, opened));
	CHECK(ends.server.open(named, ONE.size(), opened) && equal(opened, Bytes(3, 3)));
	CHECK(!ends.server.open(named, ONE.size(), opened));
	Content content = Content::FAST;
	ends.client.seal(Content::ENET, ONE, named);
	CHECK(ends.server.open(named, content, opened) && content == Content::ENET);
}

TEST(the_window_forgets_what_it_has_passed) {
	ReplayWindow window;
	CHECK(window.is_new(0));
	window.note(0);
	CHECK(!window.is_new(0));
	window.note(ReplayWindow::SIZE + 5);
	CHECK(!window.is_new(5) && window.is_new(6) && !window.is_new(ReplayWindow::SIZE + 5));
	window.note(10 * ReplayWindow::SIZE);
	CHECK(!window.is_new(ReplayWindow::SIZE + 5));
	CHECK(window.is_new(10 * ReplayWindow::SIZE - 1));
	CHECK(window.next() == 10 * ReplayWindow::SIZE + 1);
	CHECK(ReplayWindow::SIZE >= 1024);
}

TEST(the_keys_are_different_and_always_the_same) {
	std::array<uint8_t, 64> secret{};
	const ChannelKeys keys = ChannelKeys::derive(secret);
	CHECK(keys.to_server != keys.to_client && keys.to_client != keys.exporter && keys.to_server != keys.exporter);
	CHECK(ChannelKeys::derive(secret).exporter == keys.exporter);
	secret[63] = 1;
	CHECK(ChannelKeys::derive(secret).exporter != keys.exporter);
}

} // namespace test_sealed_channel
