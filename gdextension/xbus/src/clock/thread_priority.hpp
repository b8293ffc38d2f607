// SPDX-License-Identifier: MIT
#pragma once

#include <pthread.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace clocks {

/// How a thread that must not be late is preferred to others.
enum class Priority {
	REAL_TIME, ///< It runs as soon as it has something to do.
	HIGH, ///< A greater share of a busy processor.
	USUAL, ///< The system allows neither.
};

/// Prefers the calling thread as far as the system allows. A thread that reads a device hardly works, but a serial
/// chip holds only a few milliseconds: whoever fetches later loses samples. Threads and processes that it starts
/// are as others are, unless they are to inherit it.
inline Priority prefer_this_thread(bool p_is_inherited = false) {
	// Above ordinary threads, below the kernel's own for interrupts (50).
	constexpr int RT_PRIORITY = 20;
	constexpr int NICE = -10;
	sched_param parameters{};
	parameters.sched_priority = RT_PRIORITY;
	if (sched_setscheduler(0, SCHED_RR | (p_is_inherited ? 0 : SCHED_RESET_ON_FORK), &parameters) == 0) {
		return Priority::REAL_TIME;
	}
	const auto thread = id_t(syscall(SYS_gettid));
	return setpriority(PRIO_PROCESS, thread, NICE) == 0 ? Priority::HIGH : Priority::USUAL;
}

/// Takes the preference back.
inline void prefer_nobody() {
	const sched_param parameters{};
	(void)sched_setscheduler(0, SCHED_OTHER, &parameters);
	(void)setpriority(PRIO_PROCESS, 0, 0);
}

/// What that means, for the log.
inline const char *priority_text(Priority p_priority) {
	switch (p_priority) {
		case Priority::REAL_TIME:
			return "suits are read at real-time priority";
		case Priority::HIGH:
			return "suits are read at high priority";
		default:
			return "suits are read at the usual priority, for the system allows no other: on a busy machine samples "
				   "may "
				   "come late or be lost (to allow it: a line '@users - rtprio 20' in /etc/security/limits.d/, and log "
				   "in "
				   "anew)";
	}
}

} // namespace clocks
