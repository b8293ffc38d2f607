// SPDX-License-Identifier: MIT
#pragma once

#include "bus/sample.hpp"

// What the product does not read of samples: for the decoder, the emulated suit, tests and benchmarks.

namespace xbus {

/// What a sample may hold besides `Field`; bits of FullSample::further_present are 1 << field.
enum class Further : uint8_t {
	TEMPERATURE,
	UTC_TIME,
	ITOW,
	GNSS_AGE,
	PRESSURE_AGE,
	SAMPLE_TIME_COARSE,
	FRAME_RANGE,
	SAMPLE_TIME_64,
	PRESSURE,
	DELTA_V,
	FREE_ACCELERATION,
	ACCELERATION_HR,
	TRIGGER_1,
	TRIGGER_2,
	TRIGGER_3,
	ALTITUDE_MSL,
	ALTITUDE_ELLIPSOID,
	POSITION_ECEF,
	LAT_LON,
	GNSS_PVT,
	GNSS_SATELLITES,
	GNSS_PULSE,
	DELTA_Q,
	RATE_OF_TURN_HR,
	RAW_ACCELERATION,
	RAW_RATE_OF_TURN,
	RAW_MAGNETIC_FIELD,
	RAW_TEMPERATURE,
	RAW_GYRO_TEMPERATURE,
	RAW_DELTA_Q,
	RAW_DELTA_V,
	ANALOG_IN_1,
	ANALOG_IN_2,
	MAGNETIC_FIELD_CORRECTED,
	SNAPSHOT,
	VELOCITY,
	/// Legacy position: latitude and longitude in degrees, altitude in metres.
	POSITION,
	GPS_PVT,
	STATUS_BYTE,
	RSSI,
	DEVICE_ID,
	LOCATION_ID,
	COUNT,
};

static_assert(std::size_t(Further::COUNT) <= 64);

struct UtcTime {
	uint32_t nanoseconds = 0;
	uint16_t year = 0;
	uint8_t month = 0;
	uint8_t day = 0;
	uint8_t hour = 0;
	uint8_t minute = 0;
	uint8_t second = 0;
	/// Bit 0: date, 1: time of day, 2: fully resolved.
	uint8_t validity = 0;
};

/// GNSS position, velocity and time, in the units of the receiver (u-blox NAV-PVT).
struct GnssPvt {
	/// GPS time of week, ms.
	uint32_t itow = 0;
	UtcTime utc;
	/// Accuracy of the time, ns.
	uint32_t time_accuracy = 0;
	/// Fraction of the second, ns, -10^9 to 10^9.
	int32_t nanoseconds = 0;
	uint8_t fix_type = 0;
	uint8_t flags = 0;
	uint8_t satellites = 0;
	uint8_t reserved = 0;
	/// 10^-7 degrees.
	int32_t longitude = 0;
	int32_t latitude = 0;
	/// Above the ellipsoid, above the sea, mm.
	int32_t height = 0;
	int32_t height_msl = 0;
	/// mm.
	uint32_t horizontal_accuracy = 0;
	uint32_t vertical_accuracy = 0;
	/// mm/s.
	int32_t velocity_north = 0;
	int32_t velocity_east = 0;
	int32_t velocity_down = 0;
	int32_t ground_speed = 0;
	/// 10^-5 degrees.
	int32_t heading_of_motion = 0;
	/// mm/s.
	uint32_t speed_accuracy = 0;
	/// 10^-5 degrees.
	uint32_t heading_accuracy = 0;
	int32_t heading_of_vehicle = 0;
	/// Geometric, position, time, vertical, horizontal, northing, easting dilution, 0.01.
	std::array<uint16_t, 7> dilutions{};
};

struct Satellite {
	uint8_t system = 0;
	uint8_t number = 0;
	/// Carrier to noise, dBHz.
	uint8_t signal = 0;
	uint8_t flags = 0;
};

struct GnssSatellites {
	/// As many as an item's one length byte allows.
	static constexpr std::size_t MAX = 61;
	/// GPS time of week, ms.
	uint32_t itow = 0;
	uint8_t count = 0;
	std::array<Satellite, MAX> satellites{};
};

/// An edge on an input line.
struct Trigger {
	uint8_t line = 0;
	uint8_t polarity = 0;
	uint32_t time = 0;
	uint16_t frame = 0;
};

/// The increments that a wireless tracker sends instead of orientations, in the tracker's own units: only
/// Xsens' closed software turns them into orientations.
struct Snapshot {
	bool is_full = false;
	bool is_retransmission = false;
	uint32_t device_id = 0;
	uint32_t frame = 0;
	uint64_t time = 0;
	/// Four values in a full snapshot, three in an Awinda snapshot.
	std::array<int32_t, 4> delta_q{};
	std::array<int64_t, 3> delta_v{};
	std::array<int32_t, 3> magnetic_field{};
	int32_t pressure = 0;
	uint16_t status = 0;
	uint8_t acceleration_clips = 0;
	uint8_t rate_clips = 0;
};

/// GPS position, velocity, time and pressure of a legacy MTi-G.
struct GpsPvt {
	uint16_t pressure = 0;
	uint8_t pressure_age = 0;
	/// Time of week, ms.
	uint32_t itow = 0;
	/// 10^-7 degrees, mm.
	int32_t latitude = 0;
	int32_t longitude = 0;
	int32_t height = 0;
	/// cm/s.
	int32_t velocity_north = 0;
	int32_t velocity_east = 0;
	int32_t velocity_down = 0;
	/// mm, mm, cm/s.
	uint32_t horizontal_accuracy = 0;
	uint32_t vertical_accuracy = 0;
	uint32_t speed_accuracy = 0;
	uint8_t age = 0;
};

/// The values of `Further`.
struct FurtherValues {
	using Vector = Sample::Vector;

