// SPDX-License-Identifier: MIT
#include <drift_state.hpp>

#include <check.hpp>

#include <cmath>

namespace test_drift_state {

using namespace heading;

TEST(what_grows_evenly_is_drift) {
	DriftState state;
	const double rate = degrees(5.0) / 60.0;
	for (int i = 1; i <= 300; i++) {
		state.predict(2.0);
		const Angle angle{ 4, 3, 4, false };
		const double seen = 0.3 + rate * 2.0 * i;
		if (i == 1) {
			state.begin(angle, seen, degrees(2.0) * degrees(2.0));
		} else {
			state.observe(angle, seen, degrees(2.0) * degrees(2.0));
		}
	}
	CHECK(std::abs(state.drift(4) - state.drift(3) - rate * 600.0) < degrees(3.0));
	// Nobody can say which of the two drifts: both do by half.
	CHECK(std::abs(state.drift(4) + state.drift(3)) < degrees(0.1));
	CHECK(state.rate_deviation(4) < degrees(4.0) / 60.0);
}

TEST(another_posture_is_no_drift) {
	DriftState state;
	for (int i = 1; i <= 100; i++) {
		state.predict(2.0);
		const Angle angle{ 1, 0, 1, false };
		const double variance = degrees(1.0) * degrees(1.0);
		if (i == 1 || i == 50) {
			state.begin(angle, i < 50 ? 0.0 : 0.6, variance);
		} else {
			state.observe(angle, i < 50 ? 0.0 : 0.6, variance);
		}
	}
	CHECK(std::abs(state.drift(1)) < degrees(0.1));
}

TEST(pulls_tell_drifts_and_levers_apart) {
	DriftState state;
	double drift = 0.0;
	const double lever = 0.04;
	for (int i = 1; i <= 200; i++) {
		state.predict(1.0);
		drift += degrees(0.05);
		// An acceleration that swings, and a limb that turns at another pace.
		Pull pull{ 5, 4, std::sin(0.7 * i), {} };
		pull.levers[3] = 3.0 * std::cos(1.9 * i);
		const double expected = pull.turn * (state.drift(5) - state.drift(4)) + pull.levers[3] * state.lever(5, 3);
		state.observe(pull, pull.turn * drift + pull.levers[3] * lever - expected, 0.01);
	}
	CHECK(std::abs(state.drift(5) - state.drift(4) - drift) < degrees(0.3));
	CHECK(std::abs(state.lever(5, 3) - lever) < 0.002);
	state.restart();
	CHECK(state.drift(5) == 0.0 && std::abs(state.lever(5, 3) - lever) < 0.002);
	state.observe(Pull{ 5, 4, 1.0, {} }, 1000.0, 0.01);
	CHECK(state.drift(5) == 0.0);
}

} // namespace test_drift_state
