// SPDX-License-Identifier: MIT
#pragma once

#include "bus/encoder.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace xbus {

/// What trackers are asked to send.
struct Outputs {
	uint16_t mode = 0;
	uint32_t settings = 0;
	/// Between two samples, 1/115200 s.
	uint16_t period = 0;

	double rate_hz() const { return period > 0 ? 115200.0 / period : 0.0; }
};

/// What is asked for, the most first: what a line or a device does not bear is left out step by step.
struct Demand {
	uint16_t mode;
	uint32_t settings;
	/// Bytes of one tracker, in single precision.
	std::size_t block;
};

/// Bits of the output mode and settings (docs/xbus.md).
constexpr uint16_t MODE_CALIBRATED = 0x0002;
constexpr uint16_t MODE_ORIENTATION = 0x0004;
constexpr uint32_t SETTINGS_COUNTER = 0x0001;
constexpr uint32_t SETTINGS_NO_ACCELERATION = 0x0010;
constexpr uint32_t SETTINGS_NO_MAGNETIC_FIELD = 0x0040;

constexpr std::array<Demand, 4> DEMANDS = { {
		{ MODE_CALIBRATED | MODE_ORIENTATION, 0, 52 },
		{ MODE_CALIBRATED | MODE_ORIENTATION, SETTINGS_NO_MAGNETIC_FIELD, 40 },
		{ MODE_CALIBRATED | MODE_ORIENTATION, SETTINGS_NO_ACCELERATION | SETTINGS_NO_MAGNETIC_FIELD, 28 },
		{ MODE_ORIENTATION, 0, 16 },
} };
/// The speed that a slower line is set to where it does not carry the samples, bit/s.
constexpr uint32_t FAST_BAUD = 460800;
/// Rates that a line is brought down to, Hz.
constexpr std::array<double, 8> RATES = { 100.0, 75.0, 60.0, 50.0, 40.0, 30.0, 20.0, 10.0 };
constexpr uint16_t MIN_PERIOD = 225;
constexpr uint16_t MAX_PERIOD = 11520;

/// The period of a rate, in 1/115200 s.
constexpr uint16_t period_of(double p_rate_hz) {
	return uint16_t(std::clamp(115200.0 / std::max(p_rate_hz, 0.1) + 0.5, double(MIN_PERIOD), double(MAX_PERIOD)));
}

/// Whether a line of `p_baud` (0: of any speed) carries a master's samples, with a tenth of it to spare.
constexpr bool fits(uint32_t p_baud, std::size_t p_block, int p_trackers, double p_rate_hz) {
	constexpr double BITS_PER_BYTE = 11.0; // With two stop bits.
	const std::size_t bytes = frame_size(2 + p_block * std::size_t(p_trackers));
	return p_baud == 0 || double(bytes) * BITS_PER_BYTE * p_rate_hz <= 0.9 * p_baud;
}

/// The greatest rate up to `p_rate_hz` that a line carries, Hz.
constexpr double rate_that_fits(uint32_t p_baud, std::size_t p_block, int p_trackers, double p_rate_hz) {
	if (fits(p_baud, p_block, p_trackers, p_rate_hz)) {
		return p_rate_hz;
	}
	for (const double rate : RATES) {
		if (rate < p_rate_hz && fits(p_baud, p_block, p_trackers, rate)) {
			return rate;
		}
	}
	return RATES.back();
}

} // namespace xbus
