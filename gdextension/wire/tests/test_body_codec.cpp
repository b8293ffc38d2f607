// SPDX-License-Identifier: MIT
#include "people.hpp"

#include <replication/body_codec.hpp>

#include <check.hpp>

#include <limits>

namespace test_body_codec {

using namespace wire;

namespace {

constexpr int RATE = 60;
constexpr std::size_t ROOM = 256;

bool same(const BodyState &p_a, const BodyState &p_b) {
	return p_a.position == p_b.position && p_a.velocity == p_b.velocity && p_a.spin == p_b.spin &&
			p_a.turn == p_b.turn && p_a.at_rest == p_b.at_rest;
}

Vec3 draw_vector(std::mt19937 &p_random, float p_most) {
	return { people::draw(p_random, p_most), people::draw(p_random, p_most), people::draw(p_random, p_most) };
}

// A body anywhere, from at rest to absurdly quick.
BodyUpdate draw_body(std::mt19937 &p_random) {
	BodyUpdate body;
	const float wild = p_random() % 4 == 0 ? 1e6f : 20.0f;
	body.position = draw_vector(p_random, wild);
	body.orientation = people::draw_rotation(p_random);
	body.at_rest = p_random() % 3 == 0;
	body.velocity = body.at_rest ? Vec3{} : draw_vector(p_random, wild);
	body.spin = body.at_rest ? Vec3{} : draw_vector(p_random, wild);
	return body;
}

bool passes(const BodyState &p_state, const BodyState *p_base, int p_ticks, int p_rate) {
	std::array<uint8_t, ROOM> bytes{};
	RangeEncoder encoder(bytes.data(), bytes.size());
	BodyCodec::encode(encoder, p_state, p_base, p_ticks, p_rate);
	const std::size_t size = encoder.finish();
	BodyState found;
	RangeDecoder decoder(bytes.data(), size);
	return size > 0 && BodyCodec::decode(decoder, p_base, p_ticks, p_rate, found) && same(found, p_state);
}

BodyState extreme(int p_sign, uint8_t p_dropped) {
	BodyState state;
	state.position.fill(p_sign * int32_t(FARTHEST_M) * 1000);
	state.velocity.fill(int16_t(p_sign * 500 * BODY_VELOCITY_SCALE));
	state.spin.fill(int16_t(p_sign * 2000 * BODY_SPIN_SCALE));
	state.turn.parts.fill(int16_t(p_sign * BODY_TURN_SCALE / 2));
	state.turn.dropped = p_dropped;
	return state;
}

double apart_deg(const Quat &p_a, const Quat &p_b) {
	const Quat change = p_a.inverse() * p_b;
	const double chord =
			std::sqrt(double(change.x) * change.x + double(change.y) * change.y + double(change.z) * change.z);
	return 2.0 * std::atan2(chord, std::fabs(double(change.w))) * 180.0 / 3.14159265358979;
}

} // namespace

TEST(any_state_comes_through_from_nothing_and_from_any_other) {
	std::mt19937 random(1);
	int wrong = 0;
	for (int round = 0; round < 20000; round++) {
		const BodyState state = quantise_body(draw_body(random));
		const BodyState base = quantise_body(draw_body(random));
		const int ticks = 1 + int(random() % 127);
		const int rate = round % 2 == 0 ? RATE : 1 + int(random() % 240);
		wrong += passes(state, nullptr, 0, rate) ? 0 : 1;
		wrong += passes(state, &base, ticks, rate) ? 0 : 1;
	}
	CHECK(wrong == 0);
}

TEST(extremes_come_through) {
	for (uint8_t now = 0; now < 4; now++) {
		for (uint8_t before = 0; before < 4; before++) {
			for (const int sign : { -1, 1 }) {
				const BodyState state = extreme(sign, now);
				for (const int base_sign : { -1, 1 }) {
					const BodyState base = extreme(base_sign, before);
					CHECK(passes(state, &base, 127, 1));
					CHECK(passes(state, &base, 1, 240));
				}
				CHECK(passes(state, nullptr, 0, RATE));
			}
		}
	}
}

TEST(what_comes_through_is_near_what_was_put_in) {
	std::mt19937 random(2);
	double angle = 0.0;
	float distance = 0.0f;
	float velocity = 0.0f;
	for (int round = 0; round < 5000; round++) {
		BodyUpdate body;
		body.position = draw_vector(random, 30.0f);
		body.velocity = draw_vector(random, 30.0f);
		body.orientation = people::draw_rotation(random);
		BodyUpdate found;
		restore_body(quantise_body(body), found);
		angle = std::max(angle, apart_deg(body.orientation, found.orientation));
		distance = std::max(distance, (body.position - found.position).length());
		velocity = std::max(velocity, (body.velocity - found.velocity).length());
		CHECK_NEAR(found.orientation.dot(found.orientation), 1.0, 1e-5);
	}
	CHECK(angle < 0.8);
	CHECK(distance < 0.001f);
	CHECK(velocity < 1.0f / float(BODY_VELOCITY_SCALE));
}

TEST(every_axis_can_be_the_one_left_out) {
	const std::array<Quat, 4> turns{ Quat{ 1, 0, 0, 0 }, Quat{ 0, -1, 0, 0 }, Quat{ 0, 0, 1, 0 }, Quat{ 0, 0, 0, -1 } };
	for (std::size_t i = 0; i < 4; i++) {
		BodyUpdate body;
		body.orientation = turns[i];
		const BodyState state = quantise_body(body);
		CHECK(state.turn.dropped == i);
		BodyUpdate found;
		restore_body(state, found);
		CHECK_NEAR(std::fabs(found.orientation.dot(turns[i])), 1.0, 1e-6);
		CHECK(passes(state, nullptr, 0, RATE));
	}
}

TEST(what_is_no_number_becomes_a_state_all_the_same) {
	const float nan = std::numeric_limits<float>::quiet_NaN();
	const float inf = std::numeric_limits<float>::infinity();
	const float most = std::numeric_limits<float>::max();
	for (const float bad : { nan, inf, -inf, most, -most, 1e-40f }) {
		BodyUpdate body;
		body.position = { bad, 1.0f, bad };
		body.velocity = { bad, bad, 2.0f };
		body.spin = { 0.0f, bad, bad };
		body.orientation = { bad, bad, bad, bad };
		const BodyState state = quantise_body(body);
		CHECK(state.position[1] == 1000);
		CHECK(passes(state, nullptr, 0, RATE));
		BodyUpdate found;
		restore_body(state, found);
		CHECK(found.position.is_finite() && found.velocity.is_finite() && found.spin.is_finite());
		CHECK_NEAR(found.orientation.w, 1.0, 1e-6);
	}
	BodyUpdate none;
	none.orientation = { 0.0f, 0.0f, 0.0f, 0.0f };
	CHECK(quantise_body(none).turn == RotationCode());
}

TEST(a_body_at_rest_has_no_velocity) {
	BodyUpdate body;
	body.velocity = body.spin = { 1.0f, 2.0f, 3.0f };
	body.at_rest = true;
	const BodyState state = quantise_body(body);
	const std::array<int16_t, 3> zero{};
	CHECK(state.velocity == zero && state.spin == zero && state.at_rest);
	CHECK(passes(state, nullptr, 0, RATE));
}

TEST(positions_are_foreseen_as_by_floats) {
	std::mt19937 random(3);
	double worst_mm = 0.0;
	for (int round = 0; round < 5000; round++) {
		BodyUpdate body;
		body.position = draw_vector(random, 50.0f);
		body.velocity = draw_vector(random, 20.0f);
		const BodyState base = quantise_body(body);
		BodyUpdate restored;
		restore_body(base, restored);
		const int ticks = int(random() % 128);
		const auto position = foresee_position(base, base.velocity, ticks, RATE);
		const Vec3 expected = restored.position + restored.velocity * (float(ticks) / float(RATE));
		for (std::size_t i = 0; i < 3; i++) {
			const float part = i == 0 ? expected.x : (i == 1 ? expected.y : expected.z);
			worst_mm = std::max(worst_mm, std::fabs(double(position[i]) - 1000.0 * double(part)));
		}
	}
	CHECK(worst_mm < 1.0);
}

TEST(turns_are_foreseen_as_by_floats) {
	std::mt19937 random(4);
	double worst_deg = 0.0;
	for (int round = 0; round < 5000; round++) {
		BodyUpdate body;
		body.orientation = people::draw_rotation(random);
		body.spin = draw_vector(random, 4.0f);
		const BodyState base = quantise_body(body);
		BodyUpdate restored;
		restore_body(base, restored);
		const int ticks = int(random() % 13);
		const Quat expected =
				(kinematics::exp(restored.spin * (float(ticks) / float(RATE))) * restored.orientation).normalized();
		// In the terms of the component that is largest in truth, as an encoder asks.
		BodyUpdate turned;
		turned.orientation = expected;
		BodyState state;
		state.turn.dropped = quantise_body(turned).turn.dropped;
		state.turn.parts = foresee_turn(base, base.spin, ticks, RATE, int(state.turn.dropped));
		BodyUpdate found;
		restore_body(state, found);
		worst_deg = std::max(worst_deg, apart_deg(expected, found.orientation));
	}
	CHECK(worst_deg < 0.9);
}

TEST(what_goes_on_as_foreseen_takes_few_bits) {
	BodyUpdate body;
	body.position = { 3.0f, 2.0f, 1.0f };
	body.velocity = { 2.0f, 0.0f, -1.0f };
	body.spin = { 0.0f, 3.0f, 0.0f };
	const BodyState base = quantise_body(body);
	body.position = body.position + body.velocity * 0.1f;
	body.orientation = (kinematics::exp(body.spin * 0.1f) * body.orientation).normalized();
	const BodyState state = quantise_body(body);
	std::array<uint8_t, ROOM> bytes{};
	RangeEncoder encoder(bytes.data(), bytes.size());
	BodyCodec::encode(encoder, state, &base, 6, RATE);
	CHECK(encoder.finish() <= 6);
}

TEST(no_bytes_give_what_is_no_state) {
	std::mt19937 random(5);
	const int64_t farthest = int64_t(FARTHEST_M) * 1000;
	int good = 0;
	int bad = 0;
	for (int round = 0; round < 50000; round++) {
		std::vector<uint8_t> bytes(random() % 40);
		for (uint8_t &byte : bytes) {
			byte = uint8_t(random());
		}
		const BodyState base = extreme(round % 2 == 0 ? 1 : -1, uint8_t(random() % 4));
		BodyState found;
		RangeDecoder decoder(bytes.data(), bytes.size());
		if (!BodyCodec::decode(decoder, random() % 2 == 0 ? &base : nullptr, int(random() % 128), RATE, found)) {
			continue;
		}
		good++;
		for (const int32_t part : found.position) {
			bad += std::abs(int64_t(part)) <= farthest ? 0 : 1;
		}
		for (const int16_t part : found.turn.parts) {
			bad += std::abs(int(part)) <= BODY_TURN_SCALE && found.turn.dropped < 4 ? 0 : 1;
		}
		BodyUpdate body;
		restore_body(found, body);
		bad += body.position.is_finite() && std::fabs(body.orientation.dot(body.orientation) - 1.0f) < 1e-4f ? 0 : 1;
	}
	CHECK(good > 0);
	CHECK(bad == 0);
}

} // namespace test_body_codec
