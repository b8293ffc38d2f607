// SPDX-License-Identifier: MIT
#pragma once

#include <light_grid.hpp>

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/color.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>
#include <godot_cpp/variant/vector3i.hpp>

namespace godot {

/// Light in the air of a level. Documented in doc_classes/LightGrid.xml.
class LightGrid : public RefCounted {
	GDCLASS(LightGrid, RefCounted)

public:
	bool set_points(const PackedByteArray &p_bytes, const Vector3i &p_counts);
	PackedByteArray combine(const PackedVector3Array &p_strengths) const;
	Vector3 mean_at(const Vector3 &p_place, const PackedVector3Array &p_strengths) const;

protected:
	static void _bind_methods();

private:
	level::LightGrid _core;
};

} // namespace godot
