// SPDX-License-Identifier: MIT
#pragma once

// What the sources of the bindings share.
#include <godot_cpp/variant/variant.hpp>

#include <cstring>

namespace godot::internal {

/// Names are interned: equal names have equal content, which makes a quick key.
inline uint64_t key_of(const void *p_name) {
	uint64_t key = 0;
	std::memcpy(&key, p_name, sizeof(key));
	return key;
}

inline uint64_t key_of(const StringName &p_name) {
	return key_of(p_name.opaque);
}

/// Makes the engine classes' wrappers known, once the engine's functions are.
void activate_engine_classes();

/// Takes every class of the extension back.
void unregister_classes();

/// Hands the documentation of the extension's classes to the editor.
void load_documentation();

} // namespace godot::internal
