// SPDX-License-Identifier: MIT
#include "replication/people_writer.hpp"

#include "replication/entry_coding.hpp"

#include <algorithm>
#include <cstring>

namespace wire {

void PeopleWriter::collect(ClientRecord &p_client, bool p_jolts_only) {
	_waiting.clear();
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
				: _interest.weight(p_client.viewpoint, person.position);
		delivery.urgency += weight;
		const bool is_due = weight >= Interest::FAR || delivery.urgency >= HIDDEN_URGENCY || delivery.sent == NEVER;
		if (p_jolts_only ? person.jolted : is_due) {
			_waiting.add(delivery.urgency + (person.jolted ? MAX_URGENCY : 0.0f), i);
		}
	}
	_waiting.sort();
}

Baseline PeopleWriter::find_usual(const ClientRecord &p_client) const {
	// That of the most urgent: mostly all have the same.
	if (_waiting.is_empty()) {
		return {};
	}
	const Baseline base = p_client.people[_waiting.last()].find_baseline(_history.tick(), true);
	return base.age <= Baseline::MAX_SHORT_AGE ? base : Baseline{};
}

// The states that a person is coded against: only those in the same frame are of use.
Baseline PeopleWriter::find_baseline(const Delivery &p_delivery, const WorldHistory::Person &p_person) const {
	Baseline base = p_delivery.find_baseline(_history.tick(), true);
	const uint16_t frame = p_person.history.find(_history.tick())->frame;
	const PersonState *known = base.age > 0 ? p_person.history.find(p_delivery.acked) : nullptr;
	if (known == nullptr || known->frame != frame) {
		return {};
	}
	const PersonState *before = base.spacing > 0 ? p_person.history.find(p_delivery.before) : nullptr;
	base.spacing = before != nullptr && before->frame == frame ? base.spacing : 0;
	return base;
}

const PeopleWriter::Encoded &PeopleWriter::encode(std::size_t p_index, const Baseline &p_base, bool p_is_usual) {
	if (_encoded.size() <= p_index) {
		_encoded.resize(p_index + 1);
		_next_encoded.resize(p_index + 1, 0);
	}
	const uint32_t tick = _history.tick();
	for (const Encoded &encoded : _encoded[p_index]) {
		if (encoded.tick == tick && encoded.base == p_base && encoded.is_usual == p_is_usual) {
			return encoded;
		}
	}
	Encoded &encoded = _encoded[p_index][_next_encoded[p_index]++ % MAX_ENCODINGS];
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

void PeopleWriter::write(ClientRecord &p_client, Draft &p_draft, std::size_t p_room) {
	SentDatagram &entry = p_draft.entry;
	while (!_waiting.is_empty() && entry.people_count < MAX_PEOPLE) {
		const std::size_t index = _waiting.last();
		const WorldHistory::Person &person = *_history.people()[index];
		Delivery &delivery = p_client.people[index];
		const Baseline base = find_baseline(delivery, person);
		const Encoded &encoded = encode(index, base, base == p_draft.usual);
		// The most urgent comes before all bodies.
		const std::size_t room = entry.people_count == 0 ? p_draft.room : p_room;
		if (encoded.size == 0 || p_draft.out.size + encoded.size > room) {
			if (encoded.size == 0) {
				_waiting.remove_last();
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
		_waiting.remove_last();
	}
}

} // namespace wire
