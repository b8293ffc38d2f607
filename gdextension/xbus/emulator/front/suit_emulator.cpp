// SPDX-License-Identifier: MIT
// A suit behind umockdev: programs that it starts, or that have its environment, find its USB devices.
#include "front/session.hpp"

#include "clock/thread_priority.hpp"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iterator>

#include <unistd.h>

namespace {

int refuse(const std::string &p_what) {
	(void)fprintf(stderr, "suit_emulator: %s\n", p_what.c_str());
	return 2;
}

/// umockdev sends udev's messages only from a program that it is loaded into itself.
void enter_umockdev(char **p_arguments) {
	if (umockdev_in_mock_environment() == 0 && std::getenv("SUIT_EMULATOR_ENTERED") == nullptr) {
		setenv("SUIT_EMULATOR_ENTERED", "1", 1);
		setenv("LD_PRELOAD", emulator::preload_value().c_str(), 1);
		execv("/proc/self/exe", p_arguments);
	}
	unsetenv("SUIT_EMULATOR_ENTERED");
}

} // namespace

int main(int p_count, char **p_arguments) {
	enter_umockdev(p_arguments);
	emulator::prepare_threads();
	try {
		emulator::SuitOptions options;
		const std::string fault = options.parse({ p_arguments + 1, p_arguments + p_count });
		if (!fault.empty()) {
			return refuse(fault);
		}
		if (options.is_real_time) {
			(void)clocks::prefer_this_thread(true);
		}
		emulator::MotionStream stream = emulator::MotionStream::still(std::size_t(options.sensors));
		if (!options.stream.empty()) {
			std::ifstream file(options.stream, std::ios::binary);
			const std::vector<uint8_t> bytes{ std::istreambuf_iterator<char>(file), {} };
			const std::string wrong = file ? stream.parse(bytes) : "it cannot be read";
			if (!wrong.empty()) {
				return refuse(options.stream + ": " + wrong);
			}
		}
		emulator::Session session(options, std::move(stream));
		if (!session.error().empty()) {
			return refuse(session.error());
		}
		return session.run();
	} catch (const std::exception &error) {
		return refuse(error.what());
	}
}
