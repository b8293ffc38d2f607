// SPDX-License-Identifier: MIT
#include "walker_fixture.hpp"

#include <motion_file.hpp>

#include <check.hpp>

#include <cstring>

using namespace matching;

TEST(clips_are_read_as_they_were_written) {
	const std::vector<Clip> clips = walker_fixture::clips();
	const std::vector<uint8_t> bytes = write_motion_file(clips);
	std::vector<Clip> found;
	CHECK(read_motion_file(bytes.data(), bytes.size(), found).empty());
	CHECK(found.size() == clips.size());
	for (std::size_t i = 0; i < clips.size(); i++) {
		CHECK(found[i].name == clips[i].name && found[i].frames.size() == clips[i].frames.size());
		CHECK_NEAR(found[i].ankle_height, clips[i].ankle_height, 1e-6);
		const ClipFrame &was = clips[i].frames[20];
		const ClipFrame &is = found[i].frames[20];
		CHECK_NEAR((was.pose.hips - is.pose.hips).length(), 0.0, 3e-4);
		CHECK_NEAR(was.velocity_z, is.velocity_z, 1e-3);
		CHECK(was.contacts == is.contacts);
		for (std::size_t limb = 0; limb < LIMBS; limb++) {
			CHECK_NEAR(kinematics::angle_between(was.pose.limbs[limb], is.pose.limbs[limb]), 0.0, 1e-3);
		}
	}
	CHECK(write_motion_file(found).size() == bytes.size());
}

TEST(a_file_that_is_cut_anywhere_is_refused) {
	const std::vector<uint8_t> bytes = write_motion_file({ walker_fixture::clip("stand", 0.0f) });
	std::vector<Clip> found;
	for (std::size_t size = 0; size < bytes.size(); size += size < 64 ? 1 : 97) {
		CHECK(!read_motion_file(bytes.data(), size, found).empty());
		CHECK(found.empty());
	}
	std::vector<uint8_t> longer = bytes;
	longer.push_back(0);
	CHECK(read_motion_file(longer.data(), longer.size(), found) == "the motion set goes on behind its last clip");
}

TEST(what_is_no_pose_is_refused) {
	std::vector<Clip> found;
	std::vector<uint8_t> bytes = write_motion_file({ walker_fixture::clip("stand", 0.0f) });
	std::vector<uint8_t> zeros = bytes;
	std::memset(zeros.data() + zeros.size() - 100, 0, 99);
	CHECK(read_motion_file(zeros.data(), zeros.size(), found) == "clip stand has a frame that is no pose");
	// Where hips and left ankle of the first frame are, and its velocity: nobody is so far away or so fast.
	for (const std::size_t number : { 0U, 3U, 9U }) {
		std::vector<uint8_t> far_off = bytes;
		far_off[8 + 1 + 5 + 1 + 4 + 8 + 2 * number + 1] = 0x7F;
		CHECK(read_motion_file(far_off.data(), far_off.size(), found) == "clip stand has a frame that is no pose");
	}
	std::vector<uint8_t> newer = bytes;
	newer[4] = 9;
	CHECK(read_motion_file(newer.data(), newer.size(), found) ==
			"this is a motion set of version 9, expected version 1");
	// Its name's length is at 8, the number of its frames behind the name and the stance.
	bytes[8 + 1 + 5 + 1 + 3] = 0x7F;
	CHECK(read_motion_file(bytes.data(), bytes.size(), found) == "clip stand has too few or too many frames");
}
