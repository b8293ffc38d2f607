// SPDX-License-Identifier: MIT
// One datagram: what is read of it, and what is refused.
#include "drawn_content.hpp"

#include "mvn/stranger_text.hpp"

#include <check.hpp>

#include <cstring>

namespace test_datagram {

using namespace drawn;

namespace {

Fault read(const Bytes &p_bytes, Content &r_content) {
	const Fault fault = read_header(p_bytes.data(), p_bytes.size(), r_content.header);
	return fault != Fault::NONE
			? fault
			: read_payload(r_content.header, p_bytes.data() + HEADER_SIZE, p_bytes.size() - HEADER_SIZE, r_content);
}

Fault fault_of(const Bytes &p_bytes) {
	Content content;
	return read(p_bytes, content);
}

Bytes head(int p_type, unsigned p_items) {
	Bytes bytes = { 'M', 'X', 'T', 'P', uint8_t('0' + p_type / 10), uint8_t('0' + p_type % 10), 0, 0, 0, 7, 0x80,
		uint8_t(p_items), 0, 0, 0, 9, 3 };
	bytes.resize(HEADER_SIZE); // As before MVN 2019: nothing behind the character.
	return bytes;
}

void add_float(Bytes &r_bytes, float p_value) {
	uint32_t bits = 0;
	std::memcpy(&bits, &p_value, sizeof(bits));
	for (int shift = 24; shift >= 0; shift -= 8) {
		r_bytes.push_back(uint8_t(bits >> unsigned(shift)));
	}
}

void add_id(Bytes &r_bytes, int p_id) {
	r_bytes.insert(r_bytes.end(), { 0, 0, uint8_t(p_id / 256), uint8_t(p_id % 256) });
}

/// Datagrams written by hand from docs/mvn.md, not by the encoder.
Bytes pose_by_hand(unsigned p_items) {
	Bytes bytes = head(2, p_items);
	for (unsigned item = 0; item < p_items; ++item) {
		add_id(bytes, int(item) + 1);
		for (const float value : { 1.0F, 2.0F, float(item), 0.5F, -0.5F, 0.5F, 0.5F }) {
			add_float(bytes, value);
		}
	}
	return bytes;
}

} // namespace

TEST(a_quaternion_pose_of_an_old_sender_is_read) {
	const Bytes bytes = pose_by_hand(23);
	CHECK(bytes.size() == 760);
	Content content;
	CHECK(read(bytes, content) == Fault::NONE);
	CHECK(content.header.type == Type::POSE && content.header.sample == 7 && content.header.time_code_ms == 9);
	CHECK(content.header.character == 3 && content.header.is_last && content.header.part == 0);
	CHECK(content.poses.size() == 23);
	CHECK(content.poses[22].id == 23);
	CHECK((content.poses[5].position == Vector{ 1.0F, 2.0F, 5.0F }));
	CHECK((content.poses[5].rotation == Quaternion{ 0.5F, -0.5F, 0.5F, 0.5F }));
}

TEST(trackers_are_distinguished_by_the_size_of_their_items) {
	for (const bool is_full : { false, true }) {
		Bytes bytes = head(23, 2);
		for (int item = 0; item < 2; ++item) {
			add_id(bytes, item + 1);
			for (int value = 0; value < (is_full ? 16 : 10); ++value) {
				add_float(bytes, value == 0 ? 1.0F : (value < 4 ? 0.0F : float(value)));
			}
		}
		CHECK(bytes.size() == HEADER_SIZE + 2 * (is_full ? 68 : 44));
		Content content;
		CHECK(read(bytes, content) == Fault::NONE);
		CHECK(content.motions.size() == 2 && content.motions[1].is_full == is_full);
		CHECK((content.motions[1].free_acceleration == Vector{ 4.0F, 5.0F, 6.0F }));
		const Vector field = is_full ? Vector{ 13.0F, 14.0F, 15.0F } : Vector{ 7.0F, 8.0F, 9.0F };
		CHECK(content.motions[1].magnetic_field == field);
		CHECK(!is_full || (content.motions[1].rate == Vector{ 10.0F, 11.0F, 12.0F }));
	}
}

TEST(a_segment_without_a_tracker_may_have_no_rotation) {
	Bytes bytes = head(23, 1);
	add_id(bytes, 2);
	for (int value = 0; value < 16; ++value) {
		add_float(bytes, 0.0F);
	}
	Content content;
	CHECK(read(bytes, content) == Fault::NONE);
	CHECK(content.motions.size() == 1 && !content.motions[0].has_rotation);
}

TEST(the_time_code_comes_with_a_length_and_without) {
	const std::string text = "01:02:03.456";
	for (const bool has_length : { false, true }) {
		Bytes bytes = head(25, 1);
		if (has_length) {
			add_id(bytes, 12);
		}
		bytes.insert(bytes.end(), text.begin(), text.end());
		Content content;
		CHECK(read(bytes, content) == Fault::NONE);
		CHECK(content.time_code == text);
		bytes.back() = 'x';
		CHECK(fault_of(bytes) == Fault::BAD_VALUE);
		bytes.pop_back();
		CHECK(fault_of(bytes) == Fault::WRONG_SIZE);
	}
}

TEST(the_centre_of_mass_may_have_more_behind_it) {
	Bytes bytes = head(24, 1);
	for (int value = 0; value < 9; ++value) {
		add_float(bytes, float(value));
	}
	Content content;
	CHECK(read(bytes, content) == Fault::NONE);
	CHECK((content.centre_of_mass == Vector{ 0.0F, 1.0F, 2.0F }));
	bytes.resize(HEADER_SIZE + 11);
	CHECK(fault_of(bytes) == Fault::WRONG_SIZE);
}

TEST(meta_data_come_in_any_order_with_unknown_tags) {
	const std::string text = "colour:?\ncolor:FF00AA\nno line of a tag\nname:Eve:2\n:\n\nxmid:5";
	Bytes bytes = head(12, 0);
	bytes.insert(bytes.end(), text.begin(), text.end());
	Content content;
	CHECK(read(bytes, content) == Fault::NONE);
	CHECK(content.tags.size() == 4);
	CHECK(content.tags[2].first == "name" && content.tags[2].second == "Eve:2");
	CHECK(content.tags[3].second == "5");
}

TEST(text_of_strangers_is_made_harmless) {
	const std::string bad = "a\x1B[31m\xC0\x80\xFF\xE2\x82\xAC\xED\xA0\x80\xC2\x9B!\xF0\x9F\x98\x80\xE2\x82";
	const std::string good = clean_text(bad.data(), bad.size());
	CHECK(good ==
			"a[31m?"
			"?"
			"?\xE2\x82\xAC?"
			"?"
			"?!\xF0\x9F\x98\x80?"
			"?");
	CHECK(cut_text("1\xE2\x82\xAC", 3) == "1");
	CHECK(cut_text("1\xE2\x82\xAC", 4) == "1\xE2\x82\xAC");
}

TEST(what_does_not_fit_is_refused_with_its_reason) {
	CHECK(fault_of({}) == Fault::TOO_SHORT);
	CHECK(fault_of(Bytes(23, 'M')) == Fault::TOO_SHORT);
	CHECK(fault_of(Bytes(24, 'M')) == Fault::NOT_MXTP);
	CHECK(fault_of(head(4, 0)) == Fault::UNKNOWN_TYPE);
	CHECK(fault_of(head(99, 0)) == Fault::UNKNOWN_TYPE);
	Bytes pose = pose_by_hand(23);
	pose.pop_back();
	CHECK(fault_of(pose) == Fault::WRONG_SIZE);
	CHECK(fault_of(pose_by_hand(255)) == Fault::TOO_MANY);
	pose = pose_by_hand(23);
	pose[11] = 255;
	CHECK(fault_of(pose) != Fault::NONE);
	pose = pose_by_hand(23);
	pose[17] = 255;
	CHECK(fault_of(pose) == Fault::TOO_MANY);
	pose = pose_by_hand(23);
	pose[23] = 1;
	CHECK(fault_of(pose) == Fault::WRONG_SIZE);
	pose = pose_by_hand(23);
	pose[HEADER_SIZE + 4] = 0x7F;
	pose[HEADER_SIZE + 5] = 0xC0; // Not a number.
	CHECK(fault_of(pose) == Fault::BAD_VALUE);
	pose = pose_by_hand(23);
	pose[HEADER_SIZE + 16] = 0x41; // A quaternion of length 8.
	CHECK(fault_of(pose) == Fault::BAD_VALUE);
}

TEST(scale_data_cannot_ask_for_memory) {
	for (const uint8_t first : { uint8_t(0x7F), uint8_t(0xFF), uint8_t(0x00) }) {
		Bytes bytes = head(13, 1);
		bytes.insert(bytes.end(), { first, 0xFF, 0xFF, 0xFF });
		CHECK(fault_of(bytes) != Fault::NONE);
	}
	Bytes bytes = head(13, 1);
	bytes.insert(bytes.end(), { 0, 0, 0, 1, 0x7F, 0xFF, 0xFF, 0xFF, 'x' });
	CHECK(fault_of(bytes) == Fault::WRONG_SIZE);
	bytes = head(13, 1);
	bytes.insert(bytes.end(), { 0, 0, 0, 1 }); // One is announced, none comes.
	CHECK(fault_of(bytes) == Fault::WRONG_SIZE);
}

TEST(whatever_is_written_is_read_as_it_was) {
	Source source(3);
	for (int round = 0; round < 40; ++round) {
		for (const Type type : TYPES_OF_ALL) {
			Content content = source.content(type, source.below(1U << 31U), false);
			content.header.character = uint8_t(source.below(256));
			const std::vector<Bytes> datagrams = encode(content, 65000);
			CHECK(!datagrams.empty());
			Content found;
			Fault fault = Fault::NONE;
			for (const Bytes &datagram : datagrams) {
				const Fault one = read(datagram, found);
				fault = one != Fault::NONE ? one : fault;
				// The size in the head is what it is.
				CHECK(found.header.payload == datagram.size() - HEADER_SIZE);
			}
			CHECK(fault == Fault::NONE);
			CHECK(same(found, content));
		}
	}
}

TEST(every_cut_of_a_datagram_is_refused_or_shorter_text) {
	Source source(4);
	for (const Type type : TYPES_OF_ALL) {
		const std::vector<Bytes> datagrams = encode(source.content(type, 5), 65000);
		const Bytes &whole = datagrams[0];
		for (std::size_t size = 0; size < whole.size(); ++size) {
			// In memory of just that size, for sanitizers.
			CHECK(fault_of(Bytes(whole.begin(), whole.begin() + std::ptrdiff_t(size))) != Fault::NONE);
		}
	}
}

} // namespace test_datagram
