// SPDX-License-Identifier: MIT
#include "bus_streams.hpp"
#include "count_allocations.hpp"

#include "check.hpp"

#include <limits>

using namespace streams;

namespace {

using Step = CounterTrack::Step;
using Verdict = StreamCheck::Verdict;

/// A suit whose messages can be tampered with.
class Suit {
public:
	Suit() : format(suit_format(4, output_mode::ORIENTATION)), _random(1) {
		for (FullSample &sample : samples) {
			sample = draw_sample(_random);
		}
		check->expect_master(format);
	}

	Verdict send(uint16_t p_counter) {
		const std::size_t size = write_data(format, p_counter, samples.data(), _data.data());
		return check->take({ MASTER, Message::MT_DATA, _data.data(), size });
	}
	void send_good(std::size_t p_count) {
		for (std::size_t i = 0; i < p_count; i++) {
			CHECK(send(next++) == Verdict::DATA);
		}
	}

	MasterFormat format;
	std::unique_ptr<StreamCheck> check = std::make_unique<StreamCheck>();
	std::array<FullSample, 4> samples;
	uint16_t next = 0;

private:
	std::mt19937 _random;
	std::array<uint8_t, MAX_DATA> _data{};
};

} // namespace

TEST(a_counter_wraps_around) {
	for (const unsigned bits : { 8U, 16U, 32U }) {
		const uint32_t mask = bits == 32 ? 0xFFFFFFFFU : (1U << bits) - 1U;
		CounterTrack track;
		DeviceStatistics stats;
		CHECK(track.see(mask - 2, bits, stats) == Step::FIRST);
		for (uint32_t i = 0; i < 6; i++) {
			CHECK(track.see((mask - 1 + i) & mask, bits, stats) == Step::NEXT);
		}
		CHECK(track.see((mask + 9) & mask, bits, stats) == Step::GAP);
		CHECK(stats.lost == 4 && stats.received == 8 && stats.resets == 0);
	}
}

TEST(what_is_lost_twice_or_late_is_counted) {
	CounterTrack track;
	DeviceStatistics stats;
	track.see(100, 16, stats);
	CHECK(track.see(100, 16, stats) == Step::DUPLICATE);
	CHECK(track.see(103, 16, stats) == Step::GAP);
	CHECK(track.see(101, 16, stats) == Step::LATE);
	CHECK(track.see(104, 16, stats) == Step::NEXT);
	CHECK(stats.lost == 2 && stats.duplicates == 1 && stats.late == 1 && stats.received == 5);
}

TEST(a_wild_counter_is_not_believed_at_once) {
	CounterTrack track;
	DeviceStatistics stats;
	track.see(100, 16, stats);
	CHECK(track.see(40000, 16, stats) == Step::JUMP);
	CHECK(track.see(101, 16, stats) == Step::NEXT);
	// A device that starts again goes on from where it landed.
	CHECK(track.see(30000, 16, stats) == Step::JUMP && track.see(30001, 16, stats) == Step::RESET);
	CHECK(track.see(30002, 16, stats) == Step::NEXT);
	// Also one that had hardly begun: it looks late first.
	CounterTrack young;
	young.see(5, 16, stats);
	CHECK(young.see(0, 16, stats) == Step::LATE && young.see(1, 16, stats) == Step::RESET);
	CHECK(stats.lost == 0 && stats.resets == 2);
}

TEST(a_counter_may_go_up_by_more_than_one) {
	CounterTrack track;
	track.set_step(4);
	DeviceStatistics stats;
	for (uint32_t i = 0; i < 100; i++) {
		track.see(uint16_t(65000 + i * 4), 16, stats);
	}
	track.see(uint16_t(65000 + 102 * 4), 16, stats);
	CHECK(stats.lost == 2 && stats.received == 101);
}

TEST(a_suit_is_followed) {
	Suit suit;
	suit.next = 65500;
	suit.send_good(100);
	suit.next += 3;
	suit.send_good(10);
	CHECK(suit.check->sample_count() == 4 && suit.check->sample(2).bus_id == 3);
	for (const uint8_t bus_id : { 1, 2, 3, 4 }) {
		CHECK(suit.check->device(bus_id).received == 110 && suit.check->device(bus_id).lost == 3);
	}
	CHECK(suit.check->data_size() == 66);
	CHECK_NEAR(suit.check->sample(0).quaternion[1], suit.samples[0].quaternion[1], 1e-6);
}

TEST(one_wrong_quaternion_betrays_a_message) {
	Suit suit;
	suit.send_good(100);
	const std::array<double, 4> good = suit.samples[1].quaternion;
	for (const double wrong :
			{ 1.001, 0.0, 2.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() }) {
		suit.samples[1].quaternion[0] = good[0] * wrong + (wrong == 0.0 ? 0.5 : 0.0);
		CHECK(suit.send(suit.next++) == Verdict::REFUSED);
		suit.samples[1].quaternion = good;
		suit.send_good(3);
	}
	CHECK(suit.check->statistics().implausible == 5 && suit.check->device(2).implausible == 5);
	CHECK(suit.check->device(1).implausible == 0);
	// Messages refused are lost ones.
	CHECK(suit.check->device(1).lost == 5);
}

TEST(a_sick_tracker_does_not_stop_the_others) {
	Suit suit;
	suit.send_good(50);
	suit.samples[2].quaternion = {};
	std::size_t taken = 0;
	for (int i = 0; i < 100; i++) {
		taken += suit.send(suit.next++) == Verdict::DATA ? 1U : 0U;
	}
	CHECK(taken >= 90);
	CHECK(suit.check->sample(2).present == 0 && suit.check->sample(1).has(Field::QUATERNION));
	CHECK(suit.check->device(3).received == 50 && suit.check->device(3).implausible == 100);
	CHECK(suit.check->device(2).received == 50 + taken);
	// It may recover.
	suit.samples[2].quaternion = { 1.0, 0.0, 0.0, 0.0 };
	suit.send_good(10);
	CHECK(suit.check->sample(2).has(Field::QUATERNION));
}

