// SPDX-License-Identifier: MIT
#include <drift_estimator.hpp>

#include <check.hpp>

using namespace heading;

TEST(nothing_known_is_nothing_corrected) {
	DriftEstimator estimator;
	estimator.add({});
	CHECK(estimator.correction(0) == 0.0);
}

TEST_MAIN()
