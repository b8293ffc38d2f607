// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace mvn {

/// Bytes of the UTF-8 character that begins here; 0 if none does.
inline std::size_t utf8_size(const char *p_text, std::size_t p_left) {
	const auto first = uint8_t(*p_text);
	const std::size_t size = first < 0x80 ? 1 : (first < 0xC2 ? 0 : (first < 0xE0 ? 2 : (first < 0xF0 ? 3 : 4)));
	if (size == 0 || first > 0xF4 || size > p_left) {
		return 0;
	}
	uint32_t code = size == 1 ? first : uint32_t(first) & (0xFFU >> (size + 1));
	for (std::size_t at = 1; at < size; ++at) {
		const auto byte = uint8_t(p_text[at]);
		if ((byte & 0xC0U) != 0x80U) {
			return 0;
		}
		code = (code << 6U) | (byte & 0x3FU);
	}
	// Overlong forms, halves of pairs, beyond the last character.
	const bool is_bad = (size == 3 && code < 0x800) || (size == 4 && code < 0x10000) || code > 0x10FFFF ||
			(code >= 0xD800 && code <= 0xDFFF);
	return is_bad ? 0 : size;
}

/// What a stranger says goes to logs and screens: control characters go, what is no UTF-8 becomes "?".
inline std::string clean_text(const char *p_text, std::size_t p_size, bool p_keeps_lines = false) {
	std::string text;
	text.reserve(p_size);
	for (std::size_t at = 0; at < p_size;) {
		const std::size_t size = utf8_size(p_text + at, p_size - at);
		const auto first = uint8_t(p_text[at]);
		// U+0080 to U+009F are control characters too.
		const bool is_control = (size == 1 && (first < 0x20 || first == 0x7F)) ||
				(size == 2 && first == 0xC2 && uint8_t(p_text[at + 1]) < 0xA0);
		if (size == 0) {
			text += '?';
		} else if (!is_control || (p_keeps_lines && first == '\n')) {
			text.append(p_text + at, size);
		}
		at += size > 0 ? size : 1;
	}
	return text;
}

/// As much of a UTF-8 text as fits, in whole characters.
inline std::string cut_text(const std::string &p_text, std::size_t p_most) {
	std::size_t end = p_text.size();
	if (end > p_most) {
		end = p_most;
		while (end > 0 && (uint8_t(p_text[end]) & 0xC0U) == 0x80U) {
			--end;
		}
	}
	return p_text.substr(0, end);
}

} // namespace mvn
