// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/variant/string.hpp>

#include <string>

namespace godot {

/// UTF-8 text as the engine's.
inline String as_string(const std::string &p_text) {
	return String::utf8(p_text.c_str());
}

} // namespace godot
