// SPDX-License-Identifier: MIT
#include "fixtures.hpp"

#include "check.hpp"

#include <cmath>

namespace test_actuation {

using namespace ragdoll;

namespace {

void wait(ActuationTable &r_table, float p_seconds) {
	const int steps = int(std::lround(p_seconds * 100.0f));
	for (int step = 0; step < steps; step++) {
		r_table.advance(0.01f);
	}
}

} // namespace

TEST(ramps_are_smooth_and_end) {
	Ramp ramp(1.0f);
	ramp.go(0.0f, 1.0f);
	float before = 1.0f;
	for (int i = 0; i < 100; i++) {
		ramp.advance(0.01f);
		CHECK(ramp.get() <= before && before - ramp.get() < 0.016f);
		before = ramp.get();
	}
	ramp.advance(0.01f);
	CHECK(!ramp.is_moving());
	CHECK_NEAR(ramp.get(), 0.0, 0.0);
	ramp.go(3.0f, 0.0f);
	CHECK_NEAR(ramp.get(), 3.0, 0.0);
}

TEST(groups_are_switched_apart) {
	ActuationTable table(fixtures::groups(), 3);
	table.set_mode(Actuation::POSITION_MOTOR, 1, 0.0f);
	table.set_strength(0.5f, 2, 0.0f);
	CHECK(table.get_mode(2) == Actuation::POSITION_MOTOR);
	CHECK(table.get_mode(3) == Actuation::VELOCITY_MOTOR);
	CHECK_NEAR(table.get_strength(3), 0.5, 1e-6);
	CHECK_NEAR(table.get_strength(0), 1.0, 1e-6);
	table.set_mode(Actuation::SPRING_TORQUE, -1, 0.0f);
	for (std::size_t i = 0; i < 4; i++) {
		CHECK(table.get_mode(i) == Actuation::SPRING_TORQUE);
	}
}

TEST(going_limp_fades_and_getting_up_rises) {
	ActuationTable table(fixtures::groups(), 3);
	table.set_mode(Actuation::LIMP, -1, 1.0f);
	CHECK(table.get_mode(0) == Actuation::VELOCITY_MOTOR);
	CHECK(table.get_wanted_mode(0) == Actuation::LIMP);
	wait(table, 0.5f);
	CHECK(table.get_strength(0) < 0.7f && table.get_strength(0) > 0.3f);
	wait(table, 0.6f);
	CHECK(table.get_mode(0) == Actuation::LIMP);
	CHECK_NEAR(table.get_strength(0), ActuationTable::LIMP_FRICTION, 1e-6);
	table.set_mode(Actuation::VELOCITY_MOTOR, -1, 2.0f);
	CHECK(table.get_mode(0) == Actuation::VELOCITY_MOTOR);
	CHECK(table.get_strength(0) < 0.03f);
	wait(table, 2.1f);
	CHECK_NEAR(table.get_strength(0), 1.0, 1e-6);
}

TEST(a_death_can_be_called_off) {
	ActuationTable table(fixtures::groups(), 3);
	table.set_mode(Actuation::LIMP, -1, 1.0f);
	wait(table, 0.5f);
	table.set_mode(Actuation::VELOCITY_MOTOR, -1, 0.5f);
	wait(table, 2.0f);
	CHECK(table.get_mode(0) == Actuation::VELOCITY_MOTOR);
	CHECK_NEAR(table.get_strength(0), 1.0, 1e-6);
}

TEST(a_put_limb_arrives_within_the_blend) {
	ActuationTable table(fixtures::groups(), 3);
	table.set_mode(Actuation::DIRECT_SET, -1, 0.5f);
	CHECK_NEAR(table.get_arrival(0), 0.0, 1e-6);
	wait(table, 0.6f);
	CHECK_NEAR(table.get_arrival(0), 1.0, 1e-6);
}

TEST(strength_is_never_negative_and_never_nothing) {
	ActuationTable table(fixtures::groups(), 3);
	table.set_strength(-3.0f, -1, 0.0f);
	CHECK_NEAR(table.get_strength(0), ActuationTable::LIMP_FRICTION, 1e-6);
}

TEST(is_saved_and_restored) {
	ActuationTable table(fixtures::groups(), 3);
	table.set_mode(Actuation::LIMP, 1, 1.0f);
	table.set_strength(0.25f, 0, 1.0f);
	wait(table, 0.3f);
	ArchiveWriter archive;
	table.save(archive);
	ActuationTable copy(fixtures::groups(), 3);
	ArchiveReader reader(archive.get_bytes().data(), archive.get_bytes().size());
	CHECK(copy.restore(reader) && reader.is_at_end());
	wait(table, 0.4f);
	wait(copy, 0.4f);
	for (std::size_t i = 0; i < 4; i++) {
		CHECK_NEAR(copy.get_strength(i), table.get_strength(i), 0.0);
	}
	ArchiveReader cut(archive.get_bytes().data(), archive.get_bytes().size() - 1);
	CHECK(!copy.restore(cut));
}

} // namespace test_actuation
