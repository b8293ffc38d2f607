// SPDX-License-Identifier: MIT
#include "terminal.hpp"

#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>

namespace godot {

namespace {

// There is one terminal: how it was belongs to the process.
termios before = {};

/// Whether the shell has given the terminal to us: whoever reads from it in the background is
/// stopped.
bool is_foreground() {
	return isatty(STDIN_FILENO) == 0 || tcgetpgrp(STDIN_FILENO) == getpgrp();
}

} // namespace

Terminal::~Terminal() {
	close();
}

bool Terminal::open() {
	const bool is_terminal = isatty(STDIN_FILENO) == 1 && isatty(STDOUT_FILENO) == 1;
	if (_is_raw || !is_terminal || !is_foreground() || tcgetattr(STDIN_FILENO, &before) != 0) {
		return _is_raw;
	}
	termios raw = before;
	// Ctrl+C still ends the program.
	raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
	raw.c_cc[VMIN] = 1;
	raw.c_cc[VTIME] = 0;
	_is_raw = tcsetattr(STDIN_FILENO, TCSANOW, &raw) == 0;
	return _is_raw;
}

PackedByteArray Terminal::read() {
	PackedByteArray bytes;
	pollfd input = { STDIN_FILENO, POLLIN, 0 };
	if (_has_ended || !is_foreground() || poll(&input, 1, 0) <= 0) {
		return bytes;
	}
	std::array<uint8_t, 4096> buffer{};
	const ssize_t got = ::read(STDIN_FILENO, buffer.data(), buffer.size());
	if (got > 0) {
		bytes.resize(got);
		std::memcpy(bytes.ptrw(), buffer.data(), static_cast<size_t>(got));
	} else if (got == 0 || (errno != EINTR && errno != EAGAIN)) {
		_has_ended = true;
	}
	return bytes;
}

bool Terminal::is_at_end() const {
	return _has_ended;
}

void Terminal::write(const String &p_text) {
	// What was printed before comes before it.
	std::fputs(p_text.utf8().get_data(), stdout);
	std::fflush(stdout);
}

void Terminal::close() {
	if (_is_raw) {
		tcsetattr(STDIN_FILENO, TCSANOW, &before);
	}
	_is_raw = false;
}

void Terminal::_bind_methods() {
	ClassDB::bind_method(D_METHOD("open"), &Terminal::open);
	ClassDB::bind_method(D_METHOD("read"), &Terminal::read);
	ClassDB::bind_method(D_METHOD("is_at_end"), &Terminal::is_at_end);
	ClassDB::bind_method(D_METHOD("write", "text"), &Terminal::write);
	ClassDB::bind_method(D_METHOD("close"), &Terminal::close);
}

} // namespace godot
