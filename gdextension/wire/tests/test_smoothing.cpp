// SPDX-License-Identifier: MIT
#include "smoothing_fixtures.hpp"

#include <check.hpp>

namespace test_smoothing {

using namespace fixtures;

namespace {

/// What a display of 60 Hz shows of a network's datagrams.
struct Watched {
	std::vector<Vec3> hand; // Where the last limb was shown.
	std::vector<double> times;
	float gap = 0.0f;
	bool is_finite = true;
};

Watched watch(SmoothingMethod p_method, const std::vector<Arrival> &p_datagrams, double p_begin, double p_end) {
	Smoother smoother;
	smoother.set_method(p_method);
	smoother.set_skeleton(0, arm());
	Watched watched;
	std::size_t next = 0;
	for (int frame = 0; double(frame) / 60.0 < p_end; frame++) {
		const double now = (double(frame) + 0.4) / 60.0;
		while (next < p_datagrams.size() && p_datagrams[next].arrival <= now) {
			smoother.push(swinging(p_datagrams[next].tick), p_datagrams[next].arrival);
			next++;
		}
		smoother.evaluate(now);
		const Smoother::Person *person = smoother.person(0);
		if (person != nullptr && now >= p_begin) {
			watched.hand.push_back(person->positions[2]);
			watched.times.push_back(now);
			watched.gap = std::max(watched.gap, widest_gap(arm(), *person));
			watched.is_finite = watched.is_finite && is_finite(*person);
		}
	}
	return watched;
}

Vec3 true_hand(double p_time) {
	PersonUpdate update = swinging(0);
	const float time = float(p_time);
	update.pose.root.x = time;
	update.pose.orientations[1] = kinematics::exp({ 0.0f, 0.0f, std::sin(6.283f * time) });
	update.pose.orientations[2] = kinematics::exp({ 0.0f, 0.6f * std::cos(6.283f * time), std::sin(6.283f * time) });
	std::array<Vec3, kinematics::MAX_LIMBS> positions;
	kinematics::position_limbs(arm(), update.pose, positions);
	return positions[2];
}

/// RMS distance of the hand from where it was a lag ago, m.
double error(const Watched &p_watched, double p_lag) {
	double sum = 0.0;
	for (std::size_t i = 0; i < p_watched.hand.size(); i++) {
		const Vec3 off = p_watched.hand[i] - true_hand(p_watched.times[i] - p_lag);
		sum += double(off.dot(off));
	}
	return std::sqrt(sum / double(p_watched.hand.size()));
}

/// The greatest change of the hand's path from one frame to the next, m: a jump shows in it.
float roughest(const Watched &p_watched) {
	float worst = 0.0f;
	for (std::size_t i = 2; i < p_watched.hand.size(); i++) {
		const Vec3 change = p_watched.hand[i] - p_watched.hand[i - 1] * 2.0f + p_watched.hand[i - 2];
		worst = std::max(worst, change.length());
	}
	return worst;
}

} // namespace

TEST(joints_never_gap_whatever_the_method_and_the_network) {
	const std::vector<Arrival> bad = network(0, 600, 2, 0.06, 0.05, 0.2);
	for (const SmoothingMethod method : ALL_METHODS) {
		const Watched watched = watch(method, bad, 0.5, 10.0);
		CHECK(watched.hand.size() > 500);
		CHECK(watched.gap < 1e-5f);
		CHECK(watched.is_finite);
	}
}

TEST(over_a_perfect_network_a_buffer_shows_the_truth_late) {
	const std::vector<Arrival> perfect = network(0, 600, 1, 0.0, 0.0, 0.0);
	for (const SmoothingMethod method : { SmoothingMethod::LINEAR, SmoothingMethod::HERMITE }) {
		const Watched watched = watch(method, perfect, 2.0, 10.0);
		CHECK(error(watched, BUFFER_S) < 0.001);
	}
}

TEST(the_default_stays_close_behind_and_does_not_jump) {
	const std::vector<Arrival> usual = network(0, 1200, 2, 0.025, 0.01, 0.02);
	const Watched watched = watch(SmoothingMethod::ADAPTIVE_LOW_DELAY, usual, 2.0, 20.0);
	const Watched raw = watch(SmoothingMethod::NONE, usual, 2.0, 20.0);
	CHECK(error(watched, 0.042) < 0.02);
	CHECK(roughest(watched) < 0.4f * roughest(raw));
}

TEST(the_default_waits_longer_where_updates_vary_more) {
	Smoother smoother;
	smoother.set_skeleton(0, arm());
	double before = 0.0;
	for (const double jitter : { 0.0, 0.02, 0.06 }) {
		smoother.clear();
		for (const Arrival &datagram : network(0, 300, 1, 0.08, jitter, 0.0)) {
			smoother.push(swinging(datagram.tick), datagram.arrival);
		}
		smoother.evaluate(5.1);
		CHECK(smoother.delay() > before);
		CHECK(smoother.delay() < 0.02 + 2.0 * jitter);
		before = smoother.delay();
	}
}

TEST(the_delay_that_is_reported_is_that_of_what_is_shown_however_slow_the_server_is) {
	for (const double speed : { 1.0, 0.95, 0.85, 0.7 }) {
		Smoother smoother;
		smoother.set_skeleton(0, arm());
		double reported = 0.0;
		double shown = 0.0;
		int count = 0;
		for (uint32_t tick = 1; tick < 1200; tick++) {
			// Ticks come later and later, as those of a machine that is too slow.
			const double arrival = double(tick) / 60.0 / speed + 0.005;
			smoother.push(swinging(tick), arrival);
			smoother.evaluate(arrival + 0.004);
			if (tick > 600) {
				reported += smoother.delay();
				// Ahead of the newest tick it is carried on, which is no delay.
				shown += std::max((double(tick) - smoother.shown_tick()) / 60.0, 0.0);
				count++;
			}
		}
		CHECK(std::fabs(reported - shown) / count < 0.05);
		CHECK(reported / count < 0.06);
	}
}

TEST(the_thesis_and_the_error_offset_are_ahead_of_the_buffers) {
	const std::vector<Arrival> usual = network(0, 1200, 2, 0.025, 0.01, 0.02);
	const double buffered = error(watch(SmoothingMethod::HERMITE, usual, 2.0, 20.0), 0.0);
	for (const SmoothingMethod method : { SmoothingMethod::EXTRAPOLATE_LERP, SmoothingMethod::ERROR_OFFSET }) {
		CHECK(error(watch(method, usual, 2.0, 20.0), 0.0) < 0.6 * buffered);
	}
}

TEST(the_clock_finds_the_least_latency_and_follows_drift) {
	ServerClock clock;
	std::mt19937 random(3);
	std::uniform_real_distribution<double> jitter(0.0, 0.02);
	double worst = 0.0;
	for (uint32_t tick = 0; tick < 3600; tick++) {
		// The client's clock is 100 s ahead and runs 0.1 % faster.
		const double sent = double(tick) / 60.0;
		clock.arrived(tick, 100.0 + sent * 1.001 + 0.01 + jitter(random));
		if (tick > 120) {
			const double now = 100.0 + sent * 1.001 + 0.01;
			worst = std::max(worst, std::fabs(clock.server_now(now) - sent));
		}
	}
	CHECK(worst < 0.005);
	CHECK_NEAR(clock.interval(), 1.0 / 60.0, 1e-9);
	CHECK_NEAR(clock.lateness(0.9), 0.018, 0.003);
}

TEST(what_is_shown_never_goes_back_in_time) {
	Smoother smoother;
	smoother.set_skeleton(0, arm());
	double before = -1.0;
	int back = 0;
	std::size_t next = 0;
	// The network becomes slower, then quicker again.
	std::vector<Arrival> datagrams = network(0, 300, 1, 0.02, 0.005, 0.0);
	for (const Arrival &datagram : network(300, 600, 1, 0.15, 0.05, 0.0)) {
		datagrams.push_back(datagram);
	}
	for (const Arrival &datagram : network(600, 900, 1, 0.02, 0.005, 0.0)) {
		datagrams.push_back(datagram);
	}
	for (int frame = 60; frame < 900; frame++) {
		while (next < datagrams.size() && datagrams[next].arrival <= double(frame) / 60.0) {
			smoother.push(swinging(datagrams[next].tick), datagrams[next].arrival);
			next++;
		}
		smoother.evaluate(double(frame) / 60.0);
		back += smoother.shown_tick() < before ? 1 : 0;
		before = smoother.shown_tick();
	}
	CHECK(back == 0);
	CHECK(before > 890.0);
}

TEST(the_method_can_change_while_it_runs) {
	Smoother smoother;
	smoother.set_skeleton(0, arm());
	float widest = 0.0f;
	Vec3 before;
	for (uint32_t tick = 0; tick < 600; tick++) {
		const double now = double(tick) / 60.0;
		smoother.set_method(ALL_METHODS[(tick / 50) % 6]);
		smoother.push(swinging(tick), now);
		smoother.evaluate(now + 0.001);
		const Smoother::Person *person = smoother.person(0);
		CHECK(person != nullptr && is_finite(*person));
		widest = tick > 1 ? std::max(widest, (person->pose.root - before).length()) : 0.0f;
		before = person->pose.root;
	}
	CHECK(widest < 0.1f);
}

TEST(bodies_at_rest_have_not_moved) {
	Smoother smoother;
	std::size_t shown = 0;
	for (uint32_t tick = 0; tick < 120; tick++) {
		const double now = double(tick) / 60.0;
		for (uint16_t id = 1; id <= 3; id++) {
			BodyUpdate update;
			update.id = id;
			update.tick = tick;
			update.at_rest = id != 2;
			update.position = { float(id), id == 2 ? float(now) : 0.0f, 0.0f };
			update.velocity = { 0.0f, id == 2 ? 1.0f : 0.0f, 0.0f };
			smoother.push(update, now);
		}
		smoother.evaluate(now);
		const std::vector<uint16_t> &moved = smoother.moved_bodies();
		shown += moved.size();
		if (tick == 0) {
			CHECK(moved.size() == 3);
		} else {
			CHECK(moved.size() == 1 && moved[0] == 2);
		}
	}
	CHECK(shown == 122);
	smoother.clear();
	smoother.evaluate(2.0);
	CHECK(smoother.moved_bodies().empty());
}

} // namespace test_smoothing
