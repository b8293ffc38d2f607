// SPDX-License-Identifier: MIT
// While a suit measures, nothing is allocated for its messages.
#include "suit_rig.hpp"

#include "check.hpp"
#include "count_allocations.hpp"

TEST(no_allocation_per_message) {
	SuitRig rig({ "--sensors=15", "--devices=ftdi", "--corrupt=0.0001" });
	CHECK(rig.measures_within(5.0));
	rig.run(1.0);
	int counted = 0;
	int before = 0;
	rig.around = [&](bool p_begins) {
		if (p_begins) {
			before = allocations;
		} else {
			counted += allocations - before;
		}
	};
	rig.frames = 0;
	rig.run(60.0);
	CHECK(rig.frames > 5000);
	CHECK(counted == 0);
}

TEST_MAIN()
