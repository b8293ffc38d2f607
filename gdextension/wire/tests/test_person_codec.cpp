// SPDX-License-Identifier: MIT
#include "people.hpp"

#include <check.hpp>
#include <coding/person_tables.hpp>

#include <array>
#include <vector>

namespace test_person_codec {

using namespace wire;

namespace {

using Bytes = std::array<uint8_t, PersonCodec::MAX_BYTES + 16>;

struct Case {
	PersonState now;
	PersonState base;
	PersonState before;
	bool has_base = false;
	bool has_before = false;
	int base_age = 2;
	int before_age = 4;

	const PersonState *base_or_null() const { return has_base ? &base : nullptr; }
	const PersonState *before_or_null() const { return has_before ? &before : nullptr; }
};

std::size_t write(const PersonCodec &p_codec, const Case &p_case, Bytes &r_bytes) {
	RangeEncoder encoder(r_bytes.data(), PersonCodec::MAX_BYTES);
	p_codec.encode(
			encoder, p_case.now, p_case.base_or_null(), p_case.before_or_null(), p_case.base_age, p_case.before_age);
	return encoder.finish();
}

bool read(const PersonCodec &p_codec, const Case &p_case, const uint8_t *p_bytes, std::size_t p_size,
		PersonState &r_now, std::size_t &r_used) {
	RangeDecoder decoder(p_bytes, p_size);
	const bool good = p_codec.decode(
			decoder, r_now, p_case.base_or_null(), p_case.before_or_null(), p_case.base_age, p_case.before_age);
	r_used = decoder.used();
	return good;
}

Case draw_case(std::mt19937 &p_random, const PersonLattice &p_lattice, const Skeleton &p_body) {
	constexpr float STEPS[4] = { 0.0f, 0.005f, 0.1f, 4.0f };
	Case drawn;
	PersonPose pose = people::draw_pose(p_random);
	p_lattice.quantise(pose, p_body, nullptr, drawn.before);
	pose = people::moved(p_random, pose, STEPS[p_random() % 4]);
	p_lattice.quantise(pose, p_body, &drawn.before, drawn.base);
	pose = people::moved(p_random, pose, STEPS[p_random() % 4]);
	p_lattice.quantise(pose, p_body, p_random() % 2 == 0 ? &drawn.base : nullptr, drawn.now);
	drawn.has_base = p_random() % 8 != 0;
	drawn.has_before = p_random() % 4 != 0;
	drawn.base_age = 1 + int(p_random() % 40);
	drawn.before_age = drawn.base_age + int(p_random() % 9);
	return drawn;
}

} // namespace

TEST(what_is_written_is_read_and_its_end_found) {
	std::mt19937 random(1);
	for (const int resolution : { PersonLattice::FINE, PersonLattice::COARSE, PersonLattice::MIN_RESOLUTION,
				 PersonLattice::MAX_RESOLUTION }) {
		const PersonLattice lattice(resolution);
		const Skeleton body = people::skeleton();
		const PersonCodec codec(body, resolution);
		int wrong = 0;
		for (int round = 0; round < 4000; round++) {
			const Case drawn = draw_case(random, lattice, body);
			Bytes bytes{};
			const std::size_t size = write(codec, drawn, bytes);
			PersonState found;
			std::size_t used = 0;
			const bool good = read(codec, drawn, bytes.data(), bytes.size(), found, used);
			wrong += size > 0 && good && used == size && people::same(found, drawn.now, 16) ? 0 : 1;
		}
		CHECK(wrong == 0);
	}
}

TEST(bodies_with_any_number_of_limbs) {
	std::mt19937 random(2);
	for (int limbs = 1; limbs <= kinematics::MAX_LIMBS; limbs++) {
		Skeleton body;
		body.limb_count = limbs;
		body.parents[0] = -1;
		for (std::size_t i = 1; i < std::size_t(limbs); i++) {
			body.parents[i] = int(random() % i);
		}
		const PersonLattice lattice;
		const PersonCodec codec(body, lattice.resolution());
		for (int round = 0; round < 100; round++) {
			const Case drawn = draw_case(random, lattice, body);
			Bytes bytes{};
			const std::size_t size = write(codec, drawn, bytes);
			PersonState found;
			std::size_t used = 0;
			CHECK(size > 0 && read(codec, drawn, bytes.data(), size, found, used));
			CHECK(used == size && people::same(found, drawn.now, limbs));
		}
	}
}

TEST(extreme_places_and_ages) {
	const PersonLattice lattice;
	const Skeleton body = people::skeleton();
	const PersonCodec codec(body, lattice.resolution());
	constexpr int32_t MAX = PersonLattice::MAX_ROOT;
	int wrong = 0;
	for (const int32_t now : { -MAX, 0, 1, MAX }) {
		for (const int32_t base : { -MAX, 0, MAX }) {
			for (const int32_t before : { -MAX, 0, MAX }) {
				for (const int age : { -1, 0, 1, 255, 100000, 2147483647 }) {
					Case made;
					made.now.root = { now, -now, now };
					made.base.root = { base, base, -base };
					made.before.root = { before, -before, before };
					made.has_base = made.has_before = true;
					made.base_age = age;
					made.before_age = age < 100000 ? age + 1 : age;
					Bytes bytes{};
					const std::size_t size = write(codec, made, bytes);
					PersonState found;
					std::size_t used = 0;
					const bool good = read(codec, made, bytes.data(), size, found, used);
					wrong += size > 0 && good && people::same(found, made.now, 16) ? 0 : 1;
				}
			}
		}
	}
	CHECK(wrong == 0);
}

TEST(a_person_at_rest_takes_few_bytes) {
	std::mt19937 random(3);
	const PersonLattice lattice;
	const Skeleton body = people::skeleton();
	const PersonCodec codec(body, lattice.resolution());
	Case rest;
	lattice.quantise(people::draw_pose(random), body, nullptr, rest.now);
	rest.base = rest.before = rest.now;
	rest.has_base = rest.has_before = true;
	Bytes bytes{};
	CHECK(write(codec, rest, bytes) == 1);
}

TEST(any_bytes_give_a_state_on_the_lattice_or_are_refused) {
	std::mt19937 random(4);
	const PersonLattice lattice;
	const Skeleton body = people::skeleton();
	const PersonCodec codec(body, lattice.resolution());
	int good = 0;
	int bad_states = 0;
	for (int round = 0; round < 200000; round++) {
		const Case drawn = draw_case(random, lattice, body);
		Bytes bytes{};
		std::size_t size = write(codec, drawn, bytes);
		if (round % 2 == 0) {
			size = random() % 120;
			for (uint8_t &byte : bytes) {
				byte = uint8_t(random());
			}
		} else {
			bytes[random() % size] ^= uint8_t(1U << (random() % 8));
			size -= random() % 3 == 0 ? random() % size : 0;
		}
		PersonState found;
		std::size_t used = 0;
		if (!read(codec, drawn, bytes.data(), size, found, used)) {
			continue;
		}
		good++;
		for (std::size_t i = 0; i < 16; i++) {
			const RotationCode &code = found.limbs[i];
			const std::array<int32_t, 3> parts{ code.parts[0], code.parts[1], code.parts[2] };
			bad_states += code.dropped < 4 && is_on_lattice(parts, lattice.resolution()) ? 0 : 1;
		}
	}
	CHECK(bad_states == 0);
	CHECK(good > 1000);
}

TEST(the_format_does_not_drift) {
	// Whole numbers only, so that every machine writes these bytes. Another hash means another format:
	// then the protocol needs another version, and docs/wire-coding.md another look.
	uint32_t random = 1;
	const auto draw = [&random](int32_t p_most) {
		random = random * 1664525U + 1013904223U;
		return int32_t(random >> 8U) % (2 * p_most + 1) - p_most;
	};
	const PersonCodec codec(people::skeleton(), PersonLattice::FINE);
	Case walk;
	walk.has_base = walk.has_before = true;
	uint64_t hash = 14695981039346656037U;
	for (int round = 0; round < 500; round++) {
		walk.before = walk.base;
		walk.base = walk.now;
		for (std::size_t i = 0; i < 16; i++) {
			RotationCode &code = walk.now.limbs[i];
			const int32_t odd = draw(40);
			for (int16_t &part : code.parts) {
				part = int16_t((part / 2 + draw(20) - part / 20) * 2 + (odd % 2));
			}
			code.dropped = uint8_t(draw(100) == 0 ? (code.dropped + 1) % 4 : code.dropped);
		}
		for (int32_t &position : walk.now.root) {
			position += draw(30);
		}
		walk.base_age = 1 + round % 9;
		walk.before_age = walk.base_age + round % 4;
		Bytes bytes{};
		const std::size_t size = write(codec, walk, bytes);
		PersonState found;
		std::size_t used = 0;
		CHECK(read(codec, walk, bytes.data(), size, found, used) && people::same(found, walk.now, 16));
		for (std::size_t i = 0; i < size; i++) {
			hash = (hash ^ bytes[i]) * 1099511628211U;
		}
	}
	CHECK(hash == 16393237956542121696U);
}

TEST(no_parameter_lets_anything_be_divided_by_nothing) {
	for (const auto &models : { STILL_MODELS, MOVING_MODELS }) {
		for (int i = 0; i < 2 * AGE_STEPS; i++) {
			const PersonModel &model = models[i / AGE_STEPS][i % AGE_STEPS];
			CHECK(model.root.along >= 0 && model.rotation.along >= 0);
		}
	}
	for (const PersonModel &model : WHOLE_MODELS) {
		CHECK(model.root.along >= 0 && model.rotation.along >= 0);
	}
}

} // namespace test_person_codec
