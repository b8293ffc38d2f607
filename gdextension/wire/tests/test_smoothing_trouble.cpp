// SPDX-License-Identifier: MIT
#include "smoothing_fixtures.hpp"

#include <check.hpp>

#include <cstdlib>
#include <cstring>
#include <limits>
#include <new>

using namespace fixtures;

namespace {

int allocations = 0;

} // namespace

void *operator new(std::size_t p_size) {
	allocations++;
	void *memory = std::malloc(p_size);
	if (memory == nullptr) {
		throw std::bad_alloc();
	}
	return memory;
}

void operator delete(void *p_memory) noexcept {
	std::free(p_memory);
}

void operator delete(void *p_memory, std::size_t) noexcept {
	std::free(p_memory);
}

namespace {

BodyUpdate falling(uint32_t p_tick) {
	BodyUpdate update;
	update.tick = p_tick;
	update.id = 5;
	update.position = { 0.0f, 10.0f - float(p_tick) / 60.0f, 0.0f };
	update.velocity = { 0.0f, -1.0f, 0.0f };
	update.spin = { 0.0f, 2.0f, 0.0f };
	update.orientation = kinematics::exp({ 0.0f, 2.0f * float(p_tick) / 60.0f, 0.0f });
	return update;
}

/// Any bits as a float, often such as make trouble.
float any_float(std::mt19937 &p_random) {
	constexpr float NASTY[] = { 0.0f, 1.0f, -1.0f, 1e-38f, 1e30f, -1e38f, std::numeric_limits<float>::infinity(),
		std::numeric_limits<float>::quiet_NaN(), 99999.0f };
	if (p_random() % 2 == 0) {
		return NASTY[p_random() % 9];
	}
	const uint32_t bits = uint32_t(p_random());
	float number = 0.0f;
	std::memcpy(&number, &bits, sizeof number);
	return number;
}

Quat any_turn(std::mt19937 &p_random) {
	return { any_float(p_random), any_float(p_random), any_float(p_random), any_float(p_random) };
}

Vec3 any_vector(std::mt19937 &p_random) {
	return { any_float(p_random), any_float(p_random), any_float(p_random) };
}

/// A person shown at 60 Hz who gets every tick.
void run(Smoother &r_smoother, uint32_t p_first, uint32_t p_end, double p_begin) {
	for (uint32_t tick = p_first; tick < p_end; tick++) {
		const double now = p_begin + double(tick - p_first) / 60.0;
		r_smoother.push(swinging(tick), now);
		r_smoother.evaluate(now + 0.001);
	}
}

} // namespace

TEST(a_running_smoother_allocates_nothing) {
	Smoother smoother;
	smoother.set_skeleton(0, arm());
	const auto step = [&smoother](uint32_t p_tick) {
		const double now = double(p_tick) / 60.0;
		smoother.push(swinging(p_tick), now);
		smoother.push(falling(p_tick), now);
		smoother.evaluate(now);
	};
	step(0);
	const int before = allocations;
	for (uint32_t tick = 1; tick < 400; tick++) {
		smoother.set_method(ALL_METHODS[tick % 6]);
		step(tick);
	}
	CHECK(allocations == before);
}

TEST(what_is_broken_is_refused_and_never_shown) {
	std::mt19937 random(11);
	Smoother smoother;
	smoother.set_skeleton(0, arm());
	bool sound = true;
	for (int i = 0; i < 40000; i++) {
		PersonUpdate person;
		BodyUpdate body;
		person.tick = body.tick = random() % 4 == 0 ? uint32_t(random()) : uint32_t(i);
		person.pose.root = any_vector(random);
		for (Quat &turn : person.pose.orientations) {
			turn = random() % 8 == 0 ? any_turn(random) : Quat();
		}
		body.position = any_vector(random);
		body.orientation = random() % 2 == 0 ? any_turn(random) : Quat();
		body.velocity = any_vector(random);
		body.spin = any_vector(random);
		body.at_rest = random() % 4 == 0;
		const double now = random() % 16 == 0 ? double(any_float(random)) : double(i) / 60.0;
		smoother.set_method(ALL_METHODS[(i / 100) % 6]);
		smoother.push(person, now);
		smoother.push(body, now);
		smoother.evaluate(random() % 16 == 0 ? double(any_float(random)) : double(i) / 60.0);
		const Smoother::Person *shown = smoother.person(0);
		const BodyTransform *position = smoother.body(0);
		sound = sound && (shown == nullptr || is_finite(*shown));
		sound = sound && (position == nullptr || (position->position.is_finite() && position->orientation.is_finite()));
	}
	CHECK(sound);
}

