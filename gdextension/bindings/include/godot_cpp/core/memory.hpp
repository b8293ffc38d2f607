// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/classes/wrapped.hpp>

namespace godot {

namespace internal {

/// Ties a new object to the engine's half of it; what is no engine object passes as it is.
template <class T>
T *after_new(T *p_object) {
	if constexpr (std::is_base_of_v<Wrapped, T>) {
		p_object->_attach();
		p_object->notification(T::NOTIFICATION_POSTINITIALIZE, false);
	}
	return p_object;
}

} // namespace internal

template <class T>
void memdelete(T *p_object) {
	if constexpr (std::is_base_of_v<Wrapped, T>) {
		// The engine deletes the C++ half through the instance binding.
		internal::engine.object_destroy(p_object->_owner);
	} else {
		delete p_object;
	}
}

} // namespace godot

#define memnew(m_class) (::godot::internal::after_new(new m_class))
