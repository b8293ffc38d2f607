// SPDX-License-Identifier: MIT
// The part of SnapshotDecoder that is about the entity table and the fields of entities.
#include "replication/entry_coding.hpp"
#include "replication/snapshot_decoder.hpp"

#include <algorithm>
#include <iterator>

namespace wire {

namespace {

// For so many ticks after an entity was removed, datagrams from before may still come.
constexpr int32_t REMOVED_FOR = 256;

} // namespace

bool SnapshotDecoder::add_entity(uint16_t p_id, uint8_t p_type, const float *p_values, std::size_t p_count) {
	const EntityType *type = _types.find(p_type);
	if (type == nullptr || type->fields.size() != p_count) {
		return false;
	}
	_sweep_removed();
	std::vector<uint32_t> spawn;
	spawn.reserve(p_count);
	for (std::size_t i = 0; i < p_count; i++) {
		spawn.push_back(type->fields[i].quantise(p_values[i]));
	}
	_known[p_id] =
			std::make_unique<Known>(Known{ type, FieldHistory(spawn), spawn, NEVER, ++_generations, false, NEVER });
	_people_known.erase(p_id);
	_bodies_known.erase(p_id);
	return true;
}

void SnapshotDecoder::remove_entity(uint16_t p_id) {
	_sweep_removed();
	Known *known = _find_known(p_id);
	if (known != nullptr) {
		known->is_removed = true;
		known->removed_tick = _newest_tick;
	}
}

void SnapshotDecoder::set_table_version(uint32_t p_version) {
	// The server is to know at once: it sends nothing of what is new before.
	_owes_ack = _owes_ack || (p_version != _table_version && _has_numbers);
	_table_version = p_version;
}

SnapshotDecoder::Known *SnapshotDecoder::_find_known(uint16_t p_id) const {
	const auto found = _known.find(p_id);
	return found == _known.end() ? nullptr : found->second.get();
}

bool SnapshotDecoder::_is_gone(uint16_t p_id) const {
	const Known *known = _find_known(p_id);
	return known != nullptr && known->is_removed;
}

bool SnapshotDecoder::has_entity(uint16_t p_id) const {
	const Known *known = _find_known(p_id);
	return known != nullptr && !known->is_removed;
}

const EntityType *SnapshotDecoder::type_of(uint16_t p_id) const {
	return has_entity(p_id) ? _find_known(p_id)->type : nullptr;
}

const uint32_t *SnapshotDecoder::newest_fields(uint16_t p_id) const {
	return has_entity(p_id) ? _find_known(p_id)->newest.data() : nullptr;
}

const uint32_t *SnapshotDecoder::spawn_fields(uint16_t p_id) const {
	return has_entity(p_id) ? _find_known(p_id)->history.spawn().data() : nullptr;
}

uint32_t SnapshotDecoder::generation_of(uint16_t p_id) const {
	return has_entity(p_id) ? _find_known(p_id)->generation : 0;
}

void SnapshotDecoder::_sweep_removed() {
	for (auto one = _known.begin(); one != _known.end();) {
		const Known &known = *one->second;
		const bool is_over = known.is_removed && int32_t(_newest_tick - known.removed_tick) > REMOVED_FOR;
		if (is_over) {
			_people_known.erase(one->first);
			_bodies_known.erase(one->first);
		}
		one = is_over ? _known.erase(one) : std::next(one);
	}
}

SnapshotDecoder::Outcome SnapshotDecoder::_read_entity(
		RangeDecoder &p_decoder, FieldCodec &r_codec, const Reader &p_reader, Known &p_known, int p_age) {
	const uint32_t *base = p_known.history.spawn().data();
	if (p_age > 0) {
		base = p_known.history.find(p_reader.tick - uint32_t(p_age));
	} else if (p_age == 0) {
		base = p_known.history.find_until(p_reader.tick - FieldHistory::MAX_AGE - 1);
	}
	if (base == nullptr) {
		return p_decoder.is_bad() ? Outcome::BROKEN : Outcome::LACKS_BASELINE;
	}
	const std::size_t begin = _field_values.size();
	_field_values.resize(begin + p_known.type->fields.size());
	return r_codec.decode(p_decoder, *p_known.type, base, _field_values.data() + begin) ? Outcome::OK : Outcome::BROKEN;
}

SnapshotDecoder::Outcome SnapshotDecoder::_read_fields(Reader &r_reader) {
	if ((r_reader.flags & HAS_FIELDS) == 0) {
		return Outcome::OK;
	}
	RangeDecoder decoder(r_reader.bytes + r_reader.at, r_reader.size - r_reader.at);
	FieldCodec codec;
	int64_t number = -1;
	int age = r_reader.usual.age > 0 ? r_reader.usual.age : -1;
	do {
		number += 1 + int64_t(decode_count(decoder, 1));
		Known *known = number > 65535 ? nullptr : _find_known(thing_id(uint16_t(number)));
		if (known == nullptr || decoder.is_bad() || _field_scratch.size() >= std::size_t(MAX_FIELD_ENTITIES)) {
			return Outcome::BROKEN;
		}
		if (decoder.decode_bit(SAME_FIELD_BASE)) {
			age = decoder.decode_bit(HAS_FIELD_BASE) ? -1 : int(decoder.decode_bits(FIELD_AGE_BITS));
		}
		const Outcome outcome = _read_entity(decoder, codec, r_reader, *known, age);
		if (outcome != Outcome::OK) {
			return outcome;
		}
		_field_scratch.push_back(thing_id(uint16_t(number)));
	} while (!decoder.decode_bit(GOES_ON));
	r_reader.at += decoder.used();
	return decoder.is_bad() ? Outcome::BROKEN : Outcome::OK;
}

void SnapshotDecoder::_keep_fields(uint32_t p_tick) {
	std::size_t at = 0;
	for (const uint16_t id : _field_scratch) {
		Known &known = *_find_known(id);
		const uint32_t *values = _field_values.data() + at;
		at += known.type->fields.size();
		known.history.put(p_tick, values);
		if (known.newest_tick == NEVER || int32_t(p_tick - known.newest_tick) > 0) {
			known.newest_tick = p_tick;
			std::copy_n(values, known.newest.size(), known.newest.begin());
		}
		if (!known.is_removed) {
			_field_updates.push_back({ p_tick, id, known.type, values });
		}
	}
}

} // namespace wire
