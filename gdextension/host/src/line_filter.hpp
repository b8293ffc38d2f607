// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace host {

/// Leaves single messages out of a stream of text, by their exact words. A message is a line, and
/// the lines after it that are indented, as the engine writes where an error comes from.
class LineFilter {
public:
	/// Leaves out lines that a pattern fits from now on: `*` stands for any characters. Colours of a
	/// terminal do not count.
	void add(const std::string &p_pattern);
	/// What is to be written after some text has come. The rest of a line comes with its end.
	std::string take(std::string_view p_text);
	/// What has come of a line that has not ended.
	std::string take_rest();

private:
	bool is_left_out(std::string_view p_line);

	std::vector<std::string> _patterns;
	std::string _rest;
	/// Whether the line before belongs to a message that is left out.
	bool _skips = false;
};

} // namespace host
