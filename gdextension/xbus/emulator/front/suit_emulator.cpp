// SPDX-License-Identifier: MIT
// A suit behind umockdev: programs that it starts, or that have its environment, find its USB devices.
#include "front/session.hpp"

#include <cstdio>
#include <exception>
#include <fstream>
#include <iterator>

namespace {

int refuse(const std::string &p_what) {
	(void)fprintf(stderr, "suit_emulator: %s\n", p_what.c_str());
	return 2;
}

} // namespace

int main(int p_count, char **p_arguments) {
	try {
		emulator::SuitOptions options;
		const std::string fault = options.parse({ p_arguments + 1, p_arguments + p_count });
		if (!fault.empty()) {
			return refuse(fault);
		}
		emulator::MotionStream stream = emulator::MotionStream::still(size_t(options.sensors));
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
