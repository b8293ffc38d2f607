// SPDX-License-Identifier: MIT
#include "check.hpp"
#include "stall_guard.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <functional>
#include <future>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace test_stall_guard {

using host::replace_program;
using host::StallGuard;
using namespace std::chrono_literals;

namespace {

/// What a shell's command returns that replaces a child of this process.
int run_replaced(const std::string &p_script, const std::function<void(const std::vector<std::string> &)> &p_replace) {
	const pid_t child = fork();
	if (child == 0) {
		p_replace({ "/bin/sh", "-c", p_script, "sh" });
		_exit(99);
	}
	int status = 0;
	waitpid(child, &status, 0);
	return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

void replace(const std::vector<std::string> &p_command) {
	replace_program(p_command);
}

/// As a main loop that blocks in a lock, which the guard's thread gets it out of.
void replace_from_guard(const std::vector<std::string> &p_command) {
	StallGuard guard;
	guard.start(40ms, [&p_command] { replace_program(p_command); });
	std::mutex blocked;
	blocked.lock();
	std::promise<void> never;
	never.get_future().wait();
}

} // namespace

TEST(another_program_takes_the_process_over) {
	CHECK(run_replaced("exit 7", replace) == 7);
}

TEST(a_blocked_main_thread_is_replaced_too) {
	CHECK(run_replaced("exit 8", replace_from_guard) == 8);
}

TEST(files_of_the_old_program_are_closed) {
	const int descriptor = open("/dev/null", O_RDONLY);
	const std::string name = "/proc/$$/fd/" + std::to_string(descriptor);
	CHECK(run_replaced("test ! -e " + name, replace) == 0);
	close(descriptor);
}

TEST(standard_streams_stay) {
	CHECK(run_replaced("test -e /proc/$$/fd/0 && test -e /proc/$$/fd/1 && test -e /proc/$$/fd/2", replace) == 0);
}

TEST(a_program_that_is_not_there_leaves_this_one) {
	CHECK(replace_program({ "/nonexistent/program" }) == ENOENT);
	CHECK(replace_program({}) == EINVAL);
}

TEST(a_loop_that_beats_is_left_alone) {
	StallGuard guard;
	std::atomic<int> calls{ 0 };
	// No machine is so slow that it beats once in an hour.
	CHECK(guard.start(std::chrono::hours(1), [&calls] { ++calls; }));
	CHECK(!guard.start(1ms, [] {}));
	guard.beat();
	guard.stop();
	CHECK(calls == 0);
	CHECK(!guard.is_watching());
}

TEST(work_that_may_take_long_is_no_stall) {
	StallGuard guard;
	std::atomic<int> calls{ 0 };
	guard.hold();
	guard.start(8ms, [&calls] { ++calls; });
	std::this_thread::sleep_for(100ms);
	CHECK(calls == 0);
	guard.stop();
}

TEST(a_loop_that_stands_still_is_reported_once) {
	StallGuard guard;
	std::atomic<int> calls{ 0 };
	std::promise<void> called;
	guard.start(8ms, [&calls, &called] {
		if (++calls == 1) {
			called.set_value();
		}
	});
	called.get_future().wait();
	guard.stop();
	CHECK(calls == 1);
}

} // namespace test_stall_guard
