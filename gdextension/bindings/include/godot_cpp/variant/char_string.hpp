// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <utility>

namespace godot {

/// Text as a C string, e.g. from String::utf8().
class CharString {
public:
	CharString() = default;
	explicit CharString(std::string p_text) : text(std::move(p_text)) {}

	const char *get_data() const { return text.c_str(); }
	const char *ptr() const { return text.c_str(); }
	/// In bytes.
	int64_t length() const { return int64_t(text.size()); }

private:
	std::string text;
};

} // namespace godot
