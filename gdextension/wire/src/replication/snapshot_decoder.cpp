// SPDX-License-Identifier: MIT
#include "replication/snapshot_decoder.hpp"

#include "replication/entry_coding.hpp"

#include <algorithm>
#include <cstring>
#include <iterator>

namespace wire {

SnapshotDecoder::SnapshotDecoder(const Skeleton &p_skeleton, double p_max_error_deg) :
		_skeleton(p_skeleton),
		_lattice(PersonLattice::resolution_for(p_max_error_deg)),
		_codec(p_skeleton, PersonLattice::resolution_for(p_max_error_deg)) {
	_person_scratch.reserve(MAX_PEOPLE);
	_body_scratch.reserve(MAX_BODIES);
	_person_updates.reserve(MAX_PEOPLE);
	_body_updates.reserve(MAX_BODIES);
}

void SnapshotDecoder::clear() {
	_people_known.clear();
	_bodies_known.clear();
	_person_updates.clear();
	_body_updates.clear();
	_has_mark = false;
	_rate = 0;
	_last_tick = _newest_tick = NEVER;
	_has_numbers = _owes_ack = _wants_all = false;
	_strays = 0;
}

bool SnapshotDecoder::_is_known(uint8_t p_number, uint32_t p_tick) const {
	if (!_has_numbers) {
		return false;
	}
	if (int32_t(p_tick - _newest_tick) < -STALE) {
		return true;
	}
	// Numbers come round: the nearer way about is the right one.
	const uint32_t ago = uint8_t(_newest_number - p_number);
	const bool is_later = ago >= 128;
	return ago == 0 || (!is_later && (ago > 64 || ((_earlier_numbers >> (ago - 1)) & 1U) != 0));
}

// Whether the newest tick must be wrong: a forgery with a tick far ahead would make all others look old.
bool SnapshotDecoder::_is_astray(const Reader &p_reader) {
	const bool is_key = Kind(p_reader.bytes[0] & KIND_MASK) == Kind::KEY;
	const bool is_old = is_key && int32_t(p_reader.tick - _newest_tick) < -STALE;
	// Only a server goes on: what is merely sent again does not count.
	if (is_old && (_strays == 0 || int32_t(p_reader.tick - _stray_tick) > 0)) {
		_strays++;
		_stray_tick = p_reader.tick;
	}
	return _strays >= MAX_STRAYS;
}

void SnapshotDecoder::_note(uint8_t p_number) {
	const uint32_t ahead = uint8_t(p_number - _newest_number);
	const uint32_t ago = uint8_t(_newest_number - p_number);
	if (!_has_numbers) {
		_newest_number = p_number;
		_earlier_numbers = 0;
	} else if (ahead > 0 && ahead < 128) {
		_earlier_numbers = ahead < 64 ? (_earlier_numbers << ahead) | (1ULL << (ahead - 1)) : 0;
		_newest_number = p_number;
	} else if (ago > 0 && ago <= 64) {
		_earlier_numbers |= 1ULL << (ago - 1);
	}
	_has_numbers = true;
	_owes_ack = true;
}

SnapshotDecoder::Outcome SnapshotDecoder::_read_header(Reader &r_reader, int &r_people) {
	const uint8_t *bytes = r_reader.bytes;
	if (r_reader.size < 4 || r_reader.size > MAX_BYTES) {
		return Outcome::BROKEN;
	}
	const Kind kind = Kind(bytes[0] & KIND_MASK);
	r_people = int(uint32_t(bytes[0]) >> 4U);
	if (kind == Kind::KEY && r_reader.size >= 8) {
		r_reader.tick = uint32_t(get_number(bytes + 2, 4));
		_read_rate = bytes[6];
		r_reader.at = 7;
	} else if (kind == Kind::SNAPSHOT) {
		if (_rate == 0) {
			return Outcome::NOT_BEGUN;
		}
		_read_rate = _rate;
		r_reader.tick = _newest_tick + uint32_t(int32_t(int8_t(bytes[2] - uint8_t(_newest_tick))));
		r_reader.at = 3;
	} else {
		return Outcome::BROKEN;
	}
	if (_read_rate == 0 || r_reader.tick == NEVER) {
		return Outcome::BROKEN;
	}
	r_reader.usual = Baseline::unpack(bytes[r_reader.at++]);
	_has_mark = (bytes[0] & HAS_MARKS) != 0;
	if (_has_mark) {
		if (r_reader.size - r_reader.at < Mark::BYTES) {
			return Outcome::BROKEN;
		}
		const uint8_t *at = bytes + r_reader.at;
		_last_mark.person = uint16_t(get_number(at, 2));
		_last_mark.sample = uint32_t(get_number(at + 2, 4));
		_last_mark.simulated_usec = int64_t(get_number(at + 6, 8));
		for (std::size_t step = 0; step < _last_mark.steps.size(); step++) {
			_last_mark.steps[step] = uint16_t(get_number(at + 14 + 2 * step, 2));
		}
		r_reader.at += Mark::BYTES;
	}
	// Numbers come round within a second or two: after a gap only a whole tick says what is new.
	r_reader.follows_gap = kind == Kind::KEY && _has_numbers && int32_t(r_reader.tick - _newest_tick) > GAP;
	return !r_reader.follows_gap && _is_known(bytes[1], r_reader.tick) ? Outcome::STALE : Outcome::OK;
}

SnapshotDecoder::Outcome SnapshotDecoder::_read_people(Reader &r_reader, int p_count) {
	for (int i = 0; i < p_count; i++) {
		const std::size_t left = r_reader.size - r_reader.at;
		RangeDecoder decoder(r_reader.bytes + r_reader.at, left);
		const uint32_t id = decode_count(decoder, 2);
		const Baseline base = decode_baseline(decoder, r_reader.usual);
		if (id > 65535 || left == 0) {
			return Outcome::BROKEN;
		}
		const auto known = _people_known.find(uint16_t(id));
		const int older = base.age + base.spacing;
		const History<PersonState> *history = known == _people_known.end() ? nullptr : known->second.get();
		const auto find = [&](int p_age) {
			return history != nullptr ? history->find(r_reader.tick - uint32_t(p_age)) : nullptr;
		};
		const PersonState *state = base.age > 0 ? find(base.age) : nullptr;
		const PersonState *before = base.age > 0 && base.spacing > 0 ? find(older) : nullptr;
		if ((base.age > 0 && state == nullptr) || (base.spacing > 0 && before == nullptr)) {
			return base.age > 0 ? Outcome::LACKS_BASELINE : Outcome::BROKEN;
		}
		PersonScratch scratch;
		scratch.id = uint16_t(id);
		if (!_codec.decode(decoder, scratch.state, state, before, base.age, older) || decoder.is_bad()) {
			return Outcome::BROKEN;
		}
		r_reader.at += decoder.used();
		_person_scratch.push_back(scratch);
	}
	return Outcome::OK;
}

SnapshotDecoder::Outcome SnapshotDecoder::_read_bodies(Reader &r_reader) {
	if (r_reader.at == r_reader.size) {
		return Outcome::OK;
	}
	RangeDecoder decoder(r_reader.bytes + r_reader.at, r_reader.size - r_reader.at);
	int64_t id = -1;
	do {
		id += 1 + int64_t(decode_count(decoder, 1));
		if (id > 65535 || decoder.is_bad() || _body_scratch.size() >= std::size_t(MAX_BODIES)) {
			return Outcome::BROKEN;
		}
		const BodyState *base = nullptr;
		int age = 0;
		if (!decoder.decode_bit(HAS_BASE)) {
			age = int(decoder.decode_bits(AGE_BITS));
			const auto known = _bodies_known.find(uint16_t(id));
			base = known == _bodies_known.end() ? nullptr : known->second->find(r_reader.tick - uint32_t(age));
			if (base == nullptr || age == 0) {
				return age == 0 || decoder.is_bad() ? Outcome::BROKEN : Outcome::LACKS_BASELINE;
			}
		}
		BodyScratch scratch;
		scratch.id = uint16_t(id);
		if (!BodyCodec::decode(decoder, base, age, _read_rate, scratch.state)) {
			return Outcome::BROKEN;
		}
		_body_scratch.push_back(scratch);
	} while (!decoder.decode_bit(GOES_ON));
	r_reader.at += decoder.used();
	return decoder.is_bad() || r_reader.at != r_reader.size ? Outcome::BROKEN : Outcome::OK;
}

void SnapshotDecoder::keep_people(const std::vector<uint16_t> &p_people) {
	for (auto known = _people_known.begin(); known != _people_known.end();) {
		const bool stays = std::find(p_people.begin(), p_people.end(), known->first) != p_people.end();
		known = stays ? std::next(known) : _people_known.erase(known);
	}
}

void SnapshotDecoder::_keep(uint32_t p_tick) {
	for (const PersonScratch &scratch : _person_scratch) {
		std::unique_ptr<History<PersonState>> &history = _people_known[scratch.id];
		history = history != nullptr ? std::move(history) : std::make_unique<History<PersonState>>();
		history->put(p_tick, scratch.state);
		PersonUpdate &update = _person_updates.emplace_back();
		update.id = scratch.id;
		update.tick = p_tick;
		_lattice.restore(scratch.state, _skeleton, update.pose);
	}
	for (const BodyScratch &scratch : _body_scratch) {
		std::unique_ptr<History<BodyState>> &history = _bodies_known[scratch.id];
		history = history != nullptr ? std::move(history) : std::make_unique<History<BodyState>>();
		history->put(p_tick, scratch.state);
		BodyUpdate &update = _body_updates.emplace_back();
		update.id = scratch.id;
		update.tick = p_tick;
		restore_body(scratch.state, update);
	}
}

SnapshotDecoder::Outcome SnapshotDecoder::decode(const uint8_t *p_bytes, std::size_t p_size) {
	_person_scratch.clear();
	_body_scratch.clear();
	_person_updates.clear();
	_body_updates.clear();
	_has_mark = false;
	Reader reader{ p_bytes, p_size, 0, 0, {}, false };
	int people = 0;
	Outcome outcome = _read_header(reader, people);
	if (outcome == Outcome::STALE && _is_astray(reader)) {
		clear();
		outcome = _read_header(reader, people);
	}
	outcome = outcome == Outcome::OK ? _read_people(reader, people) : outcome;
	outcome = outcome == Outcome::OK ? _read_bodies(reader) : outcome;
	if (outcome == Outcome::OK &&
			_people_known.size() + _bodies_known.size() + _person_scratch.size() + _body_scratch.size() >
					MAX_ENTITIES) {
		outcome = Outcome::BROKEN;
	}
	if (outcome != Outcome::OK) {
		_has_mark = false;
		_wants_all = _wants_all || outcome == Outcome::LACKS_BASELINE;
		return outcome;
	}
	_strays = Kind(p_bytes[0] & KIND_MASK) == Kind::KEY ? 0 : _strays;
	_rate = _read_rate;
	_last_tick = reader.tick;
	_newest_tick = _newest_tick == NEVER || int32_t(reader.tick - _newest_tick) > 0 ? reader.tick : _newest_tick;
	_has_numbers = _has_numbers && !reader.follows_gap;
	_note(p_bytes[1]);
	_keep(reader.tick);
	return Outcome::OK;
}

bool SnapshotDecoder::write_ack(const Vec3 &p_viewpoint, std::array<uint8_t, ClientRecord::ACK_BYTES> &r_bytes) {
	if (!_owes_ack && !_wants_all) {
		return false;
	}
	r_bytes[0] = uint8_t(Kind::ACK);
	r_bytes[1] = uint8_t((_wants_all ? ClientRecord::WANTS_ALL : 0) + (_wants_marks ? ClientRecord::WANTS_MARKS : 0));
	r_bytes[2] = _newest_number;
	put_number(&r_bytes[3], _earlier_numbers, 8);
	const std::array<float, 3> position{ p_viewpoint.x, p_viewpoint.y, p_viewpoint.z };
	std::memcpy(&r_bytes[11], position.data(), sizeof(position));
	_owes_ack = _wants_all = false;
	return true;
}

} // namespace wire
