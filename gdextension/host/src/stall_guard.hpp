// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace host {

/// Replaces the program by another one in the same process: same number, parent and terminal.
///
/// Open files but standard input, output and error end with the old program. It can be called by
/// any thread, whatever the others wait for. Returns only if it fails: the system's error number.
int replace_program(const std::vector<std::string> &p_command);

/// Notices that the main loop has stood still, from a thread of its own.
class StallGuard {
public:
	StallGuard() = default;
	~StallGuard();
	StallGuard(const StallGuard &) = delete;
	StallGuard &operator=(const StallGuard &) = delete;

	/// Begins to watch: where no beat has come for the patience, the guard calls once, in its own
	/// thread. False if it watches already.
	bool start(std::chrono::milliseconds p_patience, std::function<void()> p_stalled);
	/// The main loop lives, and is watched from here on.
	void beat();
	/// What comes now may take as long as it likes, until the next beat.
	void hold();
	/// Ends to watch. The thread has ended after this, unless it is that thread which calls.
	void stop();
	bool is_watching() const { return _thread.joinable(); }

private:
	void watch();

	std::thread _thread;
	std::mutex _mutex;
	std::condition_variable _wake;
	std::function<void()> _stalled;
	std::chrono::milliseconds _patience{ 0 };
	std::atomic<uint64_t> _beats{ 0 };
	std::atomic<bool> _is_held{ false };
	bool _is_ending = false;
};

} // namespace host
