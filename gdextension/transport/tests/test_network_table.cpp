// SPDX-License-Identifier: MIT
#include "sealing/try_limiter.hpp"

#include <check.hpp>

#include <cstring>

namespace test_network_table {

using namespace transport;

namespace {

std::array<uint8_t, 16> network(uint32_t p_number) {
	std::array<uint8_t, 16> made{};
	std::memcpy(made.data(), &p_number, sizeof(p_number));
	return made;
}

} // namespace

TEST(however_many_networks_come_so_many_are_known) {
	NetworkTable<int> table;
	const auto is_idle = [](int p_value) { return p_value == 0; };
	table.find_or_add(network(0), 1, is_idle);
	for (uint32_t i = 1; i < 3 * NetworkTable<int>::MAX; i++) {
		CHECK(table.find_or_add(network(i), 0, is_idle) == 0);
		CHECK(table.size() <= NetworkTable<int>::MAX);
	}
	// The idle ones make room first.
	CHECK(table.find(network(0)) != nullptr && *table.find(network(0)) == 1);
	for (uint32_t i = 0; i < 3 * NetworkTable<int>::MAX; i++) {
		table.find_or_add(network(i), 1, is_idle) = 1;
		CHECK(table.size() <= NetworkTable<int>::MAX);
	}
}

TEST(who_is_known_makes_nobody_forgotten) {
	NetworkTable<int> table;
	const auto is_idle = [](int) { return true; };
	for (uint32_t i = 0; i < NetworkTable<int>::MAX; i++) {
		table.find_or_add(network(i), 0, is_idle);
	}
	table.find_or_add(network(7), 0, is_idle);
	CHECK(table.size() == NetworkTable<int>::MAX);
}

TEST(a_guesser_is_not_forgotten_for_others_who_come_once) {
	TryLimiter tries(5.0, 0.5);
	for (int i = 0; i < 5; i++) {
		CHECK(tries.take(network(0), 0));
	}
	// Each of the others has its tries back before the next one needs its room.
	for (uint32_t i = 1; i < 3 * NetworkTable<int>::MAX; i++) {
		CHECK(tries.take(network(i), 100 * int64_t(i)));
		tries.give_back(network(i));
	}
	CHECK(!tries.take(network(0), 1300000));
	CHECK(tries.take(network(0), 2000000));
}

} // namespace test_network_table
