// SPDX-License-Identifier: MIT
#include "snapshot_decoder.hpp"

#include "entry_coding.hpp"

#include <algorithm>
#include <cstring>
#include <iterator>

namespace wire {

SnapshotDecoder::SnapshotDecoder(const Skeleton &p_skeleton, double p_max_error_deg) :
		skeleton(p_skeleton),
		lattice(PersonLattice::resolution_for(p_max_error_deg)),
		codec(p_skeleton, PersonLattice::resolution_for(p_max_error_deg)) {
	person_scratch.reserve(MAX_PEOPLE);
	body_scratch.reserve(MAX_BODIES);
	person_updates.reserve(MAX_PEOPLE);
	body_updates.reserve(MAX_BODIES);
}

void SnapshotDecoder::clear() {
	people_known.clear();
	bodies_known.clear();
	person_updates.clear();
	body_updates.clear();
	has_mark = false;
	rate = 0;
	last_tick = newest_tick = NEVER;
	has_numbers = owes_ack = wants_all = false;
	strays = 0;
}

bool SnapshotDecoder::is_known(uint8_t p_number, uint32_t p_tick) const {
	if (!has_numbers) {
		return false;
	}
	if (int32_t(p_tick - newest_tick) < -STALE) {
		return true;
	}
	// Numbers come round: the nearer way about is the right one.
	const uint32_t ago = uint8_t(newest_number - p_number);
	const bool is_later = ago >= 128;
	return ago == 0 || (!is_later && (ago > 64 || ((earlier_numbers >> (ago - 1)) & 1U) != 0));
}

// Whether the newest tick must be wrong: a forgery with a tick far ahead would make all others look old.
bool SnapshotDecoder::is_astray(const Reader &p_reader) {
	const bool is_key = Kind(p_reader.bytes[0] & KIND_MASK) == Kind::KEY;
	const bool is_old = is_key && int32_t(p_reader.tick - newest_tick) < -STALE;
	// Only a server goes on: what is merely sent again does not count.
	if (is_old && (strays == 0 || int32_t(p_reader.tick - stray_tick) > 0)) {
		strays++;
		stray_tick = p_reader.tick;
	}
	return strays >= MAX_STRAYS;
}

void SnapshotDecoder::note(uint8_t p_number) {
	const uint32_t ahead = uint8_t(p_number - newest_number);
	const uint32_t ago = uint8_t(newest_number - p_number);
	if (!has_numbers) {
		newest_number = p_number;
		earlier_numbers = 0;
	} else if (ahead > 0 && ahead < 128) {
		earlier_numbers = ahead < 64 ? (earlier_numbers << ahead) | (1ULL << (ahead - 1)) : 0;
		newest_number = p_number;
	} else if (ago > 0 && ago <= 64) {
		earlier_numbers |= 1ULL << (ago - 1);
	}
	has_numbers = true;
	owes_ack = true;
}

SnapshotDecoder::Outcome SnapshotDecoder::read_header(Reader &r_reader, int &r_people) {
	const uint8_t *bytes = r_reader.bytes;
	if (r_reader.size < 4 || r_reader.size > MAX_BYTES) {
		return Outcome::BROKEN;
	}
	const Kind kind = Kind(bytes[0] & KIND_MASK);
	r_people = int(uint32_t(bytes[0]) >> 4U);
	if (kind == Kind::KEY && r_reader.size >= 8) {
		r_reader.tick = uint32_t(get_number(bytes + 2, 4));
		read_rate = bytes[6];
		r_reader.at = 7;
	} else if (kind == Kind::SNAPSHOT) {
		if (rate == 0) {
			return Outcome::NOT_BEGUN;
		}
		read_rate = rate;
		r_reader.tick = newest_tick + uint32_t(int32_t(int8_t(bytes[2] - uint8_t(newest_tick))));
		r_reader.at = 3;
	} else {
		return Outcome::BROKEN;
	}
	if (read_rate == 0 || r_reader.tick == NEVER) {
		return Outcome::BROKEN;
	}
	r_reader.usual = Baseline::unpack(bytes[r_reader.at++]);
	has_mark = (bytes[0] & HAS_MARKS) != 0;
	if (has_mark) {
		if (r_reader.size - r_reader.at < Mark::BYTES) {
			return Outcome::BROKEN;
		}
		const uint8_t *at = bytes + r_reader.at;
		last_mark.person = uint16_t(get_number(at, 2));
		last_mark.sample = uint32_t(get_number(at + 2, 4));
		last_mark.simulated_usec = int64_t(get_number(at + 6, 8));
		for (std::size_t step = 0; step < last_mark.steps.size(); step++) {
			last_mark.steps[step] = uint16_t(get_number(at + 14 + 2 * step, 2));
		}
		r_reader.at += Mark::BYTES;
	}
	// Numbers come round within a second or two: after a gap only a whole tick tells what is new.
	r_reader.follows_gap = kind == Kind::KEY && has_numbers && int32_t(r_reader.tick - newest_tick) > GAP;
	return !r_reader.follows_gap && is_known(bytes[1], r_reader.tick) ? Outcome::STALE : Outcome::OK;
}

SnapshotDecoder::Outcome SnapshotDecoder::read_people(Reader &r_reader, int p_count) {
	for (int i = 0; i < p_count; i++) {
		const std::size_t left = r_reader.size - r_reader.at;
		RangeDecoder decoder(r_reader.bytes + r_reader.at, left);
		const uint32_t id = decode_count(decoder, 2);
		const Baseline base = decode_baseline(decoder, r_reader.usual);
		if (id > 65535 || left == 0) {
			return Outcome::BROKEN;
		}
		const auto known = people_known.find(uint16_t(id));
		const int older = base.age + base.spacing;
		const Trail<PersonState> *trail = known == people_known.end() ? nullptr : known->second.get();
		const auto find = [&](int p_age) {
			return trail != nullptr ? trail->find(r_reader.tick - uint32_t(p_age)) : nullptr;
		};
		const PersonState *state = base.age > 0 ? find(base.age) : nullptr;
		const PersonState *before = base.age > 0 && base.spacing > 0 ? find(older) : nullptr;
		if ((base.age > 0 && state == nullptr) || (base.spacing > 0 && before == nullptr)) {
			return base.age > 0 ? Outcome::LACKS_BASELINE : Outcome::BROKEN;
		}
		PersonScratch scratch;
		scratch.id = uint16_t(id);
		if (!codec.decode(decoder, scratch.state, state, before, base.age, older) || decoder.is_bad()) {
			return Outcome::BROKEN;
		}
		r_reader.at += decoder.used();
		person_scratch.push_back(scratch);
	}
	return Outcome::OK;
}

SnapshotDecoder::Outcome SnapshotDecoder::read_bodies(Reader &r_reader) {
	if (r_reader.at == r_reader.size) {
		return Outcome::OK;
	}
	RangeDecoder decoder(r_reader.bytes + r_reader.at, r_reader.size - r_reader.at);
	int64_t id = -1;
	do {
		id += 1 + int64_t(decode_count(decoder, 1));
		if (id > 65535 || decoder.is_bad() || body_scratch.size() >= std::size_t(MAX_BODIES)) {
			return Outcome::BROKEN;
		}
		const BodyState *base = nullptr;
		int age = 0;
		if (!decoder.decode_bit(HAS_BASE)) {
			age = int(decoder.decode_bits(AGE_BITS));
			const auto known = bodies_known.find(uint16_t(id));
			base = known == bodies_known.end() ? nullptr : known->second->find(r_reader.tick - uint32_t(age));
			if (base == nullptr || age == 0) {
				return age == 0 || decoder.is_bad() ? Outcome::BROKEN : Outcome::LACKS_BASELINE;
			}
		}
		BodyScratch scratch;
		scratch.id = uint16_t(id);
		if (!BodyCodec::decode(decoder, base, age, read_rate, scratch.state)) {
			return Outcome::BROKEN;
		}
		body_scratch.push_back(scratch);
	} while (!decoder.decode_bit(GOES_ON));
	r_reader.at += decoder.used();
	return decoder.is_bad() || r_reader.at != r_reader.size ? Outcome::BROKEN : Outcome::OK;
}

void SnapshotDecoder::keep_people(const std::vector<uint16_t> &p_people) {
	for (auto known = people_known.begin(); known != people_known.end();) {
		const bool stays = std::find(p_people.begin(), p_people.end(), known->first) != p_people.end();
		known = stays ? std::next(known) : people_known.erase(known);
	}
}

void SnapshotDecoder::keep(uint32_t p_tick) {
	for (const PersonScratch &scratch : person_scratch) {
		std::unique_ptr<Trail<PersonState>> &trail = people_known[scratch.id];
		trail = trail != nullptr ? std::move(trail) : std::make_unique<Trail<PersonState>>();
		trail->put(p_tick, scratch.state);
		PersonUpdate &update = person_updates.emplace_back();
		update.id = scratch.id;
		update.tick = p_tick;
		lattice.restore(scratch.state, skeleton, update.pose);
	}
	for (const BodyScratch &scratch : body_scratch) {
		std::unique_ptr<Trail<BodyState>> &trail = bodies_known[scratch.id];
		trail = trail != nullptr ? std::move(trail) : std::make_unique<Trail<BodyState>>();
		trail->put(p_tick, scratch.state);
		BodyUpdate &update = body_updates.emplace_back();
		update.id = scratch.id;
		update.tick = p_tick;
		restore_body(scratch.state, update);
	}
}

SnapshotDecoder::Outcome SnapshotDecoder::decode(const uint8_t *p_bytes, std::size_t p_size) {
	person_scratch.clear();
	body_scratch.clear();
	person_updates.clear();
	body_updates.clear();
	has_mark = false;
	Reader reader{ p_bytes, p_size, 0, 0, {}, false };
	int people = 0;
	Outcome outcome = read_header(reader, people);
	if (outcome == Outcome::STALE && is_astray(reader)) {
		clear();
		outcome = read_header(reader, people);
	}
	outcome = outcome == Outcome::OK ? read_people(reader, people) : outcome;
	outcome = outcome == Outcome::OK ? read_bodies(reader) : outcome;
	if (outcome == Outcome::OK &&
			people_known.size() + bodies_known.size() + person_scratch.size() + body_scratch.size() > MAX_ENTITIES) {
		outcome = Outcome::BROKEN;
	}
	if (outcome != Outcome::OK) {
		has_mark = false;
		wants_all = wants_all || outcome == Outcome::LACKS_BASELINE;
		return outcome;
	}
	strays = Kind(p_bytes[0] & KIND_MASK) == Kind::KEY ? 0 : strays;
	rate = read_rate;
	last_tick = reader.tick;
	newest_tick = newest_tick == NEVER || int32_t(reader.tick - newest_tick) > 0 ? reader.tick : newest_tick;
	has_numbers = has_numbers && !reader.follows_gap;
	note(p_bytes[1]);
	keep(reader.tick);
	return Outcome::OK;
}

bool SnapshotDecoder::write_ack(const Vec3 &p_viewpoint, std::array<uint8_t, ClientRecord::ACK_BYTES> &r_bytes) {
	if (!owes_ack && !wants_all) {
		return false;
	}
	r_bytes[0] = uint8_t(Kind::ACK);
	r_bytes[1] = uint8_t((wants_all ? ClientRecord::WANTS_ALL : 0) + (wants_marks ? ClientRecord::WANTS_MARKS : 0));
	r_bytes[2] = newest_number;
	put_number(&r_bytes[3], earlier_numbers, 8);
	const std::array<float, 3> place{ p_viewpoint.x, p_viewpoint.y, p_viewpoint.z };
	std::memcpy(&r_bytes[11], place.data(), sizeof(place));
	owes_ack = wants_all = false;
	return true;
}

} // namespace wire