TEST(a_device_that_computes_coarsely_is_believed) {
	Suit suit;
	suit.send_good(100);
	for (double &part : suit.samples[0].quaternion) {
		part *= 1.0005;
	}
	std::size_t taken = 0;
	for (int i = 0; i < 20; i++) {
		taken += suit.send(suit.next++) == Verdict::DATA ? 1U : 0U;
	}
	CHECK(taken >= 15);
}

TEST(data_of_another_size_or_position_are_refused) {
	Suit suit;
	const Bytes data(200, 0);
	CHECK(suit.check->take({ MASTER, Message::MT_DATA, data.data(), 65 }) == Verdict::REFUSED);
	CHECK(suit.check->take({ 1, Message::MT_DATA, data.data(), 66 }) == Verdict::REFUSED);
	CHECK(suit.check->statistics().wrong_sizes == 2);
	CHECK(suit.check->take({ 5, Message::DEVICE_ID, data.data(), 4 }) == Verdict::REFUSED);
	CHECK(suit.check->take({ 4, Message::DEVICE_ID, data.data(), 4 }) == Verdict::CONTROL);
	CHECK(suit.check->take({ MASTER, Message::ERROR, data.data(), 3 }) == Verdict::REFUSED);
	CHECK(suit.check->take({ MASTER, Message::ERROR, data.data(), 2 }) == Verdict::CONTROL);
	CHECK(suit.check->take({ MASTER, Message::GO_TO_CONFIG_ACK, data.data(), 0 }) == Verdict::CONTROL);
	CHECK(suit.check->take({ MASTER, Message(0xEE), data.data(), 0 }) == Verdict::REFUSED);
	CHECK(suit.check->take({ BROADCAST, Message::WAKE_UP, data.data(), 0 }) == Verdict::REFUSED);
	CHECK(suit.check->statistics().impossible == 4);
}

TEST(data_without_a_format_are_kept_apart) {
	StreamCheck check;
	const Bytes data(36, 0);
	CHECK(check.take({ MASTER, Message::MT_DATA, data.data(), data.size() }) == Verdict::CONTROL);
	check.expect_tracker({ output_mode::CALIBRATED, 0 });
	CHECK(check.take({ MASTER, Message::MT_DATA, data.data(), data.size() }) == Verdict::DATA);
	check.reset();
	CHECK(check.take({ MASTER, Message::MT_DATA, data.data(), data.size() }) == Verdict::CONTROL);
}

TEST(trackers_with_items_are_distinguished_by_their_bus_identifiers) {
	std::mt19937 random(2);
	StreamCheck check;
	Bytes data(MAX_DATA);
	for (uint32_t i = 0; i < 60; i++) {
		const auto bus_id = uint8_t(1 + i % 3);
		FullSample sample = draw_sample(random);
		sample.counter = i / 3 + (bus_id == 2 && i > 30 ? 5 : 0);
		const std::size_t size = write_mt_data2(IMU_ITEMS.data(), IMU_ITEMS.size(), sample, data.data(), data.size());
		CHECK(check.take({ bus_id, Message::MT_DATA2, data.data(), size }) == Verdict::DATA);
		CHECK(check.sample(0).bus_id == bus_id);
	}
	CHECK(check.device(1).received == 20 && check.device(1).lost == 0);
	CHECK(check.device(2).received == 20 && check.device(2).lost == 5);
}

TEST(odd_items_are_taken_from_a_good_line_and_doubted_on_a_bad_one) {
	StreamCheck check;
	const Bytes odd = { 0x66, 0x60, 1, 0, 0x10, 0x20, 2, 0, 1 };
	const Frame frame = { MASTER, Message::MT_DATA2, odd.data(), odd.size() };
	CHECK(check.take(frame) == Verdict::DATA && check.statistics().unknown_items == 1);
	StreamCheck doubting;
	CHECK(doubting.take(frame, true) == Verdict::REFUSED);
	CHECK(doubting.take(frame, true) == Verdict::DATA);
	// Half an item is never taken.
	CHECK(check.take({ MASTER, Message::MT_DATA2, odd.data(), 8 }) == Verdict::REFUSED);
}

TEST(a_new_measurement_counts_from_anywhere) {
	Suit suit;
	suit.next = 500;
	suit.send_good(10);
	suit.check->restart();
	suit.next = 0;
	suit.send_good(10);
	CHECK(suit.check->device(1).received == 20 && suit.check->device(1).resets == 0);
	CHECK(suit.check->device(1).lost == 0 && suit.check->device(1).late == 0);
}

TEST(following_a_stream_takes_no_memory) {
	const MasterFormat format = suit_format(15, output_mode::ORIENTATION);
	const Stream suit = suit_stream(format, 500, 5);
	const Stream imu = imu_stream(500, 6);
	const auto check = std::make_unique<StreamCheck>();
	const auto framer = std::make_unique<Framer>();
	check->expect_master(format);
	std::size_t taken = 0;
	const int before = allocations;
	for (const Stream *stream : { &suit, &imu }) {
		for (std::size_t at = 0; at < stream->bytes.size(); at += 62) {
			const std::size_t size = std::min<std::size_t>(62, stream->bytes.size() - at);
			framer->feed(stream->bytes.data() + at, size,
					[&](const Frame &p_frame) { taken += check->take(p_frame) == Verdict::DATA ? 1U : 0U; });
		}
	}
	CHECK(allocations == before);
	CHECK(taken == 1000);
}

TEST_MAIN()
