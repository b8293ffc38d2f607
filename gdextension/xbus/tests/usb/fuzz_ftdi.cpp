// SPDX-License-Identifier: MIT
// Hostile reads for the removal of FTDI's status bytes: xbus_fuzz_ftdi [EXECUTIONS [SEED]].
#include "usb/ftdi_protocol.hpp"

#include "fuzzing.hpp"

#include <cstdio>
#include <cstdlib>

namespace {

constexpr std::size_t MAX = 1100;

/// Strips a read that lies in memory of just its size; false if what came out cannot be.
bool strip(fuzzing::Random &r_random, fuzzing::ExactBlocks &r_blocks, const fuzzing::Corpus &p_corpus,
		const fuzzing::Corpus::Bytes *p_whole) {
	const fuzzing::Corpus::Bytes *seed = p_whole;
	if (seed == nullptr && r_random.below(4) == 0) {
		seed = &p_corpus.files()[r_random.below(uint32_t(p_corpus.files().size()))];
	}
	std::size_t size = r_random.below(8) == 0 ? r_random.below(MAX) : r_random.below(140);
	size = seed != nullptr ? seed->size() : size;
	uint8_t *bytes = r_blocks.of(size);
	if (seed != nullptr) {
		std::copy(seed->begin(), seed->end(), bytes);
	}
	for (int change = 0; change < 4 && size > 0 && p_whole == nullptr; ++change) {
		bytes[r_random.below(uint32_t(size))] = uint8_t(r_random.below(256));
	}
	fuzzing::LastInput::note(bytes, size);
	constexpr std::size_t PACKETS[] = { 64, 512, 8, 3, 2, 1, 0, 4096 };
	const std::size_t packet = r_random.below(4) == 0 ? r_random.below(600) : PACKETS[r_random.below(8)];
	usb::FtdiStatistics statistics;
	std::size_t payload = 0;
	uint32_t sum = 0;
	bool is_sound = true;
	usb::ftdi_strip(bytes, size, packet, statistics, [&](const uint8_t *p_bytes, std::size_t p_size) {
		is_sound = is_sound && p_size > 0 && p_bytes >= bytes + 2 && p_bytes + p_size <= bytes + size;
		payload += p_size;
		for (std::size_t at = 0; at < p_size; ++at) {
			sum += p_bytes[at];
		}
	});
	const std::size_t status = 2 * (statistics.packets - statistics.short_packets) + statistics.short_packets;
	return is_sound && payload + status == size && statistics.line_faults <= statistics.packets && sum <= 255 * payload;
}

} // namespace

int main(int p_count, char **p_values) {
	const uint64_t executions = p_count > 1 ? std::strtoull(p_values[1], nullptr, 10) : 300000;
	const uint64_t seed = p_count > 2 ? std::strtoull(p_values[2], nullptr, 10) : 1;
	fuzzing::Random random(seed);
	fuzzing::ExactBlocks blocks(MAX);
	const fuzzing::Corpus corpus(DISMOUNT_CORPUS, MAX);
	fuzzing::LastInput::arm();
	for (uint64_t execution = 0; execution < executions; ++execution) {
		if (!strip(random, blocks, corpus, corpus.whole(execution))) {
			fuzzing::LastInput::keep();
			std::printf(
					"FAIL at execution %llu of seed %llu\n", (unsigned long long)execution, (unsigned long long)seed);
			return 1;
		}
	}
	std::printf("%llu executions, no finding\n", (unsigned long long)executions);
	return 0;
}
