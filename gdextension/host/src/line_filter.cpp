// SPDX-License-Identifier: MIT
#include "line_filter.hpp"

#include <algorithm>
#include <utility>

namespace host {

namespace {

constexpr std::string_view INDENT = "   ";

/// A line without the sequences that change a terminal's colour: ESC [ numbers m.
std::string plain(std::string_view p_line) {
	std::string text;
	bool in_sequence = false;
	for (const char letter : p_line) {
		if (letter == '\x1b') {
			in_sequence = true;
		} else if (!in_sequence) {
			text += letter;
		} else if (letter == 'm') {
			in_sequence = false;
		}
	}
	return text;
}

/// Whether a pattern fits a whole text. Goes back to the last `*` only, which is enough.
bool fits(std::string_view p_pattern, std::string_view p_text) {
	size_t at = 0;
	size_t text_at = 0;
	size_t star = std::string_view::npos;
	size_t after_star = 0;
	while (text_at < p_text.size()) {
		if (at < p_pattern.size() && p_pattern[at] == '*') {
			star = at++;
			after_star = text_at;
		} else if (at < p_pattern.size() && p_pattern[at] == p_text[text_at]) {
			at++;
			text_at++;
		} else if (star != std::string_view::npos) {
			at = star + 1;
			text_at = ++after_star;
		} else {
			return false;
		}
	}
	return p_pattern.find_first_not_of('*', at) == std::string_view::npos;
}

} // namespace

void LineFilter::add(const std::string &p_pattern) {
	_patterns.push_back(p_pattern);
}

std::string LineFilter::take(std::string_view p_text) {
	std::string out;
	_rest += p_text;
	size_t from = 0;
	for (size_t end = _rest.find('\n'); end != std::string::npos; end = _rest.find('\n', from)) {
		if (!is_left_out(std::string_view(_rest).substr(from, end - from))) {
			out.append(_rest, from, end + 1 - from);
		}
		from = end + 1;
	}
	_rest.erase(0, from);
	return out;
}

std::string LineFilter::take_rest() {
	return std::exchange(_rest, std::string());
}

bool LineFilter::is_left_out(std::string_view p_line) {
	const std::string text = plain(p_line);
	if (_skips && text.compare(0, INDENT.size(), INDENT) == 0) {
		return true;
	}
	_skips = std::any_of(_patterns.begin(), _patterns.end(),
			[&text](const std::string &p_pattern) { return fits(p_pattern, text); });
	return _skips;
}

} // namespace host
