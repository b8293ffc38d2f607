// SPDX-License-Identifier: MIT
#include "stop_signal.hpp"

#include <csignal>

namespace godot {

namespace {

// Signals belong to the process: so does what they leave behind.
volatile std::sig_atomic_t raised = 0;

void on_signal(int p_signal) {
	raised = 1;
	// Whoever asks a second time does not want to wait.
	std::signal(p_signal, SIG_DFL);
}

} // namespace

bool StopSignal::watch() {
	raised = 0;
	return std::signal(SIGTERM, on_signal) != SIG_ERR && std::signal(SIGINT, on_signal) != SIG_ERR;
}

bool StopSignal::is_raised() const {
	return raised != 0;
}

void StopSignal::_bind_methods() {
	ClassDB::bind_method(D_METHOD("watch"), &StopSignal::watch);
	ClassDB::bind_method(D_METHOD("is_raised"), &StopSignal::is_raised);
}

} // namespace godot
