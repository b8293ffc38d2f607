// SPDX-License-Identifier: MIT
#include "fixtures.hpp"

#include "check.hpp"

namespace test_tracking {

using namespace ragdoll;

namespace {

const Rig ONE(std::vector<Segment>(1));

void push(PoseStream &r_stream, TrackingMeter &r_meter, double p_time, float p_angle) {
	const Quat turn = exp({ 0.0f, p_angle, 0.0f });
	const float values[4] = { turn.x, turn.y, turn.z, turn.w };
	r_stream.push(p_time, values, {});
	r_meter.settle(r_stream, ONE);
}

} // namespace

TEST(compares_with_the_later_truth) {
	PoseStream stream(1);
	TrackingMeter meter;
	push(stream, meter, 0.0, 0.0f);
	meter.note(0.01, { exp({ 0.0f, 0.15f, 0.0f }) }, { { 0.0f, 0.02f, 0.0f } });
	CHECK(meter.get_count() == 0); // Not known yet.
	push(stream, meter, 0.02, 0.2f);
	CHECK(meter.get_count() == 1);
	CHECK_NEAR(meter.mean(), 0.05, 1e-4); // 0.15 against 0.1 half-way.
	CHECK_NEAR(meter.percentile(0.95), 0.05, 1.1e-3);
	CHECK_NEAR(meter.latest(), 0.05, 1e-4);
	CHECK_NEAR(meter.mean_distance(), 0.02, 1e-6);
}

TEST(percentiles_of_a_known_spread) {
	PoseStream stream(1);
	TrackingMeter meter;
	push(stream, meter, 0.0, 0.0f);
	for (int i = 1; i <= 100; i++) {
		meter.note(i * 0.001, { exp({ 0.01f * float(i), 0.0f, 0.0f }) }, { {} });
		push(stream, meter, i * 0.001, 0.0f);
	}
	CHECK(meter.get_count() == 100);
	CHECK_NEAR(meter.percentile(0.95), 0.95, 0.011);
	CHECK_NEAR(meter.mean(), 0.505, 1e-3);
	meter.clear();
	CHECK(meter.get_count() == 0);
	CHECK_NEAR(meter.percentile(0.95), 0.0, 0.0);
}

namespace {

/// Follows a swing that is sampled at a rate (Hz), so much late (s).
TrackingMeter follow_late(double p_late_s, int p_hz) {
	PoseStream stream(1);
	TrackingMeter meter;
	meter.measures_lag = true;
	for (int i = 0; i < 5 * p_hz; i++) {
		const double time = i / double(p_hz);
		if (i > 2) {
			const float late = 0.8f * float(std::sin(3.0 * (time - p_late_s)));
			meter.note(time, { exp({ 0.0f, late, 0.0f }) }, { {} });
		}
		push(stream, meter, time, 0.8f * float(std::sin(3.0 * time)));
	}
	return meter;
}

} // namespace

TEST(finds_a_known_lag_and_a_known_lead) {
	for (const int hz : { 30, 60, 120, 240 }) {
		for (const double late : { 0.011, 0.0, 0.03, 0.071, -0.0035, -0.01, -0.03 }) {
			const TrackingMeter meter = follow_late(late, hz);
			CHECK(meter.is_lag_known());
			CHECK_NEAR(meter.lag(), late, 0.001);
		}
	}
}

TEST(says_when_the_lag_is_beyond_the_search) {
	for (const double late : { 0.15, -0.08 }) {
		const TrackingMeter meter = follow_late(late, 60);
		CHECK(!meter.is_lag_known());
		CHECK_NEAR(meter.lag(), late > 0.0 ? TrackingMeter::MAX_LAG : -TrackingMeter::MAX_LEAD, 1e-9);
	}
	CHECK(!TrackingMeter().is_lag_known());
	CHECK_NEAR(TrackingMeter().lag(), 0.0, 0.0);
}

} // namespace test_tracking
