// SPDX-License-Identifier: MIT
#include <drift_state.hpp>

#include <check.hpp>

#include <cmath>

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

TEST_MAIN()
