// SPDX-License-Identifier: MIT
// What a recorded bus carried, decoded again.
#include "bus_streams.hpp"

#include "bus/requests.hpp"
#include "recording/bus_replay.hpp"

#include <check.hpp>

namespace test_replay {

using namespace recording;
using namespace xbus;
using streams::Bytes;

namespace {

struct Chunk {
	bool is_out = false;
	Bytes bytes;
};

/// A master as it is brought up and measures, with all that went out and came in.
class Dialogue {
public:
	explicit Dialogue(std::size_t p_trackers) : _random(9), _answer(MAX_FRAME) {
		const OutputFormat format = { output_mode::CALIBRATED | output_mode::ORIENTATION,
			output_setting::NO_MAGNETIC_FIELD };
		in(device::write_device_id(0x00100123, MASTER, _answer.data()));
		std::vector<uint32_t> ids;
		for (std::size_t at = 0; at < p_trackers; ++at) {
			ids.push_back(uint32_t(0x00300001 + at));
			_format.add(format);
		}
		in(device::write_device_list(ids.data(), ids.size(), _answer.data()));
		for (std::size_t at = 1; at <= p_trackers; ++at) {
			out(host::set_output_mode(format.mode, uint8_t(at)));
			in(device::write_ack(Message::SET_OUTPUT_MODE, uint8_t(at), _answer.data()));
			out(host::set_output_settings(format.settings, uint8_t(at)));
			in(device::write_ack(Message::SET_OUTPUT_SETTINGS, uint8_t(at), _answer.data()));
		}
		out(host::set_period(1152));
		in(device::write_ack(Message::SET_PERIOD, MASTER, _answer.data()));
		in(device::write_ack(Message::GO_TO_MEASUREMENT, MASTER, _answer.data()));
	}

	void measure(uint16_t p_counter) {
		std::vector<FullSample> samples(_format.count());
		for (FullSample &sample : samples) {
			sample = streams::draw_sample(_random);
			orientations.push_back(sample.quaternion);
		}
		in(device::write_mt_data(_format, p_counter, samples.data(), _answer.data()));
	}

	void out(const Request &p_request) {
		chunks.push_back(
				{ true, Bytes(p_request.bytes.begin(), p_request.bytes.begin() + std::ptrdiff_t(p_request.size)) });
	}
	void in(std::size_t p_size) {
		chunks.push_back({ false, Bytes(_answer.begin(), _answer.begin() + std::ptrdiff_t(p_size)) });
	}

