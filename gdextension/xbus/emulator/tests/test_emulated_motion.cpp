// SPDX-License-Identifier: MIT
// Motion streams, and what sensors make of them.
#include "check.hpp"
#include "suit/tracker.hpp"

#include <cstring>

namespace test_emulated_motion {

using emulator::MotionStream;
using emulator::Mounting;
using emulator::Random;
using emulator::Reading;
using emulator::Tracker;
using kinematics::Quat;
using kinematics::Vec3;

namespace {

/// A stream of one limb: turns about the vertical with `p_rate` rad/s, or goes up with `p_push` m/s2.
std::vector<uint8_t> make_stream(float p_rate, float p_push, uint32_t p_frames = 200, uint32_t p_loop = 100) {
	std::vector<uint8_t> bytes;
	const auto put = [&bytes](const void *p_value, std::size_t p_size) {
		const auto *raw = static_cast<const uint8_t *>(p_value);
		bytes.insert(bytes.end(), raw, raw + p_size);
	};
	const uint32_t head[] = { 1, 1 };
	const double rate = 100.0;
	const uint32_t frames[] = { p_frames, p_loop };
	const char name[32] = "pelvis";
	put("XBMOTION", 8);
	put(head, sizeof(head));
	put(&rate, sizeof(rate));
	put(frames, sizeof(frames));
	put(name, sizeof(name));
	for (uint32_t i = 0; i < p_frames; i++) {
		const float time = float(i) / 100.0F;
		const float half = p_rate * time / 2.0F;
		const float key[] = { std::cos(half), 0.0F, 0.0F, std::sin(half), 0.0F, 0.0F, p_push * time * time / 2.0F };
		put(key, sizeof(key));
	}
	return bytes;
}

Tracker tracker_with(const Mounting &p_mounting) {
	Tracker tracker;
	tracker.mounting = p_mounting;
	return tracker;
}

} // namespace

TEST(a_broken_stream_is_refused_with_a_reason) {
	const std::vector<uint8_t> good = make_stream(1.0F, 0.0F);
	MotionStream stream;
	CHECK(stream.parse(good).empty());
	CHECK(stream.limb_name(0) == "pelvis" && stream.frame_count() == 200);
	for (std::size_t size = 0; size < good.size(); size += 7) {
		CHECK(!stream.parse({ good.begin(), good.begin() + std::ptrdiff_t(size) }).empty());
	}
	for (const std::size_t at : { std::size_t(0), std::size_t(8), std::size_t(12), std::size_t(23), std::size_t(27),
				 std::size_t(31), std::size_t(67) }) {
		std::vector<uint8_t> bad = good;
		bad[at] = 0xFF;
		CHECK(!stream.parse(bad).empty());
	}
}

TEST(the_loop_goes_on_for_ever) {
	MotionStream stream;
	CHECK(stream.parse(make_stream(1.0F, 0.0F)).empty());
	CHECK_NEAR(stream.lead_in_s(), 1.0, 1e-9);
	for (const double time : { 1.25, 1.5, 1.75 }) {
		const Quat once = stream.at(0, time).orientation;
		for (const int round : { 1, 7, 100000 }) {
			CHECK_NEAR(angle_between(once, stream.at(0, time + round).orientation), 0.0, 1e-3);
		}
	}
}

TEST(rates_and_accelerations_follow_from_the_motion) {
	MotionStream stream;
	CHECK(stream.parse(make_stream(2.0F, 3.0F)).empty());
	Random random(1);
	for (uint64_t seed = 0; seed < 50; seed++) {
		Random chance(seed);
		const Tracker tracker = tracker_with(Mounting::random(chance, 1.0));
		const Reading now = tracker.read(stream, 0.5, true, random);
		const Reading later = tracker.read(stream, 0.501, true, random);
		const Vec3 turned = log(now.orientation.inverse() * later.orientation) * 1000.0F;
		CHECK_NEAR(turned.x, now.rate[0], 0.01);
		CHECK_NEAR(turned.y, now.rate[1], 0.01);
		CHECK_NEAR(turned.z, now.rate[2], 0.01);
		// In the world: gravity and the push, straight up; the field points north and down.
		const Vec3 felt = { float(now.acceleration[0]), float(now.acceleration[1]), float(now.acceleration[2]) };
		const Vec3 world = now.orientation.rotate(felt);
		CHECK_NEAR(world.x, 0.0, 0.01);
		CHECK_NEAR(world.z, 12.81, 0.01);
	}
}

TEST(who_holds_still_feels_gravity_alone) {
	MotionStream stream;
	CHECK(stream.parse(make_stream(2.0F, 3.0F)).empty());
	Random random(1);
	const Reading held = tracker_with(Mounting()).read(stream, 0.5, false, random);
	CHECK_NEAR(held.rate[2], 0.0, 1e-6);
	CHECK_NEAR(held.acceleration[2], 9.81, 1e-4);
}

TEST(a_sensor_says_its_mounting_and_its_north) {
	const MotionStream stream = MotionStream::still(1);
	Random random(3);
	for (uint64_t seed = 0; seed < 50; seed++) {
		Random chance(seed);
		const Mounting mounting = Mounting::random(chance, 0.5);
		const Reading reading = tracker_with(mounting).read(stream, 5.0, true, random);
		const auto half = float(mounting.heading / 2.0);
		const Quat expected = Quat{ 0.0F, 0.0F, std::sin(half), std::cos(half) } * mounting.rotation;
		CHECK_NEAR(angle_between(expected, reading.orientation), 0.0, 1e-3);
	}
}

} // namespace test_emulated_motion
