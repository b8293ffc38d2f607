// SPDX-License-Identifier: MIT
#include "error_filter.hpp"

#include "line_filter.hpp"

#include <dlfcn.h>
#include <unistd.h>

#include <cstdio>
#include <mutex>

namespace godot {

namespace {

// There is one standard error: what passes belongs to the process.
std::mutex filter_mutex;
host::LineFilter filter;
FILE **stream = nullptr;
FILE *unfiltered = nullptr;
FILE *filtered = nullptr;

void pass_on(const std::string &p_text) {
	for (size_t at = 0; at < p_text.size();) {
		const ssize_t written = ::write(STDERR_FILENO, p_text.data() + at, p_text.size() - at);
		if (written <= 0) {
			return;
		}
		at += static_cast<size_t>(written);
	}
}

ssize_t write_filtered(void *, const char *p_text, size_t p_size) {
	const std::lock_guard<std::mutex> lock(filter_mutex);
	pass_on(filter.take({ p_text, p_size }));
	return static_cast<ssize_t>(p_size);
}

/// The program's own variable stderr: extensions are opened so that they see the C library's
/// (RTLD_DEEPBIND), which the program does not read.
FILE **find_stream() {
	return static_cast<FILE **>(dlsym(dlopen(nullptr, RTLD_NOW), "stderr"));
}

/// The engine writes each line to the C library's stream: another one takes its place. Whoever
/// writes to the descriptor itself is not heard.
void open_filter() {
	stream = unfiltered == nullptr ? find_stream() : stream;
	if (stream == nullptr) {
		return;
	}
	cookie_io_functions_t functions = {};
	functions.write = write_filtered;
	FILE *made = unfiltered == nullptr ? fopencookie(nullptr, "w", functions) : nullptr;
	if (made == nullptr) {
		return;
	}
	// Whoever is killed has written all lines that it said.
	(void)setvbuf(made, nullptr, _IOLBF, BUFSIZ);
	(void)fflush(*stream);
	unfiltered = *stream;
	filtered = made;
	*stream = made;
}

} // namespace

void ErrorFilter::leave_out(const String &p_pattern) {
	{
		const std::lock_guard<std::mutex> lock(filter_mutex);
		filter.add(p_pattern.utf8().get_data());
	}
	open_filter();
}

void ErrorFilter::close() {
	if (unfiltered == nullptr) {
		return;
	}
	*stream = unfiltered;
	unfiltered = nullptr;
	(void)fclose(filtered);
	pass_on(filter.take_rest());
}

void ErrorFilter::_bind_methods() {
	ClassDB::bind_static_method(get_class_static(), D_METHOD("leave_out", "pattern"), &ErrorFilter::leave_out);
}

} // namespace godot
