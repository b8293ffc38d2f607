// SPDX-License-Identifier: MIT
#pragma once

#include "person_state.hpp"
#include "replication/entity_type.hpp"
#include "replication/field_history.hpp"

#include <memory>

namespace wire {

/// What entities the server has, of which types, and their fields' values.
///
/// A field that does not change costs nothing: what changes is listed once, and each client reads on from where it
/// was in that list.
class EntityTable {
public:
	struct Entity {
		uint16_t id = 0;
		bool is_there = false;
		bool is_dirty = false; ///< set() has changed it since the last commit().
		bool has_position = false;
		uint32_t generation = 0; ///< Counts who has had this slot: records about an earlier one are void.
		uint32_t table_version = 0; ///< Of the entity table, from which on clients know it.
		uint32_t first_tick = NEVER; ///< Of the commit() that it was there at first.
		const EntityType *type = nullptr;
		Vec3 position; ///< m; for interest, if it has no body.
		std::vector<uint32_t> values; ///< As they were set.
		std::vector<uint32_t> committed; ///< As they were at the last tick.
		std::unique_ptr<FieldHistory> history;
	};
	/// Changes that are remembered; a client that reads more rarely looks at all entities.
	static constexpr std::size_t MAX_CHANGES = 1U << 14U;

	EntityTable() : _index(65536, NONE), _changes(MAX_CHANGES, 0) {}

	EntityTypes &types() { return _types; }
	/// Takes an entity in, in place of another of its id. False if the type is not defined, or has another number of
	/// fields.
	bool add(uint16_t p_id, uint8_t p_type, const float *p_values, std::size_t p_count, uint32_t p_table_version);
	void remove(uint16_t p_id);
	/// Sets a field from the next tick on; false if there is none.
	bool set(uint16_t p_id, std::size_t p_field, float p_value);
	/// A field's value as receivers restore it; false if there is none.
	bool get(uint16_t p_id, std::size_t p_field, float &r_value) const;
	bool set_position(uint16_t p_id, const Vec3 &p_position);
	/// Notes what has changed since the last tick.
	void commit(uint32_t p_tick);

	const Entity *find(uint16_t p_id) const { return _index[p_id] == NONE ? nullptr : _slots[_index[p_id]].get(); }
	/// The version of the entity table from which on clients know an id; 0 if it was never added.
	uint32_t version_of(uint16_t p_id) const { return _index[p_id] == NONE ? 0 : _slots[_index[p_id]]->table_version; }
	/// Slots of entities; some may be empty.
	const std::vector<std::unique_ptr<Entity>> &slots() const { return _slots; }
	/// How many changes there have been; change() knows the last MAX_CHANGES.
	uint64_t change_count() const { return _change_count; }
	std::size_t change(uint64_t p_number) const { return _changes[p_number % MAX_CHANGES]; }
	/// The newest version of the table that an entity was added in.
	uint32_t newest_version() const { return _newest_version; }

private:
	static constexpr uint32_t NONE = UINT32_MAX;

	Entity *_find(uint16_t p_id) { return _index[p_id] == NONE ? nullptr : _slots[_index[p_id]].get(); }

	EntityTypes _types;
	std::vector<uint32_t> _index; // By id.
	std::vector<std::unique_ptr<Entity>> _slots;
	std::vector<uint32_t> _free;
	std::vector<uint32_t> _dirty;
	std::vector<uint32_t> _changes;
	uint64_t _change_count = 0;
	uint32_t _newest_version = 0;
};

} // namespace wire
