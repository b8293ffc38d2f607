// SPDX-License-Identifier: MIT
// Hostile bytes for the framer and every decoder: xbus_fuzz [EXECUTIONS [SEED]]. Built with sanitizers
// (DISMOUNT_SANITIZE) it finds what a wrong byte could do.
#include "bus_streams.hpp"

#include "bus/configuration.hpp"
#include "fuzzing.hpp"

#include <cstdio>
#include <cstdlib>

using namespace streams;
using fuzzing::ExactBlocks;
using fuzzing::Random;

namespace {

/// What an execution can do wrong without a sanitizer's help.
const char *fault = nullptr;

void expect(bool p_holds, const char *p_what) {
	if (!p_holds) {
		fault = p_what;
	}
}

class Fuzzer {
public:
	static constexpr std::size_t MAX = 700;

	explicit Fuzzer(uint32_t p_seed) : _random(p_seed), _blocks(MAX), _corpus(DISMOUNT_CORPUS, MAX) {
		std::mt19937 random(p_seed);
		_seed_mt_data2(random);
		_seed_mt_data(random);
		_seed_configuration();
		_master = suit_format(5, output_mode::CALIBRATED | output_mode::ORIENTATION);
		_check->expect_master(_master);
	}

	/// The messages of the corpus unchanged, each to the framer.
	void run_corpus() {
		for (const Bytes &bytes : _corpus.files()) {
			_feed(bytes.data(), bytes.size());
		}
	}

	void run() {
		switch (_random.below(8)) {
			case 0:
			case 1:
				_run_mt_data2();
				break;
			case 2:
				_run_mt_data();
				break;
			case 3:
				_run_configuration();
				break;
			case 4:
				_run_check();
				break;
			default:
				_run_framer();
				break;
		}
	}

	uint64_t taken = 0;

private:
	static constexpr std::array<uint16_t, 17> ITEMS = { item::PACKET_COUNTER, item::UTC_TIME, 0x2011, 0x2022, 0x2037,
		0x4021, item::GNSS_PVT_DATA, item::GNSS_SAT_INFO, item::AWINDA_SNAPSHOT, item::FULL_SNAPSHOT,
		item::TRIGGER_IN_2, item::RAW_ACC_GYR_MAG_TEMP, item::SAMPLE_TIME_64, 0xD012, item::STATUS_BYTE, item::RSSI,
		item::FRAME_RANGE };

	void _keep(const uint8_t *p_data, std::size_t p_size, std::vector<Bytes> &r_seeds) {
		r_seeds.emplace_back(p_data, p_data + std::min(p_size, MAX));
	}
	void _seed_mt_data2(std::mt19937 &r_random) {
		Bytes data(MAX_DATA);
		for (std::size_t i = 0; i < 24; i++) {
			FullSample sample = draw_sample(r_random);
			sample.gnss_satellites.count = uint8_t(i);
			const uint16_t *first = ITEMS.data() + i % 12;
			_keep(data.data(), write_mt_data2(first, 3 + i % 3, sample, data.data(), data.size()), _items);
		}
	}
	void _seed_mt_data(std::mt19937 &r_random) {
		Bytes data(MAX_DATA);
		for (std::size_t i = 0; i < 24; i++) {
			const FullSample sample = draw_sample(r_random);
			const OutputFormat format = { uint16_t(i % 3 == 0 ? 0x1000U : (0x083FU & ~(1U << (i % 6)))),
				uint32_t((i % 4) << 8U | (i % 3) << 2U | 1U) };
			_formats.push_back(format);
			_keep(data.data(), write_block(format, sample, true, data.data()), _blocks_of_data);
		}
	}
	void _seed_configuration() {
		Configuration configuration;
		Bytes data(Configuration::MAX_BYTES);
		for (const std::size_t count : { 0, 1, 2, 17, 30 }) {
			configuration.device_count = count;
			_keep(data.data(), configuration.write(data.data()), _configurations);
		}
	}

	/// A damaged seed, or bytes that are made up, in memory of just that size.
	const uint8_t *_draw(const std::vector<Bytes> &p_seeds, std::size_t &r_size) {
		if (_random.below(4) == 0) {
			r_size = _random.below(60);
			uint8_t *bytes = _blocks.of(r_size);
			for (std::size_t i = 0; i < r_size; i++) {
				bytes[i] = uint8_t(_random());
			}
			return bytes;
		}
		const Bytes &seed = p_seeds[_random.below(uint32_t(p_seeds.size()))];
		r_size = seed.size();
		r_size -= _random.below(4) == 0 ? _random.below(uint32_t(r_size) + 1U) : 0;
		uint8_t *bytes = _blocks.of(r_size);
		std::memcpy(bytes, seed.data(), r_size);
		_damage(bytes, r_size);
		fuzzing::LastInput::note(bytes, r_size);
		return bytes;
	}
	void _damage(uint8_t *r_bytes, std::size_t p_size) {
		for (uint32_t i = p_size > 0 ? _random.below(4) : 0; i > 0; i--) {
			const uint32_t at = _random.below(uint32_t(p_size));
			r_bytes[at] = _random.below(2) == 0 ? uint8_t(_random()) : uint8_t(r_bytes[at] ^ (1U << _random.below(8)));
		}
	}

