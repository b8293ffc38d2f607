// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

/// What fuzzers share.
namespace fuzzing {

/// Memory of just the size asked for at its end, so that a sanitizer sees what is read beyond: one block for
/// each size, as making one for each execution would be most of the work.
class ExactBlocks {
public:
	explicit ExactBlocks(std::size_t p_most) : _blocks(p_most + 1) {
		for (std::size_t i = 0; i <= p_most; i++) {
			_blocks[i] = std::make_unique<uint8_t[]>(i);
		}
	}
	uint8_t *of(std::size_t p_size) { return _blocks[p_size].get(); }

private:
	std::vector<std::unique_ptr<uint8_t[]>> _blocks;
};

/// Fast numbers; their quality hardly matters.
class Random {
public:
	explicit Random(uint64_t p_seed) : _state(p_seed * 2 + 1) {}
	uint32_t operator()() {
		_state = _state * 6364136223846793005ULL + 1442695040888963407ULL;
		return uint32_t(_state >> 33U);
	}
	uint32_t below(uint32_t p_end) { return (*this)() % p_end; }

private:
	uint64_t _state;
};

} // namespace fuzzing
