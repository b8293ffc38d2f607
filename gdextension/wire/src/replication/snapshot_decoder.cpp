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
	_field_scratch.reserve(MAX_FIELD_ENTITIES);
	_field_updates.reserve(MAX_FIELD_ENTITIES);
	_field_values.reserve(MAX_FIELD_ENTITIES * MAX_FIELDS);
}

void SnapshotDecoder::clear() {
	_known.clear();
	_types = EntityTypes();
	_table_version = 0;
	_forget_snapshots();
}

// Forgets what snapshots have said, but not what the entity table says.
void SnapshotDecoder::_forget_snapshots() {
	for (auto &[id, known] : _known) {
		known->newest = known->history.spawn();
		known->newest_tick = NEVER;
		known->history = FieldHistory(known->history.spawn());
		known->is_removed = false;
	}
	_field_updates.clear();
	_command_ack = -1;
	_viewpoint_tick = NEVER;
	_unacknowledged = 0;
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
	const bool is_old = p_reader.is_key && int32_t(p_reader.tick - _newest_tick) < -STALE;
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
	_unacknowledged++;
}

// Message, flags, number of people and of the datagram, tick, usual baseline; false for what no encoder writes.
bool SnapshotDecoder::_read_begin(Reader &r_reader) {
	const uint8_t *bytes = r_reader.bytes;
	const Message message = r_reader.size > 0 ? Message(bytes[0]) : Message::ACK;
	r_reader.is_key = message == Message::KEY;
	const bool is_short = message == Message::SNAPSHOT_OF_ONE;
	if (!r_reader.is_key && !is_short && message != Message::SNAPSHOT) {
		return false;
	}
	r_reader.at = is_short ? 1 : 3;
	if (r_reader.size > MAX_BYTES || r_reader.size < r_reader.at + (r_reader.is_key ? 7 : 3)) {
		return false;
	}
	r_reader.flags = is_short ? uint8_t(0) : bytes[1];
	r_reader.people = is_short ? 1 : int(bytes[2]);
	r_reader.number = bytes[r_reader.at++];
	return (r_reader.flags & ~ALL_FLAGS) == 0 && r_reader.people <= MAX_PEOPLE;
}

bool SnapshotDecoder::_find_extras(Reader &r_reader) {
	const auto find = [&r_reader](uint8_t p_flag, std::size_t p_size, const uint8_t *&r_found) {
		if ((r_reader.flags & p_flag) == 0) {
			return true;
		}
		if (r_reader.size - r_reader.at < p_size) {
			return false;
		}
		r_found = r_reader.bytes + r_reader.at;
		r_reader.at += p_size;
		return true;
	};
	return find(HAS_MARK, Mark::BYTES, r_reader.mark) && find(HAS_COMMAND_ACK, 2, r_reader.command_bytes) &&
			find(HAS_MOTION_ACK, MOTION_ACK_BYTES, r_reader.motion_ack);
}

bool SnapshotDecoder::_read_extras(Reader &r_reader) {
	_has_mark = (r_reader.flags & HAS_MARK) != 0;
	if (!_find_extras(r_reader)) {
		return false;
	}
	if (_has_mark) {
		const uint8_t *at = r_reader.mark;
		_last_mark.person = uint16_t(get_number(at, 2));
		_last_mark.sample = uint32_t(get_number(at + 2, 4));
		_last_mark.simulated_usec = int64_t(get_number(at + 6, 8));
		for (std::size_t step = 0; step < _last_mark.steps.size(); step++) {
			_last_mark.steps[step] = uint16_t(get_number(at + 14 + 2 * step, 2));
		}
	}
	if (r_reader.command_bytes != nullptr) {
		r_reader.command_ack = int(get_number(r_reader.command_bytes, 2));
	}
	return true;
}

const uint8_t *SnapshotDecoder::find_motion_ack(const uint8_t *p_bytes, std::size_t p_size) {
	Reader reader;
	reader.bytes = p_bytes;
	reader.size = p_size;
	if (!_read_begin(reader) || (reader.flags & HAS_MOTION_ACK) == 0) {
		return nullptr;
	}
	reader.at += reader.is_key ? 6 : 2; // Tick and usual baseline.
	return reader.at <= p_size && _find_extras(reader) ? reader.motion_ack : nullptr;
}

