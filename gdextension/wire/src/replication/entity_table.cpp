// SPDX-License-Identifier: MIT
#include "replication/entity_table.hpp"

namespace wire {

bool EntityTable::add(
		uint16_t p_id, uint8_t p_type, const float *p_values, std::size_t p_count, uint32_t p_table_version) {
	const EntityType *type = _types.find(p_type);
	if (type == nullptr || type->fields.size() != p_count) {
		return false;
	}
	remove(p_id);
	if (_free.empty()) {
		_free.push_back(uint32_t(_slots.size()));
		_slots.push_back(std::make_unique<Entity>());
	}
	const uint32_t index = _free.back();
	_free.pop_back();
	const uint32_t generation = _slots[index]->generation + 1;
	Entity &entity = *_slots[index];
	entity = Entity();
	entity.id = p_id;
	entity.is_there = true;
	entity.generation = generation;
	entity.table_version = p_table_version;
	entity.type = type;
	for (std::size_t i = 0; i < p_count; i++) {
		entity.values.push_back(type->fields[i].quantise(p_values[i]));
	}
	entity.committed = entity.values;
	entity.history = std::make_unique<FieldHistory>(entity.values);
	// The first commit gives it its first tick.
	entity.is_dirty = true;
	_dirty.push_back(index);
	_index[p_id] = index;
	_newest_version = p_table_version > _newest_version ? p_table_version : _newest_version;
	return true;
}

void EntityTable::remove(uint16_t p_id) {
	if (_index[p_id] != NONE) {
		_slots[_index[p_id]]->is_there = false;
		_free.push_back(_index[p_id]);
		_index[p_id] = NONE;
	}
}

bool EntityTable::set(uint16_t p_id, std::size_t p_field, float p_value) {
	Entity *entity = _find(p_id);
	if (entity == nullptr || p_field >= entity->values.size()) {
		return false;
	}
	const uint32_t number = entity->type->fields[p_field].quantise(p_value);
	if (entity->values[p_field] != number) {
		entity->values[p_field] = number;
		if (!entity->is_dirty) {
			entity->is_dirty = true;
			_dirty.push_back(_index[p_id]);
		}
	}
	return true;
}

bool EntityTable::get(uint16_t p_id, std::size_t p_field, float &r_value) const {
	const Entity *entity = find(p_id);
	if (entity == nullptr || p_field >= entity->values.size()) {
		return false;
	}
	r_value = entity->type->fields[p_field].restore(entity->values[p_field]);
	return true;
}

bool EntityTable::set_position(uint16_t p_id, const Vec3 &p_position) {
	Entity *entity = _find(p_id);
	if (entity == nullptr || !p_position.is_finite()) {
		return false;
	}
	entity->position = p_position;
	entity->has_position = true;
	return true;
}

void EntityTable::commit(uint32_t p_tick) {
	for (const uint32_t index : _dirty) {
		Entity &entity = *_slots[index];
		if (!entity.is_there || !entity.is_dirty) {
			continue;
		}
		entity.is_dirty = false;
		entity.first_tick = entity.first_tick == NEVER ? p_tick : entity.first_tick;
		if (entity.values != entity.committed) {
			entity.committed = entity.values;
			entity.history->put(p_tick, entity.values.data());
			_changes[_change_count++ % MAX_CHANGES] = index;
		}
	}
	_dirty.clear();
}

} // namespace wire