	uint64_t further_present = 0;
	/// s.
	uint32_t sample_time_coarse = 0;
	uint64_t sample_time_64 = 0;
	UtcTime utc;
	/// First and last frame.
	std::array<uint16_t, 2> frame_range{};
	/// ms.
	uint32_t itow = 0;
	uint8_t gnss_age = 0;
	uint8_t pressure_age = 0;

	/// m/s^2; without gravity (in the world's axes), and not filtered.
	Vector free_acceleration{};
	Vector acceleration_hr{};
	/// m/s in one sample's time.
	Vector delta_v{};
	/// rad/s, not filtered.
	Vector rate_of_turn_hr{};
	/// w, x, y, z in one sample's time.
	std::array<double, 4> delta_q{};
	/// The earth's field is 1 where the tracker was calibrated.
	Vector magnetic_field_corrected{};
	/// Degrees Celsius.
	double temperature = 0.0;
	/// Pa.
	uint32_t pressure = 0;

	/// m.
	double altitude_msl = 0.0;
	double altitude_ellipsoid = 0.0;
	Vector position_ecef{};
	/// Degrees.
	std::array<double, 2> lat_lon{};
	/// Degrees, degrees, m.
	Vector position{};
	/// m/s.
	Vector velocity{};

	/// As the converters gave them.
	std::array<uint16_t, 3> raw_acceleration{};
	std::array<uint16_t, 3> raw_rate_of_turn{};
	std::array<uint16_t, 3> raw_magnetic_field{};
	std::array<uint16_t, 3> raw_gyro_temperature{};
	uint16_t raw_temperature = 0;
	std::array<double, 4> raw_delta_q{};
	Vector raw_delta_v{};
	uint16_t analog_in_1 = 0;
	uint16_t analog_in_2 = 0;

	uint8_t status_byte = 0;
	/// dBm.
	int8_t rssi = 0;
	uint16_t location_id = 0;
	uint32_t device_id = 0;

	GnssPvt gnss_pvt;
	GnssSatellites gnss_satellites;
	uint32_t gnss_pulse = 0;
	GpsPvt gps_pvt;
	std::array<Trigger, 3> triggers{};
	Snapshot snapshot;
};

/// Everything that one tracker can say of one moment.
struct FullSample : Sample, FurtherValues {
	FullSample() = default;
	explicit FullSample(const Sample &p_sample) : Sample(p_sample) {}

	using Sample::has;
	using Sample::set;
	bool has(Further p_field) const { return (further_present >> unsigned(p_field) & 1U) != 0; }
	void set(Further p_field) { further_present |= uint64_t(1) << unsigned(p_field); }
	void clear() {
		Sample::clear();
		further_present = 0;
	}
	bool is_empty() const { return present == 0 && further_present == 0; }
};

} // namespace xbus
