// SPDX-License-Identifier: MIT
#pragma once

#include "replication/draft.hpp"
#include "replication/interest.hpp"

#include <algorithm>
#include <vector>

namespace wire {

/// Chooses which entities' fields a client gets in its datagrams of a tick, and writes them: those that have changed
/// since what it is known to have.
class FieldsWriter {
public:
	/// Keeps references.
	FieldsWriter(const WorldHistory &p_history, const Interest &p_interest) :
			_history(p_history), _interest(p_interest) {}

	/// Begins a client's tick.
	void collect(ClientRecord &p_client);
	/// Begins one in which it gets none.
	void collect_nothing() { _waiting.clear(); }
	bool is_waiting() const { return !_waiting.is_empty(); }
	/// About how many bytes all that wait take.
	double expected_bytes() const { return double(_bytes_each) * double(_waiting.size()); }
	/// Writes the most urgent.
	void write(ClientRecord &p_client, Draft &p_draft);

private:
	// What an entity's fields are coded against.
	struct Base {
		const uint32_t *values;
		int age; // Ticks; 0: the client's newest that is older than FieldHistory::MAX_AGE; -1: as it was spawned.
	};

	void read_changes(ClientRecord &p_client) const;
	bool needs_fields(ClientRecord &p_client, std::size_t p_index) const;
	Base find_base(const FieldDelivery &p_delivery, const EntityTable::Entity &p_entity) const;
	void choose(std::size_t p_room);

	const WorldHistory &_history;
	const Interest &_interest;
	WaitingList _waiting;
	std::vector<uint16_t> _chosen;
	float _bytes_each = 4.0f;
};

} // namespace wire
