// SPDX-License-Identifier: MIT
#include "fixtures.hpp"

#include "check.hpp"

using namespace ragdoll;

namespace {

std::vector<std::uint8_t> saved(const Driver &p_driver) {
	ArchiveWriter archive;
	p_driver.save(archive);
	return archive.get_bytes();
}

bool restore(Driver &r_driver, const std::vector<std::uint8_t> &p_bytes) {
	ArchiveReader reader(p_bytes.data(), p_bytes.size());
	return r_driver.restore(reader) && reader.is_at_end();
}

} // namespace

TEST(the_state_of_another_body_is_refused) {
	std::vector<Segment> heavier = fixtures::limbs();
	heavier[3].mass = 11.0f;
	std::vector<Segment> regrouped = fixtures::limbs();
	regrouped[3].group = 3;
	Driver own(Rig(fixtures::limbs()), fixtures::groups(), 3, {});
	Driver other(Rig(heavier), fixtures::groups(), 3, {});
	// Of one group more: a limb's index in the table of groups would lie behind its end.
	Driver larger(Rig(regrouped), { 0, 0, 1, 3 }, 4, {});
	Driver standing(Rig(fixtures::limbs()), fixtures::groups(), 3, std::vector<ContactPoint>(1));
	CHECK(restore(own, saved(own)));
	CHECK(!restore(own, saved(other)));
	CHECK(!restore(own, saved(larger)));
	CHECK(!restore(own, saved(standing)));
	CHECK_NEAR(own.get_table().get_strength(3), 1.0, 1e-6);
}

TEST(a_state_that_is_cut_off_changes_nothing) {
	Driver driver(Rig(fixtures::limbs()), fixtures::groups(), 3, {});
	const float still[16] = { 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1 };
	CHECK(driver.push(1.0, still, {}, nullptr));
	driver.get_table().set_mode(Actuation::LIMP, 1, 0.0f);
	std::vector<std::uint8_t> early = saved(driver);
	CHECK(driver.push(2.0, still, {}, nullptr));
	driver.get_table().set_mode(Actuation::POSITION_MOTOR, -1, 0.0f);
	const std::vector<std::uint8_t> before = saved(driver);
	for (std::size_t size = 0; size < early.size(); size += 7) {
		CHECK(!restore(driver, { early.begin(), early.begin() + long(size) }));
		CHECK_NEAR(driver.get_stream().newest(), 2.0, 0.0);
		CHECK(driver.get_table().get_mode(2) == Actuation::POSITION_MOTOR);
	}
	CHECK(saved(driver).size() == before.size());
	CHECK(restore(driver, early));
	CHECK_NEAR(driver.get_stream().newest(), 1.0, 0.0);
	CHECK(driver.get_table().get_mode(2) == Actuation::LIMP);
}

TEST(another_clock_may_begin_earlier_or_later) {
	const float still[16] = { 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1 };
	for (const double begin : { 5.0, 1e6, -1e6, -1e12 }) {
		Driver driver(Rig(fixtures::limbs()), fixtures::groups(), 3, {});
		Pose pose;
		pose.orientations.assign(4, Quat());
		RigState state = fixtures::state_of(driver.get_rig(), pose);
		CHECK(driver.push(100.0, still, {}, nullptr));
		driver.step(state, 100.0, 0.01f);
		driver.measure(100.01, state);
		driver.clear_motion();
		CHECK(driver.push(begin, still, { 3.0f, 0.0f, 0.0f }, nullptr));
		CHECK(driver.step(state, begin, 0.01f).must_put);
		CHECK_NEAR(state.root.x, 3.0, 1e-6);
		driver.measure(begin + 0.01, state);
		CHECK(driver.push(begin + 0.02, still, { 3.0f, 0.0f, 0.0f }, nullptr));
		CHECK(!driver.step(state, begin + 0.02, 0.01f).must_put);
		CHECK(driver.get_meter().get_count() == 4);
	}
}

TEST_MAIN()
