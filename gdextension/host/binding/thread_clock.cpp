// SPDX-License-Identifier: MIT
#include "thread_clock.hpp"

#include <ctime>

namespace godot {

int64_t ThreadClock::get_usec() {
	timespec now{};
	if (clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now) != 0) {
		return 0;
	}
	return int64_t(now.tv_sec) * 1000000 + int64_t(now.tv_nsec) / 1000;
}

void ThreadClock::_bind_methods() {
	ClassDB::bind_static_method(get_class_static(), D_METHOD("get_usec"), &ThreadClock::get_usec);
}

} // namespace godot
