// SPDX-License-Identifier: MIT
// The part of SnapshotEncoder that is about people.
#include "replication/entry_coding.hpp"
#include "replication/snapshot_encoder.hpp"

#include <algorithm>
#include <cstring>

namespace wire {

void SnapshotEncoder::_collect_people(ClientRecord &p_client, bool p_jolts_only) {
	_people_waiting.clear();
	for (std::size_t i = 0; i < p_client.people.size(); i++) {
		const WorldHistory::Person &person = *_history.people()[i];
		Delivery &delivery = p_client.people[i];
		if (!person.is_there || !p_client.knows(person.table_version) ||
				person.history.find(_history.tick()) == nullptr) {
			continue;
		}
		const bool own = int(person.id) == p_client.own_person;
		const float weight = own || p_client.is_recorder || !p_client.has_viewpoint
				? 1.0f
				: _visibility.weight(p_client.viewpoint, person.position);
		delivery.urgency += weight;
		const bool is_due = weight >= Interest::FAR || delivery.urgency >= HIDDEN_URGENCY || delivery.sent == NEVER;
		if (p_jolts_only ? person.jolted : is_due) {
			_people_waiting.push_back({ delivery.urgency + (person.jolted ? MAX_URGENCY : 0.0f), uint16_t(i) });
		}
	}
	std::sort(_people_waiting.begin(), _people_waiting.end(),
			[](const Candidate &p_a, const Candidate &p_b) { return p_a.urgency < p_b.urgency; });
}

Baseline SnapshotEncoder::_baseline_of(const Delivery &p_delivery, bool p_has_before) const {
	Baseline base;
	const uint32_t tick = _history.tick();
	if (p_delivery.acked == NEVER || tick - p_delivery.acked > uint32_t(MAX_AGE) || p_delivery.acked >= tick) {
		return base;
	}
	base.age = int(tick - p_delivery.acked);
	if (p_has_before && p_delivery.before != NEVER) {
		const uint32_t spacing = p_delivery.acked - p_delivery.before;
		const bool fits = spacing <= uint32_t(Baseline::MAX_SPACING) && base.age + int(spacing) <= MAX_AGE;
		base.spacing = fits ? int(spacing) : 0;
	}
	return base;
}

Baseline SnapshotEncoder::_usual_baseline(const ClientRecord &p_client) const {
	// That of the most urgent: mostly all have the same.
	if (_people_waiting.empty()) {
		return {};
	}
	const Baseline base = _baseline_of(p_client.people[_people_waiting.back().index], true);
	return base.age <= Baseline::MAX_SHORT_AGE ? base : Baseline{};
}

// The states that a person is coded against: only those in the same frame are of use.
Baseline SnapshotEncoder::_person_baseline(const Delivery &p_delivery, const WorldHistory::Person &p_person) const {
	Baseline base = _baseline_of(p_delivery, true);
	const uint16_t frame = p_person.history.find(_history.tick())->frame;
	const PersonState *known = base.age > 0 ? p_person.history.find(p_delivery.acked) : nullptr;
	if (known == nullptr || known->frame != frame) {
		return {};
	}
	const PersonState *before = base.spacing > 0 ? p_person.history.find(p_delivery.before) : nullptr;
	base.spacing = before != nullptr && before->frame == frame ? base.spacing : 0;
	return base;
}

const SnapshotEncoder::EncodedPerson &SnapshotEncoder::_encode_person(
		std::size_t p_index, const Baseline &p_base, bool p_is_usual) {
	if (_encoded_people.size() <= p_index) {
		_encoded_people.resize(p_index + 1);
		_next_encoded.resize(p_index + 1, 0);
	}
	const uint32_t tick = _history.tick();
	for (const EncodedPerson &encoded : _encoded_people[p_index]) {
		if (encoded.tick == tick && encoded.base == p_base && encoded.is_usual == p_is_usual) {
			return encoded;
		}
	}
	EncodedPerson &encoded = _encoded_people[p_index][_next_encoded[p_index]++ % MAX_ENCODINGS];
	const WorldHistory::Person &person = *_history.people()[p_index];
	encoded.tick = tick;
	encoded.base = p_base;
	encoded.is_usual = p_is_usual;
	RangeEncoder encoder(encoded.bytes.data(), encoded.bytes.size());
	encode_count(encoder, person.id, 2);
	encode_baseline(encoder, p_base, p_is_usual);
	if (p_base.age == 0) {
		encode_frame(encoder, person.history.find(tick)->frame);
	}
	const PersonState *base = p_base.age > 0 ? person.history.find(tick - uint32_t(p_base.age)) : nullptr;
	const int older = p_base.age + p_base.spacing;
	const PersonState *before = p_base.spacing > 0 ? person.history.find(tick - uint32_t(older)) : nullptr;
	_codec.encode(encoder, *person.history.find(tick), base, before, p_base.age, older);
	encoded.size = encoder.finish();
	return encoded;
}

void SnapshotEncoder::_write_people(ClientRecord &p_client, Draft &p_draft, std::size_t p_room) {
	SentDatagram &entry = p_draft.entry;
	while (!_people_waiting.empty() && entry.people_count < MAX_PEOPLE) {
		const std::size_t index = _people_waiting.back().index;
		const WorldHistory::Person &person = *_history.people()[index];
		Delivery &delivery = p_client.people[index];
		const Baseline base = _person_baseline(delivery, person);
		const EncodedPerson &encoded = _encode_person(index, base, base == p_draft.usual);
		// The most urgent comes before all bodies.
		const std::size_t room = entry.people_count == 0 ? p_draft.room : p_room;
		if (encoded.size == 0 || p_draft.out.size + encoded.size > room) {
			if (encoded.size == 0) {
				_people_waiting.pop_back();
				continue;
			}
			return;
		}
		std::memcpy(&p_draft.out.bytes[p_draft.out.size], encoded.bytes.data(), encoded.size);
		p_draft.out.size += encoded.size;
		entry.people[entry.people_count++] = uint16_t(index);
		delivery.sent = _history.tick();
		delivery.is_lost = false;
		delivery.urgency = 0.0f;
		_people_waiting.pop_back();
	}
}

} // namespace wire
