// SPDX-License-Identifier: MIT
#pragma once

#include <coding/person_codec.hpp>

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>
#include <godot_cpp/variant/vector2.hpp>
#include <godot_cpp/variant/vector3.hpp>

#include <vector>

namespace godot {

/// A person's motion, to be coded and measured. Documented in doc_classes/PersonStream.xml.
class PersonStream : public RefCounted {
	GDCLASS(PersonStream, RefCounted)

public:
	static int resolution_for(double p_max_error_deg);

	bool setup(const PackedInt32Array &p_parents, int p_resolution);
	int push(const Vector3 &p_root, const PackedFloat32Array &p_orientations);
	PackedByteArray encode(int p_tick, int p_base, int p_before) const;
	bool decode(const PackedByteArray &p_bytes, int p_tick, int p_base, int p_before) const;
	PackedFloat32Array restore(int p_tick) const;
	Vector2 measure(int p_every, int p_age, int p_before_age, int p_rounds) const;

protected:
	static void _bind_methods();

private:
	bool _is_tick(int p_tick) const { return p_tick >= 0 && p_tick < int(_states.size()); }
	const wire::PersonState *_state_or_null(int p_tick) const {
		return _is_tick(p_tick) ? &_states[std::size_t(p_tick)] : nullptr;
	}
	std::size_t _write(int p_tick, int p_base, int p_before, uint8_t *r_bytes) const;
	bool _read(const uint8_t *p_bytes, std::size_t p_size, int p_tick, int p_base, int p_before,
			wire::PersonState &r_state) const;

	wire::Skeleton _skeleton;
	int _resolution = wire::PersonLattice::FINE;
	std::vector<wire::PersonState> _states;
};

} // namespace godot