	std::vector<Chunk> chunks;
	std::vector<std::array<double, 4>> orientations;

private:
	std::mt19937 _random;
	Bytes _answer;
	MasterFormat _format;
};

} // namespace

TEST(a_recorded_suit_is_decoded_however_its_bytes_were_cut) {
	for (const std::size_t piece : { std::size_t(1), std::size_t(7), std::size_t(62), std::size_t(4096) }) {
		Dialogue dialogue(17);
		for (uint16_t counter = 0; counter < 50; ++counter) {
			dialogue.measure(uint16_t(65500 + counter));
		}
		BusReplay replay;
		std::vector<SuitFrame> frames;
		uint64_t now = 1000000;
		for (const Chunk &chunk : dialogue.chunks) {
			if (chunk.is_out) {
				replay.take_out(chunk.bytes.data(), chunk.bytes.size());
				continue;
			}
			for (std::size_t at = 0; at < chunk.bytes.size(); at += piece) {
				replay.take_in(chunk.bytes.data() + at, std::min(piece, chunk.bytes.size() - at), now,
						[&](const SuitFrame &p_frame) { frames.push_back(p_frame); });
			}
			now += 10000;
		}
		CHECK(replay.device_id() == 0x00100123 && replay.is_master());
		CHECK(replay.tracker_ids().size() == 17 && replay.tracker_ids()[16] == 0x00300011);
		CHECK_NEAR(replay.rate_hz(), 100.0, 1e-9);
		CHECK(frames.size() == 50 && replay.undecoded() == 0);
		CHECK(replay.tracker(3).received == 50 && replay.tracker(3).lost == 0);
		std::size_t at = 0;
		double worst = 0.0;
		for (const SuitFrame &frame : frames) {
			CHECK(frame.tracker_count == 17);
			for (int tracker = 0; tracker < frame.tracker_count; ++tracker, ++at) {
				for (std::size_t part = 0; part < 4; ++part) {
					worst = std::max(worst,
							std::fabs(frame.trackers[std::size_t(tracker)].orientation[part] -
									dialogue.orientations[at][part]));
				}
			}
		}
		CHECK(worst < 1e-6);
		CHECK(frames.back().time_usec > frames.front().time_usec + 480000);
	}
}

TEST(without_the_beginning_samples_are_counted_but_not_guessed) {
	Dialogue dialogue(3);
	dialogue.chunks.clear();
	dialogue.measure(1);
	dialogue.measure(2);
	BusReplay replay;
	int frames = 0;
	for (const Chunk &chunk : dialogue.chunks) {
		replay.take_in(chunk.bytes.data(), chunk.bytes.size(), 1, [&](const SuitFrame &) { ++frames; });
	}
	CHECK(frames == 0 && replay.undecoded() == 2);
}

TEST(a_bus_in_one_piece_keeps_every_message) {
	Dialogue dialogue(4);
	for (uint16_t counter = 0; counter < 20; ++counter) {
		dialogue.measure(counter);
		dialogue.out(host::request_battery_level());
	}
	Bytes file(MAGIC.begin(), MAGIC.end());
	Bytes came;
	Bytes went;
	const auto put = [&](Kind p_kind, int p_stream, const uint8_t *p_bytes, std::size_t p_size) {
		std::array<uint8_t, HEAD_SIZE> head{};
		put_head(p_kind, p_stream, 1, p_bytes, p_size, head.data());
		file.insert(file.end(), head.begin(), head.end());
		file.insert(file.end(), p_bytes, p_bytes + p_size);
	};
	const Bytes other(40, 0x11);
	for (const Chunk &chunk : dialogue.chunks) {
		(chunk.is_out ? went : came).insert((chunk.is_out ? went : came).end(), chunk.bytes.begin(), chunk.bytes.end());
		// Answers come in two pieces, with a request of ours between them.
		const std::size_t half = chunk.bytes.size() / 2;
		put(chunk.is_out ? Kind::BUS_OUT : Kind::BUS_IN, 2, chunk.bytes.data(), half);
		put(Kind::BUS_IN, 1, other.data(), 10);
		put(chunk.is_out ? Kind::BUS_OUT : Kind::BUS_IN, 2, chunk.bytes.data() + half, chunk.bytes.size() - half);
	}
	Reader reader;
	CHECK(reader.open(file).empty());
	CHECK(bus_bytes(reader, -1, false) == came);
	CHECK(bus_bytes(reader, 2, false) == came);
	CHECK(bus_bytes(reader, 1, false).size() == dialogue.chunks.size() * 10);
	const Bytes all = bus_bytes(reader, 2, true);
	CHECK(all.size() == came.size() + went.size());
	Framer framer;
	std::size_t messages = 0;
	framer.feed(all.data(), all.size(), [&](const Frame &) {
		++messages;
		return true;
	});
	CHECK(messages == dialogue.chunks.size() && framer.statistics().skipped_bytes == 0);
}

TEST(hostile_recordings_do_no_harm) {
	Dialogue dialogue(6);
	for (uint16_t counter = 0; counter < 30; ++counter) {
		dialogue.measure(counter);
	}
	std::mt19937 random(3);
	uint64_t frames = 0;
	for (int round = 0; round < 400; ++round) {
		BusReplay replay;
		uint64_t now = 1;
		for (const Chunk &chunk : dialogue.chunks) {
			Bytes bytes = chunk.bytes;
			// Some chunks are cut, changed, or come from the other side.
			for (unsigned damage = random() % 32 == 0 ? random() % 4 : 0; damage > 0 && !bytes.empty(); --damage) {
				bytes[random() % bytes.size()] = uint8_t(random());
			}
			bytes.resize(random() % 64 == 0 ? random() % (bytes.size() + 1) : bytes.size());
			now += random() % 8 == 0 ? 80000 : 10000;
			if (chunk.is_out != (random() % 64 == 0)) {
				replay.take_out(bytes.data(), bytes.size());
				continue;
			}
			replay.take_in(bytes.data(), bytes.size(), now, [&](const SuitFrame &p_frame) {
				++frames;
				CHECK(p_frame.tracker_count >= 0 && p_frame.tracker_count <= MAX_TRACKERS);
			});
		}
		CHECK(replay.tracker_ids().size() <= std::size_t(MAX_TRACKERS));
	}
	CHECK(frames > 1000);
}

} // namespace test_replay
