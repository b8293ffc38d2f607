// SPDX-License-Identifier: MIT
#include <cue_stream.hpp>

#include "check.hpp"

#include <algorithm>
#include <random>

namespace test_cue_stream {

using namespace cueing;

namespace {

constexpr double TICK_S = 1.0 / 60.0;
constexpr double STEP_S = 1.0 / 200.0;

/// A vehicle that drives a time line, and the stream that is fed from it.
class Drive {
public:
	Drive() {
		const AxisLimits travel{ 0.4, 0.6, 6.0 };
		const AxisLimits attitude{ 0.35, 0.6, 6.0 };
		stream.cueing.set_limits({ travel, travel, travel }, { attitude, attitude, attitude });
		stream.cueing.washout.parameters.horizontal.frequency = 4.0;
	}

	/// Drives on for a time; the acceleration is ahead, m/s^2.
	void run(double p_seconds, double p_ahead = 0.0, bool p_is_heard = true) {
		const double end = _now + p_seconds;
		while (_now < end) {
			_now += STEP_S;
			while (_tick * TICK_S <= _now) {
				_speed += p_ahead * TICK_S;
				_way += _speed * TICK_S;
				_tick++;
				if (p_is_heard) {
					// States come in bunches and late, as frames do.
					SeatState state;
					state.time = 1000.0 + _tick * TICK_S;
					state.position = { _elsewhere, 0.0, -_way };
					stream.push(state, _tick, _now + _late(_random));
				}
			}
			const Pose before = stream.message().cue;
			stream.step(_now);
			for (int axis = 0; axis < 3; axis++) {
				fastest = std::max(
						fastest, std::fabs(stream.message().cue.position[axis] - before.position[axis]) / STEP_S);
				hardest = std::max(hardest, std::fabs(stream.message().motion.felt.specific_force[axis]));
			}
		}
	}
	void jump(double p_metres) { _elsewhere += p_metres; }

	CueStream stream;
	double fastest = 0.0;
	double hardest = 0.0;

private:
	std::mt19937 _random{ 3 };
	std::uniform_real_distribution<double> _late{ 0.0, 0.012 };
	double _now = 50.0;
	uint32_t _tick = 3000;
	double _speed = 0.0;
	double _way = 0.0;
	double _elsewhere = 0.0;
};

} // namespace

TEST(a_drive_is_felt_as_it_is) {
	Drive drive;
	drive.run(3.0);
	CHECK_NEAR(drive.stream.message().motion.felt.specific_force[2], 0.0, 0.05);
	CHECK_NEAR(drive.stream.message().gain, 1.0, 1e-9);
	drive.run(3.0, 2.0);
	// Ahead is -Z, and what is felt is the push from behind.
	CHECK_NEAR(drive.stream.message().motion.felt.specific_force[2], -2.0, 0.1);
	CHECK(drive.stream.message().cue.attitude[0] > 0.06);
	CHECK_NEAR(drive.stream.message().motion.velocity[2], -5.9, 0.2);
	CHECK(drive.hardest < GRAVITY + 0.2);
	CHECK(!drive.stream.message().is_stale);
}

TEST(messages_are_numbered_and_timed) {
	Drive drive;
	drive.run(1.0);
	const CueMessage before = drive.stream.message();
	drive.run(0.5);
	const CueMessage after = drive.stream.message();
	CHECK(after.sequence == before.sequence + 100);
	CHECK_NEAR(double(after.time_usec - before.time_usec), 500000.0, 10.0);
	CHECK(after.tick > before.tick + 25);
}

TEST(silence_leads_to_neutral_and_back) {
	Drive drive;
	drive.run(3.0);
	drive.run(3.0, 2.0);
	CHECK(std::fabs(drive.stream.message().cue.attitude[0]) > 0.05);
	drive.run(0.19, 2.0, false);
	CHECK(!drive.stream.message().is_stale);
	drive.run(0.05, 2.0, false);
	CHECK(drive.stream.message().is_stale);
	drive.run(2.0, 2.0, false);
	CHECK_NEAR(drive.stream.message().cue.attitude[0], 0.0, 1e-4);
	CHECK_NEAR(drive.stream.message().gain, 0.0, 1e-9);
	drive.run(4.0, 2.0);
	CHECK(std::fabs(drive.stream.message().cue.attitude[0]) > 0.05);
}

TEST(a_jump_is_noticed_and_makes_no_step) {
	for (const bool is_announced : { false, true }) {
		Drive drive;
		drive.run(3.0);
		drive.run(3.0, 2.0);
		drive.fastest = 0.0;
		drive.hardest = 0.0;
		drive.jump(is_announced ? 0.4 : 300.0);
		if (is_announced) {
			drive.stream.teleport(56.0);
		}
		drive.run(0.1, 2.0);
		CHECK(drive.stream.message().has_teleported);
		drive.run(1.2, 2.0);
		CHECK(!drive.stream.message().has_teleported);
		drive.run(4.0, 0.0);
		CHECK(drive.fastest < 0.25);
		CHECK(drive.hardest < GRAVITY + 0.3);
		CHECK_NEAR(drive.stream.message().gain, 1.0, 1e-9);
	}
}

TEST(a_pause_is_shown) {
	Drive drive;
	drive.run(3.0);
	drive.stream.set_paused(true);
	drive.run(2.1);
	CHECK(drive.stream.message().is_paused);
	CHECK_NEAR(drive.stream.message().gain, 0.0, 1e-9);
	drive.stream.set_paused(false);
	drive.run(2.1);
	CHECK(!drive.stream.message().is_paused);
	CHECK_NEAR(drive.stream.message().gain, 1.0, 1e-9);
}

} // namespace test_cue_stream
