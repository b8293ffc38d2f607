// SPDX-License-Identifier: MIT
#include "balance/loose_ground.hpp"

#include "check.hpp"

namespace test_loose_ground {

namespace {

using ragdoll::LooseGround;
using ragdoll::LooseGroundSettings;
using ragdoll::Vec3;

constexpr float STEP = 1.0f / 60.0f;
const Vec3 BENT{ 0.1f, -0.6f, 0.0f };
const Vec3 STRETCHED{ 0.0f, -0.8f, 0.2f };

} // namespace

TEST(a_leg_over_loose_things_pushes_no_further_than_it_may) {
	const LooseGroundSettings settings;
	LooseGround ground;
	ground.advance(settings, true, 0.0f, STEP);
	const Vec3 give = ground.find_give(settings, BENT, STRETCHED);
	CHECK_NEAR((STRETCHED + give).length(), BENT.length() + settings.push, 1e-5);
	CHECK(give.cross(STRETCHED).length() < 1e-5f); // Along the leg: where it points is the motion's.
	// To draw it in it is free.
	CHECK(ground.find_give(settings, STRETCHED, BENT).length() == 0.0f);
}

TEST(a_leg_is_free_on_firm_ground_and_some_time_after_loose_things) {
	const LooseGroundSettings settings;
	LooseGround ground;
	CHECK(ground.find_give(settings, BENT, STRETCHED).length() == 0.0f);
	ground.advance(settings, true, 0.0f, STEP);
	for (int i = 0; float(i) * STEP < settings.memory_s - 0.1f; i++) {
		ground.advance(settings, false, 0.0f, STEP);
	}
	CHECK(ground.find_give(settings, BENT, STRETCHED).length() > 0.0f);
	for (int i = 0; float(i) * STEP < 0.2f; i++) {
		ground.advance(settings, false, 0.0f, STEP);
	}
	CHECK(ground.find_give(settings, BENT, STRETCHED).length() == 0.0f);
}

TEST(legs_follow_a_body_that_sinks_and_lift_it_slowly) {
	const LooseGroundSettings settings;
	LooseGround ground;
	ground.advance(settings, false, 0.15f, STEP);
	CHECK(ground.get_sag() == 0.0f); // On firm ground it is lifted at once.
	ground.advance(settings, true, settings.sag_slack + 0.1f, STEP);
	CHECK_NEAR(ground.get_sag(), -0.1, 1e-5);
	ground.advance(settings, true, 0.0f, STEP);
	CHECK_NEAR(ground.get_sag(), settings.sag_back * STEP - 0.1, 1e-5);
	ground.advance(settings, true, 1.0f, STEP);
	CHECK_NEAR(ground.get_sag(), -settings.sag_most, 1e-5);
}

TEST(what_legs_know_of_loose_ground_is_restored) {
	const LooseGroundSettings settings;
	LooseGround ground;
	ground.advance(settings, true, 0.2f, STEP);
	ragdoll::ArchiveWriter archive;
	ground.save(archive);
	LooseGround other;
	ragdoll::ArchiveReader reader(archive.get_bytes().data(), archive.get_bytes().size());
	CHECK(other.restore(reader) && reader.is_at_end());
	for (int step = 0; step < 90; step++) {
		ground.advance(settings, false, 0.0f, STEP);
		other.advance(settings, false, 0.0f, STEP);
		CHECK(ground.get_sag() == other.get_sag());
		const Vec3 give = ground.find_give(settings, BENT, STRETCHED);
		CHECK(give.length() == other.find_give(settings, BENT, STRETCHED).length());
	}
}

} // namespace test_loose_ground
