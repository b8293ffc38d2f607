// SPDX-License-Identifier: MIT
#include "mover_state.hpp"

#include <cmath>
#include <cstring>

namespace mover {

namespace {

constexpr float FARTHEST = 100000.0f; // m, m/s

std::uint32_t bits_of(float p_number) {
	std::uint32_t bits = 0;
	std::memcpy(&bits, &p_number, sizeof(bits));
	return bits;
}

float number_of(std::uint32_t p_bits) {
	float number = 0.0f;
	std::memcpy(&number, &p_bits, sizeof(number));
	return number;
}

/// Writes or reads the numbers one after the other, so that both have the same order.
template <typename T_STATE, typename T_NUMBER, typename T_COUNT>
void visit(T_STATE &r_state, T_NUMBER p_number, T_COUNT p_count) {
	const auto vector = [&p_number](auto &r_vector) {
		p_number(r_vector.x);
		p_number(r_vector.y);
		p_number(r_vector.z);
	};
	vector(r_state.position);
	vector(r_state.velocity);
	p_number(r_state.heading);
	p_count(r_state.is_grounded, 2);
	p_count(r_state.stance, STANCES);
	p_count(r_state.mode, MODES);
	p_count(r_state.has_jumped, 2);
	p_number(r_state.lift);
	p_number(r_state.time);
	vector(r_state.from);
	vector(r_state.to);
	vector(r_state.normal);
	p_count(r_state.carrier, 65536);
	vector(r_state.local);
	p_number(r_state.local_heading);
	p_number(r_state.hold.x);
	p_number(r_state.hold.z);
}

} // namespace

State::Words State::words() const {
	Words words{};
	std::size_t at = 0;
	visit(
			*this, [&](const float &p_number) { words[at++] = bits_of(p_number); },
			[&](const auto &p_count, std::uint32_t) { words[at++] = std::uint32_t(p_count); });
	return words;
}

bool State::read(const Words &p_words) {
	State fresh;
	bool is_sound = true;
	std::size_t at = 0;
	visit(
			fresh,
			[&](float &r_number) {
				r_number = number_of(p_words[at++]);
				// A comparison that NaN fails, too.
				is_sound = is_sound && std::fabs(r_number) < FARTHEST;
			},
			[&](auto &r_count, std::uint32_t p_end) {
				const std::uint32_t count = p_words[at++];
				is_sound = is_sound && count < p_end;
				r_count = std::decay_t<decltype(r_count)>(is_sound ? count : 0);
			});
	if (is_sound) {
		*this = fresh;
	}
	return is_sound;
}

std::uint16_t State::check() const {
	std::uint32_t hash = 2166136261u; // FNV-1a (Fowler, Noll, Vo), a number at a time.
	for (const std::uint32_t word : words()) {
		hash = (hash ^ word) * 16777619u;
		hash ^= hash >> 15;
	}
	return std::uint16_t(hash ^ (hash >> 16));
}

} // namespace mover
