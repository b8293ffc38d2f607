// SPDX-License-Identifier: MIT
// Hostile reads for the removal of FTDI's status bytes: xbus_fuzz_ftdi [EXECUTIONS [SEED]].
#include "usb/ftdi_protocol.hpp"

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <vector>

namespace {

constexpr std::size_t MOST = 1100;

/// Fast numbers; their quality hardly matters.
class Random {
public:
	explicit Random(uint64_t p_seed) : _state(p_seed * 2 + 1) {}
	uint32_t below(uint32_t p_end) {
		_state = _state * 6364136223846793005ULL + 1442695040888963407ULL;
		return uint32_t(_state >> 33U) % p_end;
	}

private:
	uint64_t _state;
};

/// Strips a read that lies in memory of just its size; false if what came out cannot be.
bool strip(Random &r_random, const std::vector<std::unique_ptr<uint8_t[]>> &p_blocks) {
	const std::size_t size = r_random.below(8) == 0 ? r_random.below(MOST) : r_random.below(140);
	uint8_t *bytes = p_blocks[size].get();
	for (int change = 0; change < 4 && size > 0; ++change) {
		bytes[r_random.below(uint32_t(size))] = uint8_t(r_random.below(256));
	}
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
	Random random(seed);
	std::vector<std::unique_ptr<uint8_t[]>> blocks(MOST + 1);
	for (std::size_t size = 0; size <= MOST; ++size) {
		blocks[size] = std::make_unique<uint8_t[]>(size);
	}
	for (uint64_t execution = 0; execution < executions; ++execution) {
		if (!strip(random, blocks)) {
			std::printf(
					"FAIL at execution %llu of seed %llu\n", (unsigned long long)execution, (unsigned long long)seed);
			return 1;
		}
	}
	std::printf("%llu executions, no finding\n", (unsigned long long)executions);
	return 0;
}
