// SPDX-License-Identifier: MIT
#include "replication/client_record.hpp"

#include <cstring>

namespace wire {

namespace {

// So many later datagrams have to arrive before one counts as lost: some overtake each other.
constexpr uint32_t OVERTAKEN = 3;
constexpr float ROUND_TRIP_MEMORY = 0.1f;

} // namespace

void Delivery::arrived(uint32_t p_tick) {
	if (acked == NEVER || p_tick > acked) {
		before = acked;
		acked = p_tick;
	} else if (p_tick < acked && (before == NEVER || p_tick > before)) {
		before = p_tick;
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
	return entry;
}

void ClientRecord::cancel_datagram() {
	_log[--_next_number % KEPT].is_open = false;
}

bool ClientRecord::take_ack(const uint8_t *p_bytes, std::size_t p_size, uint32_t p_now) {
	if (p_size != ACK_BYTES || p_bytes[0] != uint8_t(Kind::ACK)) {
		return false;
	}
	std::array<float, 3> position{};
	std::memcpy(position.data(), p_bytes + 11, sizeof(position));
	const Vec3 from{ position[0], position[1], position[2] };
	if (from.is_finite() && from.length() < FARTHEST_M) {
		viewpoint = from;
		has_viewpoint = true;
	}
	wants_marks = (p_bytes[1] & WANTS_MARKS) != 0;
	if ((p_bytes[1] & WANTS_ALL) != 0) {
		_forget_all();
		return true;
	}
	const uint8_t newest = p_bytes[2];
	const uint64_t earlier = get_number(p_bytes + 3, 8);
	// The oldest first: who has what is noted in the order of time.
	for (uint32_t ago = 65; ago-- > 0;) {
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
}

void ClientRecord::_forget_all() {
	for (Delivery &delivery : people) {
		delivery.acked = delivery.before = NEVER;
	}
	for (BodyDelivery &delivery : bodies) {
		delivery.acked = delivery.before = NEVER;
		delivery.is_lost = true;
	}
	for (SentDatagram &entry : _log) {
		entry.is_open = false;
	}
	heard_tick = NEVER;
}

} // namespace wire
