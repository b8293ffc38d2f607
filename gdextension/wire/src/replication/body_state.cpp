// SPDX-License-Identifier: MIT
#include "replication/body_state.hpp"

#include <algorithm>
#include <cmath>

namespace wire {

namespace {

// Scale of quaternions in whole-number arithmetic.
constexpr int64_t ONE = 16384;

using Whole4 = std::array<int64_t, 4>;

int64_t whole_root(int64_t p_square) {
	if (p_square <= 0) {
		return 0;
	}
	int64_t root = int64_t(std::sqrt(double(p_square)));
	while (root * root > p_square) {
		root--;
	}
	while ((root + 1) * (root + 1) <= p_square) {
		root++;
	}
	return root;
}

int64_t divide_rounded(int64_t p_number, int64_t p_by) {
	return p_number >= 0 ? (p_number + p_by / 2) / p_by : -((-p_number + p_by / 2) / p_by);
}

int64_t to_lattice(float p_value, float p_scale, float p_most) {
	return std::isfinite(p_value) ? std::llround(std::clamp(p_value, -p_most, p_most) * p_scale) : 0;
}

RotationCode quantise_turn(const Quat &p_turn) {
	const std::array<float, 4> parts{ p_turn.x, p_turn.y, p_turn.z, p_turn.w };
	RotationCode code;
	const float square = p_turn.dot(p_turn);
	// Written so that NaN fails too.
	if (!(square > 1e-6f && square < 1e12f)) {
		return code;
	}
	for (std::size_t i = 0; i < 3; i++) {
		code.dropped = std::fabs(parts[i]) > std::fabs(parts[code.dropped]) ? uint8_t(i) : code.dropped;
	}
	const float scale = std::copysign(1.0f, parts[code.dropped]) / std::sqrt(square);
	for (std::size_t i = 0, at = 0; i < 4; i++) {
		if (i != code.dropped) {
			code.parts[at++] = int16_t(std::lround(parts[i] * scale * float(BODY_TURN_SCALE)));
		}
	}
	return code;
}

Whole4 unfold(const RotationCode &p_code) {
	Whole4 turn{};
	int64_t rest = ONE * ONE;
	for (std::size_t i = 0, at = 0; i < 4; i++) {
		if (i != p_code.dropped) {
			turn[i] = divide_rounded(p_code.parts[at++] * ONE, BODY_TURN_SCALE);
			rest -= turn[i] * turn[i];
		}
	}
	turn[p_code.dropped] = whole_root(rest);
	return turn;
}

// A turn by a half angle of up to about a radian: sine and cosine by their series.
Whole4 turn_by(const std::array<int64_t, 3> &p_half) {
	const int64_t square = (p_half[0] * p_half[0] + p_half[1] * p_half[1] + p_half[2] * p_half[2]) / ONE;
	const int64_t ratio = ONE - square / 6 + square * square / ONE / 120;
	return { p_half[0] * ratio / ONE, p_half[1] * ratio / ONE, p_half[2] * ratio / ONE,
		ONE - square / 2 + square * square / ONE / 24 };
}

Whole4 multiply(const Whole4 &p_a, const Whole4 &p_b) {
	Whole4 product{
		p_a[3] * p_b[0] + p_a[0] * p_b[3] + p_a[1] * p_b[2] - p_a[2] * p_b[1],
		p_a[3] * p_b[1] + p_a[1] * p_b[3] + p_a[2] * p_b[0] - p_a[0] * p_b[2],
		p_a[3] * p_b[2] + p_a[2] * p_b[3] + p_a[0] * p_b[1] - p_a[1] * p_b[0],
		p_a[3] * p_b[3] - p_a[0] * p_b[0] - p_a[1] * p_b[1] - p_a[2] * p_b[2],
	};
	for (int64_t &part : product) {
		part /= ONE;
	}
	return product;
}

} // namespace

BodyState quantise_body(const BodyUpdate &p_body) {
	BodyState state;
	const std::array<const Vec3 *, 3> vectors{ &p_body.position, &p_body.velocity, &p_body.spin };
	for (std::size_t i = 0; i < 3; i++) {
		const auto part = [i](const Vec3 &p_vector) {
			return i == 0 ? p_vector.x : (i == 1 ? p_vector.y : p_vector.z);
		};
		state.position[i] = int32_t(to_lattice(part(*vectors[0]), 1000.0f, FARTHEST_M));
		if (!p_body.at_rest) {
			state.velocity[i] = int16_t(to_lattice(part(*vectors[1]), float(BODY_VELOCITY_SCALE), 500.0f));
			state.spin[i] = int16_t(to_lattice(part(*vectors[2]), float(BODY_SPIN_SCALE), 2000.0f));
		}
	}
	state.turn = quantise_turn(p_body.orientation);
	state.at_rest = p_body.at_rest;
	return state;
}

void restore_body(const BodyState &p_state, BodyUpdate &r_body) {
	const auto vector = [](const auto &p_parts, float p_unit) {
		return Vec3{ float(p_parts[0]) * p_unit, float(p_parts[1]) * p_unit, float(p_parts[2]) * p_unit };
	};
	r_body.position = vector(p_state.position, 0.001f);
	r_body.velocity = vector(p_state.velocity, 1.0f / float(BODY_VELOCITY_SCALE));
	r_body.spin = vector(p_state.spin, 1.0f / float(BODY_SPIN_SCALE));
	const Whole4 turn = unfold(p_state.turn);
	const Quat orientation{ float(turn[0]), float(turn[1]), float(turn[2]), float(turn[3]) };
	r_body.orientation = orientation.normalized();
	r_body.at_rest = p_state.at_rest;
}

std::array<int32_t, 3> foresee_position(
		const BodyState &p_base, const std::array<int16_t, 3> &p_velocity, int p_ticks, int p_tick_rate) {
	std::array<int32_t, 3> position{};
	for (std::size_t i = 0; i < 3; i++) {
		const int64_t twice = int64_t(p_base.velocity[i]) + p_velocity[i];
		const int64_t displacement = divide_rounded(twice * p_ticks * 1000, 2LL * BODY_VELOCITY_SCALE * p_tick_rate);
		position[i] = int32_t(p_base.position[i] + displacement);
	}
	return position;
}

std::array<int16_t, 3> foresee_turn(
		const BodyState &p_base, const std::array<int16_t, 3> &p_spin, int p_ticks, int p_tick_rate, int p_dropped) {
	Whole4 turn = unfold(p_base.turn);
	std::array<int64_t, 3> half{};
	bool is_small = true;
	for (std::size_t i = 0; i < 3; i++) {
		const int64_t twice = int64_t(p_base.spin[i]) + p_spin[i];
		half[i] = divide_rounded(twice * p_ticks * ONE, 4LL * BODY_SPIN_SCALE * p_tick_rate);
		is_small = is_small && std::abs(half[i]) < ONE;
	}
	// Beyond that nobody knows how far it has turned.
	if (is_small) {
		turn = multiply(turn_by(half), turn);
	}
	const std::size_t dropped = std::size_t(p_dropped);
	const int64_t length = whole_root(turn[0] * turn[0] + turn[1] * turn[1] + turn[2] * turn[2] + turn[3] * turn[3]);
	const int64_t sign = turn[dropped] < 0 ? -1 : 1;
	std::array<int16_t, 3> parts{};
	for (std::size_t i = 0, at = 0; i < 4; i++) {
		if (i != dropped) {
			parts[at++] = int16_t(divide_rounded(turn[i] * sign * BODY_TURN_SCALE, std::max<int64_t>(length, 1)));
		}
	}
	return parts;
}

} // namespace wire
