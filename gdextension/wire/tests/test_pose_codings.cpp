// SPDX-License-Identifier: MIT
#include "people.hpp"

#include <check.hpp>
#include <coding/pose_codings.hpp>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

namespace test_pose_codings {

using namespace wire;

namespace {

constexpr PoseCoding ALL[4] = { PoseCoding::FLOATS, PoseCoding::THESIS_12, PoseCoding::THESIS_4,
	PoseCoding::SMALLEST_3 };

// The greatest error of many rotations, degrees; -1 if one is lost.
double worst_error(PoseCoding p_coding, int p_bits, const std::vector<Quat> &p_rotations) {
	double worst = 0.0;
	for (const Quat &rotation : p_rotations) {
		std::array<uint8_t, 16> bytes{};
		PersonPose wanted;
		PersonPose found;
		wanted.orientations[0] = rotation;
		const std::size_t size = coded_size(p_coding, p_bits, 1);
		if (!encode_pose(p_coding, p_bits, &rotation, 1, bytes.data()) || coded_limbs(p_coding, p_bits, size) != 1 ||
				!decode_pose(p_coding, p_bits, bytes.data(), size, found.orientations.data())) {
			return -1.0;
		}
		worst = std::max(worst, people::error_of(wanted, found, 1));
	}
	return worst;
}

std::vector<Quat> many_rotations() {
	std::mt19937 random(1);
	std::vector<Quat> rotations;
	const float root = std::sqrt(0.5f);
	rotations.reserve(20020);
	for (int i = 0; i < 20000; i++) {
		rotations.push_back(people::draw_rotation(random));
	}
	for (const float sign : { -1.0f, 1.0f }) {
		rotations.push_back({ 0.0f, 0.0f, 0.0f, sign });
		rotations.push_back({ sign, 0.0f, 0.0f, 0.0f });
		rotations.push_back({ 0.0f, sign, 0.0f, 0.0f });
		rotations.push_back({ 0.0f, 0.0f, sign, 0.0f });
		rotations.push_back({ sign * root, root, 0.0f, 0.0f });
		rotations.push_back({ 0.0f, sign * root, 0.0f, root });
		rotations.push_back({ 0.5f, sign * 0.5f, -0.5f, 0.5f });
	}
	return rotations;
}

bool is_unit(const Quat &p_rotation) {
	return std::fabs(p_rotation.dot(p_rotation) - 1.0f) < 1e-5f;
}

} // namespace

TEST(every_coding_keeps_its_error) {
	const std::vector<Quat> rotations = many_rotations();
	CHECK_NEAR(worst_error(PoseCoding::FLOATS, 15, rotations), 0.0, 1e-4);
	CHECK_NEAR(worst_error(PoseCoding::SMALLEST_3, 15, rotations), 0.003, 0.004);
	CHECK_NEAR(worst_error(PoseCoding::SMALLEST_3, 12, rotations), 0.05, 0.02);
	CHECK_NEAR(worst_error(PoseCoding::SMALLEST_3, 10, rotations), 0.2, 0.08);
	CHECK_NEAR(worst_error(PoseCoding::THESIS_4, 15, rotations), 0.2, 0.1);
	// Close to half a turn w is a small difference of large numbers.
	const double twelve = worst_error(PoseCoding::THESIS_12, 15, rotations);
	CHECK(twelve >= 0.0 && twelve < 0.1);
}

TEST(sizes) {
	CHECK(coded_size(PoseCoding::FLOATS, 15, 16) == 256);
	CHECK(coded_size(PoseCoding::THESIS_12, 15, 16) == 192);
	CHECK(coded_size(PoseCoding::THESIS_4, 15, 16) == 64);
	CHECK(coded_size(PoseCoding::SMALLEST_3, 15, 16) == 94);
	CHECK(coded_size(PoseCoding::SMALLEST_3, 10, 16) == 64);
	for (std::size_t limbs = 1; limbs <= 32; limbs++) {
		for (int bits = MIN_BITS; bits <= MAX_BITS; bits++) {
			const PoseCoding coding = PoseCoding::SMALLEST_3;
			CHECK(coded_limbs(coding, bits, coded_size(coding, bits, limbs)) == limbs);
		}
	}
	CHECK(coded_limbs(PoseCoding::FLOATS, 15, 17) == 0);
}

TEST(what_is_no_rotation_is_refused) {
	std::array<uint8_t, 16> bytes{};
	for (const PoseCoding coding : ALL) {
		for (const float bad : { std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
					 -std::numeric_limits<float>::infinity(), 3.0f }) {
			const Quat rotation{ 0.0f, bad, 0.0f, 0.0f };
			CHECK(!encode_pose(coding, 15, &rotation, 1, bytes.data()));
		}
		const Quat nothing{ 0.0f, 0.0f, 0.0f, 0.0f };
		CHECK(!encode_pose(coding, 15, &nothing, 1, bytes.data()));
	}
}

TEST(any_bytes_are_unit_quaternions_or_refused) {
	std::mt19937 random(2);
	int wrong = 0;
	int good = 0;
	for (int round = 0; round < 400000; round++) {
		const PoseCoding coding = ALL[round % 4];
		const int bits = MIN_BITS + int(random() % (MAX_BITS - MIN_BITS + 1));
		std::array<uint8_t, 64> bytes{};
		for (uint8_t &byte : bytes) {
			byte = uint8_t(random());
		}
		const std::size_t size = 1 + random() % bytes.size();
		std::array<Quat, 64> found{};
		if (!decode_pose(coding, bits, bytes.data(), size, found.data())) {
			continue;
		}
		good++;
		for (std::size_t i = 0; i < coded_limbs(coding, bits, size); i++) {
			wrong += is_unit(found[i]) ? 0 : 1;
		}
	}
	CHECK(wrong == 0);
	CHECK(good > 1000);
}

TEST(a_root_of_less_than_nothing_is_guarded_against) {
	// Squares that add up to a little more than 1, as rounding makes them: w is 0, not undefined.
	const float values[3] = { 0.8f, 0.600001f, 0.0f };
	std::array<uint8_t, 12> bytes{};
	std::memcpy(bytes.data(), values, sizeof(values));
	Quat found;
	CHECK(decode_pose(PoseCoding::THESIS_12, 15, bytes.data(), bytes.size(), &found));
	CHECK(is_unit(found));
	CHECK_NEAR(found.w, 0.0, 1e-6);
}

} // namespace test_pose_codings
