// SPDX-License-Identifier: MIT
#pragma once

#include "bus/mt_data.hpp"
#include "cable/random.hpp"
#include "device/full_sample.hpp"
#include "suit/motion_stream.hpp"

#include <array>

namespace emulator {

/// m/s2.
constexpr double GRAVITY = 9.81;

/// How a sensor sits on its limb, and how good it is.
struct Mounting {
	/// The sensor's axes in the limb's: whoever puts a suit on mounts them at any angle.
	kinematics::Quat rotation;
	/// How far the sensor's idea of north is turned from the others', rad.
	double heading = 0.0;
	/// Drift of the heading, rad/s.
	double drift = 0.0;
	/// Standard deviation of the noise of the orientation, rad.
	double noise = 0.0;

	/// By chance: at any angle, with headings up to `p_heading` rad apart.
	static Mounting random(Random &r_random, double p_heading);
};

/// What a tracker measures at one moment, in its own frame.
struct Reading {
	kinematics::Quat orientation;
	/// m/s2, with gravity: at rest 9.81 upwards.
	std::array<double, 3> acceleration{};
	/// rad/s.
	std::array<double, 3> rate{};
	/// Of the earth's field.
	std::array<double, 3> magnetic{};
	double temperature = 0.0;
};

/// The reading as a sample in these axes of the world, at so many seconds of the motion: all that a tracker sends.
xbus::FullSample sample_of(const Reading &p_reading, xbus::Axes p_axes, uint16_t p_counter, double p_time_s);

/// One MT: what it measures, how it is set, how it writes its part of MTData.
class Tracker {
public:
	uint32_t device_id = 0;
	uint16_t mode = 0x0006;
	/// Quaternions as floats with the sample counter: what the factory sets.
	uint32_t settings = 0x00000001;
	uint16_t skip_factor = 0;
	uint16_t filter_scenario = 0x0102;
	Mounting mounting;
	/// Which limb of the stream it sits on.
	std::size_t limb = 0;
	/// Bytes by which its data differ from the length that it reports: a fault.
	int length_fault = 0;

	/// @param p_runs whether the motion goes on; who holds still neither turns nor is accelerated
	Reading read(const MotionStream &p_stream, double p_time_s, bool p_runs, Random &r_random) const;
	/// What its settings ask for of MTData, less what does not exist.
	xbus::OutputFormat format() const;
	/// Bytes of its part of MTData. Behind a master there is no counter of its own.
	std::size_t data_size(bool p_is_behind_master) const;
	/// Writes that part; `r_bytes` has room for LONGEST. Returns the bytes written.
	std::size_t write_data(
			const Reading &p_reading, bool p_is_behind_master, uint16_t p_counter, uint8_t *r_bytes) const;

	static constexpr std::size_t LONGEST = 512;
};

} // namespace emulator
