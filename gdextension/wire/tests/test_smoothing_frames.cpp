// SPDX-License-Identifier: MIT
// People who are carried by a body: a platform that turns and moves, over a network with loss and jitter.
#include "smoothing_fixtures.hpp"

#include <check.hpp>

namespace test_smoothing_frames {

using namespace fixtures;

namespace {

constexpr uint16_t PERSON = 1;
constexpr uint16_t PLATFORM = 2000;

BodyUpdate platform(double p_time, uint32_t p_tick) {
	const float time = float(p_time);
	BodyUpdate body;
	body.tick = p_tick;
	body.id = PLATFORM;
	body.position = { 4.0f * std::sin(0.7f * time), 0.5f, 4.0f * std::cos(0.7f * time) };
	body.velocity = { 2.8f * std::cos(0.7f * time), 0.0f, -2.8f * std::sin(0.7f * time) };
	body.spin = { 0.0f, 1.2f, 0.0f };
	body.orientation = kinematics::exp({ 0.0f, 1.2f * time, 0.0f });
	return body;
}

// Stands off the platform's middle and turns the head a little.
PersonPose on_platform(double p_time) {
	PersonPose pose;
	pose.root = { 1.5f, 1.0f, -0.8f };
	pose.orientations[1] = kinematics::exp({ 0.0f, 0.1f * std::sin(float(p_time)), 0.0f });
	return pose;
}

PersonPose in_world(const PersonPose &p_local, const BodyUpdate &p_carrier) {
	PersonPose pose = p_local;
	pose.root = p_carrier.position + p_carrier.orientation.rotate(p_local.root);
	for (Quat &turn : pose.orientations) {
		turn = p_carrier.orientation * turn;
	}
	return pose;
}

struct Result {
	float worst_position = 0.0f; // On the carrier as shown, m.
	float worst_angle = 0.0f; // rad
	float worst_jump = 0.0f; // From frame to frame, beyond the real motion, m.
};

// Twelve seconds at 60 frames a second; p_is_on says whether the person is carried at a time.
template <typename IsOn>
Result watch(uint32_t p_step, double p_loss, IsOn p_is_on) {
	Smoother smoother;
	smoother.set_skeleton(PERSON, arm());
	const std::vector<fixtures::Arrival> datagrams = network(100, 820, p_step, 0.05, 0.03, p_loss);
	std::size_t next = 0;
	Result result;
	Vec3 before;
	Vec3 true_before;
	for (int frame = 0; frame < 720; frame++) {
		const double now = (100.0 + frame) / 60.0 + 0.003;
		for (; next < datagrams.size() && datagrams[next].arrival <= now; next++) {
			const uint32_t tick = datagrams[next].tick;
			const double time = double(tick) / 60.0;
			const BodyUpdate carrier = platform(time, tick);
			smoother.push(carrier, datagrams[next].arrival);
			PersonUpdate update;
			update.tick = tick;
			update.id = PERSON;
			update.frame = p_is_on(time) ? PLATFORM : uint16_t(0);
			update.pose = p_is_on(time) ? on_platform(time) : in_world(on_platform(time), carrier);
			smoother.push(update, datagrams[next].arrival);
		}
		smoother.evaluate(now);
		const Smoother::Person *person = smoother.person(PERSON);
		const BodyTransform *carrier = smoother.body(PLATFORM);
		if (person == nullptr || carrier == nullptr || frame < 60) {
			continue;
		}
		const double shown = smoother.shown_tick() / 60.0;
		const Vec3 local = carrier->orientation.inverse().rotate(person->pose.root - carrier->position);
		const Vec3 right = in_world(on_platform(shown), platform(shown, 0)).root;
		if (frame > 60) {
			result.worst_jump =
					std::max(result.worst_jump, ((person->pose.root - before) - (right - true_before)).length());
		}
		before = person->pose.root;
		true_before = right;
		result.worst_position = std::max(result.worst_position, (local - on_platform(shown).root).length());
		const Quat head = carrier->orientation.inverse() * person->pose.orientations[1];
		result.worst_angle =
				std::max(result.worst_angle, kinematics::angle_between(head, on_platform(shown).orientations[1]));
	}
	return result;
}

} // namespace

TEST(who_is_carried_stays_in_place_on_the_carrier) {
	for (const uint32_t step : { 1U, 2U }) {
		for (const double loss : { 0.0, 0.05 }) {
			const Result result = watch(step, loss, [](double) { return true; });
			CHECK(result.worst_position < 0.01f);
			CHECK(result.worst_angle < 0.5f * 3.14159f / 180.0f);
		}
	}
}

TEST(without_a_frame_it_would_not) {
	// The measure is one that can fail: a person in the world's frame slides on the platform as shown.
	const Result result = watch(2, 0.05, [](double) { return false; });
	CHECK(result.worst_position > 0.01f);
}

TEST(getting_on_and_off_makes_no_jump) {
	for (const uint32_t step : { 1U, 2U }) {
		const Result result = watch(step, 0.05, [](double p_time) { return int(p_time) % 2 == 0; });
		CHECK(result.worst_jump < 0.05f);
	}
}

TEST(who_is_carried_by_something_unknown_waits) {
	Smoother smoother;
	smoother.set_skeleton(PERSON, arm());
	PersonUpdate update;
	update.id = PERSON;
	update.frame = PLATFORM;
	update.pose = on_platform(0.0);
	for (uint32_t tick = 100; tick < 120; tick++) {
		update.tick = tick;
		CHECK(smoother.push(update, tick / 60.0));
		smoother.evaluate(tick / 60.0 + 0.002);
	}
	Smoother::Person person;
	CHECK(smoother.person(PERSON) == nullptr && !smoother.newest(PERSON, person));
	CHECK(smoother.push(platform(2.0, 120), 2.0));
	smoother.evaluate(2.0);
	CHECK(smoother.person(PERSON) != nullptr && smoother.newest(PERSON, person));
	CHECK_NEAR((person.pose.root - smoother.person(PERSON)->pose.root).length(), 0.0, 0.2);
}

TEST(who_is_carried_by_a_predicted_body_is_shown_on_it) {
	Smoother smoother;
	smoother.set_skeleton(PERSON, arm());
	const BodyTransform ahead{ { 30.0f, 2.0f, -4.0f }, kinematics::exp({ 0.0f, 0.6f, 0.0f }) };
	CHECK(!smoother.predict_body(PLATFORM, ahead));
	for (uint32_t tick = 100; tick < 160; tick++) {
		smoother.push(platform(double(tick) / 60.0, tick), double(tick) / 60.0);
		PersonUpdate update;
		update.tick = tick;
		update.id = PERSON;
		update.frame = PLATFORM;
		update.pose = on_platform(double(tick) / 60.0);
		smoother.push(update, double(tick) / 60.0);
	}
	CHECK(smoother.predict_body(PLATFORM, ahead));
	CHECK(!smoother.predict_body(PLATFORM, { { NAN, 0.0f, 0.0f }, Quat() }));
	smoother.evaluate(159.0 / 60.0);
	CHECK((smoother.body(PLATFORM)->position - ahead.position).length() < 1e-4f);
	const Vec3 local = ahead.orientation.inverse().rotate(smoother.person(PERSON)->pose.root - ahead.position);
	CHECK((local - on_platform(0.0).root).length() < 1e-3f);
	CHECK(smoother.moved_bodies().size() == 1);
	smoother.forget_prediction(PLATFORM);
	smoother.evaluate(160.0 / 60.0);
	CHECK((smoother.body(PLATFORM)->position - ahead.position).length() > 10.0f);
}

TEST(fields_move_as_their_kind_says) {
	EntityTypes types;
	const uint8_t kinds[3] = { 0, 1, 2 };
	const float mins[3] = { 0.0f, 0.0f, 0.0f };
	const float maxs[3] = { 360.0f, 10.0f, 9.0f };
	const float resolutions[3] = { 1.0f, 0.01f, 1.0f };
	CHECK(types.define(0, 3, kinds, mins, maxs, resolutions));
	const EntityType &type = *types.find(0);
	const uint32_t spawn[3] = { 350, 0, 1 };
	FieldTrack track(type, spawn);
	CHECK_NEAR(track.at(0, 5.0), 350.0, 1e-3);
	const uint32_t first[3] = { 350, 100, 1 };
	const uint32_t second[3] = { 10, 200, 5 };
	CHECK(track.push(10.0, first, 0.1) && track.push(10.1, second, 0.1));
	CHECK(!track.push(10.1, first, 0.1));
	// The short way round, evenly, at once.
	CHECK_NEAR(track.at(0, 10.025), 355.0, 1e-2);
	CHECK_NEAR(track.at(0, 10.075), 5.0, 1e-2);
	CHECK_NEAR(track.at(1, 10.05), 1.5, 1e-3);
	CHECK(track.at(2, 10.099) == 1.0f && track.at(2, 10.1) == 5.0f);
	// Beyond the newest all stay.
	CHECK_NEAR(track.at(1, 99.0), 2.0, 1e-3);
	// After a rest it moves only just before the update.
	const uint32_t third[3] = { 20, 300, 5 };
	CHECK(track.push(50.0, third, 0.1));
	CHECK_NEAR(track.at(1, 49.85), 2.0, 1e-3);
	CHECK_NEAR(track.at(1, 49.95), 2.5, 1e-3);
	// Late ones go where they belong.
	const uint32_t late[3] = { 10, 250, 5 };
	CHECK(track.push(49.9, late, 0.1));
	CHECK_NEAR(track.at(1, 49.9), 2.5, 1e-3);
	for (int i = 0; i < 40; i++) {
		CHECK(track.push(60.0 + 0.1 * i, third, 0.1));
	}
	CHECK(!track.push(55.0, first, 0.1));
	CHECK_NEAR(track.newest(1), 3.0, 1e-3);
}

} // namespace test_smoothing_frames
