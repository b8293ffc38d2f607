// SPDX-License-Identifier: MIT
#include "replication/client_record.hpp"

#include <cstring>

namespace wire {

namespace {

// So many later datagrams have to arrive before one counts as lost: some overtake each other.
constexpr uint32_t OVERTAKEN = 3;
constexpr float ROUND_TRIP_MEMORY = 0.1f;
// After two round trips and this part of a second nobody waits for an acknowledgement, if the client was heard of
// within so many seconds.
constexpr uint32_t PATIENCE_PART = 4;
constexpr uint32_t HEARD_S = 2;

} // namespace

Baseline Delivery::find_baseline(uint32_t p_tick, bool p_has_before) const {
	Baseline base;
	if (acked == NEVER || p_tick - acked > uint32_t(MAX_AGE) || acked >= p_tick) {
		return base;
	}
	base.age = int(p_tick - acked);
	if (p_has_before && before != NEVER) {
		const uint32_t spacing = acked - before;
		const bool fits = spacing <= uint32_t(Baseline::MAX_SPACING) && base.age + int(spacing) <= MAX_AGE;
		base.spacing = fits ? int(spacing) : 0;
	}
	return base;
}

void Delivery::arrived(uint32_t p_tick) {
	if (acked == NEVER || p_tick > acked) {
		before = acked;
		acked = p_tick;
	} else if (p_tick < acked && (before == NEVER || p_tick > before)) {
		before = p_tick;
	}
}

void FieldDelivery::arrived(uint32_t p_tick) {
	if (acked == NEVER || p_tick > acked) {
		acked = p_tick;
		// What lies between the two is not looked up: it counts as sent.
		first_unacked = sent > acked ? acked + 1 : NEVER;
	}
}

void FieldDelivery::was_sent(uint32_t p_tick) {
	sent = p_tick;
	first_unacked = first_unacked == NEVER ? p_tick : first_unacked;
	urgency = 0.0f;
	is_lost = false;
}

FieldDelivery &ClientRecord::field_delivery(std::size_t p_index, uint32_t p_generation) {
	if (fields.size() <= p_index) {
		fields.resize(p_index + 1);
	}
	FieldDelivery &delivery = fields[p_index];
	if (delivery.generation != p_generation) {
		const bool is_pending = delivery.is_pending;
		delivery = FieldDelivery();
		delivery.generation = p_generation;
		delivery.is_pending = is_pending;
	}
	return delivery;
}

void ClientRecord::mark_fields(std::size_t p_index, uint32_t p_generation) {
	FieldDelivery &delivery = field_delivery(p_index, p_generation);
	if (!delivery.is_pending) {
		delivery.is_pending = true;
		pending_fields.push_back(uint16_t(p_index));
	}
}

void ClientRecord::follow(const WorldHistory &p_world) {
	people.resize(p_world.people().size());
	bodies.resize(p_world.bodies().size());
	for (std::size_t i = 0; i < people.size(); i++) {
		if (people[i].generation != p_world.people()[i]->generation) {
			people[i] = Delivery();
			people[i].generation = p_world.people()[i]->generation;
		}
	}
	for (std::size_t i = 0; i < bodies.size(); i++) {
		if (bodies[i].generation != p_world.bodies()[i]->generation) {
			bodies[i] = BodyDelivery();
			bodies[i].generation = p_world.bodies()[i]->generation;
		}
	}
}

SentDatagram &ClientRecord::begin_datagram(uint32_t p_tick) {
	SentDatagram &entry = _log[_next_number % KEPT];
	if (entry.is_open) {
		_note_loss(entry);
	}
	entry.tick = p_tick;
	entry.number = _next_number++;
	entry.is_open = true;
	entry.people_count = 0;
	entry.body_count = 0;
	entry.field_count = 0;
	entry.has_command_ack = false;
	return entry;
}

void ClientRecord::expire(uint32_t p_now, int p_tick_rate) {
	// Who is not heard of is not there, or lacks more than this could mend.
	if (heard_tick == NEVER || p_now - heard_tick > HEARD_S * uint32_t(p_tick_rate)) {
		return;
	}
	const uint32_t patience = uint32_t(p_tick_rate) / PATIENCE_PART + 2 * uint32_t(stats.round_trip_ticks);
	for (; _oldest_open != _next_number; _oldest_open++) {
		SentDatagram &entry = _log[_oldest_open % KEPT];
		const bool is_open = entry.is_open && entry.number == _oldest_open;
		if (is_open && p_now - entry.tick <= patience) {
			return;
		}
		if (is_open) {
			_note_loss(entry);
		}
	}
}

void ClientRecord::cancel_datagram() {
	_log[--_next_number % KEPT].is_open = false;
}

void ClientRecord::_take_viewpoint(const uint8_t *p_bytes) {
	std::array<float, 3> position{};
	std::memcpy(position.data(), p_bytes, sizeof(position));
	const Vec3 from{ position[0], position[1], position[2] };
	if (from.is_finite() && from.length() < FARTHEST_M) {
		viewpoint = from;
		has_viewpoint = true;
	}
}

bool ClientRecord::take_ack(const uint8_t *p_bytes, std::size_t p_size, uint32_t p_now, uint32_t p_newest_version) {
	if (p_size < ACK_BYTES || p_bytes[0] != uint8_t(Message::ACK) ||
			(p_bytes[1] & ~(WANTS_ALL | WANTS_MARKS | HAS_VIEWPOINT)) != 0) {
		return false;
	}
	const bool sees = (p_bytes[1] & HAS_VIEWPOINT) != 0;
	if (p_size != ACK_BYTES + (sees ? VIEWPOINT_BYTES : 0)) {
		return false;
	}
	if (sees) {
		_take_viewpoint(p_bytes + ACK_BYTES);
	}
	// Of the versions with these low bits the one nearest to the newest that there is.
	const uint16_t low = uint16_t(get_number(p_bytes + 7, 2));
	const int64_t version = int64_t(p_newest_version) + int16_t(low - uint16_t(p_newest_version));
	if (version > int64_t(table_version) && version <= int64_t(UINT32_MAX)) {
		table_version = uint32_t(version);
		reads_all_fields = true;
	}
	wants_marks = (p_bytes[1] & WANTS_MARKS) != 0;
	if ((p_bytes[1] & WANTS_ALL) != 0) {
		_forget_all();
		return true;
	}
	const uint8_t newest = p_bytes[2];
	const uint64_t earlier = get_number(p_bytes + 3, 4);
	// The oldest first: who has what is noted in the order of time.
	for (uint32_t ago = ACKED_BEFORE + 1; ago-- > 0;) {
		const uint8_t number = uint8_t(newest - ago);
		SentDatagram &entry = _log[number % KEPT];
		if (!entry.is_open || entry.number != number) {
			continue;
		}
		if (ago == 0 || ((earlier >> (ago - 1)) & 1U) != 0) {
			_note_arrival(entry, p_now);
		} else if (ago >= OVERTAKEN) {
			_note_loss(entry);
		}
	}
	return true;
}

void ClientRecord::_note_arrival(SentDatagram &p_entry, uint32_t p_now) {
	p_entry.is_open = false;
	heard_tick = p_now;
	stats.acked++;
	const float ticks = float(p_now - p_entry.tick);
	stats.round_trip_ticks +=
			(ticks - stats.round_trip_ticks) * (stats.round_trip_ticks == 0.0f ? 1.0f : ROUND_TRIP_MEMORY);
	for (std::size_t i = 0; i < p_entry.people_count; i++) {
		people[p_entry.people[i]].arrived(p_entry.tick);
	}
	for (std::size_t i = 0; i < p_entry.body_count; i++) {
		bodies[p_entry.bodies[i]].arrived(p_entry.tick);
	}
	for (std::size_t i = 0; i < p_entry.field_count; i++) {
		fields[p_entry.fields[i]].arrived(p_entry.tick);
	}
	is_command_acked = is_command_acked || (p_entry.has_command_ack && p_entry.command_ack == command);
}

void ClientRecord::_note_loss(SentDatagram &p_entry) {
	p_entry.is_open = false;
	stats.lost++;
	for (std::size_t i = 0; i < p_entry.people_count; i++) {
		Delivery &delivery = people[p_entry.people[i]];
		delivery.is_lost = delivery.is_lost || delivery.sent == p_entry.tick;
	}
	for (std::size_t i = 0; i < p_entry.body_count; i++) {
		Delivery &delivery = bodies[p_entry.bodies[i]];
		delivery.is_lost = delivery.is_lost || delivery.sent == p_entry.tick;
	}
	for (std::size_t i = 0; i < p_entry.field_count; i++) {
		FieldDelivery &delivery = fields[p_entry.fields[i]];
		if (delivery.sent == p_entry.tick) {
			delivery.is_lost = true;
			mark_fields(p_entry.fields[i], delivery.generation);
		}
	}
}

void ClientRecord::_forget_all() {
	for (Delivery &delivery : people) {
		delivery.acked = delivery.before = NEVER;
	}
	for (BodyDelivery &delivery : bodies) {
		delivery.acked = delivery.before = NEVER;
		delivery.is_lost = true;
	}
	for (FieldDelivery &delivery : fields) {
		delivery.acked = NEVER;
		delivery.is_lost = delivery.sent != NEVER;
	}
	reads_all_fields = true;
	is_command_acked = !has_command;
	for (SentDatagram &entry : _log) {
		entry.is_open = false;
	}
	heard_tick = NEVER;
}

} // namespace wire
