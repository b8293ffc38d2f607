// SPDX-License-Identifier: MIT
// Reads hostile bytes as a person: wire_fuzz [EXECUTIONS [SEED]]. Built with sanitizers
// (DISMOUNT_SANITIZE) it finds what a wrong byte could do.
#include "fuzzing.hpp"
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
	explicit Fuzzer(uint32_t p_seed) :
			_random(p_seed), _body(people::skeleton()), _corpus(DISMOUNT_CORPUS, PersonCodec::MAX_BYTES) {
		PersonPose pose = people::draw_pose(_random);
		for (std::size_t i = 0; i < STATES; i++) {
			pose = people::moved(_random, pose, i % 7 == 0 ? 2.0f : 0.05f);
			for (std::size_t fine = 0; fine < 2; fine++) {
				_lattices[fine].quantise(pose, _body, i > 0 ? &_states[fine][i - 1] : nullptr, _states[fine][i]);
			}
		}
	}

	/// Reads one damaged or made-up person; false if what comes out is no state.
	bool run() {
		const std::size_t fine = _random() % 2;
		const PersonState *base = _random() % 8 == 0 ? nullptr : &_states[fine][_random() % STATES];
		const PersonState *before = _random() % 4 == 0 ? nullptr : &_states[fine][_random() % STATES];
		const int age = _random() % 16 == 0 ? int(_random()) : int(_random() % 12);
		const int before_age = _random() % 16 == 0 ? int(_random()) : age + int(_random() % 4);
		const PersonCodec codec(_body, _lattices[fine].resolution());
		std::array<uint8_t, PersonCodec::MAX_BYTES> bytes;
		std::size_t size = _random() % 96;
		const fuzzing::Corpus::Bytes *whole = _corpus.whole(_executions++);
		if (whole != nullptr || _random() % 8 == 0) {
			const auto &seed = whole != nullptr ? *whole : _corpus.files()[_random() % _corpus.files().size()];
			size = seed.size();
			std::copy(seed.begin(), seed.end(), bytes.begin());
			if (whole == nullptr) {
				_damage(bytes.data(), size);
			}
		} else if (_random() % 2 == 0) {
			RangeEncoder encoder(bytes.data(), bytes.size());
			codec.encode(encoder, _states[fine][_random() % STATES], base, before, age, before_age);
			size = encoder.finish();
			_damage(bytes.data(), size);
		} else {
			for (std::size_t i = 0; i < size; i++) {
				bytes[i] = uint8_t(_random());
			}
		}
		// Of just this size, so that a sanitizer sees what is read beyond.
		const std::vector<uint8_t> exact(bytes.begin(), bytes.begin() + std::ptrdiff_t(size));
		fuzzing::LastInput::note(exact.data(), exact.size());
		PersonState found;
		RangeDecoder decoder(exact.data(), exact.size());
		const bool good = codec.decode(decoder, found, base, before, age, before_age);
		accepted += good ? 1 : 0;
		return !good || _is_state(found, _lattices[fine].resolution());
	}

	long accepted = 0;

private:
	void _damage(uint8_t *r_bytes, std::size_t &r_size) {
		for (std::size_t i = _random() % 4; i > 0 && r_size > 0; i--) {
			const std::size_t at = _random() % r_size;
			r_bytes[at] = _random() % 2 == 0 ? uint8_t(_random()) : uint8_t(r_bytes[at] ^ (1U << (_random() % 8)));
		}
		r_size -= _random() % 4 == 0 && r_size > 0 ? _random() % r_size : 0;
	}
	bool _is_state(const PersonState &p_state, int p_resolution) const {
		bool good = true;
		for (std::size_t i = 0; i < std::size_t(_body.limb_count); i++) {
			const RotationCode &code = p_state.limbs[i];
			good = good && code.dropped < 4 &&
					is_on_lattice({ code.parts[0], code.parts[1], code.parts[2] }, p_resolution);
		}
		return good;
	}

	std::mt19937 _random;
	Skeleton _body;
	fuzzing::Corpus _corpus;
	uint64_t _executions = 0;
	std::array<PersonLattice, 2> _lattices{ PersonLattice(PersonLattice::COARSE), PersonLattice(PersonLattice::FINE) };
	std::array<std::array<PersonState, STATES>, 2> _states{};
};

} // namespace

int main(int p_count, char **p_arguments) {
	const long executions = p_count > 1 ? std::strtol(p_arguments[1], nullptr, 10) : 100000;
	Fuzzer fuzzer(p_count > 2 ? uint32_t(std::strtol(p_arguments[2], nullptr, 10)) : 1);
	fuzzing::LastInput::arm();
	for (long i = 0; i < executions; i++) {
		if (!fuzzer.run()) {
			fuzzing::LastInput::keep();
			std::printf("execution %ld: what was read is no state\n", i);
			return 1;
		}
	}
	std::printf("%ld executions, %ld of them gave a state\n", executions, fuzzer.accepted);
	return 0;
}
