// SPDX-License-Identifier: MIT
#pragma once

#include <replication/entity_type.hpp>

#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>

namespace godot {

/// Whether a script's number can be that of an entity's type.
inline bool is_type(int64_t p_type) {
	return p_type >= 0 && p_type <= 255;
}

/// Takes a type of entity from a script's arrays; false if they make none.
inline bool read_type(wire::EntityTypes &r_types, int64_t p_type, const PackedByteArray &p_kinds,
		const PackedFloat32Array &p_mins, const PackedFloat32Array &p_maxs, const PackedFloat32Array &p_resolutions) {
	const int64_t count = p_kinds.size();
	return is_type(p_type) && p_mins.size() == count && p_maxs.size() == count && p_resolutions.size() == count &&
			r_types.define(uint8_t(p_type), std::size_t(count), p_kinds.ptr(), p_mins.ptr(), p_maxs.ptr(),
					p_resolutions.ptr());
}

} // namespace godot
