// SPDX-License-Identifier: MIT
// Measures the bus's core: xbus_bench FOLDER [FILE]. The folder holds the golden recordings; a file is decoded
// besides. Prints a line of JSON for each figure: tests/bench/bench_xbus.py makes a table of them.
#include "bus_streams.hpp"
#include "count_allocations.hpp"

#include "recording/bus_replay.hpp"

#include <chrono>
#include <cstdio>
#include <functional>

using namespace streams;

namespace {

constexpr int REPEATS = 5;
constexpr std::size_t FRAMING_BYTES = 32U << 20U;

enum class Goal : uint8_t {
	NONE,
	AT_LEAST,
	AT_MOST
};

void print_figure(const char *p_case, const char *p_metric, double p_value, const char *p_unit,
		Goal p_kind = Goal::NONE, double p_goal = 0.0) {
	static constexpr const char *KINDS[] = { "", "at_least", "at_most" };
	std::printf("{\"case\": \"%s\", \"metric\": \"%s\", \"value\": %.9g, \"unit\": \"%s\"", p_case, p_metric, p_value,
			p_unit);
	if (p_kind != Goal::NONE) {
		std::printf(", \"%s\": %.9g", KINDS[int(p_kind)], p_goal);
	}
	std::printf("}\n");
	std::fflush(stdout);
}

/// Of the quickest of several runs, s.
double time_of(const std::function<void()> &p_work) {
	double best = 1.0e9;
	for (int i = 0; i < REPEATS; i++) {
		const auto begin = std::chrono::steady_clock::now();
		p_work();
		best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
	}
	return best;
}

/// Calls `p_feed(bytes, size)` for the bytes in pieces.
template <class F>
void in_pieces(const Bytes &p_bytes, std::size_t p_piece, F &&p_feed) {
	for (std::size_t at = 0; at < p_bytes.size(); at += p_piece) {
		p_feed(p_bytes.data() + at, std::min(p_piece, p_bytes.size() - at));
	}
}

Bytes repeated(const Bytes &p_bytes, std::size_t p_least) {
	Bytes all;
	all.reserve(p_least + p_bytes.size());
	while (!p_bytes.empty() && all.size() < p_least) {
		all.insert(all.end(), p_bytes.begin(), p_bytes.end());
	}
	return all;
}

void measure_framing(const Bytes &p_bytes) {
	struct Piece {
		const char *metric;
		std::size_t size;
	};
	for (const Piece &piece : { Piece{ "in one piece", p_bytes.size() }, { "in pieces of 16384", 16384 },
				 { "in pieces of 512", 512 }, { "in pieces of 62", 62 } }) {
		const auto framer = std::make_unique<Framer>();
		uint64_t sum = 0;
		const double seconds = time_of([&] {
			in_pieces(p_bytes, piece.size, [&](const uint8_t *p_data, std::size_t p_size) {
				framer->feed(p_data, p_size, [&](const Frame &p_frame) { sum += p_frame.size; });
			});
		});
		if (sum == 0) {
			std::fprintf(stderr, "xbus_bench: no message was found in what is framed.\n");
		}
		print_figure("framing", piece.metric, double(p_bytes.size()) / seconds / 1.0e9, "GB/s", Goal::AT_LEAST, 1.0);
	}
}

void measure_items(const Bytes &p_bytes) {
	const auto framer = std::make_unique<Framer>();
	Sample sample;
	double sum = 0.0;
	std::size_t messages = 0;
	const double decoding = time_of([&] {
		messages = 0;
		framer->feed(p_bytes.data(), p_bytes.size(), [&](const Frame &p_frame) {
			if (p_frame.message == Message::MT_DATA2) {
				decode_mt_data2(p_frame.data, p_frame.size, sample);
				sum += sample.acceleration[0];
				messages++;
			}
		});
	});
	if (messages == 0) {
		return;
	}
	print_figure("MTData2", "framed and decoded", double(messages) / decoding / 1.0e6, "M/s", Goal::AT_LEAST, 3.0);
	const auto check = std::make_unique<StreamCheck>();
	const double judging = time_of([&] {
		framer->feed(p_bytes.data(), p_bytes.size(),
				[&](const Frame &p_frame) { return check->take(p_frame) != StreamCheck::Verdict::REFUSED; });
	});
	print_figure("MTData2", "and judged", double(messages) / judging / 1.0e6, "M/s");
}

void measure_suit() {
	const MasterFormat format = suit_format(15, output_mode::ORIENTATION);
	const Stream stream = suit_stream(format, 20000, 7);
	const auto framer = std::make_unique<Framer>();
	const auto check = std::make_unique<StreamCheck>();
	check->expect_master(format);
	const double seconds = time_of([&] {
		framer->feed(stream.bytes.data(), stream.bytes.size(),
				[&](const Frame &p_frame) { return check->take(p_frame) != StreamCheck::Verdict::REFUSED; });
	});
	print_figure(
			"MTData of 15 trackers", "framed, decoded, judged", double(stream.begins.size()) / seconds / 1.0e6, "M/s");
}

/// A number for everything that a framer hands on.
uint64_t digest_of(const Bytes &p_bytes, const std::function<std::size_t()> &p_piece) {
	uint64_t hash = 14695981039346656037ULL;
	const auto mix = [&](uint64_t p_value) { hash = (hash ^ p_value) * 1099511628211ULL; };
	const auto framer = std::make_unique<Framer>();
	for (std::size_t at = 0; at < p_bytes.size();) {
		const std::size_t size = std::min(p_piece(), p_bytes.size() - at);
		framer->feed(p_bytes.data() + at, size, [&](const Frame &p_frame) {
			mix(p_frame.bus_id);
			mix(uint64_t(p_frame.message));
			for (std::size_t i = 0; i < p_frame.size; i++) {
				mix(p_frame.data[i]);
			}
		});
		at += size;
	}
	mix(framer->statistics().frames);
	mix(framer->statistics().skipped_bytes);
	return hash;
}

void measure_splits(const Bytes &p_recordings) {
	std::vector<bool> touched;
	Stream stream = suit_stream(suit_format(20, output_mode::ORIENTATION), 2000, 11);
	stream.add(p_recordings.data(), p_recordings.size());
	const Bytes bytes = corrupt(stream, 1.0e-3, 12, touched);
	const uint64_t whole = digest_of(bytes, [&] { return bytes.size(); });
	bool same = true;
	for (const std::size_t piece : { std::size_t(1), std::size_t(62), std::size_t(512), std::size_t(16384) }) {
		same = same && digest_of(bytes, [&] { return piece; }) == whole;
	}
	std::mt19937 random(13);
	same = same && digest_of(bytes, [&] { return std::size_t(1) + random() % 3000; }) == whole;
	print_figure("splits", "all give the same", same ? 1.0 : 0.0, "", Goal::AT_LEAST, 1.0);
}

/// `p_has_goal`: whether values say enough for the goal of wrong messages to be in reach (docs/xbus.md).
void measure_bad_line(
		const char *p_case, const Stream &p_stream, const MasterFormat *p_format, bool p_has_goal = true) {
	Survival rare;
	Survival often;
	for (uint32_t run = 0; run < 8; run++) {
		rare.add(survive(p_stream, p_format, 1.0e-4, 100 + run));
		often.add(survive(p_stream, p_format, 1.0e-3, 200 + run));
	}
	print_figure(p_case, "regained at 1e-4", 100.0 * rare.regained_share(), "%", Goal::AT_LEAST, 100.0);
	print_figure(p_case, "regained at 1e-3", 100.0 * often.regained_share(), "%", Goal::AT_LEAST, 99.9);
	Survival both = rare;
	both.add(often);
	print_figure(p_case, "wrong per 10,000 stretches", 1.0e4 * both.wrong_share(), "",
			p_has_goal ? Goal::AT_MOST : Goal::NONE, 1.0);
	print_figure(p_case, "stretches", double(both.stretches), "");
}

/// A suit of 15 trackers at 100 Hz, in USB's pieces.
void measure_hour() {
	constexpr std::size_t MESSAGES = 3600 * 100;
	const MasterFormat format = suit_format(15, output_mode::ORIENTATION);
	const auto framer = std::make_unique<Framer>();
	const auto check = std::make_unique<StreamCheck>();
	check->expect_master(format);
	framer->set_longest(format.size());
	const std::size_t block = 1200;
	int allocated = 0;
	const auto begin = std::chrono::steady_clock::now();
	double seconds = 0.0;
	for (std::size_t sent = 0; sent < MESSAGES; sent += block) {
		const Stream stream = suit_stream(format, block, uint32_t(sent), uint16_t(sent));
		const int before = allocations;
		const auto start = std::chrono::steady_clock::now();
		in_pieces(stream.bytes, 62, [&](const uint8_t *p_data, std::size_t p_size) {
			framer->feed(p_data, p_size,
					[&](const Frame &p_frame) { return check->take(p_frame) != StreamCheck::Verdict::REFUSED; });
		});
		seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
		allocated += allocations - before;
	}
	const DeviceStatistics &tracker = check->device(15);
	const char *name = "one hour, 15 trackers at 100 Hz";
	print_figure(name, "samples of the last tracker", double(tracker.received), "", Goal::AT_LEAST, double(MESSAGES));
	print_figure(name, "lost", double(tracker.lost + tracker.duplicates + tracker.late), "", Goal::AT_MOST, 0.0);
	print_figure(name, "malformed bytes", double(framer->statistics().skipped_bytes), "", Goal::AT_MOST, 0.0);
	print_figure(name, "allocations per message", double(allocated) / double(MESSAGES), "", Goal::AT_MOST, 0.0);
	print_figure(name, "time", seconds, "s");
	print_figure(name, "time with making it",
			std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), "s");
}