SnapshotDecoder::Outcome SnapshotDecoder::_read_header(Reader &r_reader) {
	const uint8_t *bytes = r_reader.bytes;
	if (!_read_begin(r_reader)) {
		return Outcome::BROKEN;
	}
	if (r_reader.is_key) {
		r_reader.tick = uint32_t(get_number(bytes + r_reader.at, 4));
		_read_rate = bytes[r_reader.at + 4];
		r_reader.at += 5;
	} else {
		if (_rate == 0) {
			return Outcome::NOT_BEGUN;
		}
		_read_rate = _rate;
		r_reader.tick = _newest_tick + uint32_t(int32_t(int8_t(bytes[r_reader.at++] - uint8_t(_newest_tick))));
	}
	if (_read_rate == 0 || r_reader.tick == NEVER) {
		return Outcome::BROKEN;
	}
	r_reader.usual = Baseline::unpack(bytes[r_reader.at++]);
	if (!_read_extras(r_reader)) {
		return Outcome::BROKEN;
	}
	// Numbers come round within a second or two: after a gap only a whole tick says what is new.
	r_reader.follows_gap = r_reader.is_key && _has_numbers && int32_t(r_reader.tick - _newest_tick) > GAP;
	return !r_reader.follows_gap && _is_known(r_reader.number, r_reader.tick) ? Outcome::STALE : Outcome::OK;
}

SnapshotDecoder::Outcome SnapshotDecoder::_read_people(Reader &r_reader) {
	for (int i = 0; i < r_reader.people; i++) {
		const std::size_t left = r_reader.size - r_reader.at;
		RangeDecoder decoder(r_reader.bytes + r_reader.at, left);
		const uint32_t id = decode_count(decoder, 2);
		const Baseline base = decode_baseline(decoder, r_reader.usual);
		if (id > 65535 || left == 0 || !_may_be_sent(uint16_t(id))) {
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
		const uint16_t frame = state != nullptr ? state->frame : decode_frame(decoder);
		const bool is_sound = before == nullptr || before->frame == frame;
		if (!is_sound || !_codec.decode(decoder, scratch.state, state, before, base.age, older) || decoder.is_bad()) {
			return Outcome::BROKEN;
		}
		scratch.state.frame = frame;
		r_reader.at += decoder.used();
		_person_scratch.push_back(scratch);
	}
	return Outcome::OK;
}

SnapshotDecoder::Outcome SnapshotDecoder::_read_bodies(Reader &r_reader) {
	if ((r_reader.flags & HAS_BODIES) == 0) {
		return Outcome::OK;
	}
	RangeDecoder decoder(r_reader.bytes + r_reader.at, r_reader.size - r_reader.at);
	int64_t number = -1;
	do {
		number += 1 + int64_t(decode_count(decoder, 1));
		const uint16_t id = thing_id(uint16_t(number));
		if (number > 65535 || decoder.is_bad() || _body_scratch.size() >= std::size_t(MAX_BODIES) ||
				!_may_be_sent(id)) {
			return Outcome::BROKEN;
		}
		const BodyState *base = nullptr;
		int age = 0;
		if (!decoder.decode_bit(HAS_BASE)) {
			age = int(decoder.decode_bits(AGE_BITS));
			const auto known = _bodies_known.find(id);
			base = known == _bodies_known.end() ? nullptr : known->second->find(r_reader.tick - uint32_t(age));
			if (base == nullptr || age == 0) {
				return age == 0 || decoder.is_bad() ? Outcome::BROKEN : Outcome::LACKS_BASELINE;
			}
		}
		BodyScratch scratch;
		scratch.id = id;
		if (!BodyCodec::decode(decoder, base, age, _read_rate, scratch.state)) {
			return Outcome::BROKEN;
		}
		_body_scratch.push_back(scratch);
	} while (!decoder.decode_bit(GOES_ON));
	r_reader.at += decoder.used();
	return decoder.is_bad() ? Outcome::BROKEN : Outcome::OK;
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
		if (_is_gone(scratch.id)) {
			continue;
		}
		PersonUpdate &update = _person_updates.emplace_back();
		update.id = scratch.id;
		update.tick = p_tick;
		update.frame = scratch.state.frame;
		_lattice.restore(scratch.state, _skeleton, update.pose);
	}
	for (const BodyScratch &scratch : _body_scratch) {
		std::unique_ptr<History<BodyState>> &history = _bodies_known[scratch.id];
		history = history != nullptr ? std::move(history) : std::make_unique<History<BodyState>>();
		history->put(p_tick, scratch.state);
		if (_is_gone(scratch.id)) {
			continue;
		}
		BodyUpdate &update = _body_updates.emplace_back();
		update.id = scratch.id;
		update.tick = p_tick;
		restore_body(scratch.state, update);
	}
}

