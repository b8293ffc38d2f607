// SPDX-License-Identifier: MIT
#pragma once

// Making and destroying objects.

#include <godot_cpp/classes/wrapped.hpp>

/// Makes an object of an engine class or of an extension's class: `memnew(Node3D)`.
// The left side of << is evaluated first: it says what the constructor on the right is making.
#define memnew(m_class) (::godot::internal::Construction<std::remove_pointer_t<decltype(new m_class)>>() << new m_class)

namespace godot {

/// Destroys an object that memnew made.
template <class T>
void memdelete(T *p_object) {
	if constexpr (std::is_base_of_v<Wrapped, T>) {
		internal::destroy(p_object);
	} else {
		delete p_object;
	}
}

} // namespace godot
