// SPDX-License-Identifier: MIT
#include <engine.hpp>

#include <check.hpp>

#include <algorithm>

namespace test_engine {

using namespace vehicle;

namespace {

constexpr float STEP = 1.0f / 60.0f;

Engine make_diesel() {
	Engine engine;
	engine.settings.curve = { { 600, 2800 }, { 1600, 4700 }, { 2600, 4050 }, { 2860, 0 } };
	engine.reset();
	return engine;
}

void run(Engine &r_engine, float p_throttle, float p_load, float p_seconds) {
	for (int i = 0; i < int(p_seconds / STEP); i++) {
		r_engine.step(p_throttle, p_load, 0.0f, STEP);
	}
}

} // namespace

TEST(torque_follows_the_curve) {
	const Engine engine = make_diesel();
	CHECK_NEAR(engine.full_torque(1600), 4700, 1e-3);
	CHECK_NEAR(engine.full_torque(1100), 3750, 1e-2);
	CHECK_NEAR(engine.full_torque(100), 2800, 1e-3);
	CHECK_NEAR(engine.full_torque(3000), 0, 1e-3);
}

TEST(it_idles_without_a_load_and_with_one) {
	Engine engine = make_diesel();
	run(engine, 0.0f, 0.0f, 10.0f);
	CHECK_NEAR(engine.rpm(), engine.settings.idle_rpm, 20.0);
	run(engine, 0.0f, 500.0f, 10.0f);
	CHECK(engine.rpm() > 0.7f * engine.settings.idle_rpm);
	CHECK(engine.load() > 0.05f);
}

TEST(the_governor_holds_the_highest_speed) {
	Engine engine = make_diesel();
	float highest = 0.0f;
	for (int i = 0; i < 600; i++) {
		engine.step(1.0f, 0.0f, 0.0f, STEP);
		highest = std::max(highest, engine.rpm());
	}
	CHECK(highest < 1.1f * engine.settings.max_rpm);
	CHECK_NEAR(engine.rpm(), engine.settings.max_rpm, 0.06 * engine.settings.max_rpm);
}

TEST(it_brakes_when_nobody_accelerates) {
	Engine engine = make_diesel();
	run(engine, 1.0f, 0.0f, 5.0f);
	float torque = 0.0f;
	for (int i = 0; i < 120; i++) {
		torque = engine.step_locked(0.0f, 2400.0f, STEP);
	}
	CHECK(torque < -0.8f * engine.drag_torque(2400.0f));
}

TEST(an_engine_that_is_off_stops) {
	Engine engine = make_diesel();
	engine.set_running(false);
	run(engine, 1.0f, 0.0f, 10.0f);
	CHECK(engine.rpm() < 1.0f);
	engine.set_running(true);
	CHECK_NEAR(engine.rpm(), engine.settings.idle_rpm, 1e-3);
}

} // namespace test_engine
