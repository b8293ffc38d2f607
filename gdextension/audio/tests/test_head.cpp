// SPDX-License-Identifier: MIT
#include <head.hpp>

#include <check.hpp>
#include <test_data.hpp>

#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace test_head {

using namespace audio;

namespace {

constexpr float RATE = 48000.0f;
constexpr double PI = 3.14159265358979;

std::vector<char> read_file() {
	std::ifstream file(std::string(test_data::SOURCES) + "/../assets/sound/head/mit_kemar.sofa", std::ios::binary);
	return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}

template <class Taps>
double power(const Taps &p_taps) {
	double sum = 0.0;
	for (const float tap : p_taps) {
		sum += double(tap) * double(tap);
	}
	return sum;
}

/// By how many frames the left ear hears later: where the responses fit best.
template <class Taps>
double delay(const Taps &p_left, const Taps &p_right) {
	const int count = int(p_left.size());
	double best = -1.0;
	int found = 0;
	for (int lag = -60; lag <= 60; lag++) {
		double sum = 0.0;
		for (int i = 0; i < count; i++) {
			const int at = i + lag;
			sum += at >= 0 && at < count ? double(p_right[std::size_t(i)]) * double(p_left[std::size_t(at)]) : 0.0;
		}
		if (sum > best) {
			best = sum;
			found = lag;
		}
	}
	return double(found);
}

struct Way {
	float x;
	float z;
};

Way to_the_right(double p_degrees) {
	return { float(std::sin(p_degrees * PI / 180.0)), float(-std::cos(p_degrees * PI / 180.0)) };
}

} // namespace

TEST(the_cues_are_those_of_the_measured_head) {
	Head head;
	CHECK(head.open(read_file(), RATE).empty());
	for (const double degrees : { 30.0, 60.0, 90.0 }) {
		const Way way = to_the_right(degrees);
		const Ears ears = head.find(way.x, 0.0f, way.z);
		std::vector<float> left;
		std::vector<float> right;
		head.find_whole(way.x, 0.0f, way.z, left, right);
		const double lag = delay(left, right);
		const double level = 10.0 * std::log10(power(right) / power(left));
		CHECK(lag > 5.0);
		CHECK(level > 3.0);
		CHECK_NEAR(delay(ears.left, ears.right) / lag, 1.0, 0.1);
		CHECK_NEAR(10.0 * std::log10(power(ears.right) / power(ears.left)) / level, 1.0, 0.1);
		CHECK_NEAR(power(ears.right) / power(right), 1.0, 0.1);
	}
}

TEST(left_and_right_are_not_exchanged_and_ahead_is_even) {
	Head head;
	head.open(read_file(), RATE);
	const Ears right = head.find(1.0f, 0.0f, 0.0f);
	const Ears left = head.find(-1.0f, 0.0f, 0.0f);
	CHECK(power(right.right) > 4.0 * power(right.left));
	CHECK(power(left.left) > 4.0 * power(left.right));
	const Ears ahead = head.find(0.0f, 0.0f, -1.0f);
	CHECK_NEAR(delay(ahead.left, ahead.right), 0.0, 1.1);
	CHECK_NEAR(10.0 * std::log10(power(ahead.left) / power(ahead.right)), 0.0, 1.0);
}

TEST(ahead_behind_above_and_below_differ) {
	Head head;
	head.open(read_file(), RATE);
	const Ears ahead = head.find(0.0f, 0.0f, -1.0f);
	for (const Ears &other :
			{ head.find(0.0f, 0.0f, 1.0f), head.find(0.0f, 1.0f, 0.0f), head.find(0.0f, -0.6f, -0.8f) }) {
		double difference = 0.0;
		for (std::size_t i = 0; i < TAPS; i++) {
			difference += std::pow(double(other.left[i] - ahead.left[i]), 2.0);
		}
		CHECK(difference > 0.1 * power(ahead.left));
	}
}

TEST(a_direction_that_is_none_is_ahead) {
	Head head;
	head.open(read_file(), RATE);
	const Ears ahead = head.find(0.0f, 0.0f, -1.0f);
	const float nan = std::numeric_limits<float>::quiet_NaN();
	CHECK(head.find(0.0f, 0.0f, 0.0f).left == ahead.left);
	CHECK(head.find(nan, 0.0f, 1.0f).left == ahead.left);
}

TEST(files_that_are_no_head_are_refused) {
	Head head;
	CHECK(!head.open({}, RATE).empty());
	CHECK(!head.open(std::vector<char>(5000, 'x'), RATE).empty());
	const std::vector<char> good = read_file();
	CHECK(!head.open(good, 10.0f).empty());
	CHECK(!head.open(good, std::numeric_limits<float>::quiet_NaN()).empty());
	for (const std::size_t size : { std::size_t(100), good.size() / 3, good.size() - 1000 }) {
		const std::vector<char> cut(good.begin(), good.begin() + std::ptrdiff_t(size));
		CHECK(!head.open(cut, RATE).empty());
		CHECK(power(head.find(1.0f, 0.0f, 0.0f).left) == 0.0);
	}
	CHECK(head.open(good, RATE).empty());
}

} // namespace test_head
