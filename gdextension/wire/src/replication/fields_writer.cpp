// SPDX-License-Identifier: MIT
#include "replication/fields_writer.hpp"

#include "replication/entry_coding.hpp"
#include "replication/field_codec.hpp"

#include <algorithm>

namespace wire {

namespace {

// Bytes that an entity's fields usually take at most, with the end of the coder.
constexpr std::size_t FIELDS_MARGIN = 16;
constexpr float FIELDS_SIZE_MEMORY = 0.02f;

} // namespace

// Puts what has changed since the client was last looked at on its list.
void FieldsWriter::read_changes(ClientRecord &p_client) const {
	const EntityTable &entities = _history.entities();
	const uint64_t count = entities.change_count();
	if (count - p_client.changes_read > EntityTable::MAX_CHANGES || p_client.reads_all_fields) {
		p_client.reads_all_fields = false;
		for (std::size_t i = 0; i < entities.slots().size(); i++) {
			p_client.mark_fields(i, entities.slots()[i]->generation);
		}
	} else {
		for (uint64_t number = p_client.changes_read; number < count; number++) {
			const std::size_t index = entities.change(number);
			p_client.mark_fields(index, entities.slots()[index]->generation);
		}
	}
	p_client.changes_read = count;
}

FieldsWriter::Base FieldsWriter::find_base(const FieldDelivery &p_delivery, const EntityTable::Entity &p_entity) const {
	const Base spawn{ p_entity.history->spawn().data(), -1 };
	const uint32_t tick = _history.tick();
	const uint32_t acked = p_delivery.acked;
	if (acked == NEVER || acked >= tick || acked < p_entity.first_tick) {
		return spawn;
	}
	const uint32_t *values = p_entity.history->in_force_at(acked);
	if (values == nullptr) {
		return spawn;
	}
	if (tick - acked <= FieldHistory::MAX_AGE) {
		return { values, int(tick - acked) };
	}
	// Old as it is, it is the newest that the client can have from so long ago.
	const bool is_only = p_delivery.first_unacked == NEVER || tick - p_delivery.first_unacked <= FieldHistory::MAX_AGE;
	return is_only ? Base{ values, 0 } : spawn;
}

// Whether a client does not have an entity's fields, as far as is known.
bool FieldsWriter::needs_fields(ClientRecord &p_client, std::size_t p_index) const {
	const EntityTable::Entity &entity = *_history.entities().slots()[p_index];
	if (!entity.is_there || entity.first_tick == NEVER || entity.committed.empty()) {
		return false;
	}
	const FieldDelivery &delivery = p_client.field_delivery(p_index, entity.generation);
	// What was sent last counts as on its way until it is known to be lost.
	const uint32_t newest = delivery.first_unacked != NEVER ? delivery.sent : delivery.acked;
	const uint32_t *known = newest == NEVER || newest < entity.first_tick ? entity.history->spawn().data()
																		  : entity.history->in_force_at(newest);
	return delivery.is_lost || known == nullptr || !std::equal(entity.committed.begin(), entity.committed.end(), known);
}

void FieldsWriter::collect(ClientRecord &p_client) {
	_waiting.clear();
	read_changes(p_client);
	std::size_t kept = 0;
	for (const uint16_t index : p_client.pending_fields) {
		const EntityTable::Entity &entity = *_history.entities().slots()[index];
		FieldDelivery &delivery = p_client.field_delivery(index, entity.generation);
		// A new version of the table makes the client look at all that it does not know yet.
		if (!p_client.knows(entity.table_version) || !needs_fields(p_client, index)) {
			delivery.is_pending = false;
			continue;
		}
		p_client.pending_fields[kept++] = index;
		const Vec3 *position = _history.position_of(entity);
		const bool is_own = int(entity.id) == p_client.own_person;
		const bool is_plain = position == nullptr || is_own || p_client.is_recorder || !p_client.has_viewpoint;
		const float weight = is_plain ? 1.0f : _interest.weight(p_client.viewpoint, *position);
		delivery.urgency = std::min(delivery.urgency + weight, MAX_URGENCY);
		if (weight >= Interest::FAR || delivery.urgency >= HIDDEN_URGENCY) {
			_waiting.add(delivery.urgency + (delivery.is_lost ? MAX_URGENCY : 0.0f), index);
		}
	}
	p_client.pending_fields.resize(kept);
}

// Takes the most urgent entities that are likely to fit out of those that wait, in the order of their numbers.
void FieldsWriter::choose(std::size_t p_room) {
	const std::size_t most = std::min(std::size_t(float(p_room) / _bytes_each), std::size_t(MAX_FIELD_ENTITIES));
	const std::size_t count = std::min(std::max<std::size_t>(most, 1), _waiting.size());
	_waiting.take(count, _chosen);
	const auto &slots = _history.entities().slots();
	std::sort(_chosen.begin(), _chosen.end(),
			[&](uint16_t p_a, uint16_t p_b) { return thing_number(slots[p_a]->id) < thing_number(slots[p_b]->id); });
}

void FieldsWriter::write(ClientRecord &p_client, Draft &p_draft) {
	Datagram &out = p_draft.out;
	if (_waiting.is_empty() || out.size + FIELDS_MARGIN > p_draft.room) {
		return;
	}
	choose(p_draft.room - out.size - FIELDS_MARGIN);
	const std::size_t begin = out.size;
	RangeEncoder encoder(&out.bytes[begin], MAX_BYTES - begin);
	FieldCodec codec;
	int last_number = -1;
	int last_age = p_draft.usual.age > 0 ? p_draft.usual.age : -1;
	for (const uint16_t index : _chosen) {
		const EntityTable::Entity &entity = *_history.entities().slots()[index];
		FieldDelivery &delivery = p_client.field_delivery(index, entity.generation);
		const std::size_t now = begin + encoder.written();
		if (now + FIELDS_MARGIN > p_draft.room ||
				now + FieldCodec::max_bytes(entity.committed.size()) + FIELDS_MARGIN > MAX_BYTES) {
			_waiting.add(delivery.urgency, index);
			continue;
		}
		const Base base = find_base(delivery, entity);
		if (last_number >= 0) {
			encoder.encode_bit(false, GOES_ON);
		}
		encode_count(encoder, uint32_t(int(thing_number(entity.id)) - last_number - 1), 1);
		encoder.encode_bit(base.age != last_age, SAME_FIELD_BASE);
		if (base.age != last_age) {
			encoder.encode_bit(base.age < 0, HAS_FIELD_BASE);
			if (base.age >= 0) {
				encoder.encode_bits(uint32_t(base.age), FIELD_AGE_BITS);
			}
		}
		codec.encode(encoder, *entity.type, base.values, entity.committed.data());
		last_number = int(thing_number(entity.id));
		last_age = base.age;
		p_draft.entry.fields[p_draft.entry.field_count++] = index;
		delivery.was_sent(_history.tick());
	}
	if (p_draft.entry.field_count == 0) {
		return;
	}
	encoder.encode_bit(true, GOES_ON);
	const std::size_t size = encoder.finish();
	const float each = float(size) / float(p_draft.entry.field_count);
	_bytes_each += (each - _bytes_each) * FIELDS_SIZE_MEMORY;
	out.size += size;
	p_draft.flags |= HAS_FIELDS;
}

} // namespace wire
