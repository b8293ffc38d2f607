// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace wire {

/// Fields that an entity can have at most.
constexpr std::size_t MAX_FIELDS = 32;
/// The largest whole number that a field's value becomes.
constexpr uint32_t MAX_FIELD_NUMBER = 1U << 24U;

/// How a field's values follow each other.
enum class FieldKind : uint8_t {
	ANGLE = 0, ///< Wraps round its range [min, max); the short way round is the way that it moves.
	LINEAR = 1, ///< Moves evenly from one value to the next.
	STEP = 2, ///< Has a value until it has another.
};
constexpr int FIELD_KIND_COUNT = 3;

/// A field of an entity: a number that is sent as a whole number of `resolution` above `min`.
struct Field {
	FieldKind kind = FieldKind::STEP;
	float min = 0.0f;
	float resolution = 1.0f;
	uint32_t count = 1; ///< Of the whole numbers that it can be: 0 to count - 1.

	bool operator==(const Field &p_other) const {
		return kind == p_other.kind && min == p_other.min && resolution == p_other.resolution && count == p_other.count;
	}
	/// The nearest whole number; what lies outside is cut off, or turned into the range if it is an angle. What is
	/// not finite becomes 0.
	uint32_t quantise(float p_value) const;
	/// The value that a whole number stands for.
	float restore(uint32_t p_number) const { return float(double(min) + double(resolution) * p_number); }
	/// The difference between two whole numbers, an angle's by the short way round.
	int32_t difference(uint32_t p_from, uint32_t p_to) const;
	/// The whole number that so much leads to; false if that is none.
	bool add(uint32_t p_from, int32_t p_difference, uint32_t &r_number) const;
};

/// Which fields the entities of a type have.
struct EntityType {
	std::vector<Field> fields;
	bool is_defined = false;
};

/// All types of a session, by their numbers.
class EntityTypes {
public:
	/// Says which fields a type has. False, and nothing is changed, if they are more than MAX_FIELDS or make no
	/// sense: a range or resolution that is not above 0, more than MAX_FIELD_NUMBER steps, or
	/// other fields than before.
	bool define(uint8_t p_type, std::size_t p_count, const uint8_t *p_kinds, const float *p_mins, const float *p_maxs,
			const float *p_resolutions);
	/// A type that was defined, or null.
	const EntityType *find(uint8_t p_type) const { return _types[p_type].is_defined ? &_types[p_type] : nullptr; }

private:
	std::array<EntityType, 256> _types{};
};

} // namespace wire
