// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <string>
#include <sys/types.h>

namespace host {

/// Asks an OpenXR runtime whether a headset can be had, in a process of its own: a runtime that
/// stalls, crashes or leaves things behind does so there.
class RuntimeProbe {
public:
	enum class Answer {
		/// Nobody has been asked.
		NONE,
		/// It hasn't answered yet.
		PENDING,
		/// A headset can be had.
		READY,
		/// The library of the runtime can't be loaded, or is none.
		NO_LIBRARY,
		/// The runtime's service does not run, or refuses.
		NO_SERVICE,
		/// The runtime has no headset.
		NO_HEADSET,
		/// No answer within the patience.
		STALLED,
	};

	RuntimeProbe() = default;
	~RuntimeProbe();
	RuntimeProbe(const RuntimeProbe &) = delete;
	RuntimeProbe &operator=(const RuntimeProbe &) = delete;

	/// Asks the runtime that a library holds. False while it is asked already, or where the system
	/// makes no process.
	bool start(const std::string &p_library, std::chrono::milliseconds p_patience);
	/// What it has answered. Never waits.
	Answer poll();

private:
	void end();

	pid_t _child = -1;
	Answer _answer = Answer::NONE;
	std::chrono::steady_clock::time_point _until;
};

} // namespace host