TEST(a_person_without_a_sound_skeleton_is_refused) {
	Smoother smoother;
	CHECK(!smoother.push(swinging(1), 0.0));
	kinematics::Skeleton wrong = arm();
	wrong.parents[1] = 2;
	CHECK(!smoother.set_skeleton(0, wrong));
	wrong = arm();
	wrong.joints_in_limb[2].x = std::numeric_limits<float>::quiet_NaN();
	CHECK(!smoother.set_skeleton(0, wrong));
	CHECK(smoother.set_skeleton(0, arm()));
	CHECK(smoother.push(swinging(1), 0.0));
	CHECK(smoother.person(0) == nullptr);
	smoother.evaluate(0.0);
	CHECK(smoother.person(0) != nullptr);
	smoother.forget_person(0);
	CHECK(smoother.person(0) == nullptr);
}

TEST(twice_and_out_of_order_change_nothing) {
	Smoother smoother;
	smoother.set_skeleton(0, arm());
	smoother.set_method(SmoothingMethod::HERMITE);
	float worst = 0.0f;
	int refused = 0;
	for (uint32_t tick = 0; tick < 300; tick += 2) {
		const double now = double(tick + 1) / 60.0;
		smoother.push(swinging(tick + 1), now);
		smoother.push(swinging(tick), now);
		refused += smoother.push(swinging(tick), now) ? 0 : 1;
		smoother.evaluate(now);
		if (tick > 60) {
			// The walk is one metre a second.
			const double error = smoother.person(0)->pose.root.x - smoother.shown_tick() / 60.0;
			worst = std::max(worst, float(std::fabs(error)));
		}
	}
	CHECK(worst < 1e-3f);
	CHECK(refused == 150);
}

TEST(a_replayed_old_datagram_does_not_restart_the_world) {
	Smoother smoother;
	smoother.set_skeleton(0, arm());
	run(smoother, 600, 900, 0.0);
	const double tick = smoother.shown_tick();
	CHECK(!smoother.push(swinging(100), 5.0));
	CHECK(!smoother.push(swinging(100), 5.0));
	CHECK(!smoother.push(swinging(100), 5.0));
	CHECK(!smoother.push(swinging(4000000000U), 5.0));
	smoother.evaluate(5.001);
	CHECK(smoother.shown_tick() > tick - 0.1 && smoother.shown_tick() < tick + 10.0);
}

TEST(a_new_server_is_believed_within_a_few_ticks) {
	for (const SmoothingMethod method : ALL_METHODS) {
		Smoother smoother;
		smoother.set_method(method);
		smoother.set_skeleton(0, arm());
		run(smoother, 10000, 10300, 0.0);
		run(smoother, 0, 8, 5.0);
		CHECK(smoother.shown_tick() < 10.0);
		CHECK(smoother.person(0)->pose.root.x < 1.0f);
		CHECK(is_finite(*smoother.person(0)));
	}
}

TEST(during_a_pause_a_person_stops_and_afterwards_goes_on) {
	for (const SmoothingMethod method : ALL_METHODS) {
		Smoother smoother;
		smoother.set_method(method);
		smoother.set_skeleton(0, arm());
		run(smoother, 0, 300, 0.0);
		for (int frame = 0; frame < 295; frame++) {
			smoother.evaluate(5.0 + double(frame) / 60.0);
		}
		CHECK_NEAR(smoother.person(0)->pose.root.x, 5.0, 0.4);
		CHECK(is_finite(*smoother.person(0)));
		// The server slept too: its ticks go on where they were, five seconds later.
		run(smoother, 300, 360, 9.95);
		CHECK_NEAR(smoother.person(0)->pose.root.x, 6.0, 0.1);
	}
}

