// SPDX-License-Identifier: MIT
#include "world_history.hpp"

#include <cmath>

namespace wire {

WorldHistory::WorldHistory(const Skeleton &p_skeleton, const PersonLattice &p_lattice, int p_tick_rate) :
		skeleton(p_skeleton), lattice(p_lattice), tick_rate(p_tick_rate) {}

template <typename Slot>
Slot &WorldHistory::find(std::vector<std::unique_ptr<Slot>> &p_slots,
		std::unordered_map<uint16_t, std::size_t> &p_index, uint16_t p_id) {
	const auto known = p_index.find(p_id);
	if (known != p_index.end()) {
		return *p_slots[known->second];
	}
	std::size_t place = 0;
	while (place < p_slots.size() && p_slots[place]->is_there) {
		place++;
	}
	if (place == p_slots.size()) {
		p_slots.push_back(std::make_unique<Slot>());
	}
	Slot &slot = *p_slots[place];
	slot.id = p_id;
	slot.is_there = true;
	slot.jolted = false;
	slot.generation++;
	slot.trail.clear();
	p_index[p_id] = place;
	return slot;
}

void WorldHistory::begin(uint32_t p_tick) {
	earlier = before;
	before = now;
	now = p_tick;
	jolts = false;
}

bool WorldHistory::is_jolt(const Vec3 &p_change) const {
	const Vec3 expected{ 0.0f, -9.81f * step(), 0.0f };
	return (p_change - expected).length() > JOLT && p_change.length() > JOLT;
}

bool WorldHistory::put_person(uint16_t p_id, const PersonPose &p_pose) {
	Person &person = find(person_slots, person_index, p_id);
	const PersonState *last = person.trail.find(before);
	PersonState state;
	if (!lattice.quantise(p_pose, skeleton, last, state)) {
		return false;
	}
	const Vec3 velocity = last != nullptr ? (p_pose.root - person.place) * (1.0f / step()) : Vec3{};
	// One tick's velocity says nothing yet.
	person.jolted = last != nullptr && person.trail.find(earlier) != nullptr && is_jolt(velocity - person.velocity);
	person.place = p_pose.root;
	person.velocity = velocity;
	person.trail.put(now, state);
	jolts = jolts || person.jolted;
	return true;
}

void WorldHistory::put_body(const BodyUpdate &p_body) {
	Body &body = find(body_slots, body_index, p_body.id);
	const bool is_new = body.trail.find(before) == nullptr;
	const Vec3 velocity = body.now.velocity;
	const BodyState state = quantise_body(p_body);
	restore_body(state, body.now);
	body.now.id = p_body.id;
	body.now.tick = now;
	body.jolted = !is_new && is_jolt(body.now.velocity - velocity);
	body.trail.put(now, state);
	jolts = jolts || body.jolted;
}

template <typename Slot>
void WorldHistory::sweep(
		std::vector<std::unique_ptr<Slot>> &p_slots, std::unordered_map<uint16_t, std::size_t> &p_index) {
	for (const std::unique_ptr<Slot> &slot : p_slots) {
		if (slot->is_there && slot->trail.find(now) == nullptr) {
			slot->is_there = false;
			p_index.erase(slot->id);
		}
	}
}

void WorldHistory::end() {
	sweep(person_slots, person_index);
	sweep(body_slots, body_index);
}

} // namespace wire
