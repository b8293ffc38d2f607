// SPDX-License-Identifier: MIT
#include "replication/world_history.hpp"

#include <cmath>

namespace wire {

WorldHistory::WorldHistory(const Skeleton &p_skeleton, const PersonLattice &p_lattice, int p_tick_rate) :
		_skeleton(p_skeleton), _lattice(p_lattice), _tick_rate(p_tick_rate) {}

template <typename Slot>
Slot &WorldHistory::_find(std::vector<std::unique_ptr<Slot>> &p_slots,
		std::unordered_map<uint16_t, std::size_t> &p_index, uint16_t p_id) {
	const auto known = p_index.find(p_id);
	if (known != p_index.end()) {
		return *p_slots[known->second];
	}
	std::size_t index = 0;
	while (index < p_slots.size() && p_slots[index]->is_there) {
		index++;
	}
	if (index == p_slots.size()) {
		p_slots.push_back(std::make_unique<Slot>());
	}
	Slot &slot = *p_slots[index];
	slot.id = p_id;
	slot.is_there = true;
	slot.jolted = false;
	slot.generation++;
	slot.history.clear();
	p_index[p_id] = index;
	return slot;
}

void WorldHistory::begin(uint32_t p_tick) {
	_earlier = _before;
	_before = _now;
	_now = p_tick;
	_jolts = false;
}

bool WorldHistory::_is_jolt(const Vec3 &p_change) const {
	const Vec3 expected{ 0.0f, -9.81f * _step(), 0.0f };
	return (p_change - expected).length() > JOLT && p_change.length() > JOLT;
}

bool WorldHistory::put_person(uint16_t p_id, const PersonPose &p_pose) {
	Person &person = _find(_person_slots, _person_index, p_id);
	const PersonState *last = person.history.find(_before);
	PersonState state;
	const Body *carrier = _carrier_of(p_id);
	const PersonPose *pose = &p_pose;
	PersonPose carried;
	if (carrier != nullptr) {
		carried = p_pose;
		const Quat back = carrier->exact.orientation.inverse();
		carried.root = back.rotate(p_pose.root - carrier->exact.position);
		for (std::size_t i = 0; i < std::size_t(_skeleton.limb_count); i++) {
			carried.orientations[i] = back * p_pose.orientations[i];
		}
		pose = &carried;
	}
	if (!_lattice.quantise(*pose, _skeleton, last, state)) {
		return false;
	}
	state.frame = carrier != nullptr ? carrier->exact.id : 0;
	person.table_version = _entities.version_of(p_id);
	const Vec3 velocity = last != nullptr ? (p_pose.root - person.position) * (1.0f / _step()) : Vec3{};
	// One tick's velocity says nothing yet.
	person.jolted = last != nullptr && person.history.find(_earlier) != nullptr && _is_jolt(velocity - person.velocity);
	person.position = p_pose.root;
	person.velocity = velocity;
	person.history.put(_now, state);
	_jolts = _jolts || person.jolted;
	return true;
}

void WorldHistory::set_frame(uint16_t p_person, uint16_t p_carrier) {
	if (p_carrier == 0) {
		_frames.erase(p_person);
	} else {
		_frames[p_person] = p_carrier;
	}
}

const WorldHistory::Body *WorldHistory::_find_body(uint16_t p_id) const {
	const auto found = _body_index.find(p_id);
	return found != _body_index.end() ? _body_slots[found->second].get() : nullptr;
}

// The body that carries a person, if it was put in this tick.
const WorldHistory::Body *WorldHistory::_carrier_of(uint16_t p_person) const {
	const auto frame = _frames.find(p_person);
	const Body *body = frame != _frames.end() ? _find_body(frame->second) : nullptr;
	return body != nullptr && body->history.find(_now) != nullptr ? body : nullptr;
}

const Vec3 *WorldHistory::position_of(const EntityTable::Entity &p_entity) const {
	const Body *body = _find_body(p_entity.id);
	if (body != nullptr) {
		return &body->now.position;
	}
	const auto person = _person_index.find(p_entity.id);
	if (person != _person_index.end()) {
		return &_person_slots[person->second]->position;
	}
	return p_entity.has_position ? &p_entity.position : nullptr;
}

void WorldHistory::put_body(const BodyUpdate &p_body) {
	Body &body = _find(_body_slots, _body_index, p_body.id);
	const bool is_new = body.history.find(_before) == nullptr;
	const Vec3 velocity = body.now.velocity;
	const BodyState state = quantise_body(p_body);
	restore_body(state, body.now);
	body.exact = p_body;
	body.exact.orientation = p_body.orientation.normalized();
	body.table_version = _entities.version_of(p_body.id);
	body.now.id = p_body.id;
	body.now.tick = _now;
	body.jolted = !is_new && _is_jolt(body.now.velocity - velocity);
	body.history.put(_now, state);
	_jolts = _jolts || body.jolted;
}

template <typename Slot>
void WorldHistory::_sweep(
		std::vector<std::unique_ptr<Slot>> &p_slots, std::unordered_map<uint16_t, std::size_t> &p_index) {
	for (const std::unique_ptr<Slot> &slot : p_slots) {
		if (slot->is_there && slot->history.find(_now) == nullptr) {
			slot->is_there = false;
			p_index.erase(slot->id);
		}
	}
}

void WorldHistory::end() {
	_sweep(_person_slots, _person_index);
	_sweep(_body_slots, _body_index);
	_entities.commit(_now);
}

} // namespace wire
