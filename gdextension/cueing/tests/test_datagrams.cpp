// SPDX-License-Identifier: MIT
#include <datagrams.hpp>

#include "check.hpp"

#include <cstring>
#include <string>

namespace test_datagrams {

using namespace cueing;

namespace {

CueMessage example() {
	CueMessage message;
	message.sequence = 0x01020304U;
	message.tick = 777;
	message.time_usec = 0x0102030405ULL;
	message.is_paused = true;
	message.is_stale = true;
	message.gain = 0.5;
	// A quarter turn to the left: it looks along -X.
	message.motion.orientation = kinematics::exp({ 0.0f, 1.57079633f, 0.0f });
	message.motion.position = { 1.0, 2.0, -3.0 };
	message.motion.velocity = { -8.0, 0.0, 0.0 };
	message.motion.acceleration = { 4.0, 2.0, 0.0 };
	message.motion.felt.specific_force = { 0.0, 11.81, 4.0 };
	message.motion.felt.rates = { 0.0, 0.0, -2.0 };
	message.cue.position = { 0.0625, -0.125, 0.25 };
	message.cue.attitude = { -0.5, 0.25, 0.125 };
	return message;
}

std::string hex(const std::array<uint8_t, MAX_DATAGRAM> &p_bytes, std::size_t p_from, std::size_t p_size) {
	static const char digits[] = "0123456789abcdef";
	std::string text;
	for (std::size_t i = p_from; i < p_from + p_size; i++) {
		text += digits[p_bytes[i] >> 4];
		text += digits[p_bytes[i] & 15];
	}
	return text;
}

float number(const std::array<uint8_t, MAX_DATAGRAM> &p_bytes, std::size_t p_at) {
	uint32_t bits = 0;
	for (int i = 3; i >= 0; i--) {
		bits = (bits << 8) | p_bytes[p_at + std::size_t(i)];
	}
	float value = 0.0f;
	static_assert(sizeof(value) == sizeof(bits), "32 bits");
	std::memcpy(&value, &bits, sizeof(value));
	return value;
}

} // namespace

TEST(our_datagram_has_every_byte_where_it_is_documented) {
	std::array<uint8_t, MAX_DATAGRAM> bytes{};
	CHECK(encode_cue(example(), bytes) == CUE_SIZE);
	CHECK(hex(bytes, 0, 24) ==
			"44534d43"
			"0100"
			"0500"
			"04030201"
			"09030000"
			"0504030201000000");
	CHECK_NEAR(number(bytes, 28), 0.70710678, 1e-6);
	CHECK_NEAR(number(bytes, 36), 0.70710678, 1e-6);
	CHECK_NEAR(number(bytes, 44), 11.81, 1e-6);
	CHECK_NEAR(number(bytes, 48), 4.0, 0.0);
	CHECK_NEAR(number(bytes, 60), -2.0, 0.0);
	CHECK(hex(bytes, 64, 24) == "0000803d000000be0000803e000000bf0000803e0000003e");
	CHECK(hex(bytes, 88, 8) == "0000003f00000000");
	// The last four bytes make the CRC of the whole what it always is.
	uint32_t rest = 0xffffffffU;
	for (std::size_t i = 0; i < CUE_SIZE; i++) {
		rest ^= bytes[i];
		for (int bit = 0; bit < 8; bit++) {
			rest = (rest >> 1) ^ ((rest & 1U) != 0 ? 0xedb88320U : 0U);
		}
	}
	CHECK(rest == 0xdebb20e3U);
}

TEST(a_teleport_is_the_second_flag) {
	CueMessage message;
	message.has_teleported = true;
	std::array<uint8_t, MAX_DATAGRAM> bytes{};
	encode_cue(message, bytes);
	CHECK(hex(bytes, 6, 2) == "0200");
}

TEST(outsim_is_in_its_own_frame) {
	std::array<uint8_t, MAX_DATAGRAM> bytes{};
	CueMessage message = example();
	message.gain = 1.0;
	CHECK(encode_outsim(message, -1, bytes) == OUTSIM_SIZE);
	CHECK(hex(bytes, 0, 4) ==
			hex({ uint8_t(0x0102030405ULL / 1000), uint8_t((0x0102030405ULL / 1000) >> 8),
						uint8_t((0x0102030405ULL / 1000) >> 16), uint8_t((0x0102030405ULL / 1000) >> 24) },
					0, 4));
	// It rolls with its right side going down about where it looks: OutSim's -X.
	CHECK_NEAR(number(bytes, 4), -2.0, 1e-5);
	CHECK_NEAR(number(bytes, 8), 0.0, 1e-5);
	// Heading to the left, level.
	CHECK_NEAR(number(bytes, 16), 1.5707963, 1e-5);
	CHECK_NEAR(number(bytes, 20), 0.0, 1e-5);
	CHECK_NEAR(number(bytes, 24), 0.0, 1e-5);
	// It goes to -X and brakes; the ground lifts it.
	CHECK_NEAR(number(bytes, 28), 4.0, 1e-5);
	CHECK_NEAR(number(bytes, 36), 2.0, 1e-5);
	CHECK_NEAR(number(bytes, 40), -8.0, 1e-5);
	CHECK(hex(bytes, 52, 12) == "000001000000030000000200");
	CHECK(encode_outsim(message, 258, bytes) == OUTSIM_ID_SIZE);
	CHECK(hex(bytes, 64, 4) == "02010000");
}

TEST(outsims_angles_have_their_signs) {
	std::array<uint8_t, MAX_DATAGRAM> bytes{};
	CueMessage message;
	message.gain = 1.0;
	message.motion.orientation = kinematics::exp({ 0.25f, 0.0f, 0.0f });
	encode_outsim(message, -1, bytes);
	CHECK_NEAR(number(bytes, 20), 0.25, 1e-5);
	message.motion.orientation = kinematics::exp({ 0.0f, 0.0f, -0.25f });
	encode_outsim(message, -1, bytes);
	CHECK_NEAR(number(bytes, 24), 0.25, 1e-5);
	// On a ramp to neutral they fade.
	message.gain = 0.0;
	encode_outsim(message, -1, bytes);
	CHECK_NEAR(number(bytes, 24), 0.0, 0.0);
}

TEST(positions_beyond_outsims_room_stay_at_its_edge) {
	std::array<uint8_t, MAX_DATAGRAM> bytes{};
	CueMessage message;
	message.motion.position = { 1e6, 0.0, 1e6 };
	encode_outsim(message, -1, bytes);
	CHECK(hex(bytes, 52, 8) == "ffffff7f01000080");
}

} // namespace test_datagrams
