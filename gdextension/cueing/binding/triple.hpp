// SPDX-License-Identifier: MIT
#pragma once

#include <washout_filter.hpp>

#include <godot_cpp/variant/vector3.hpp>

namespace godot {

inline cueing::Triple to_triple(const Vector3 &p_vector) {
	return { p_vector.x, p_vector.y, p_vector.z };
}

inline Vector3 from_triple(const cueing::Triple &p_triple) {
	return Vector3(real_t(p_triple[0]), real_t(p_triple[1]), real_t(p_triple[2]));
}

} // namespace godot