	void _run_mt_data2() {
		std::size_t size = 0;
		const uint8_t *bytes = _draw(_items, size);
		const ItemReport report = decode_mt_data2(bytes, size, _sample);
		std::size_t sum = 0;
		const bool whole = visit_items(bytes, size, [&](const Item &p_item) { sum += 3U + p_item.size; });
		expect(whole == report.whole && sum <= size && (!whole || sum == size), "items do not add up");
		expect(_sample.is_empty() || report.decoded > 0, "what is present was not decoded");
		taken += report.whole ? 1U : 0U;
		std::array<double, 4> turned;
		_sample.orientation(turned);
		is_in_range(_sample);
	}
	void _run_mt_data() {
		std::size_t size = 0;
		const uint8_t *bytes = _draw(_blocks_of_data, size);
		OutputFormat format = _formats[_random.below(uint32_t(_formats.size()))];
		if (_random.below(2) == 0) {
			format = { uint16_t(_random()), uint32_t(_random()) };
		}
		const bool good = decode_data(format, bytes, size, _sample);
		expect(!good || format.size() == size, "a block of the wrong size was taken");
		taken += good ? 1U : 0U;
		format.decode_behind_master(bytes, size, _sample);
		OutputRequest outputs[20];
		std::size_t count = 0;
		parse_output_configuration(bytes, size, outputs, 20, count);
		expect(count <= 20, "too many lines");
	}
	void _run_configuration() {
		std::size_t size = 0;
		const uint8_t *bytes = _draw(_configurations, size);
		const bool good = _configuration.parse(bytes, size) == ConfigurationFault::NONE;
		expect(!good || size == Configuration::HEAD + _configuration.device_count * Configuration::DEVICE,
				"a configuration of the wrong size was taken");
		taken += good ? 1U : 0U;
	}
	void _run_check() {
		std::size_t size = 0;
		const uint8_t *bytes = _draw(_random.below(2) == 0 ? _items : _blocks_of_data, size);
		const bool items = _random.below(2) == 0;
		const Message message =
				_random.below(8) == 0 ? Message(_random()) : (items ? Message::MT_DATA2 : Message::MT_DATA);
		const Frame frame = { uint8_t(_random.below(4) == 0 ? _random() : MASTER), message, bytes, size };
		const bool data = _check->take(frame, _random.below(2) == 0) == StreamCheck::Verdict::DATA;
		expect(_check->sample_count() <= MAX_DEVICES, "too many samples");
		taken += data ? 1U : 0U;
	}
	void _run_framer() {
		std::size_t size = 0;
		const uint8_t *bytes = _draw(_random.below(2) == 0 ? _items : _configurations, size);
		std::array<uint8_t, MAX + 7> frame;
		if (_random.below(4) == 0) {
			const Bytes &seed = _corpus.files()[_random.below(uint32_t(_corpus.files().size()))];
			size = seed.size();
			std::memcpy(frame.data(), seed.data(), size);
		} else {
			size = write_frame(MASTER, Message::MT_DATA2, bytes, std::min(size, MAX - 7), frame.data());
		}
		_damage(frame.data(), size);
		_framer->set_longest(_random.below(16) == 0 ? MAX_DATA : 300);
		_feed(frame.data(), size);
	}
	/// Feeds bytes in pieces.
	void _feed(const uint8_t *p_bytes, std::size_t p_size) {
		std::size_t at = 0;
		while (at < p_size) {
			const std::size_t piece = std::min<std::size_t>(1 + _random.below(uint32_t(p_size)), p_size - at);
			uint8_t *exact = _blocks.of(piece);
			std::memcpy(exact, p_bytes + at, piece);
			fuzzing::LastInput::note(exact, piece);
			_framer->feed(exact, piece, [&](const Frame &p_frame) { _see(p_frame); });
			at += piece;
		}
		if (_random.below(8) == 0) {
			_framer->give_up([&](const Frame &p_frame) { _see(p_frame); });
		}
		const FramerStatistics &statistics = _framer->statistics();
		expect(statistics.bytes == statistics.frame_bytes + statistics.skipped_bytes + _framer->pending(),
				"bytes are not counted once");
	}
	void _see(const Frame &p_frame) {
		uint32_t sum = 0;
		for (std::size_t i = 0; i < p_frame.size; i++) {
			sum += p_frame.data[i];
		}
		expect(sum <= p_frame.size * 255, "bytes above 255");
		taken++;
	}

	Random _random;
	ExactBlocks _blocks;
	fuzzing::Corpus _corpus;
	std::vector<Bytes> _items;
	std::vector<Bytes> _blocks_of_data;
	std::vector<Bytes> _configurations;
	std::vector<OutputFormat> _formats;
	FullSample _sample;
	Configuration _configuration;
	MasterFormat _master;
	std::unique_ptr<StreamCheck> _check = std::make_unique<StreamCheck>();
	std::unique_ptr<Framer> _framer = std::make_unique<Framer>();
};

} // namespace

int main(int p_count, char **p_arguments) {
	const long executions = p_count > 1 ? std::strtol(p_arguments[1], nullptr, 10) : 300000;
	Fuzzer fuzzer(p_count > 2 ? uint32_t(std::strtol(p_arguments[2], nullptr, 10)) : 1);
	fuzzing::LastInput::arm();
	fuzzer.run_corpus();
	for (long i = 0; i < executions; i++) {
		fuzzer.run();
		if (fault != nullptr) {
			fuzzing::LastInput::keep();
			std::printf("execution %ld: %s\n", i, fault);
			return 1;
		}
	}
	std::printf("%ld executions, no finding; %llu messages taken\n", executions,
			static_cast<unsigned long long>(fuzzer.taken));
	return 0;
}
