// SPDX-License-Identifier: MIT
#pragma once

#include "block_mesh.hpp"

#include <shadow_reach.hpp>

#include <godot_cpp/classes/ref.hpp>

namespace godot {

/// Which meshes that throw shadows are needed. Documented in doc_classes/ShadowReach.xml.
class ShadowReach : public RefCounted {
	GDCLASS(ShadowReach, RefCounted)

public:
	void add_part(const Ref<BlockMesh> &p_mesh, bool p_is_within);
	void gather();
	int64_t get_caster_count() const;
	PackedVector3Array get_caster(int64_t p_number) const;
	void set_light(const Vector3 &p_way);
	PackedByteArray look(const PackedByteArray &p_seen, const PackedVector4Array &p_bounds) const;
	PackedByteArray find_inside(const PackedVector3Array &p_corners, const PackedVector4Array &p_bounds) const;

protected:
	static void _bind_methods();

private:
	level::ShadowReach _core;
};

} // namespace godot