SnapshotDecoder::Outcome SnapshotDecoder::decode(const uint8_t *p_bytes, std::size_t p_size) {
	_person_scratch.clear();
	_body_scratch.clear();
	_field_scratch.clear();
	_field_values.clear();
	_person_updates.clear();
	_body_updates.clear();
	_field_updates.clear();
	_has_mark = false;
	Reader reader;
	reader.bytes = p_bytes;
	reader.size = p_size;
	Outcome outcome = _read_header(reader);
	if (outcome == Outcome::STALE && _is_astray(reader)) {
		_forget_snapshots();
		outcome = _read_header(reader);
	}
	outcome = outcome == Outcome::OK ? _read_people(reader) : outcome;
	outcome = outcome == Outcome::OK ? _read_bodies(reader) : outcome;
	outcome = outcome == Outcome::OK ? _read_fields(reader) : outcome;
	outcome = outcome == Outcome::OK && reader.at != reader.size ? Outcome::BROKEN : outcome;
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
	_strays = reader.is_key ? 0 : _strays;
	_rate = _read_rate;
	_last_tick = reader.tick;
	_newest_tick = _newest_tick == NEVER || int32_t(reader.tick - _newest_tick) > 0 ? reader.tick : _newest_tick;
	_has_numbers = _has_numbers && !reader.follows_gap;
	_note(reader.number);
	_keep(reader.tick);
	_keep_fields(reader.tick);
	if (reader.command_ack >= 0 && reader.tick == _newest_tick) {
		_command_ack = reader.command_ack;
	}
	return Outcome::OK;
}

std::size_t SnapshotDecoder::write_ack(const Vec3 &p_viewpoint, Ack &r_bytes) {
	if (!_owes_ack && !_wants_all) {
		return 0;
	}
	const bool is_moved = !((p_viewpoint - _sent_viewpoint).length() < VIEWPOINT_STEP_M);
	const bool is_due = _viewpoint_tick == NEVER || int32_t(_newest_tick - _viewpoint_tick) >= _rate;
	const bool sees = p_viewpoint.is_finite() && (is_moved || is_due);
	r_bytes[0] = uint8_t(Message::ACK);
	r_bytes[1] = uint8_t((_wants_all ? ClientRecord::WANTS_ALL : 0) + (_wants_marks ? ClientRecord::WANTS_MARKS : 0) +
			(sees ? ClientRecord::HAS_VIEWPOINT : 0));
	r_bytes[2] = _newest_number;
	put_number(&r_bytes[3], _earlier_numbers, 4);
	put_number(&r_bytes[7], _table_version, 2);
	if (sees) {
		const std::array<float, 3> position{ p_viewpoint.x, p_viewpoint.y, p_viewpoint.z };
		std::memcpy(&r_bytes[ClientRecord::ACK_BYTES], position.data(), sizeof(position));
		_sent_viewpoint = p_viewpoint;
		_viewpoint_tick = _newest_tick;
	}
	_owes_ack = _wants_all = false;
	_unacknowledged = 0;
	return ClientRecord::ACK_BYTES + (sees ? ClientRecord::VIEWPOINT_BYTES : 0);
}

} // namespace wire
