// SPDX-License-Identifier: MIT
#include "balance/foothold.hpp"

#include "check.hpp"

#include <cmath>

namespace test_foothold {

namespace {

using ragdoll::Foothold;
using ragdoll::FootholdSettings;
using ragdoll::Footing;
using ragdoll::FootPlace;
using ragdoll::Ground;
using ragdoll::Vec3;

constexpr float STEP = 1.0f / 60.0f;

/// Level ground with something on it from z on, m.
class Heap : public Ground {
public:
	float top = 0.0f;
	float from = -1e9f;
	bool is_loose = true;

	float height(const Vec3 &p_at) const override { return find(p_at, STEP).height; }
	Footing find(const Vec3 &p_at, float /*p_above*/) const override {
		Footing found;
		found.height = p_at.z > from ? top : 0.0f;
		found.is_loose = is_loose && found.height > 0.0f;
		return found;
	}
};

/// A foot whose motion is that of somebody who stands on level ground.
struct Foot {
	Heap heap;
	FootholdSettings settings;
	FootPlace place;
	Foothold hold;

	Foot() {
		place.ball = { 0.0f, 0.0f, 0.15f };
		hold.begin(0.0f);
	}
	float go_on(int p_steps) {
		for (int step = 0; step < p_steps; step++) {
			hold.advance(heap, settings, place, STEP);
		}
		return hold.get_height();
	}
};

} // namespace

TEST(a_foot_is_put_onto_what_lies_under_it) {
	for (const float top : { 0.05f, 0.2f, 0.4f }) {
		Foot foot;
		foot.heap.top = top;
		CHECK_NEAR(foot.go_on(60), top, 1e-4);
		// The legs bend for most of it: nobody climbs heaps.
		CHECK_NEAR(foot.hold.find_rise(foot.settings), std::fmin(top, foot.settings.loose_rise), 1e-4);
	}
	Foot firm;
	firm.heap.top = 0.2f;
	firm.heap.is_loose = false;
	CHECK_NEAR(firm.go_on(60), 0.2, 1e-4);
	CHECK_NEAR(firm.hold.find_rise(firm.settings), 0.2, 1e-4);
}

TEST(what_a_foot_was_lifted_over_carries_nobody) {
	Foot foot;
	foot.heap.top = 0.3f;
	foot.place.is_up = true;
	foot.go_on(60);
	// It slips away under the foot, which is to stand now and comes down.
	foot.heap.top = 0.0f;
	foot.place.is_up = false;
	CHECK(foot.go_on(7) > 0.1f);
	CHECK_NEAR(foot.hold.find_rise(foot.settings), 0.0, 1e-4);
}

TEST(what_is_loose_and_higher_is_kicked_aside) {
	Foot foot;
	foot.heap.top = foot.settings.loose_climb + 0.01f;
	CHECK_NEAR(foot.go_on(60), 0.0, 1e-4);
}

TEST(a_foot_in_the_air_clears_what_comes) {
	for (const bool is_loose : { true, false }) {
		Foot foot;
		foot.heap.top = 0.2f;
		foot.heap.from = 0.2f;
		foot.heap.is_loose = is_loose;
		foot.place.is_up = true;
		foot.place.further = { 0.0f, 0.0f, 0.2f };
		const float over = is_loose ? foot.settings.loose_clearance : foot.settings.clearance;
		CHECK_NEAR(foot.go_on(60), 0.2 + over, 1e-4);
	}
}

TEST(a_foothold_is_restored) {
	Foot foot;
	foot.heap.top = 0.3f;
	foot.go_on(7);
	ragdoll::ArchiveWriter archive;
	foot.hold.save(archive);
	Foot other;
	other.heap.top = 0.3f;
	ragdoll::ArchiveReader reader(archive.get_bytes().data(), archive.get_bytes().size());
	CHECK(other.hold.restore(reader) && reader.is_at_end());
	for (int step = 0; step < 20; step++) {
		CHECK(foot.go_on(1) == other.go_on(1));
	}
	ragdoll::ArchiveReader cut(archive.get_bytes().data(), archive.get_bytes().size() - 1);
	CHECK(!Foothold().restore(cut));
}

} // namespace test_foothold
