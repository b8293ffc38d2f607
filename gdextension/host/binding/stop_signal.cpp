// SPDX-License-Identifier: MIT
#include "stop_signal.hpp"

#include <csignal>
#include <ctime>

namespace godot {

namespace {

// Signals belong to the process: so does what they leave behind.
volatile std::sig_atomic_t raised = 0;
volatile std::sig_atomic_t reload_asked = 0;
// Whether a signal leads here.
bool is_watching = false;
bool is_watching_reload = false;
// When the first came, s of the monotonic clock.
volatile time_t raised_s = 0;
// A program that has not ended by then hangs: the next signal ends it at once.
constexpr time_t PATIENCE_S = 10;

time_t monotonic_s() {
	timespec now{};
	clock_gettime(CLOCK_MONOTONIC, &now);
	return now.tv_sec;
}

void on_signal(int p_signal) {
	if (raised == 0) {
		raised_s = monotonic_s();
		raised = 1;
	} else if (monotonic_s() - raised_s > PATIENCE_S) {
		std::signal(p_signal, SIG_DFL);
		(void)std::raise(p_signal);
	}
}

void on_reload(int /*p_signal*/) {
	reload_asked = 1;
}

} // namespace

bool StopSignal::watch() {
	raised = 0;
	is_watching = true;
	return std::signal(SIGTERM, on_signal) != SIG_ERR && std::signal(SIGINT, on_signal) != SIG_ERR;
}

bool StopSignal::is_raised() const {
	return raised != 0;
}

bool StopSignal::watch_reload() {
	reload_asked = 0;
	is_watching_reload = true;
	return std::signal(SIGHUP, on_reload) != SIG_ERR;
}

bool StopSignal::take_reload() {
	const bool was_asked = reload_asked != 0;
	reload_asked = 0;
	return was_asked;
}

void StopSignal::forget() {
	// The program ends anyhow, and this library leaves before it.
	if (is_watching) {
		std::signal(SIGTERM, SIG_IGN);
		std::signal(SIGINT, SIG_IGN);
	}
	if (is_watching_reload) {
		std::signal(SIGHUP, SIG_IGN);
	}
}

void StopSignal::_bind_methods() {
	ClassDB::bind_method(D_METHOD("watch_reload"), &StopSignal::watch_reload);
	ClassDB::bind_method(D_METHOD("take_reload"), &StopSignal::take_reload);
	ClassDB::bind_method(D_METHOD("watch"), &StopSignal::watch);
	ClassDB::bind_method(D_METHOD("is_raised"), &StopSignal::is_raised);
}

} // namespace godot