TEST(after_a_sleep_of_the_client_it_catches_up_at_once) {
	Smoother smoother;
	smoother.set_skeleton(0, arm());
	run(smoother, 0, 300, 0.0);
	for (uint32_t tick = 300; tick < 600; tick++) {
		smoother.push(swinging(tick), double(tick) / 60.0);
	}
	smoother.evaluate(10.0);
	CHECK_NEAR(smoother.person(0)->pose.root.x, 10.0, 0.1);
}

TEST(a_body_goes_on_as_predicted_until_an_update_says_otherwise) {
	for (const SmoothingMethod method :
			{ SmoothingMethod::LINEAR, SmoothingMethod::HERMITE, SmoothingMethod::EXTRAPOLATE_LERP,
					SmoothingMethod::ERROR_OFFSET, SmoothingMethod::ADAPTIVE_LOW_DELAY }) {
		Smoother smoother;
		smoother.set_method(method);
		smoother.set_skeleton(0, arm());
		float worst = 0.0f;
		for (uint32_t tick = 0; tick < 120; tick++) {
			const double now = double(tick) / 60.0;
			smoother.push(swinging(tick), now);
			if (tick % 48 == 0) { // Rarely, as a server does whose prediction holds.
				smoother.push(falling(tick), now);
			}
			smoother.evaluate(now);
			const double seconds = smoother.shown_tick() / 60.0;
			const float truth = float(10.0 - std::max(seconds, 0.0));
			worst = std::max(worst, std::fabs(smoother.body(5)->position.y - truth));
		}
		CHECK(worst < 0.02f);
	}
}

TEST(nobody_is_believed_for_longer_than_a_second) {
	BodyUpdate update = falling(0);
	CHECK_NEAR(predict(update, 0.5f).position.y, 9.5, 1e-5);
	CHECK_NEAR(predict(update, 30.0f).position.y, 9.0, 1e-5);
	CHECK_NEAR(predict(update, -1.0f).position.y, 10.0, 1e-5);
	CHECK_NEAR(kinematics::log(predict(update, 0.5f).orientation).y, 1.0, 1e-5);
	update.at_rest = true;
	CHECK_NEAR(predict(update, 0.5f).position.y, 10.0, 0.0);
}

TEST(a_correction_slides_in_and_a_body_at_rest_lies_exactly) {
	Smoother smoother;
	float roughest = 0.0f;
	float before = 0.0f;
	for (uint32_t tick = 0; tick < 120; tick++) {
		const double now = double(tick) / 60.0;
		if (tick == 0) {
			smoother.push(falling(tick), now);
		} else if (tick == 40) {
			BodyUpdate landed = falling(36);
			landed.position.y = 9.9f; // 0.5 m above where it was believed.
			landed.at_rest = true;
			smoother.push(landed, now);
		}
		smoother.evaluate(now);
		const float height = smoother.body(5)->position.y;
		roughest = tick > 0 ? std::max(roughest, std::fabs(height - before)) : 0.0f;
		before = height;
	}
	CHECK(roughest < 0.2f);
	CHECK_NEAR(before, 9.9, 1e-4);
}

TEST(what_is_put_elsewhere_does_not_fly_there) {
	Smoother smoother;
	BodyUpdate update;
	update.at_rest = true;
	smoother.push(update, 0.0);
	smoother.evaluate(0.0);
	for (uint32_t tick = 1; tick < 30; tick++) {
		update.tick = tick;
		update.position.x = tick < 10 ? 0.0f : 20.0f;
		const double now = double(tick) / 60.0;
		smoother.push(update, now);
		smoother.evaluate(now);
		const float position = smoother.body(0)->position.x;
		CHECK(position < 0.01f || position > 19.99f);
	}
	smoother.forget_body(0);
	CHECK(smoother.body(0) == nullptr);
}

TEST_MAIN()
