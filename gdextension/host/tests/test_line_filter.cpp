// SPDX-License-Identifier: MIT
#include "check.hpp"
#include "line_filter.hpp"

#include <string>

namespace test_line_filter {

using host::LineFilter;

namespace {

const std::string LABEL = "ERROR: no connection from 'Label'. Signal: 'size'.\n   at: f (a.cpp:1)\n";
const std::string OTHER = "ERROR: no file\n   at: g (b.cpp:2)\n";

} // namespace

TEST(everything_passes_until_something_is_left_out) {
	LineFilter filter;
	CHECK(filter.take(LABEL + OTHER) == LABEL + OTHER);
}

TEST(a_message_goes_with_its_indented_lines) {
	LineFilter filter;
	filter.add("ERROR: no connection from '*'. Signal: 'size'.");
	CHECK(filter.take(OTHER + LABEL + OTHER + LABEL + LABEL) == OTHER + OTHER);
	CHECK(filter.take("   indented by itself\n").empty());
	CHECK(filter.take("plain\n   indented\n") == "plain\n   indented\n");
}

TEST(only_whole_lines_fit) {
	LineFilter filter;
	filter.add("ERROR: no*file");
	CHECK(filter.take("ERROR: no file\nERROR: no big file\n").empty());
	for (const char *line : { "ERROR: no file there\n", "an ERROR: no file\n", "ERROR: no\n" }) {
		CHECK(filter.take(line) == line);
	}
	filter.add("*x*y*");
	CHECK(filter.take("axby\n").empty() && filter.take("y x\n") == "y x\n");
}

TEST(a_line_is_known_at_its_end) {
	LineFilter filter;
	filter.add("ERROR: no file");
	CHECK(filter.take("ERROR: no").empty());
	CHECK(filter.take(" file\nfi").empty());
	CHECK(filter.take("ne\n") == "fine\n");
	CHECK(filter.take("rest").empty() && filter.take_rest() == "rest" && filter.take_rest().empty());
}

TEST(colours_of_a_terminal_do_not_count) {
	LineFilter filter;
	filter.add("ERROR: no file");
	CHECK(filter.take("\x1b[1;31mERROR:\x1b[0;91m no file\n\x1b[0;90m   at: g (b.cpp:2)\x1b[0m\n").empty());
	CHECK(filter.take("\x1b[0;91mERROR: x\x1b[0m\n") == "\x1b[0;91mERROR: x\x1b[0m\n");
}

} // namespace test_line_filter
