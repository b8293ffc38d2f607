// SPDX-License-Identifier: MIT
#include "fixtures.hpp"

#include "check.hpp"

namespace test_driver {

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

constexpr float STILL[16] = { 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1 };
constexpr float DELTA = 0.01f;

/// Everything is in the way.
class Walls : public Obstacles {
public:
	bool is_in_way(std::size_t, const Quat &, const Vec3 &, const Vec3 &) const override {
		asked++;
		return true;
	}
	mutable int asked = 0;
};

/// A wide platform at height 0, which turns about a place 2 m away.
class Platform : public Ground {
public:
	Quat orientation;

	float height(const Vec3 & /*p_at*/) const override { return 0.0f; }
	Footing find(const Vec3 & /*p_at*/, float /*p_above*/) const override {
		Footing found;
		found.height = 0.0f;
		found.body = 7;
		found.orientation = orientation;
		found.pivot = { 2.0f, 0.0f, 0.0f };
		found.origin = found.pivot;
		return found;
	}
};

RigState at_rest(const Driver &p_driver, const Vec3 &p_root) {
	Pose pose;
	pose.orientations.assign(p_driver.get_rig().size(), Quat());
	pose.root = p_root;
	return fixtures::state_of(p_driver.get_rig(), pose);
}

/// A step in which the motion stands still. Returns whether the body is put somewhere.
bool stand(Driver &r_driver, RigState &r_state, double p_time_s) {
	return r_driver.push(p_time_s, STILL, {}, nullptr) && r_driver.step(r_state, p_time_s, DELTA).must_put;
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

	CHECK(driver.push(1.0, STILL, {}, nullptr));
	driver.get_table().set_mode(Actuation::LIMP, 1, 0.0f);
	std::vector<std::uint8_t> early = saved(driver);
	CHECK(driver.push(2.0, STILL, {}, nullptr));
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

TEST(what_a_chosen_mode_made_is_part_of_the_saved_state) {
	const std::vector<ContactPoint> contacts(1);
	Driver chosen(Rig(fixtures::limbs()), fixtures::groups(), 3, contacts);
	Driver usual(Rig(fixtures::limbs()), fixtures::groups(), 3, contacts);
	const std::vector<std::uint8_t> before = saved(usual);
	chosen.root_mode = RootMode::LOWEST_FOOT;
	chosen.get_table().set_mode(Actuation::SPRING_TORQUE, -1, 0.0f);
	RigState state = at_rest(chosen, { 0.0f, 1.0f, 0.0f });
	for (int i = 0; i < 10; i++) {
		stand(chosen, state, 1.0 + i * double(DELTA));
	}
	const std::vector<std::uint8_t> after = saved(chosen);
	CHECK(restore(usual, after));
	CHECK(saved(usual) == after);
	CHECK(usual.get_travel() != nullptr);
	CHECK(restore(usual, before));
	CHECK(saved(usual) == before);
	for (std::size_t size = 0; size < after.size(); size += 7) {
		CHECK(!restore(usual, { after.begin(), after.begin() + long(size) }));
	}
	CHECK(saved(usual) == before);
}

TEST(another_clock_may_begin_earlier_or_later) {
	for (const double begin : { 5.0, 1e6, -1e6, -1e12 }) {
		Driver driver(Rig(fixtures::limbs()), fixtures::groups(), 3, {});
		Pose pose;
		pose.orientations.assign(4, Quat());
		RigState state = fixtures::state_of(driver.get_rig(), pose);
		CHECK(driver.push(100.0, STILL, {}, nullptr));
		driver.step(state, 100.0, 0.01f);
		driver.measure(100.01, state);
		driver.clear_motion();
		CHECK(driver.push(begin, STILL, { 3.0f, 0.0f, 0.0f }, nullptr));
		CHECK(driver.step(state, begin, 0.01f).must_put);
		CHECK_NEAR(state.root.x, 3.0, 1e-6);
		driver.measure(begin + 0.01, state);
		CHECK(driver.push(begin + 0.02, STILL, { 3.0f, 0.0f, 0.0f }, nullptr));
		for (int i = 0; i < 12; i++) {
			driver.step(state, begin + 0.02 + 0.01 * i, 0.01f);
		}
		CHECK(!driver.step(state, begin + 0.02 + 2.0 * double(Arrival::DURATION_S), 0.01f).must_put);
		CHECK(driver.get_meter().get_count() == 4);
	}
}

TEST(walls_stop_nobody_whose_travel_is_found) {
	for (const RootMode mode : { RootMode::LOWEST_FOOT, RootMode::CONTACTS, RootMode::INERTIAL, RootMode::SOFT }) {
		const Walls walls;
		Driver driver(Rig(fixtures::limbs()), fixtures::groups(), 3, std::vector<ContactPoint>(1));
		driver.root_mode = mode;
		driver.obstacles = &walls;
		RigState state = at_rest(driver, { 5.0f, 0.0f, 0.0f });
		stand(driver, state, 1.0);
		state = at_rest(driver, { 5.0f, 0.0f, 0.0f });
		stand(driver, state, 3.0);
		CHECK((walls.asked > 0) == (mode == RootMode::SOFT));
	}
}

TEST(a_seat_is_taken_with_its_heading) {
	const Quat turn = exp({ 0.0f, PI, 0.0f });
	Driver driver(Rig(fixtures::limbs()), fixtures::groups(), 3, {});
	RigState state = at_rest(driver, {});
	stand(driver, state, 1.0);
	driver.set_frame(turn, { 4.0f, 0.0f, 0.0f });
	CHECK(stand(driver, state, 1.0 + double(DELTA)));
	CHECK_NEAR(state.root.x, 4.0, 1e-5);
	for (const Quat &limb : state.orientations) {
		CHECK_NEAR(angle_between(limb, turn), 0.0, 1e-3);
	}
}

TEST(a_turning_platform_puts_nobody_at_rest_whose_mode_changes) {
	Platform platform;
	Driver driver(Rig(fixtures::limbs()), fixtures::groups(), 3, std::vector<ContactPoint>(1));
	driver.ground = &platform;
	driver.root_mode = RootMode::LOWEST_FOOT;
	RigState state = at_rest(driver, {});
	double time = 1.0;
	for (int i = 0; i < 200; i++) {
		driver.root_mode = i < 100 ? RootMode::LOWEST_FOOT : RootMode::INERTIAL;
		state.linear[0] = { 0.0f, 0.0f, 0.5f };
		const bool is_put = stand(driver, state, time);
		if (i == 100) {
			CHECK(is_put); // Onto the arc.
			CHECK_NEAR(state.linear[0].z, 0.5, 1e-6);
		}
		platform.orientation = exp({ 0.0f, 0.5f * DELTA, 0.0f }) * platform.orientation;
		time += double(DELTA);
	}
}

TEST(who_is_carried_still_is_after_a_replay) {
	Platform platform;
	Driver driver(Rig(fixtures::limbs()), fixtures::groups(), 3, std::vector<ContactPoint>(1));
	driver.ground = &platform;
	driver.root_mode = RootMode::SOFT;
	RigState state = at_rest(driver, {});
	double time = 1.0;
	const auto turn_on = [&](int p_steps) {
		for (int i = 0; i < p_steps; i++) {
			stand(driver, state, time);
			platform.orientation = exp({ 0.0f, 0.5f * DELTA, 0.0f }) * platform.orientation;
			time += double(DELTA);
		}
	};
	turn_on(50);
	const std::vector<std::uint8_t> before = saved(driver);
	const Quat was = platform.orientation;
	turn_on(50);
	const std::vector<std::uint8_t> after = saved(driver);
	const Vec3 origin = driver.get_frame_origin();
	CHECK(origin.length() > 0.1f);
	platform.orientation = was;
	time -= 50.0 * double(DELTA);
	CHECK(restore(driver, before));
	CHECK(saved(driver) == before);
	turn_on(50);
	CHECK_NEAR((driver.get_frame_origin() - origin).length(), 0.0, 0.0);
	CHECK(saved(driver) == after);
}

TEST(a_refused_state_leaves_the_frame_that_is_set) {
	Driver driver(Rig(fixtures::limbs()), fixtures::groups(), 3, {});
	RigState state = at_rest(driver, {});
	stand(driver, state, 1.0);
	const std::vector<std::uint8_t> early = saved(driver);
	driver.set_frame(exp({ 0.0f, 1.0f, 0.0f }), { 4.0f, 0.0f, 0.0f });
	for (std::size_t size = 0; size < early.size(); size += 7) {
		CHECK(!restore(driver, { early.begin(), early.begin() + long(size) }));
		CHECK_NEAR(driver.get_frame_origin().x, 4.0, 0.0);
	}
	driver.set_frame(Quat(), { std::nanf(""), 0.0f, 0.0f });
	const std::vector<std::uint8_t> broken = saved(driver);
	driver.set_frame(Quat(), { 4.0f, 0.0f, 0.0f });
	CHECK(!restore(driver, broken));
	CHECK_NEAR(driver.get_frame_origin().x, 4.0, 0.0);
}

} // namespace test_driver
