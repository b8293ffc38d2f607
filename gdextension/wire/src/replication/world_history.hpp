// SPDX-License-Identifier: MIT
#pragma once

#include "../coding/person_lattice.hpp"
#include "../dead_reckoning.hpp"
#include "body_state.hpp"
#include "datagram.hpp"

#include <memory>
#include <unordered_map>
#include <vector>

namespace wire {

/// Ticks that are not.
constexpr uint32_t NEVER = UINT32_MAX;

/// The states of one person or body over the last ticks.
template <typename State>
class Trail {
public:
	void put(uint32_t p_tick, const State &p_state) {
		ticks[p_tick % HISTORY] = p_tick;
		states[p_tick % HISTORY] = p_state;
	}
	/// The state at a tick, or null if it is not known (any more).
	const State *find(uint32_t p_tick) const {
		return p_tick != NEVER && ticks[p_tick % HISTORY] == p_tick ? &states[p_tick % HISTORY] : nullptr;
	}
	void clear() { ticks.fill(NEVER); }

	Trail() { clear(); }

private:
	std::array<uint32_t, HISTORY> ticks{};
	std::array<State, HISTORY> states{};
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
		/// Counts who has had this place: records about an earlier one are void.
		uint32_t generation = 0;
		Vec3 place;
		Vec3 velocity; ///< m/s
		Trail<PersonState> trail;
	};
	struct Body {
		uint16_t id = 0;
		bool is_there = false;
		bool jolted = false;
		uint32_t generation = 0;
		BodyUpdate now; ///< As receivers restore it.
		Trail<BodyState> trail;
	};

	WorldHistory(const Skeleton &p_skeleton, const PersonLattice &p_lattice, int p_tick_rate);

	/// Begins a tick, newer than the last; then everything that is there is put.
	void begin(uint32_t p_tick);
	/// False for a pose that is none.
	bool put_person(uint16_t p_id, const PersonPose &p_pose);
	void put_body(const BodyUpdate &p_body);
	/// Ends the tick: who was not put is gone.
	void end();

	uint32_t tick() const { return now; }
	int rate() const { return tick_rate; }
	const Skeleton &shape() const { return skeleton; }
	/// Places of people and bodies; some may be empty. They never move while somebody is there.
	const std::vector<std::unique_ptr<Person>> &people() const { return person_slots; }
	const std::vector<std::unique_ptr<Body>> &bodies() const { return body_slots; }
	/// Whether somebody or something was jolted in this tick.
	bool has_jolts() const { return jolts; }

private:
	template <typename Slot>
	static Slot &find(std::vector<std::unique_ptr<Slot>> &p_slots, std::unordered_map<uint16_t, std::size_t> &p_index,
			uint16_t p_id);
	template <typename Slot>
	void sweep(std::vector<std::unique_ptr<Slot>> &p_slots, std::unordered_map<uint16_t, std::size_t> &p_index);
	bool is_jolt(const Vec3 &p_change) const;
	/// Seconds since the tick before.
	float step() const { return float(now - before) / float(tick_rate); }

	Skeleton skeleton;
	PersonLattice lattice;
	int tick_rate;
	uint32_t now = NEVER;
	uint32_t before = NEVER; // The tick before: a slow server may have left some out.
	uint32_t earlier = NEVER; // The one before that.
	bool jolts = false;
	std::vector<std::unique_ptr<Person>> person_slots;
	std::vector<std::unique_ptr<Body>> body_slots;
	std::unordered_map<uint16_t, std::size_t> person_index;
	std::unordered_map<uint16_t, std::size_t> body_index;
};

} // namespace wire
