// SPDX-License-Identifier: MIT
// The parts of samples put together: any order, loss, doubles, several characters.
#include "drawn_content.hpp"

#include "mvn/collector.hpp"

#include <check.hpp>

#include <algorithm>

namespace test_collector {

using namespace drawn;

namespace {

constexpr uint64_t TICK_USEC = 10000;

Outcome give(Collector &r_collector, const Bytes &p_bytes, uint64_t p_now_usec, uint64_t p_sender = 1) {
	return r_collector.take(p_bytes.data(), p_bytes.size(), p_sender, p_now_usec);
}

/// A pose in one datagram.
Bytes pose(Source &r_source, uint32_t p_sample, int p_character = 0, Type p_type = Type::POSE) {
	Content content = r_source.content(p_type, p_sample);
	content.header.character = uint8_t(p_character);
	return encode(content, 65000)[0];
}

} // namespace

TEST(split_samples_are_whole_in_any_order) {
	Source source(1);
	std::mt19937 random(2);
	Collector collector;
	int whole = 0;
	for (uint32_t sample = 0; sample < 300; ++sample) {
		const Type type = TYPES_OF_ALL[sample % TYPES_OF_ALL.size()];
		if (type == Type::META || type == Type::TIME_CODE || type == Type::CENTRE_OF_MASS) {
			continue;
		}
		const Content content = source.content(type, sample, type != Type::SCALE);
		std::vector<Bytes> datagrams = encode(content, 200 + source.below(900));
		CHECK(datagrams.size() > 1);
		std::shuffle(datagrams.begin(), datagrams.end(), random);
		for (std::size_t at = 0; at < datagrams.size(); ++at) {
			const Outcome outcome = give(collector, datagrams[at], (sample + 1) * TICK_USEC);
			CHECK(outcome == (at + 1 == datagrams.size() ? Outcome::SAMPLE : Outcome::PART));
		}
		CHECK(same(collector.content(), content));
		++whole;
	}
	CHECK(collector.statistics(0).samples == uint64_t(whole));
	CHECK(collector.statistics(0).incomplete == 0 && collector.statistics(0).late == 0);
}

TEST(samples_may_be_mixed_with_the_next) {
	Source source(3);
	Collector collector;
	const std::vector<Bytes> first = encode(source.content(Type::POSE, 1, true), 1400);
	const std::vector<Bytes> second = encode(source.content(Type::POSE, 2, true), 1400);
	CHECK(first.size() == 2 && second.size() == 2);
	CHECK(give(collector, first[0], 1) == Outcome::PART);
	CHECK(give(collector, second[0], 2) == Outcome::PART);
	CHECK(give(collector, first[1], 3) == Outcome::SAMPLE);
	CHECK(collector.content().header.sample == 1);
	CHECK(give(collector, second[1], 4) == Outcome::SAMPLE);
	CHECK(collector.content().header.sample == 2);
	CHECK(collector.statistics(0).incomplete == 0);
}

TEST(a_sample_that_lacks_a_part_is_counted_and_stops_nothing) {
	Source source(4);
	Collector collector;
	uint64_t now = 0;
	int whole = 0;
	int partial = 0;
	for (uint32_t sample = 0; sample < 100; ++sample) {
		const std::vector<Bytes> datagrams = encode(source.content(Type::POSE, sample, true), 1400);
		for (std::size_t part = 0; part < datagrams.size(); ++part) {
			if (sample % 10 == 5 && part == 1) {
				continue;
			}
			whole += give(collector, datagrams[part], now += 1000) == Outcome::SAMPLE ? 1 : 0;
			partial += int(collector.take_partial().size());
		}
	}
	CHECK(whole == 90 && partial == 10);
	CHECK(collector.statistics(0).incomplete == 10);
	// The bodies are there.
	CHECK(collector.statistics(0).partial == 10 && collector.statistics(0).lost == 0);
}

TEST(a_body_is_kept_when_only_fingers_are_lost) {
	Source source(14);
	Collector collector;
	uint64_t now = 0;
	std::vector<uint32_t> got;
	for (uint32_t sample = 0; sample < 100; ++sample) {
		const Content content = source.content(Type::POSE, sample, true);
		const std::vector<Bytes> datagrams = encode(content, 1400);
		CHECK(datagrams.size() == 2);
		for (std::size_t part = 0; part < datagrams.size(); ++part) {
			// For a while no fingers come at all, then now and then.
			if (part == 1 && (sample < 40 || sample % 10 == 5)) {
				continue;
			}
			const bool is_whole = give(collector, datagrams[part], now += 1000) == Outcome::SAMPLE;
			for (const Content &partial : collector.take_partial()) {
				CHECK(partial.poses.size() == std::size_t(BODY_SEGMENTS));
				CHECK(partial.header.fingers == 0 && partial.header.props == 0);
				got.push_back(partial.header.sample);
			}
			if (is_whole) {
				got.push_back(collector.content().header.sample);
				CHECK(same(collector.content(), content));
			}
		}
	}
	CHECK(std::is_sorted(got.begin(), got.end()));
	CHECK(got.size() == 100);
	CHECK(collector.statistics(0).partial == 46);
	CHECK(collector.statistics(0).samples == 100 && collector.statistics(0).lost == 0);
}

TEST(a_datagram_that_comes_twice_is_no_second_person) {
	Source source(15);
	Collector collector;
	uint64_t now = 0;
	for (uint32_t sample = 0; sample < 50; ++sample) {
		for (const Bytes &datagram : encode(source.content(Type::POSE, sample, true), 300)) {
			give(collector, datagram, now += 100);
			give(collector, datagram, now += 100);
		}
	}
	CHECK(collector.statistics(0).late > 300);
	CHECK(collector.statistics(0).conflicting == 0);
	for (uint32_t sample = 50; sample < 100; ++sample) {
		give(collector, pose(source, sample), now += 10000);
		give(collector, pose(source, sample), now += 100);
	}
	CHECK(collector.statistics(0).conflicting == 50);
}

TEST(loss_is_counted_against_the_senders_own_step) {
	for (const uint32_t step : { 1U, 2U, 4U }) {
		Source source(5);
		Collector collector;
		uint64_t now = 1;
		uint64_t left_out = 0;
		for (uint32_t number = 0; number < 500; ++number) {
			now += TICK_USEC;
			if (number > 10 && source.below(10) == 0) {
				++left_out;
				continue;
			}
			// Near the end of the counter, so that it wraps.
			CHECK(give(collector, pose(source, 0xFFFFFF00U + number * step), now) == Outcome::SAMPLE);
		}
		// What is left out at the very end cannot be known.
		CHECK(collector.statistics(0).lost + 3 >= left_out && collector.statistics(0).lost <= left_out);
		CHECK(left_out > 20);
		CHECK_NEAR(collector.statistics(0).rate_hz, 90.0, 12.0);
	}
}

TEST(doubles_and_late_ones_are_counted_and_change_nothing) {
	Source source(6);
	Collector collector;
	uint64_t now = 1;
	std::vector<Bytes> sent;
	for (uint32_t number = 0; number < 50; ++number) {
		sent.push_back(pose(source, number));
		CHECK(give(collector, sent.back(), now += TICK_USEC) == Outcome::SAMPLE);
		CHECK(give(collector, sent.back(), now) == Outcome::LATE);
	}
	CHECK(give(collector, sent[20], now) == Outcome::LATE);
	CHECK(collector.statistics(0).samples == 50 && collector.statistics(0).late == 51);
	CHECK(collector.statistics(0).lost == 0);
	CHECK(collector.content().header.sample == 49);
}

TEST(a_recording_that_begins_anew_goes_on) {
	for (const uint32_t length : { 100U, 5000U }) {
		Source source(7);
		Collector collector;
		uint64_t now = 1;
		for (uint32_t number = length - 50; number < length; ++number) {
			give(collector, pose(source, number), now += TICK_USEC);
		}
		now += 1000000;
		int taken = 0;
		for (uint32_t number = 0; number < 50; ++number) {
			taken += give(collector, pose(source, number), now += TICK_USEC) == Outcome::SAMPLE ? 1 : 0;
		}
		CHECK(taken == 50);
		CHECK(collector.statistics(0).lost == 0);
	}
}

TEST(characters_do_not_disturb_each_other) {
	Source source(8);
	Collector collector;
	uint64_t now = 1;
	for (uint32_t number = 0; number < 60; ++number) {
		for (int character = 0; character < MAX_CHARACTERS; ++character) {
			for (const Type type : { Type::POSE, Type::TRACKERS }) {
				CHECK(give(collector, pose(source, number, character * 7, type), now += 10) == Outcome::SAMPLE);
			}
		}
	}
	CHECK(collector.characters().size() == std::size_t(MAX_CHARACTERS));
	for (const auto &[number, statistics] : collector.characters()) {
		CHECK(number % 7 == 0 && statistics.lost == 0);
	}
	CHECK(give(collector, pose(source, 1, 250), now) == Outcome::CROWDED);
	collector.forget_silent(now + 1);
	CHECK(collector.characters().empty());
	CHECK(give(collector, pose(source, 1, 250), now) == Outcome::SAMPLE);
}

TEST(a_second_sender_of_a_character_is_left_out_until_the_first_is_silent) {
	Source source(9);
	Collector collector;
	uint64_t now = 1;
	for (uint32_t number = 0; number < 100; ++number) {
		now += TICK_USEC;
		CHECK(give(collector, pose(source, number), now, 1) == Outcome::SAMPLE);
		CHECK(give(collector, pose(source, number + 40), now, 2) == Outcome::FOREIGN);
	}
	CHECK(collector.statistics(0).foreign == 100 && collector.statistics(0).late == 0);
	now += 2500000;
	CHECK(give(collector, pose(source, 3), now, 2) == Outcome::SAMPLE);
	CHECK(collector.statistics(0).foreign == 0);
}

TEST(parts_that_contradict_each_other_are_refused) {
	Source source(10);
	Collector collector;
	std::vector<Bytes> datagrams = encode(source.content(Type::POSE, 1, true), 700);
	CHECK(datagrams.size() > 2);
	datagrams[0][10] |= 0x80U; // The first says that it is the last.
	CHECK(give(collector, datagrams[1], 1) == Outcome::PART);
	CHECK(give(collector, datagrams[0], 2) == Outcome::REFUSED);
	CHECK(collector.refused(Fault::BAD_PARTS) == 1);
	CHECK(give(collector, pose(source, 2), 3) == Outcome::SAMPLE);
}

TEST(a_datagram_with_255_segments_stops_nothing) {
	Source source(11);
	Collector collector;
	for (uint32_t number = 0; number < 20; ++number) {
		Bytes bad = pose(source, number * 2);
		bad[11] = 255;
		bad[22] = 0;
		bad[23] = 0;
		bad.resize(HEADER_SIZE + 255 * 32);
		CHECK(give(collector, bad, number * TICK_USEC + 1) == Outcome::REFUSED);
		CHECK(collector.fault() == Fault::TOO_MANY);
		CHECK(give(collector, pose(source, number * 2 + 1), number * TICK_USEC + 2) == Outcome::SAMPLE);
	}
	CHECK(collector.refused(Fault::TOO_MANY) == 20 && collector.statistics(0).samples == 20);
}

TEST(endless_parts_take_bounded_memory) {
	Source source(12);
	Collector collector;
	Content content = source.content(Type::META, 1);
	content.tags.assign(150, { "long", std::string(200, 'x') });
	Bytes bytes = encode(content, 65000)[0];
	int refused = 0;
	for (unsigned part = 0; part < 120; ++part) {
		bytes[10] = uint8_t(part);
		refused += give(collector, bytes, 1) == Outcome::REFUSED ? 1 : 0;
	}
	CHECK(refused > 30);
}

} // namespace test_collector
