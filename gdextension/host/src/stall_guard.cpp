// SPDX-License-Identifier: MIT
#include "stall_guard.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <utility>

extern char **environ;

namespace host {

namespace {

using Clock = std::chrono::steady_clock;

/// Looks a few times within the patience: a process that was itself stopped for a while, such as
/// by a laptop's lid, then sees its main loop beat again before it gives up.
constexpr int LOOKS = 8;

/// Lets everything but the standard streams end with this program. Marking is safe where closing
/// is not: other threads still use the files if the program cannot be replaced.
void mark_files() {
	DIR *folder = opendir("/proc/self/fd");
	if (folder == nullptr) {
		return;
	}
	for (const dirent *entry = readdir(folder); entry != nullptr; entry = readdir(folder)) {
		// Names that are no numbers, "." and "..", become 0.
		const int descriptor = static_cast<int>(std::strtol(entry->d_name, nullptr, 10));
		if (descriptor > STDERR_FILENO) {
			const int flags = fcntl(descriptor, F_GETFD);
			if (flags >= 0) {
				fcntl(descriptor, F_SETFD, flags | FD_CLOEXEC);
			}
		}
	}
	closedir(folder);
}

} // namespace

int replace_program(const std::vector<std::string> &p_command) {
	if (p_command.empty()) {
		return EINVAL;
	}
	std::vector<char *> arguments;
	arguments.reserve(p_command.size() + 1);
	for (const std::string &argument : p_command) {
		// execve() takes no constants, and writes none either.
		arguments.push_back(const_cast<char *>(argument.c_str()));
	}
	arguments.push_back(nullptr);
	mark_files();
	// What this thread keeps from coming would be kept from the next program as well.
	sigset_t none;
	sigset_t before;
	sigemptyset(&none);
	pthread_sigmask(SIG_SETMASK, &none, &before);
	execve(arguments[0], arguments.data(), environ);
	const int error = errno;
	pthread_sigmask(SIG_SETMASK, &before, nullptr);
	return error;
}

StallGuard::~StallGuard() {
	stop();
}

bool StallGuard::start(std::chrono::milliseconds p_patience, std::function<void()> p_stalled) {
	if (is_watching()) {
		return false;
	}
	_patience = p_patience;
	_stalled = std::move(p_stalled);
	_is_ending = false;
	_thread = std::thread([this] { watch(); });
	return true;
}

void StallGuard::beat() {
	_beats.fetch_add(1, std::memory_order_relaxed);
	_is_held.store(false, std::memory_order_relaxed);
}

void StallGuard::hold() {
	_is_held.store(true, std::memory_order_relaxed);
}

void StallGuard::stop() {
	if (!is_watching()) {
		return;
	}
	{
		const std::lock_guard<std::mutex> lock(_mutex);
		_is_ending = true;
	}
	_wake.notify_all();
	if (_thread.get_id() == std::this_thread::get_id()) {
		_thread.detach();
	} else {
		_thread.join();
	}
}

void StallGuard::watch() {
	std::unique_lock<std::mutex> lock(_mutex);
	uint64_t seen = _beats.load(std::memory_order_relaxed);
	int quiet = 0;
	while (!_is_ending) {
		_wake.wait_for(lock, _patience / LOOKS, [this] { return _is_ending; });
		const uint64_t now = _beats.load(std::memory_order_relaxed);
		const bool is_held = _is_held.load(std::memory_order_relaxed);
		quiet = now == seen && !is_held ? quiet + 1 : 0;
		seen = now;
		if (!_is_ending && quiet >= LOOKS) {
			_is_ending = true;
			lock.unlock();
			_stalled();
			lock.lock();
		}
	}
}

} // namespace host
