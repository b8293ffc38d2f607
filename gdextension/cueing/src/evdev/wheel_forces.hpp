// SPDX-License-Identifier: MIT
#pragma once

// The kernel's header of input devices defines the names of keys as macros, which the engine's headers do not bear:
// it is not included here.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace cueing {

/// The effects of a wheel, the most important first: a device may have room for few.
enum class ForceKind {
	CONSTANT,
	SPRING,
	DAMPER,
	PERIODIC,
};

constexpr std::size_t FORCE_KINDS = 4;
constexpr std::array<ForceKind, FORCE_KINDS> ALL_FORCE_KINDS = { ForceKind::CONSTANT, ForceKind::SPRING,
	ForceKind::DAMPER, ForceKind::PERIODIC };

/// What a wheel's motor does. Shares are of the most that the wheel can.
struct WheelForces {
	/// -1 (turns it to the left) to 1.
	double constant = 0.0;
	/// How steeply a spring pulls to spring_centre, 0 to 1.
	double spring = 0.0;
	/// -1 (left end) to 1.
	double spring_centre = 0.0;
	/// Part of the way around the centre in which the spring does nothing, 0 to 1.
	double spring_dead_band = 0.0;
	/// How much it resists being turned, by its speed, 0 to 1.
	double damper = 0.0;
	/// Strength of a vibration, 0 to 1, and its frequency, Hz.
	double periodic = 0.0;
	double periodic_hz = 20.0;
};

const char *force_name(ForceKind p_kind);

/// An input device with force feedback, as the system lists it.
struct ForceDeviceInfo {
	/// Such as /dev/input/event5.
	std::string path;
	std::string name;
	uint16_t vendor = 0;
	uint16_t product = 0;
	/// By ForceKind.
	std::array<bool, FORCE_KINDS> can{};
	/// Why it cannot be used, with what helps; empty if it can.
	std::string error;

	/// Whether its motor can push: gamepads only shake.
	bool is_wheel() const { return can[std::size_t(ForceKind::CONSTANT)]; }
};

/// All of them, by number. Needs no rights to the devices themselves.
std::vector<ForceDeviceInfo> list_force_devices();

} // namespace cueing
