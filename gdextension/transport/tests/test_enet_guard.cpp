// SPDX-License-Identifier: MIT
#include "check.hpp"
#include "wire.hpp"

#include <random>

namespace test_enet_guard {

using namespace wire;

namespace {

struct Guarded {
	EnetLimits limits;
	uint64_t in_all = 0;
	EnetGuard guard;

	Guarded() : limits(server_settings().limits), guard(limits, in_all) {
		guard.check(enet_connect());
		guard.note_sent(enet_verify(3, 1));
		guard.admit();
	}

	EnetGuard::Verdict check(const Bytes &p_bytes) { return guard.check(p_bytes); }
	void acknowledge(uint16_t p_number) { guard.note_sent(enet_acknowledge(0, 0, p_number)); }
};

} // namespace

TEST(what_enet_writes_is_let_through) {
	Guarded it;
	CHECK(it.guard.has_peer() && it.guard.peer() == 3 && it.guard.session() == 1 && !it.guard.is_confirmed());
	CHECK(it.check(enet_acknowledge(3, 0xFF, 1)) == EnetGuard::PASS && it.guard.is_confirmed());
	for (uint32_t number = 1; number <= 70000; number++) {
		if (it.check(enet_reliable(0, uint16_t(number), 1000)) != EnetGuard::PASS) {
			CHECK(number == 0);
		}
		it.acknowledge(uint16_t(number));
	}
	CHECK(it.guard.held() == 0 && it.in_all == 0);
}

TEST(what_enet_does_not_write_is_not) {
	Guarded it;
	for (const std::string digits : { "", "80", "8003", "80030000", "800300000F000000", "8003000000000000",
				 "C00300000500000000", "80030000860000010040", "8FFF00000500FFFF" }) {
		CHECK(it.check(hex(digits)) == EnetGuard::MALFORMED);
	}
	Bytes cut = enet_connect();
	cut.pop_back();
	CHECK(it.check(cut) == EnetGuard::MALFORMED);
	CHECK(it.check(enet_connect(2)) == EnetGuard::TOO_FEW_CHANNELS);
	CHECK(it.check(enet_connect(256)) == EnetGuard::MALFORMED);
}

TEST(more_commands_than_enet_writes_in_a_datagram_are_not_let_through) {
	Guarded it;
	Bytes bytes = command(3, 5, 0xFF, 1);
	const Bytes ping(bytes.end() - 4, bytes.end());
	for (int count = 1; count < 40; count++) {
		CHECK(it.check(bytes) == (count <= 32 ? EnetGuard::PASS : EnetGuard::MALFORMED));
		append(bytes, ping);
	}
}

TEST(a_forged_connect_does_not_make_a_peer_begin_anew) {
	Guarded it;
	it.check(enet_acknowledge(3, 0xFF, 1));
	it.check(enet_reliable(0, 1, 10));
	it.acknowledge(1);
	CHECK(it.check(enet_connect(8, 99)) == EnetGuard::CONNECTED_ALREADY);
	CHECK(it.check(enet_reliable(0, 2, 10)) == EnetGuard::PASS);
}

TEST(what_waits_behind_a_gap_is_bounded) {
	Guarded it;
	size_t passed = 0;
	for (uint16_t number = 2; number < 5000; number++) {
		passed += it.check(enet_reliable(0, number, 1300)) == EnetGuard::PASS ? 1 : 0;
		it.acknowledge(number);
	}
	CHECK(passed > 100 && it.guard.held() <= it.limits.max_held);
	// What was missing comes: all is handed on.
	CHECK(it.check(enet_reliable(0, 1, 1)) != EnetGuard::MALFORMED);
	Guarded small;
	for (uint16_t number = 2; number < 100; number++) {
		CHECK(small.check(enet_reliable(0, number, 1300)) == EnetGuard::PASS);
		small.acknowledge(number);
	}
	CHECK(small.guard.held() > 98 * 1300);
	small.check(enet_reliable(0, 1, 1));
	small.acknowledge(1);
	CHECK(small.guard.held() == 0);
}

TEST(unreliable_packets_behind_a_gap_are_bounded) {
	Guarded it;
	size_t passed = 0;
	for (int i = 0; i < 1000; i++) {
		Bytes bytes = command(0, 7, 1, 2);
		append_big(bytes, uint32_t(i), 2);
		append_big(bytes, 1000, 2);
		bytes.resize(bytes.size() + 1000);
		passed += it.check(bytes) == EnetGuard::PASS ? 1 : 0;
	}
	CHECK(passed < 300 && it.guard.held() <= it.limits.max_held);
	for (uint16_t number = 1; number <= 2; number++) {
		it.check(enet_reliable(1, number, 0));
		it.guard.note_sent(enet_acknowledge(0, 1, number));
	}
	CHECK(it.guard.held() == 0 || passed < 300);
}

TEST(a_packet_in_fragments_is_let_through_and_forgotten) {
	Guarded it;
	uint16_t next = 1;
	for (int round = 0; round < 200; round++) {
		for (uint32_t i = 0; i < 12; i++) {
			// In any order.
			const uint32_t index = (i * 5 + uint32_t(round)) % 12;
			CHECK(it.check(enet_fragment(next, 12, index, 16000, 1392)) == EnetGuard::PASS);
			CHECK(it.check(enet_fragment(next, 12, index, 16000, 1392)) == EnetGuard::PASS);
			CHECK(it.guard.held() > 16000 && it.guard.held() < 16500);
			it.acknowledge(uint16_t(next + index));
		}
		CHECK(it.guard.held() == 0);
		next = uint16_t(next + 12);
	}
}

TEST(first_fragments_alone_do_not_pile_up) {
	Guarded it;
	for (uint32_t number = 1; number < 60000; number++) {
		it.check(enet_fragment(uint16_t(number), 12, number % 12, 16000, 1392));
		it.acknowledge(uint16_t(number + number % 12));
	}
	CHECK(it.guard.held() > 0 && it.guard.held() <= it.limits.max_held);
	CHECK(it.in_all == it.guard.held());
}

TEST(fragments_that_do_not_fit_are_refused) {
	Guarded it;
	CHECK(it.check(enet_fragment(1, 13, 0, 17000, 1392)) == EnetGuard::BAD_FRAGMENT);
	CHECK(it.check(enet_fragment(1, 1, 0, 1000, 1000)) == EnetGuard::BAD_FRAGMENT);
	CHECK(it.check(enet_fragment(1, 12, 0, 16000, 1392)) == EnetGuard::PASS);
	// Others of its numbers, and what would be a packet of its own among them.
	CHECK(it.check(enet_fragment(2, 12, 0, 16000, 1392)) == EnetGuard::BAD_FRAGMENT);
	CHECK(it.check(enet_fragment(1, 6, 1, 8000, 1392)) == EnetGuard::BAD_FRAGMENT);
	CHECK(it.check(enet_reliable(0, 5, 10)) == EnetGuard::BAD_FRAGMENT);
	Bytes unreliable = enet_fragment(30, 2, 0, 2000, 1392);
	unreliable[4] = 12;
	CHECK(it.check(unreliable) == EnetGuard::BAD_FRAGMENT);
}

TEST(all_clients_together_are_bounded) {
	EnetLimits limits = server_settings().limits;
	limits.max_held_in_all = 1 << 20;
	uint64_t in_all = 0;
	std::deque<EnetGuard> guards;
	for (int i = 0; i < 20; i++) {
		guards.emplace_back(limits, in_all);
		guards.back().check(enet_connect());
		guards.back().admit();
		for (uint16_t number = 2; number < 300; number++) {
			guards.back().check(enet_reliable(0, number, 1300));
		}
	}
	// Nobody takes what each has in any case.
	CHECK(in_all > limits.max_held_in_all / 2 && in_all <= limits.max_held_in_all + 20 * limits.own_part);
	EnetGuard late(limits, in_all);
	late.check(enet_connect());
	late.admit();
	for (uint32_t i = 0; i < 12; i++) {
		CHECK(late.check(enet_fragment(1, 12, i, 16000, 1392)) == EnetGuard::PASS);
	}
	guards.clear();
	CHECK(in_all == late.held());
}

TEST(who_is_not_admitted_has_little_of_one_channel) {
	const EnetLimits limits = server_settings().limits;
	uint64_t in_all = 0;
	EnetGuard guard(limits, in_all);
	guard.check(enet_connect());
	guard.note_sent(enet_verify(3, 1));
	CHECK(guard.check(enet_reliable(1, 1, 10)) == EnetGuard::HELD_TOO_MUCH);
	for (uint16_t number = 2; number < 300; number++) {
		guard.check(enet_reliable(0, number, 1300));
	}
	CHECK(guard.held() > 0 && guard.held() <= limits.max_held_arriving);
	guard.admit();
	CHECK(guard.check(enet_reliable(1, 1, 10)) == EnetGuard::PASS);
}

TEST(no_sequence_of_commands_makes_the_count_wrong) {
	std::mt19937 random(4);
	for (int round = 0; round < 30; round++) {
		Guarded it;
		for (int i = 0; i < 20000; i++) {
			const uint16_t number = uint16_t(random() % 80);
			const uint32_t count = 2 + random() % 11;
			switch (random() % 4) {
				case 0:
					it.check(enet_reliable(uint8_t(random() % 9), number, random() % 50));
					break;
				case 1:
					it.check(enet_fragment(
							number, count, random() % count, (count - 1) * 100 + 1 + random() % 100, 100));
					break;
				case 2:
					it.guard.note_sent(enet_acknowledge(0, uint8_t(random() % 9), number));
					break;
				default: {
					Bytes bytes = enet_reliable(0, number, 20);
					bytes[random() % bytes.size()] = uint8_t(random());
					it.check(bytes);
				}
			}
		}
		CHECK(it.in_all == it.guard.held() && it.guard.held() <= it.limits.max_held);
	}
}

} // namespace test_enet_guard
