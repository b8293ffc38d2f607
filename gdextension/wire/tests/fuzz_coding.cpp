// SPDX-License-Identifier: MIT
// Reads hostile bytes as a person: wire_fuzz [EXECUTIONS [SEED]]. Built with sanitizers
// (DISMOUNT_SANITIZE) it finds what a wrong byte could do.
#include "people.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <vector>

using namespace wire;

namespace {

constexpr std::size_t STATES = 64;

/// Bytes and states that a fuzzer starts from.
class Fuzzer {
public:
	explicit Fuzzer(uint32_t p_seed) : random(p_seed), body(people::skeleton()) {
		PersonPose pose = people::draw_pose(random);
		for (std::size_t i = 0; i < STATES; i++) {
			pose = people::moved(random, pose, i % 7 == 0 ? 2.0f : 0.05f);
			for (std::size_t fine = 0; fine < 2; fine++) {
				lattices[fine].quantise(pose, body, i > 0 ? &states[fine][i - 1] : nullptr, states[fine][i]);
			}
		}
	}

	/// Reads one damaged or made-up person; false if what comes out is no state.
	bool run() {
		const std::size_t fine = random() % 2;
		const PersonState *base = random() % 8 == 0 ? nullptr : &states[fine][random() % STATES];
		const PersonState *before = random() % 4 == 0 ? nullptr : &states[fine][random() % STATES];
		const int age = random() % 16 == 0 ? int(random()) : int(random() % 12);
		const int before_age = random() % 16 == 0 ? int(random()) : age + int(random() % 4);
		const PersonCodec codec(body, lattices[fine].resolution());
		std::array<uint8_t, PersonCodec::MAX_BYTES> bytes;
		std::size_t size = random() % 96;
		if (random() % 2 == 0) {
			RangeEncoder encoder(bytes.data(), bytes.size());
			codec.encode(encoder, states[fine][random() % STATES], base, before, age, before_age);
			size = encoder.finish();
			damage(bytes.data(), size);
		} else {
			for (std::size_t i = 0; i < size; i++) {
				bytes[i] = uint8_t(random());
			}
		}
		// Of just this size, so that a sanitizer sees what is read beyond.
		const std::vector<uint8_t> exact(bytes.begin(), bytes.begin() + std::ptrdiff_t(size));
		PersonState found;
		RangeDecoder decoder(exact.data(), exact.size());
		const bool good = codec.decode(decoder, found, base, before, age, before_age);
		accepted += good ? 1 : 0;
		return !good || is_state(found, lattices[fine].resolution());
	}

	long accepted = 0;

private:
	void damage(uint8_t *r_bytes, std::size_t &r_size) {
		for (std::size_t i = random() % 4; i > 0 && r_size > 0; i--) {
			const std::size_t at = random() % r_size;
			r_bytes[at] = random() % 2 == 0 ? uint8_t(random()) : uint8_t(r_bytes[at] ^ (1U << (random() % 8)));
		}
		r_size -= random() % 4 == 0 && r_size > 0 ? random() % r_size : 0;
	}
	bool is_state(const PersonState &p_state, int p_resolution) const {
		bool good = true;
		for (std::size_t i = 0; i < std::size_t(body.limb_count); i++) {
			const RotationCode &code = p_state.limbs[i];
			good = good && code.dropped < 4 &&
					is_on_lattice({ code.parts[0], code.parts[1], code.parts[2] }, p_resolution);
		}
		return good;
	}

	std::mt19937 random;
	Skeleton body;
	std::array<PersonLattice, 2> lattices{ PersonLattice(PersonLattice::COARSE), PersonLattice(PersonLattice::FINE) };
	std::array<std::array<PersonState, STATES>, 2> states{};
};

} // namespace

int main(int p_count, char **p_arguments) {
	const long executions = p_count > 1 ? std::strtol(p_arguments[1], nullptr, 10) : 100000;
	Fuzzer fuzzer(p_count > 2 ? uint32_t(std::strtol(p_arguments[2], nullptr, 10)) : 1);
	for (long i = 0; i < executions; i++) {
		if (!fuzzer.run()) {
			std::printf("execution %ld: what was read is no state\n", i);
			return 1;
		}
	}
	std::printf("%ld executions, %ld of them gave a state\n", executions, fuzzer.accepted);
	return 0;
}
