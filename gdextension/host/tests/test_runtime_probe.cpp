// SPDX-License-Identifier: MIT
#include "check.hpp"
#include "runtime_probe.hpp"

#include <chrono>
#include <csignal>
#include <thread>

namespace test_runtime_probe {

using host::RuntimeProbe;
using Answer = RuntimeProbe::Answer;
using namespace std::chrono_literals;

namespace {

Answer await(RuntimeProbe &p_probe) {
	while (p_probe.poll() == Answer::PENDING) {
		std::this_thread::sleep_for(5ms);
	}
	return p_probe.poll();
}

} // namespace

TEST(nobody_has_been_asked_at_first) {
	RuntimeProbe probe;
	CHECK(probe.poll() == Answer::NONE);
}

TEST(a_library_that_is_not_there_is_none) {
	RuntimeProbe probe;
	CHECK(probe.start("/nonexistent/libopenxr.so", 60s));
	CHECK(!probe.start("/nonexistent/libopenxr.so", 60s));
	CHECK(await(probe) == Answer::NO_LIBRARY);
}

TEST(a_library_without_a_runtime_is_none) {
	RuntimeProbe probe;
	CHECK(probe.start("libc.so.6", 60s));
	CHECK(await(probe) == Answer::NO_LIBRARY);
}

TEST(one_without_an_answer_is_given_up) {
	RuntimeProbe probe;
	// No time at all: whatever it does, it is late.
	CHECK(probe.start("libc.so.6", -1ms));
	const Answer answer = probe.poll();
	CHECK(answer == Answer::STALLED || answer == Answer::NO_LIBRARY);
	CHECK(probe.start("libc.so.6", 60s));
	CHECK(await(probe) == Answer::NO_LIBRARY);
}

TEST(an_answer_that_somebody_else_has_taken_is_none) {
	// The system forgets children at once.
	const auto before = std::signal(SIGCHLD, SIG_IGN);
	RuntimeProbe probe;
	CHECK(probe.start("libc.so.6", 60s));
	CHECK(await(probe) == Answer::NO_SERVICE);
	std::signal(SIGCHLD, before);
	CHECK(probe.start("libc.so.6", 60s));
	CHECK(await(probe) == Answer::NO_LIBRARY);
}

} // namespace test_runtime_probe
