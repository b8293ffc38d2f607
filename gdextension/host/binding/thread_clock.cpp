// SPDX-License-Identifier: MIT
#include "thread_clock.hpp"

#include <ctime>

namespace godot {

namespace {

int64_t read_usec(clockid_t p_clock) {
	timespec now{};
	if (clock_gettime(p_clock, &now) != 0) {
		return 0;
	}
	return int64_t(now.tv_sec) * 1000000 + int64_t(now.tv_nsec) / 1000;
}

} // namespace

int64_t ThreadClock::get_usec() {
	return read_usec(CLOCK_THREAD_CPUTIME_ID);
}

int64_t ThreadClock::get_monotonic_usec() {
	return read_usec(CLOCK_MONOTONIC);
}

void ThreadClock::_bind_methods() {
	ClassDB::bind_static_method(get_class_static(), D_METHOD("get_monotonic_usec"), &ThreadClock::get_monotonic_usec);
	ClassDB::bind_static_method(get_class_static(), D_METHOD("get_usec"), &ThreadClock::get_usec);
}

} // namespace godot
