// SPDX-License-Identifier: MIT
// Reads hostile bytes as a motion set: matching_fuzz [EXECUTIONS [SEED]]. Built with sanitizers (DISMOUNT_SANITIZE) it
// finds what a wrong byte could do.
#include "walker_fixture.hpp"

#include <fuzzing.hpp>
#include <motion_file.hpp>
#include <motion_matcher.hpp>

#include <cstdio>
#include <cstdlib>

using namespace matching;

namespace {

constexpr std::size_t MOST = 4096;

/// Plays what was read: whatever a file holds, the pose stays one.
bool plays(const std::vector<Clip> &p_clips) {
	MotionMatcher matcher;
	matcher.set_motion_set(std::make_shared<const MotionSet>(p_clips));
	Wish wish;
	for (int i = 0; i < 20; i++) {
		wish.wished_velocity = { 0.0f, 0.0f, i < 10 ? 1.5f : 0.0f };
		matcher.advance(1.0f / 60.0f, wish);
	}
	return matcher.pose().hips.is_finite();
}

} // namespace

int main(int p_count, char **p_arguments) {
	const long executions = p_count > 1 ? std::strtol(p_arguments[1], nullptr, 10) : 20000;
	fuzzing::Random random(p_count > 2 ? uint64_t(std::strtol(p_arguments[2], nullptr, 10)) : 1);
	const fuzzing::Corpus corpus(DISMOUNT_CORPUS, MOST);
	fuzzing::ExactBlocks blocks(MOST);
	fuzzing::LastInput::arm();
	long accepted = 0;
	for (long i = 0; i < executions; i++) {
		const fuzzing::Corpus::Bytes *whole = corpus.whole(uint64_t(i));
		fuzzing::Corpus::Bytes bytes =
				whole != nullptr ? *whole : corpus.files()[random.below(uint32_t(corpus.files().size()))];
		for (uint32_t k = whole != nullptr ? 0 : random.below(5); k > 0; k--) {
			bytes[random.below(random.below(2) == 0 ? 32 : uint32_t(bytes.size()))] = uint8_t(random());
		}
		if (whole == nullptr && random.below(4) == 0) {
			bytes.resize(random.below(uint32_t(bytes.size())));
		}
		uint8_t *block = blocks.of(bytes.size());
		std::copy(bytes.begin(), bytes.end(), block);
		fuzzing::LastInput::note(block, bytes.size());
		std::vector<Clip> clips;
		const bool is_read = read_motion_file(block, bytes.size(), clips).empty();
		accepted += is_read ? 1 : 0;
		if (is_read && !plays(clips)) {
			fuzzing::LastInput::keep();
			std::printf("execution %ld: what was read gives no pose\n", i);
			return 1;
		}
	}
	std::printf("%ld executions, %ld of them gave a set\n", executions, accepted);
	return accepted > 0 ? 0 : 1;
}
