// SPDX-License-Identifier: MIT
#include "bus_streams.hpp"

#include "check.hpp"

#include <cstring>

namespace test_framer {

using namespace streams;

namespace {

/// A message that outlives the bytes it was in.
struct Kept {
	uint8_t bus_id = 0;
	Message message = Message::REQ_DEVICE_ID;
	Bytes data;

	bool operator==(const Kept &p_other) const {
		return bus_id == p_other.bus_id && message == p_other.message && data == p_other.data;
	}
};

struct Result {
	std::vector<Kept> kept;
	FramerStatistics statistics;
	std::size_t pending = 0;
};

auto keep(std::vector<Kept> &r_kept) {
	return [&r_kept](const Frame &p_frame) {
		r_kept.push_back({ p_frame.bus_id, p_frame.message, Bytes(p_frame.data, p_frame.data + p_frame.size) });
	};
}

/// Feeds the bytes in pieces of these sizes, over and over. Each piece lies in memory of its own, so that a
/// sanitizer sees what is read beyond.
Result feed_in(const Bytes &p_bytes, const std::vector<std::size_t> &p_sizes, std::size_t p_longest = MAX_DATA) {
	Result result;
	Framer framer;
	framer.set_longest(p_longest);
	std::size_t at = 0;
	for (std::size_t i = 0; at < p_bytes.size(); i++) {
		const std::size_t size = std::min(p_sizes[i % p_sizes.size()], p_bytes.size() - at);
		const Bytes piece(p_bytes.begin() + std::ptrdiff_t(at), p_bytes.begin() + std::ptrdiff_t(at + size));
		framer.feed(piece.data(), piece.size(), keep(result.kept));
		at += size;
	}
	result.statistics = framer.statistics();
	result.pending = framer.pending();
	return result;
}

Result feed_whole(const Bytes &p_bytes, std::size_t p_longest = MAX_DATA) {
	return feed_in(p_bytes, { std::max<std::size_t>(p_bytes.size(), 1) }, p_longest);
}

bool is_counted(const Result &p_result) {
	const FramerStatistics &statistics = p_result.statistics;
	return statistics.bytes == statistics.frame_bytes + statistics.skipped_bytes + p_result.pending &&
			statistics.frames == p_result.kept.size();
}

Bytes frame_of(uint8_t p_bus_id, Message p_message, const Bytes &p_data) {
	Bytes bytes(p_data.size() + 7);
	bytes.resize(write_frame(p_bus_id, p_message, p_data.data(), p_data.size(), bytes.data()));
	return bytes;
}

void append(Bytes &r_bytes, const Bytes &p_more) {
	r_bytes.insert(r_bytes.end(), p_more.begin(), p_more.end());
}

/// Messages of all lengths with noise between, in which there are many false beginnings.
Bytes noisy_bytes(uint32_t p_seed, std::size_t p_messages) {
	std::mt19937 random(p_seed);
	Bytes bytes;
	for (std::size_t i = 0; i < p_messages; i++) {
		Bytes data(random() % 8 == 0 ? random() % 3000 : random() % 80);
		for (uint8_t &byte : data) {
			byte = random() % 6 == 0 ? PREAMBLE : (random() % 6 == 0 ? MASTER : uint8_t(random()));
		}
		Bytes frame = frame_of(uint8_t(random() % 4 == 0 ? 1 + random() % 9 : 0xFF), Message::MT_DATA2, data);
		if (random() % 5 == 0) {
			frame[random() % frame.size()] ^= uint8_t(1U << (random() % 8));
		}
		append(bytes, frame);
		for (std::size_t noise = random() % 3 == 0 ? random() % 9 : 0; noise > 0; noise--) {
			bytes.push_back(random() % 3 == 0 ? PREAMBLE : uint8_t(random()));
		}
	}
	return bytes;
}

} // namespace

TEST(every_split_gives_the_same) {
	for (uint32_t seed = 1; seed <= 12; seed++) {
		const Bytes bytes = noisy_bytes(seed, 300);
		const Result whole = feed_whole(bytes, seed % 2 == 0 ? 1000 : MAX_DATA);
		CHECK(whole.kept.size() > 150 && whole.statistics.bad_checksums > 0);
		CHECK(is_counted(whole));
		std::mt19937 random(seed);
		std::vector<std::size_t> sizes(97);
		for (std::size_t &size : sizes) {
			size = 1 + random() % 700;
		}
		for (const std::vector<std::size_t> &split :
				{ std::vector<std::size_t>{ 1 }, { 2 }, { 62 }, { 512 }, { 16384 }, sizes }) {
			const Result cut = feed_in(bytes, split, seed % 2 == 0 ? 1000 : MAX_DATA);
			CHECK(cut.kept == whole.kept);
			CHECK(cut.pending == whole.pending);
			CHECK(std::memcmp(&cut.statistics, &whole.statistics, sizeof(FramerStatistics)) == 0);
		}
	}
}

TEST(what_lies_whole_in_a_chunk_is_not_copied) {
	const Bytes bytes = frame_of(MASTER, Message::MT_DATA, Bytes(40, 7));
	Framer framer;
	const uint8_t *seen = nullptr;
	framer.feed(bytes.data(), bytes.size(), [&](const Frame &p_frame) { seen = p_frame.data; });
	CHECK(seen == bytes.data() + 4);
}

TEST(a_broken_message_hides_none_behind_it) {
	const Bytes good = frame_of(1, Message::DEVICE_ID, { 1, 2, 3, 4 });
	Bytes bytes = frame_of(MASTER, Message::MT_DATA, Bytes(100, 9));
	bytes[3] = 0xF0;
	append(bytes, good);
	append(bytes, Bytes(250, 0));
	const Result result = feed_whole(bytes);
	CHECK(result.kept.size() == 1 && result.kept[0].message == Message::DEVICE_ID);
	CHECK(result.statistics.skipped_bytes == bytes.size() - good.size());
	CHECK(result.statistics.stretches == 2);
	CHECK(result.statistics.bad_checksums == 1);
}

TEST(a_message_inside_a_broken_one_is_found) {
	const Bytes inner = frame_of(MASTER, Message::WAKE_UP, {});
	Bytes outer = frame_of(MASTER, Message::MT_DATA, inner);
	outer.back()++;
	const Result result = feed_whole(outer);
	CHECK(result.kept.size() == 1 && result.kept[0].message == Message::WAKE_UP);
}

TEST(a_sink_that_refuses_makes_the_search_go_on) {
	const Bytes inner = frame_of(MASTER, Message::WAKE_UP, {});
	const Bytes outer = frame_of(MASTER, Message::MT_DATA, inner);
	Framer framer;
	std::size_t taken = 0;
	framer.feed(outer.data(), outer.size(), [&](const Frame &p_frame) {
		taken += p_frame.message == Message::WAKE_UP ? 1U : 0U;
		return p_frame.message == Message::WAKE_UP;
	});
	CHECK(taken == 1);
	CHECK(framer.statistics().refused_frames == 1);
	CHECK(framer.statistics().frames == 1);
}

TEST(lengths_at_their_limits) {
	for (const std::size_t size : { 0, 1, 253, 254, 255, 256, 2048, 8191, 8192 }) {
		const Bytes bytes = frame_of(MASTER, Message::MT_DATA, Bytes(size, 0x55));
		CHECK(bytes.size() == frame_size(size));
		const Result result = feed_whole(bytes);
		CHECK(result.kept.size() == 1 && result.kept[0].data.size() == size && result.pending == 0);
	}
	Bytes nothing(8300);
	CHECK(write_frame(MASTER, Message::MT_DATA, nothing.data(), MAX_DATA + 1, nothing.data()) == 0);
}

TEST(the_extended_form_may_be_short) {
	Bytes bytes(32);
	const Bytes data = { 1, 2, 3 };
	bytes.resize(write_extended_frame(MASTER, Message::MT_DATA2, data.data(), data.size(), bytes.data()));
	const Result result = feed_whole(bytes);
	CHECK(result.kept.size() == 1 && result.kept[0].data == data);
}

TEST(zeros_after_a_preamble_are_no_message) {
	// FA 00 00 00 00 would have a right checksum.
	const Result result = feed_whole({ 0xFA, 0x00, 0x00, 0x00, 0x00, 0xFA, 0x00, 0x00, 0x00, 0x00 });
	CHECK(result.kept.empty() && result.pending == 0);
	CHECK(result.statistics.refused_starts == 2 && result.statistics.skipped_bytes == 10);
}

TEST(a_length_that_nobody_announced_is_not_waited_for) {
	Bytes bytes = { 0xFA, 0xFF, 0x32, 0xFF, 0x1F, 0xFF };
	append(bytes, frame_of(MASTER, Message::WAKE_UP, {}));
	const Result bounded = feed_whole(bytes, 254);
	CHECK(bounded.kept.size() == 1 && bounded.statistics.refused_lengths == 1);
	const Result unbounded = feed_whole(bytes);
	CHECK(unbounded.kept.empty() && unbounded.pending == bytes.size());
	// Even without a bound, no more than any message has.
	const Result beyond = feed_whole({ 0xFA, 0xFF, 0x32, 0xFF, 0x20, 0x01, 0, 0, 0 });
	CHECK(beyond.statistics.refused_lengths == 1 && beyond.pending == 0);
}

TEST(giving_up_finds_what_is_behind) {
	Bytes bytes = { 0xFA, 0xFF, 0x32, 0xFF, 0x10, 0x00 };
	append(bytes, frame_of(MASTER, Message::WAKE_UP, {}));
	append(bytes, { 0xFA, 0xFF });
	Framer framer;
	std::vector<Kept> kept;
	framer.feed(bytes.data(), bytes.size(), keep(kept));
	CHECK(kept.empty() && framer.pending() == bytes.size());
	framer.give_up(keep(kept));
	CHECK(kept.size() == 1 && kept[0].message == Message::WAKE_UP);
	// The message that has only begun may still come.
	CHECK(framer.pending() == 2);
	const Bytes rest = { 0x40, 0x00, 0xC1 };
	framer.feed(rest.data(), rest.size(), keep(kept));
	CHECK(kept.size() == 2 && kept[1].message == Message::RESET);
	CHECK(framer.statistics().given_up == 1 && framer.statistics().skipped_bytes == 6);
}

TEST(finishing_leaves_nothing) {
	std::mt19937 random(5);
	for (int run = 0; run < 200; run++) {
		Bytes bytes(random() % 600);
		for (uint8_t &byte : bytes) {
			byte = random() % 3 == 0 ? PREAMBLE : uint8_t(random());
		}
		Framer framer;
		Result result;
		framer.feed(bytes.data(), bytes.size(), keep(result.kept));
		framer.finish(keep(result.kept));
		result.statistics = framer.statistics();
		CHECK(framer.pending() == 0 && is_counted(result));
	}
}

TEST(sums_are_sums) {
	std::mt19937 random(3);
	for (int run = 0; run < 300; run++) {
		Bytes bytes(random() % 5000, uint8_t(0xFF));
		uint32_t sum = 0;
		for (uint8_t &byte : bytes) {
			byte = run % 3 == 0 ? byte : uint8_t(random());
			sum += byte;
		}
		CHECK(sum_bytes(bytes.data(), bytes.size()) == uint8_t(sum));
	}
}

} // namespace test_framer
