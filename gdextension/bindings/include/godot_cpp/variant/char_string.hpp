// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <utility>

namespace godot {

/// UTF-8 text, as String::utf8() makes it.
class CharString {
public:
	CharString() = default;
	explicit CharString(std::string p_text) : text(std::move(p_text)) {}

	const char *get_data() const { return text.c_str(); }
	const char *ptr() const { return text.c_str(); }
	int64_t length() const { return static_cast<int64_t>(text.size()); }

private:
	std::string text;
};

} // namespace godot
