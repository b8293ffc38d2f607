// SPDX-License-Identifier: MIT
#include "people.hpp"

#include <check.hpp>

#include <cmath>
#include <limits>

namespace test_person_lattice {

using namespace wire;

namespace {

double error_of_rotation(const PersonLattice &p_lattice, const Quat &p_rotation, const RotationCode *p_previous) {
	PersonPose pose;
	PersonPose restored;
	pose.orientations[0] = p_rotation;
	restored.orientations[0] = p_lattice.rotation(p_lattice.nearest(p_rotation, p_previous));
	return people::error_of(pose, restored, 1);
}

} // namespace

TEST(every_limb_of_any_pose_is_within_the_error_asked_for) {
	std::mt19937 random(1);
	const Skeleton body = people::skeleton();
	for (const double most : { 0.05, 0.1, 0.5, 2.0 }) {
		const PersonLattice lattice(PersonLattice::resolution_for(most));
		double found = 0.0;
		PersonState state;
		PersonPose pose = people::draw_pose(random);
		for (int round = 0; round < 5000; round++) {
			pose = round % 10 == 0 ? people::draw_pose(random) : people::moved(random, pose, 0.1f);
			CHECK(lattice.quantise(pose, body, round % 3 == 0 ? nullptr : &state, state));
			PersonPose restored;
			lattice.restore(state, body, restored);
			found = std::max(found, people::error_of(pose, restored, 16));
			CHECK((pose.root - restored.root).length() < 0.00088f);
		}
		CHECK(found <= most);
		CHECK(found > 0.6 * most);
	}
}

TEST(the_two_usual_resolutions_keep_what_they_promise) {
	CHECK(PersonLattice::resolution_for(0.1) <= PersonLattice::FINE);
	CHECK(PersonLattice::resolution_for(0.5) <= PersonLattice::COARSE);
	CHECK(PersonLattice::FINE < 1.02 * PersonLattice::resolution_for(0.1));
	CHECK(PersonLattice::COARSE < 1.02 * PersonLattice::resolution_for(0.5));
}

TEST(a_rotation_and_its_negative_have_the_same_code) {
	std::mt19937 random(2);
	const PersonLattice lattice;
	int different = 0;
	for (int i = 0; i < 20000; i++) {
		const Quat rotation = people::draw_rotation(random);
		different += lattice.nearest(rotation, nullptr) == lattice.nearest(-rotation, nullptr) ? 0 : 1;
	}
	CHECK(different == 0);
}

TEST(rotations_at_the_edges_of_charts) {
	const PersonLattice lattice;
	double worst = 0.0;
	const float half = std::sqrt(0.5f);
	for (int pair = 0; pair < 4; pair++) {
		for (const float off : { -1e-3f, -1e-7f, 0.0f, 1e-7f, 1e-3f }) {
			float values[4] = {};
			values[pair] = half + off;
			values[(pair + 1) % 4] = -half;
			const Quat edge = Quat{ values[0], values[1], values[2], values[3] }.normalized();
			const Quat corner = Quat{ 0.5f + off, -0.5f, 0.5f, -0.5f - off }.normalized();
			for (int chart = 0; chart < 4; chart++) {
				RotationCode previous;
				previous.dropped = uint8_t(chart);
				worst = std::max(worst, error_of_rotation(lattice, edge, &previous));
				worst = std::max(worst, error_of_rotation(lattice, corner, &previous));
			}
			worst = std::max(worst, error_of_rotation(lattice, edge, nullptr));
		}
	}
	CHECK(worst < 0.1);
}

TEST(a_code_seen_in_another_chart_is_the_same_rotation) {
	std::mt19937 random(3);
	const PersonLattice lattice;
	const double unit = 1.0 / (double(FRACTION) * lattice.resolution());
	double worst = 0.0;
	for (int i = 0; i < 20000; i++) {
		const Quat rotation = people::draw_rotation(random);
		const RotationCode code = lattice.nearest(rotation, nullptr);
		const int chart = int(random() % 4);
		const Parts parts = parts_in_chart(code, chart, lattice.resolution());
		const double a[3] = { parts[0] * unit, parts[1] * unit, parts[2] * unit };
		const double square = a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
		double values[4] = {};
		int at = 0;
		for (int j = 0; j < 4; j++) {
			values[j] = j == chart ? (1.0 - square) / (1.0 + square) : 2.0 * a[at++] / (1.0 + square);
		}
		PersonPose one;
		PersonPose other;
		one.orientations[0] = lattice.rotation(code);
		other.orientations[0] = { float(values[0]), float(values[1]), float(values[2]), float(values[3]) };
		worst = std::max(worst, people::error_of(one, other, 1));
	}
	CHECK(worst < 0.005);
}

TEST(what_is_no_pose_is_refused_and_changes_nothing) {
	std::mt19937 random(4);
	const PersonLattice lattice;
	const Skeleton body = people::skeleton();
	const PersonPose good = people::draw_pose(random);
	PersonState state;
	CHECK(lattice.quantise(good, body, nullptr, state));
	const PersonState kept = state;
	for (const float bad :
			{ std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -1e30f }) {
		PersonPose pose = good;
		pose.root.y = bad;
		CHECK(!lattice.quantise(pose, body, nullptr, state));
		pose = good;
		pose.orientations[15].z = bad;
		CHECK(!lattice.quantise(pose, body, nullptr, state));
	}
	PersonPose pose = good;
	pose.orientations[3] = { 0.0f, 0.0f, 0.0f, 0.0f };
	CHECK(!lattice.quantise(pose, body, nullptr, state));
	CHECK(people::same(state, kept, 16));
}

} // namespace test_person_lattice
