// SPDX-License-Identifier: MIT
#pragma once

#include "bus/sample.hpp"

#include <array>
#include <cstdint>

namespace xbus {

/// Trackers on one master at most (the old host class of Xsens allows 20).
constexpr int MAX_TRACKERS = 20;

/// What one tracker said in one sample, in the tracker's own axes.
struct TrackerReading {
	/// Rotation from the tracker's axes to its global frame: w, x, y, z.
	std::array<float, 4> orientation{ 1.0F, 0.0F, 0.0F, 0.0F };
	/// Rate of turn, rad/s.
	std::array<float, 3> rate{};
	/// Acceleration with gravity, m/s2.
	std::array<float, 3> acceleration{};
	/// The magnetic field, 1 being the earth's where the tracker was calibrated.
	std::array<float, 3> magnetic{};
	bool has_orientation = false;
	bool has_rate = false;
	bool has_acceleration = false;
	bool has_magnetic = false;
};

/// One sample of all trackers of a master.
struct SuitFrame {
	/// When its last byte came in, µs of CLOCK_MONOTONIC.
	uint64_t arrival_usec = 0;
	/// When it was sampled as far as that can be known: counted on from the quickest arrivals, µs of
	/// CLOCK_MONOTONIC. Without the jitter of the bus, but with its least delay.
	uint64_t time_usec = 0;
	/// The device's sample counter, counted on over its wraps.
	uint64_t counter = 0;
	/// The global frame that orientations refer to: right-handed; a bus has X magnetic north, Y west, Z up.
	Axes axes = Axes::NORTH_WEST_UP;
	int tracker_count = 0;
	std::array<TrackerReading, MAX_TRACKERS> trackers;
};

} // namespace xbus