/// Any recording of raw bytes.
int measure_file(const char *p_name) {
	Bytes bytes = read_file(p_name);
	if (recording::is_recording(bytes.data(), bytes.size())) {
		recording::Reader reader;
		reader.open(std::move(bytes));
		bytes = recording::bus_bytes(reader, -1, false);
	}
	if (bytes.empty()) {
		std::fprintf(stderr, "xbus_bench: %s is empty or cannot be read.\n", p_name);
		return 2;
	}
	const auto framer = std::make_unique<Framer>();
	framer->feed(bytes.data(), bytes.size(), [](const Frame &) {});
	framer->finish([](const Frame &) {});
	const FramerStatistics &statistics = framer->statistics();
	print_figure("file", "bytes", double(statistics.bytes), "");
	print_figure("file", "messages", double(statistics.frames), "");
	print_figure("file", "malformed bytes", double(statistics.skipped_bytes), "");
	if (statistics.frames == 0) {
		std::fprintf(stderr, "xbus_bench: %s holds no Xbus message.\n", p_name);
		return 1;
	}
	const Bytes many = repeated(bytes, FRAMING_BYTES);
	measure_framing(many);
	measure_items(many);
	return 0;
}

} // namespace

int main(int p_count, char **p_arguments) {
	if (p_count < 2) {
		std::fprintf(stderr, "usage: xbus_bench FOLDER [FILE]\n");
		return 2;
	}
	if (p_count > 2) {
		return measure_file(p_arguments[2]);
	}
	Bytes recordings;
	for (const char *set : { "/1", "/2", "/3" }) {
		const Bytes bytes = read_file(std::string(p_arguments[1]) + set + "/output.bin");
		recordings.insert(recordings.end(), bytes.begin(), bytes.end());
	}
	if (recordings.empty()) {
		std::fprintf(stderr, "xbus_bench: there are no recordings in %s.\n", p_arguments[1]);
		return 2;
	}
	const Bytes many = repeated(recordings, FRAMING_BYTES);
	measure_framing(many);
	measure_items(many);
	measure_suit();
	measure_splits(recordings);
	const MasterFormat oriented = suit_format(15, output_mode::ORIENTATION);
	measure_bad_line("bad line, orientations", suit_stream(oriented, 40000, 1), &oriented);
	measure_bad_line("bad line, items", imu_stream(40000, 3), nullptr);
	const MasterFormat all = suit_format(15, output_mode::CALIBRATED | output_mode::ORIENTATION);
	measure_bad_line("bad line, all measurements", suit_stream(all, 20000, 2), &all, false);
	measure_hour();
	return 0;
}
