// SPDX-License-Identifier: MIT
#include <mover_state.hpp>

#include <check.hpp>

#include <limits>

namespace test_mover_state {

using namespace mover;

TEST(a_state_comes_back_as_it_was) {
	State state;
	state.position = { 1.0f, 2.0f, 3.0f };
	state.mode = Mode::VAULT;
	state.stance = Stance::PRONE;
	state.carrier = 65535;
	state.local_heading = -1.5f;
	State other;
	CHECK(other.read(state.words()));
	CHECK(other.words() == state.words() && other.mode == Mode::VAULT && other.carrier == 65535);
	CHECK(other.check() == state.check());
}

TEST(states_that_differ_in_a_bit_have_another_check) {
	const State state;
	int same = 0;
	for (std::size_t word = 0; word < State::WORDS; word++) {
		for (int bit = 0; bit < 32; bit++) {
			State other;
			State::Words words = state.words();
			words[word] ^= 1u << bit;
			same += other.read(words) && other.check() == state.check() ? 1 : 0;
		}
	}
	CHECK(same <= 1);
}

TEST(what_can_be_nobodys_state_is_left_out) {
	const float wrong[] = { std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -1e9f };
	for (const float number : wrong) {
		State state;
		state.position.x = number;
		State other;
		other.heading = 0.5f;
		CHECK(!other.read(state.words()) && other.heading == 0.5f);
	}
	State state;
	state.carrier = 65536;
	State other;
	CHECK(!other.read(state.words()));
	State::Words words = State().words();
	words[9] = 99; // The mode.
	CHECK(!other.read(words));
}

} // namespace test_mover_state
