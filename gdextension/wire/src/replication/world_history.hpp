// SPDX-License-Identifier: MIT
#pragma once

#include "coding/person_lattice.hpp"
#include "dead_reckoning.hpp"
#include "replication/body_state.hpp"
#include "replication/datagram.hpp"
#include "replication/entity_table.hpp"
#include "replication/world_tick.hpp"

#include <memory>
#include <unordered_map>
#include <vector>

namespace wire {

/// The states of one person or body over the last ticks.
template <typename State>
class History {
public:
	void put(uint32_t p_tick, const State &p_state) {
		_ticks[p_tick % HISTORY] = p_tick;
		_states[p_tick % HISTORY] = p_state;
	}
	/// The state at a tick, or null if it is not known (any more).
	const State *find(uint32_t p_tick) const {
		return p_tick != NEVER && _ticks[p_tick % HISTORY] == p_tick ? &_states[p_tick % HISTORY] : nullptr;
	}
	void clear() { _ticks.fill(NEVER); }

	History() { clear(); }

private:
	std::array<uint32_t, HISTORY> _ticks{};
	std::array<State, HISTORY> _states{};
};

/// What the server simulates, put on the lattice once for all clients.
class WorldHistory {
public:
	/// A jump of velocity (m/s, beyond what gravity does in a tick) that cannot wait for the next
	/// snapshot.
	static constexpr float JOLT = 2.0f;

	struct Person {
		uint16_t id = 0;
		bool is_there = false;
		bool jolted = false;
		/// Counts who has had this slot: records about an earlier one are void.
		uint32_t generation = 0;
		uint32_t table_version = 0; ///< From which on clients know of it.
		Vec3 position;
		Vec3 velocity; ///< m/s
		History<PersonState> history;
	};
	struct Body {
		uint16_t id = 0;
		bool is_there = false;
		bool jolted = false;
		uint32_t generation = 0;
		uint32_t table_version = 0;
		BodyUpdate exact; ///< As it was put.
		BodyUpdate now; ///< As receivers restore it.
		History<BodyState> history;
	};

	WorldHistory(const Skeleton &p_skeleton, const PersonLattice &p_lattice, int p_tick_rate);

	/// Begins a tick, newer than the last; then everything that is there is put.
	void begin(uint32_t p_tick);
	/// False for a pose that is none. A body that carries the person is put before.
	bool put_person(uint16_t p_id, const PersonPose &p_pose);
	void put_body(const BodyUpdate &p_body);
	/// Ends the tick: who was not put is gone.
	void end();

	/// Says which body carries a person: from the next tick on the person is sent in that body's frame. An id of 0
	/// means none, as does a body that is not there.
	void set_frame(uint16_t p_person, uint16_t p_carrier);
	EntityTable &entities() { return _entities; }
	const EntityTable &entities() const { return _entities; }
	/// Where an entity is: its body, its person, or the position that was set; null if nobody knows.
	const Vec3 *position_of(const EntityTable::Entity &p_entity) const;

	uint32_t tick() const { return _now; }
	int rate() const { return _tick_rate; }
	const Skeleton &shape() const { return _skeleton; }
	/// Slots of people and bodies; some may be empty. They never move while somebody is there.
	const std::vector<std::unique_ptr<Person>> &people() const { return _person_slots; }
	const std::vector<std::unique_ptr<Body>> &bodies() const { return _body_slots; }
	/// Whether somebody or something was jolted in this tick.
	bool has_jolts() const { return _jolts; }

private:
	template <typename Slot>
	static Slot &_find(std::vector<std::unique_ptr<Slot>> &p_slots, std::unordered_map<uint16_t, std::size_t> &p_index,
			uint16_t p_id);
	template <typename Slot>
	void _sweep(std::vector<std::unique_ptr<Slot>> &p_slots, std::unordered_map<uint16_t, std::size_t> &p_index);
	const Body *_find_body(uint16_t p_id) const;
	const Body *_carrier_of(uint16_t p_person) const;
	bool _is_jolt(const Vec3 &p_change) const;
	/// Seconds since the tick before.
	float _step() const { return float(_now - _before) / float(_tick_rate); }

	EntityTable _entities;
	std::unordered_map<uint16_t, uint16_t> _frames; // Who is carried, and by what.
	Skeleton _skeleton;
	PersonLattice _lattice;
	int _tick_rate;
	uint32_t _now = NEVER;
	uint32_t _before = NEVER; // The tick before: a slow server may have left some out.
	uint32_t _earlier = NEVER; // The one before that.
	bool _jolts = false;
	std::vector<std::unique_ptr<Person>> _person_slots;
	std::vector<std::unique_ptr<Body>> _body_slots;
	std::unordered_map<uint16_t, std::size_t> _person_index;
	std::unordered_map<uint16_t, std::size_t> _body_index;
};

} // namespace wire
