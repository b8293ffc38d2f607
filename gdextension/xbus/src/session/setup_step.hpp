// SPDX-License-Identifier: MIT
#pragma once

#include "bus/requests.hpp"
#include "session/known_device.hpp"
#include "session/output_choice.hpp"

#include <cstdint>

namespace xbus {

/// The steps of bringing a device up (docs/suits.md, "Bringing a suit up"), and what comes after them.
enum class SetupStep : uint8_t {
	PAUSE,
	GO_TO_CONFIG,
	DEVICE_ID,
	INIT_BUS,
	BUS_POWER,
	CONFIGURATION,
	SET_BAUD,
	REBOOT,
	OUTPUT_MODE,
	OUTPUT_SETTINGS,
	PERIOD,
	SKIP_FACTOR,
	DATA_LENGTH,
	OUTPUT_CONFIGURATION,
	BATTERY,
	MEASURE,
	MEASURING,
	STOP,
	STOPPED,
	UNSUPPORTED,
};

/// How long a step's answer is waited for, and how often it is asked for.
struct Patience {
	uint64_t limit_usec;
	int tries;
	/// Whether it goes on without an answer.
	bool is_optional;
};

Patience patience(SetupStep p_step);
/// The step after the answer to one.
SetupStep step_after(SetupStep p_step, const KnownDevice &p_device);
/// What is asked in a step, of whom a bus identifier names where it is about trackers.
Request request_of(SetupStep p_step, const OutputChoice &p_choice, uint8_t p_bus_id);
/// Whether a step sets up the trackers: of a slow device all of these are asked at once.
constexpr bool is_of_trackers(SetupStep p_step) {
	return p_step == SetupStep::OUTPUT_MODE || p_step == SetupStep::OUTPUT_SETTINGS || p_step == SetupStep::PERIOD;
}

} // namespace xbus
