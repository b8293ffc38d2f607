// SPDX-License-Identifier: MIT
#include "count_allocations.hpp"
#include "people.hpp"

#include <check.hpp>

#include <array>

using namespace wire;

TEST(coding_a_person_takes_no_memory) {
	std::mt19937 random(1);
	const Skeleton body = people::skeleton();
	const PersonLattice lattice;
	const PersonCodec codec(body, lattice.resolution());
	std::array<PersonState, 3> states;
	std::array<uint8_t, PersonCodec::MAX_BYTES> bytes{};
	PersonPose pose = people::draw_pose(random);
	int wrong = 0;
	const int before = allocations;
	for (int round = 0; round < 1000; round++) {
		states[0] = states[1];
		states[1] = states[2];
		pose = people::moved(random, pose, 0.05f);
		wrong += lattice.quantise(pose, body, &states[1], states[2]) ? 0 : 1;
		RangeEncoder encoder(bytes.data(), bytes.size());
		codec.encode(encoder, states[2], round == 0 ? nullptr : &states[1], &states[0], 2, 4);
		const std::size_t size = encoder.finish();
		PersonState found;
		RangeDecoder decoder(bytes.data(), size);
		wrong += codec.decode(decoder, found, round == 0 ? nullptr : &states[1], &states[0], 2, 4) ? 0 : 1;
		wrong += people::same(found, states[2], 16) ? 0 : 1;
		PersonPose restored;
		lattice.restore(found, body, restored);
	}
	CHECK(allocations == before);
	CHECK(wrong == 0);
	// The counter counts.
	::operator delete(::operator new(4));
	CHECK(allocations > before);
}

TEST_MAIN()
