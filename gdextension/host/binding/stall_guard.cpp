// SPDX-License-Identifier: MIT
#include "stall_guard.hpp"

#include <chrono>

namespace godot {

namespace {

std::vector<std::string> to_command(const PackedStringArray &p_command) {
	std::vector<std::string> command;
	command.reserve(static_cast<size_t>(p_command.size()));
	for (int64_t i = 0; i < p_command.size(); ++i) {
		command.emplace_back(p_command[i].utf8().get_data());
	}
	return command;
}

} // namespace

StallGuard::~StallGuard() {
	stop();
}

bool StallGuard::start(double p_patience_s, const PackedStringArray &p_command) {
	ERR_FAIL_COND_V_MSG(p_command.is_empty(), false,
			"The stall guard has no program to start: give it the path and its arguments.");
	ERR_FAIL_COND_V_MSG(!(p_patience_s > 0.0), false, "The stall guard's patience must be above 0 s.");
	// Copied here: once the main loop stands still, nothing of the engine is touched.
	const std::vector<std::string> command = to_command(p_command);
	const auto patience = std::chrono::milliseconds(static_cast<int64_t>(p_patience_s * 1000.0));
	return _guard.start(patience, [command] { host::replace_program(command); });
}

void StallGuard::beat() {
	_guard.beat();
}

void StallGuard::hold() {
	_guard.hold();
}

void StallGuard::stop() {
	_guard.stop();
}

Error StallGuard::replace(const PackedStringArray &p_command) {
	ERR_FAIL_COND_V_MSG(p_command.is_empty(), ERR_INVALID_PARAMETER,
			"There is no program to start: give its path and its arguments.");
	return host::replace_program(to_command(p_command)) == 0 ? OK : ERR_CANT_FORK;
}

void StallGuard::_bind_methods() {
	ClassDB::bind_method(D_METHOD("start", "patience_s", "command"), &StallGuard::start);
	ClassDB::bind_method(D_METHOD("beat"), &StallGuard::beat);
	ClassDB::bind_method(D_METHOD("hold"), &StallGuard::hold);
	ClassDB::bind_method(D_METHOD("stop"), &StallGuard::stop);
	ClassDB::bind_static_method(get_class_static(), D_METHOD("replace", "command"), &StallGuard::replace);
}

} // namespace godot
