// SPDX-License-Identifier: MIT
// Hostile datagrams for the receiver of MVN's stream: mvn_fuzz [EXECUTIONS [SEED]]. Built with sanitizers
// (DISMOUNT_SANITIZE) it finds what a wrong byte could do. The loop itself allocates nothing.
#include "drawn_content.hpp"
#include "fuzzing.hpp"

#include "mvn/collector.hpp"

#include <cstdio>
#include <cstdlib>

using namespace drawn;

namespace {

constexpr std::size_t MAX = 2300;

class Fuzzer {
public:
	explicit Fuzzer(unsigned p_seed) : _random(p_seed), _blocks(MAX), _corpus(DISMOUNT_CORPUS, MAX) {
		Source source(p_seed);
		_seeds.reserve(256);
		for (const Type type : TYPES_OF_ALL) {
			for (const std::size_t most : { std::size_t(300), MAX }) {
				for (const Bytes &bytes : encode(source.content(type, 1, source.below(2) == 0), most)) {
					if (bytes.size() <= MAX) {
						_seeds.push_back(bytes);
					}
				}
			}
		}
		_seeds.insert(_seeds.end(), _corpus.files().begin(), _corpus.files().end());
	}

	/// One datagram; false if what came of it cannot be.
	bool run() {
		std::size_t size = 0;
		const Bytes *whole = _corpus.whole(_executions++);
		uint8_t *bytes = whole == nullptr ? draw(size) : copy(*whole, size);
		fuzzing::LastInput::note(bytes, size);
		_now_usec += _random.below(64) == 0 ? 3000000 : 500;
		const Outcome outcome = _collector.take(bytes, size, _random.below(16) == 0 ? 2 : 1, _now_usec);
		if (outcome == Outcome::SAMPLE) {
			++samples;
			const Content &content = _collector.content();
			return content.poses.size() <= 512 && content.motions.size() <= std::size_t(MAX_SEGMENTS) &&
					content.joints.size() <= 128 && content.points.size() <= 512 && content.tags.size() <= 64;
		}
		if (_random.below(4096) == 0) {
			_collector.forget_silent(_now_usec);
		}
		return true;
	}

	uint64_t samples = 0;

private:
	uint8_t *copy(const Bytes &p_seed, std::size_t &r_size) {
		r_size = p_seed.size();
		std::copy(p_seed.begin(), p_seed.end(), _blocks.of(r_size));
		return _blocks.of(r_size);
	}
	uint8_t *draw(std::size_t &r_size) {
		if (_random.below(16) == 0) {
			r_size = _random.below(200);
			for (std::size_t at = 0; at < r_size; ++at) {
				_blocks.of(r_size)[at] = uint8_t(_random());
			}
			return _blocks.of(r_size);
		}
		const Bytes &seed = _seeds[_random.below(uint32_t(_seeds.size()))];
		r_size = _random.below(6) == 0 ? _random.below(uint32_t(seed.size()) + 1) : seed.size();
		uint8_t *bytes = _blocks.of(r_size);
		std::copy(seed.begin(), seed.begin() + std::ptrdiff_t(r_size), bytes);
		if (r_size >= HEADER_SIZE) {
			++_sample;
			bytes[8] = uint8_t(_sample >> 10U);
			bytes[9] = uint8_t(_sample >> 2U);
			if (_random.below(2) == 0) {
				bytes[22] = bytes[23] = 0; // As from old senders.
			}
		}
		for (uint32_t damage = r_size > 0 ? _random.below(5) : 0; damage > 0; --damage) {
			// The head and what follows it decide most.
			const uint32_t end = uint32_t(_random.below(2) == 0 ? std::min<std::size_t>(r_size, 40) : r_size);
			bytes[_random.below(end)] = uint8_t(_random.below(3) == 0 ? 0xFF : _random());
		}
		return bytes;
	}

	fuzzing::Random _random;
	fuzzing::ExactBlocks _blocks;
	fuzzing::Corpus _corpus;
	uint64_t _executions = 0;
	std::vector<Bytes> _seeds;
	Collector _collector;
	uint64_t _now_usec = 1;
	uint32_t _sample = 0;
};

} // namespace

int main(int p_count, char **p_arguments) {
	const long executions = p_count > 1 ? std::strtol(p_arguments[1], nullptr, 10) : 100000;
	Fuzzer fuzzer(p_count > 2 ? unsigned(std::strtol(p_arguments[2], nullptr, 10)) : 1);
	fuzzing::LastInput::arm();
	for (long at = 0; at < executions; ++at) {
		if (!fuzzer.run()) {
			fuzzing::LastInput::keep();
			std::printf("execution %ld: more came of a datagram than there can be\n", at);
			return 1;
		}
		if (at % 5000000 == 4999999) {
			std::printf("%ld executions\n", at + 1);
			std::fflush(stdout);
		}
	}
	std::printf("%ld executions, no finding; %llu samples whole\n", executions,
			static_cast<unsigned long long>(fuzzer.samples));
	return 0;
}
