// SPDX-License-Identifier: MIT
#include <check.hpp>
#include <coding/number_model.hpp>

#include <array>
#include <random>
#include <vector>

namespace test_number_model {

using namespace wire;

namespace {

constexpr int MAX = NumberSymbols::MAX_BUCKETS;

/// As docs/wire-coding.md has it: steps that halve.
int log16_by_steps(uint64_t p_number) {
	int whole = 0;
	uint64_t rest = p_number;
	for (int step = 32; step > 0; step >>= 1) {
		if ((rest >> step) != 0) {
			rest >>= step;
			whole += step;
		}
	}
	const uint64_t mantissa = whole >= 4 ? p_number >> (whole - 4) : p_number << (4 - whole);
	return 16 * whole + LOG16_OF_MANTISSA[mantissa & 15];
}

/// A distribution whose tail gets thinner.
std::array<uint16_t, SHARE_POINTS> shares() {
	std::array<uint16_t, SHARE_POINTS> made{};
	double rest = 1.0;
	for (std::size_t i = 1; i < made.size(); i++) {
		rest *= 0.9;
		made[i] = uint16_t((1.0 - rest) * 32000.0);
	}
	return made;
}

NumberModel draw(std::mt19937 &p_random, const std::array<uint16_t, SHARE_POINTS> &p_shares) {
	NumberModel model;
	model.shares = p_shares.data();
	model.step = 1 + int(p_random() % 2);
	model.first = model.step > 1 ? int64_t(p_random() % 2) : 0;
	model.level = int(p_random() % 300) - 20;
	model.expected = int64_t(p_random() % 2000000) - 1000000;
	return model;
}

} // namespace

TEST(a_logarithm_is_that_of_the_highest_bit) {
	std::mt19937 random(3);
	for (uint64_t number = 1; number < 5000; number++) {
		CHECK(log16(number) == log16_by_steps(number));
	}
	for (int i = 0; i < 5000; i++) {
		const uint64_t number = ((uint64_t(random()) << 32 | random()) >> (random() % 64)) | 1;
		CHECK(log16(number) == log16_by_steps(number));
	}
	CHECK(log16(UINT64_MAX) == log16_by_steps(UINT64_MAX));
}

TEST(every_point_is_in_one_bucket) {
	std::mt19937 random(5);
	const std::array<uint16_t, SHARE_POINTS> distribution = shares();
	for (int i = 0; i < 300; i++) {
		const NumberModel model = draw(random, distribution);
		const NumberSymbols symbols(model);
		CHECK(symbols.below(-MAX) == 0);
		CHECK(symbols.below(MAX + 1) == 1U << PROBABILITY_BITS);
		for (int bucket = -MAX; bucket <= MAX; bucket++) {
			const uint32_t from = symbols.below(bucket);
			const uint32_t end = symbols.below(bucket + 1);
			CHECK(from < end);
			CHECK(symbols.bucket_at(from) == bucket);
			CHECK(symbols.bucket_at(end - 1) == bucket);
			CHECK(symbols.bucket_at(from + (end - from) / 2) == bucket);
		}
	}
}

TEST(the_middle_bucket_has_what_is_expected) {
	std::mt19937 random(7);
	const std::array<uint16_t, SHARE_POINTS> distribution = shares();
	for (int i = 0; i < 5000; i++) {
		const NumberModel model = draw(random, distribution);
		const NumberSymbols symbols(model);
		// Of the numbers that can be the one that is nearest, also below 0.
		int64_t index = model.expected / (16 * model.step);
		const auto distance = [&](int64_t p_index) {
			const int64_t off = 16 * symbols.number_of(p_index) - model.expected;
			return off < 0 ? -off : off;
		};
		while (distance(index + 1) < distance(index)) {
			index++;
		}
		while (distance(index - 1) < distance(index)) {
			index--;
		}
		CHECK(symbols.bucket_of(index) == 0 || distance(index + 1) == distance(index));
		CHECK(symbols.index_of(symbols.number_of(index)) == index);
	}
}

TEST(numbers_come_back_wherever_they_were_expected) {
	std::mt19937 random(11);
	const std::array<uint16_t, SHARE_POINTS> distribution = shares();
	for (int i = 0; i < 200; i++) {
		std::vector<NumberModel> models;
		std::vector<int64_t> numbers;
		std::array<uint8_t, 1024> bytes{};
		RangeEncoder encoder(bytes.data(), bytes.size());
		NumberWriter writer(encoder);
		for (int k = 0; k < 50; k++) {
			models.push_back(draw(random, distribution));
			const NumberModel &model = models.back();
			const int64_t off = int64_t(random() % 2001) - 1000;
			const int64_t near = model.expected / 16 + (k % 5 == 0 ? 1000 * off : off / (1 + k));
			numbers.push_back(model.first + (near / 2) * 2);
			CHECK(writer.number(model, numbers.back()));
		}
		const std::size_t size = encoder.finish();
		RangeDecoder decoder(bytes.data(), size);
		NumberReader reader(decoder);
		for (std::size_t k = 0; k < models.size(); k++) {
			int64_t number = 0;
			CHECK(reader.number(models[k], number));
			CHECK(number == numbers[k]);
		}
		CHECK(decoder.used() == size);
	}
}

} // namespace test_number_model
