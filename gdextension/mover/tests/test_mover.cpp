// SPDX-License-Identifier: MIT
#include "box_world.hpp"

#include <mover.hpp>

#include <check.hpp>

#include <cmath>
#include <limits>

namespace test_mover {

using namespace mover;

namespace {

constexpr float TICK = 1.0f / 60.0f;
constexpr float HALF_TURN = 3.14159265f;

/// Somebody who stands at the origin and faces +Z.
struct Walker {
	BoxWorld world;
	Mover mover{ world };
	State state;

	void walk(int p_ticks, const Wish &p_wish) {
		for (int i = 0; i < p_ticks; i++) {
			mover.tick(state, p_wish, TICK);
		}
	}
};

Wish ahead(float p_speed) {
	Wish wish;
	wish.z = p_speed;
	return wish;
}

Wish jump() {
	Wish wish;
	wish.jumps = true;
	return wish;
}

Wish in_stance(Stance p_stance, float p_speed = 0.0f) {
	Wish wish = ahead(p_speed);
	wish.stance = p_stance;
	return wish;
}

} // namespace

TEST(who_is_held_back_goes_no_further_but_comes_back) {
	Walker walker;
	walker.walk(60, ahead(1.5f));
	walker.state.hold = { 0.0f, 0.0f, -1.0f };
	walker.walk(60, ahead(1.5f));
	CHECK(std::fabs(walker.state.velocity.z) < 1e-3f);
	// Sideways and back nothing holds.
	Wish aside = ahead(1.5f);
	aside.x = 1.0f;
	walker.walk(60, aside);
	CHECK(walker.state.velocity.x > 0.8f && std::fabs(walker.state.velocity.z) < 1e-3f);
	walker.walk(60, ahead(-1.5f));
	CHECK(walker.state.velocity.z < -1.0f);
	walker.state.hold = { 0.0f, 0.0f, -0.5f };
	walker.walk(60, ahead(1.5f));
	CHECK(std::fabs(walker.state.velocity.z - 0.75f) < 1e-3f);
}

TEST(who_wishes_to_walk_walks_and_stops) {
	Walker walker;
	walker.walk(60, ahead(1.5f));
	CHECK(walker.state.is_grounded == 1);
	CHECK(std::fabs(walker.state.velocity.z - 1.5f) < 1e-3f);
	CHECK(walker.state.position.z > 1.1f && walker.state.position.z < 1.5f);
	walker.walk(30, Wish());
	CHECK(walker.state.velocity.length() == 0.0f);
}

TEST(nobody_is_faster_than_people_are) {
	Walker walker;
	walker.walk(300, ahead(1000.0f));
	CHECK(std::fabs(walker.state.velocity.z - walker.mover.ability.speed[0]) < 1e-3f);
	walker.walk(300, ahead(-1000.0f));
	CHECK(std::fabs(walker.state.velocity.z) < 0.51f * walker.mover.ability.speed[0]);
	walker.walk(300, in_stance(Stance::PRONE, 5.0f));
	CHECK(walker.state.velocity.z < 0.61f);
}

TEST(nobody_runs_sideways_or_backwards) {
	for (const float direction : { 0.5f * HALF_TURN, HALF_TURN }) {
		Walker walker;
		Wish wish;
		wish.x = 5.0f * std::sin(direction);
		wish.z = 5.0f * std::cos(direction);
		walker.walk(200, wish);
		CHECK_NEAR(walker.state.velocity.length(), walker.mover.ability.most_back, 1e-3);
	}
}

TEST(what_is_no_number_is_no_wish) {
	Walker walker;
	Wish wish = ahead(std::numeric_limits<float>::quiet_NaN());
	wish.heading = std::numeric_limits<float>::infinity();
	walker.walk(10, wish);
	CHECK(walker.state.position.is_finite() && walker.state.heading == 0.0f);
	CHECK(walker.state.position.z == 0.0f);
}

TEST(kerbs_are_stepped_onto_and_walls_are_not) {
	Walker walker;
	walker.world.add({ -2.0f, 0.0f, 1.0f }, { 2.0f, 0.17f, 2.0f });
	walker.world.add({ -2.0f, 0.0f, 1.3f }, { 2.0f, 0.34f, 3.0f });
	walker.world.add({ -2.0f, 0.0f, 3.0f }, { 2.0f, 2.5f, 4.0f });
	walker.walk(240, ahead(1.5f));
	CHECK(std::fabs(walker.state.position.y - 0.34f) < 0.01f);
	CHECK(walker.state.position.z > 2.6f && walker.state.position.z < 2.71f);
}

TEST(who_walks_off_an_edge_falls_and_lands) {
	Walker walker;
	walker.world.add({ -2.0f, 0.0f, -2.0f }, { 2.0f, 2.0f, 1.0f });
	walker.state.position = { 0.0f, 2.0f, 0.0f };
	walker.walk(75, ahead(1.5f));
	CHECK(walker.state.is_grounded == 0);
	walker.walk(120, ahead(1.5f));
	CHECK(walker.state.is_grounded == 1 && std::fabs(walker.state.position.y) < 0.01f);
}

TEST(a_held_key_jumps_once) {
	Walker walker;
	walker.walk(2, Wish());
	float highest = 0.0f;
	int landed = 0;
	for (int i = 0; i < 120; i++) {
		const bool was_grounded = walker.state.is_grounded != 0;
		walker.walk(1, jump());
		highest = std::max(highest, walker.state.position.y);
		landed += !was_grounded && walker.state.is_grounded != 0 ? 1 : 0;
	}
	CHECK(highest > 0.4f && highest < 0.5f);
	CHECK(landed == 1);
}

TEST(what_is_breast_high_is_climbed_and_higher_is_not) {
	for (const float height : { 0.5f, 0.9f, 1.2f, 1.4f }) {
		Walker walker;
		walker.world.add({ -2.0f, 0.0f, 0.5f }, { 2.0f, height, 3.0f });
		walker.walk(10, Wish());
		walker.walk(1, jump());
		CHECK((walker.state.mode == Mode::VAULT) == (height < 1.3f));
		walker.walk(90, Wish());
		CHECK(walker.state.mode == Mode::WALK && walker.state.is_grounded == 1);
		CHECK(std::fabs(walker.state.position.y - (height < 1.3f ? height : 0.0f)) < 0.01f);
	}
}

TEST(below_a_low_roof_nobody_gets_up) {
	Walker walker;
	walker.world.add({ -2.0f, 1.3f, 1.0f }, { 2.0f, 1.5f, 4.0f });
	walker.walk(10, in_stance(Stance::CROUCH));
	walker.walk(120, in_stance(Stance::CROUCH, 1.5f));
	CHECK(walker.state.position.z > 1.5f);
	walker.walk(10, Wish());
	CHECK(walker.state.stance == Stance::CROUCH);
	walker.walk(200, in_stance(Stance::CROUCH, 1.5f));
	walker.walk(10, Wish());
	CHECK(walker.state.stance == Stance::STAND);
}

TEST(a_ladder_leads_up_and_down_again) {
	Walker walker;
	walker.world.add({ -2.0f, 0.0f, 1.06f }, { 2.0f, 3.0f, 5.0f });
	walker.world.add({ -0.25f, 0.0f, 1.0f }, { 0.25f, 3.0f, 1.06f }).is_ladder = true;
	walker.walk(60, ahead(1.5f));
	CHECK(walker.state.mode == Mode::LADDER);
	walker.walk(60, Wish());
	CHECK(walker.state.mode == Mode::LADDER && walker.state.velocity.length() == 0.0f);
	const float held = walker.state.position.y;
	walker.walk(30, ahead(-1.5f));
	CHECK(walker.state.position.y < held - 0.2f);
	walker.walk(280, ahead(1.5f));
	CHECK(walker.state.mode == Mode::WALK && std::fabs(walker.state.position.y - 3.0f) < 0.01f);
	CHECK(walker.state.position.z > 1.0f);
}

TEST(who_stands_on_what_moves_goes_with_it) {
	Walker walker;
	BoxWorld::Box &deck = walker.world.add({ -3.0f, 0.0f, -3.0f }, { 3.0f, 0.5f, 3.0f });
	deck.carrier = 7;
	walker.state.position = { 1.0f, 0.5f, 0.0f };
	walker.world.frames[7] = Frame();
	walker.walk(5, Wish());
	CHECK(walker.state.carrier == 7);
	for (int i = 0; i < 30; i++) {
		deck.low.x += 0.02f;
		deck.high.x += 0.02f;
		walker.world.frames[7].origin.x += 0.02f;
		walker.walk(1, Wish());
	}
	CHECK(std::fabs(walker.state.position.x - 1.6f) < 1e-3f);
	// Who jumps keeps the deck's speed.
	for (int i = 0; i < 12; i++) {
		deck.low.x += 0.02f;
		deck.high.x += 0.02f;
		walker.world.frames[7].origin.x += 0.02f;
		walker.walk(1, jump());
	}
	CHECK(std::fabs(walker.state.position.x - 1.84f) < 0.03f && walker.state.is_grounded == 0);
}

TEST(a_turntable_turns_who_stands_on_it) {
	Walker walker;
	walker.world.boxes[0].carrier = 3;
	walker.world.frames[3] = Frame();
	walker.state.position = { 1.0f, 0.0f, 0.0f };
	Wish wish;
	for (int i = 1; i <= 60; i++) {
		const float angle = 0.5f * HALF_TURN * float(i) / 60.0f;
		walker.world.frames[3].turn = { 0.0f, std::sin(angle / 2.0f), 0.0f, std::cos(angle / 2.0f) };
		wish.heading = walker.state.heading;
		walker.walk(1, wish);
	}
	CHECK(std::fabs(walker.state.position.z + 1.0f) < 0.05f && std::fabs(walker.state.position.x) < 0.05f);
}

TEST(physics_has_who_has_fallen) {
	Walker walker;
	walker.state.mode = Mode::BODY;
	walker.walk(60, ahead(1.5f));
	CHECK(walker.state.position.z == 0.0f);
}

TEST(a_tick_made_again_is_the_same_to_the_bit) {
	Walker walker;
	walker.world.add({ -2.0f, 0.0f, 1.0f }, { 2.0f, 0.3f, 2.0f });
	walker.world.add({ 1.0f, 0.0f, -5.0f }, { 2.0f, 3.0f, 5.0f });
	std::uint32_t chance = 1;
	Wish wish;
	for (int i = 0; i < 2000; i++) {
		chance = chance * 1664525u + 1013904223u;
		if (i % 20 == 0) {
			wish.x = float(chance >> 24) / 32.0f - 4.0f;
			wish.z = float((chance >> 16) & 255u) / 32.0f - 4.0f;
			wish.heading = float((chance >> 8) & 255u) / 40.0f;
			wish.jumps = (chance & 1024u) != 0;
		}
		State again = walker.state;
		walker.walk(1, wish);
		walker.mover.tick(again, wish, TICK);
		CHECK(again.words() == walker.state.words());
	}
}

} // namespace test_mover
