// SPDX-License-Identifier: MIT
#include "device/items.hpp"

#include <array>
#include <cstddef>
#include <type_traits>

namespace xbus {

namespace {

using F = Further;
using K = ItemKind;

#define AT(m_member) uint16_t(offsetof(FurtherValues, m_member))
#define TRIGGER_AT(m_index) uint16_t(offsetof(FurtherValues, triggers) + (m_index) * sizeof(Trigger))

// Offsets are taken of a class of the standard layout.
static_assert(std::is_standard_layout_v<FurtherValues>);

constexpr ItemType TYPES[] = {
	{},
	{ item::TEMPERATURE, K::REALS, 1, F::TEMPERATURE, AT(temperature), "Temperature" },
	{ item::UTC_TIME, K::UTC, 1, F::UTC_TIME, AT(utc), "UTCTime" },
	{ item::PACKET_COUNTER, K::U16, 1, F::COUNT, 0, "PacketCounter" },
	{ item::ITOW, K::U32, 1, F::ITOW, AT(itow), "ITOW" },
	{ item::GNSS_AGE, K::U8, 1, F::GNSS_AGE, AT(gnss_age), "GNSSAge" },
	{ item::PRESSURE_AGE, K::U8, 1, F::PRESSURE_AGE, AT(pressure_age), "PressureAge" },
	{ item::SAMPLE_TIME_FINE, K::U32, 1, F::COUNT, 0, "SampleTimeFine" },
	{ item::SAMPLE_TIME_COARSE, K::U32, 1, F::SAMPLE_TIME_COARSE, AT(sample_time_coarse), "SampleTimeCoarse" },
	{ item::FRAME_RANGE, K::RANGE, 1, F::FRAME_RANGE, AT(frame_range), "FrameRange" },
	{ item::PACKET_COUNTER_8, K::U8, 1, F::COUNT, 0, "PacketCounter8" },
	{ item::SAMPLE_TIME_64, K::U64, 1, F::SAMPLE_TIME_64, AT(sample_time_64), "SampleTime64" },
	{ item::PACKET_COUNTER_32, K::U32, 1, F::COUNT, 0, "PacketCounter32" },
	{ item::QUATERNION, K::REALS, 4, F::COUNT, 0, "Quaternion" },
	{ item::ROTATION_MATRIX, K::REALS, 9, F::COUNT, 0, "RotationMatrix" },
	{ item::EULER_ANGLES, K::REALS, 3, F::COUNT, 0, "EulerAngles" },
	{ item::BARO_PRESSURE, K::U32, 1, F::PRESSURE, AT(pressure), "BaroPressure" },
	{ item::DELTA_V, K::REALS, 3, F::DELTA_V, AT(delta_v), "DeltaV" },
	{ item::ACCELERATION, K::REALS, 3, F::COUNT, 0, "Acceleration" },
	{ item::FREE_ACCELERATION, K::REALS, 3, F::FREE_ACCELERATION, AT(free_acceleration), "FreeAcceleration" },
	{ item::ACCELERATION_HR, K::REALS, 3, F::ACCELERATION_HR, AT(acceleration_hr), "AccelerationHR" },
	{ item::TRIGGER_IN_1, K::TRIGGER, 1, F::TRIGGER_1, TRIGGER_AT(0), "TriggerIn1" },
	{ item::TRIGGER_IN_2, K::TRIGGER, 1, F::TRIGGER_2, TRIGGER_AT(1), "TriggerIn2" },
	{ item::TRIGGER_IN_3, K::TRIGGER, 1, F::TRIGGER_3, TRIGGER_AT(2), "TriggerIn3" },
	{ item::ALTITUDE_MSL, K::REALS, 1, F::ALTITUDE_MSL, AT(altitude_msl), "AltitudeMSL" },
	{ item::ALTITUDE_ELLIPSOID, K::REALS, 1, F::ALTITUDE_ELLIPSOID, AT(altitude_ellipsoid), "AltitudeEllipsoid" },
	{ item::POSITION_ECEF, K::REALS, 3, F::POSITION_ECEF, AT(position_ecef), "PositionECEF" },
	{ item::LAT_LON, K::REALS, 2, F::LAT_LON, AT(lat_lon), "LatLon" },
	{ item::GNSS_PVT_DATA, K::GNSS_PVT, 1, F::GNSS_PVT, AT(gnss_pvt), "GNSSPVTData" },
	{ item::GNSS_SAT_INFO, K::SATELLITES, 1, F::GNSS_SATELLITES, AT(gnss_satellites), "GNSSSatInfo" },
	{ item::GNSS_PVT_PULSE, K::U32, 1, F::GNSS_PULSE, AT(gnss_pulse), "GNSSPVTPulse" },
	{ item::RATE_OF_TURN, K::REALS, 3, F::COUNT, 0, "RateOfTurn" },
	{ item::DELTA_Q, K::REALS, 4, F::DELTA_Q, AT(delta_q), "DeltaQ" },
	{ item::RATE_OF_TURN_HR, K::REALS, 3, F::RATE_OF_TURN_HR, AT(rate_of_turn_hr), "RateOfTurnHR" },
	{ item::RAW_ACC_GYR_MAG_TEMP, K::RAW, 1, F::RAW_ACCELERATION, AT(raw_acceleration), "RawAccGyrMagTemp" },
	{ item::RAW_GYRO_TEMP, K::RAW_VECTOR, 1, F::RAW_GYRO_TEMPERATURE, AT(raw_gyro_temperature), "RawGyroTemp" },
	{ item::RAW_ACC, K::RAW_VECTOR, 1, F::RAW_ACCELERATION, AT(raw_acceleration), "RawAcc" },
	{ item::RAW_GYR, K::RAW_VECTOR, 1, F::RAW_RATE_OF_TURN, AT(raw_rate_of_turn), "RawGyr" },
	{ item::RAW_MAG, K::RAW_VECTOR, 1, F::RAW_MAGNETIC_FIELD, AT(raw_magnetic_field), "RawMag" },
	{ item::RAW_DELTA_Q, K::REALS, 4, F::RAW_DELTA_Q, AT(raw_delta_q), "RawDeltaQ" },
	{ item::RAW_DELTA_V, K::REALS, 3, F::RAW_DELTA_V, AT(raw_delta_v), "RawDeltaV" },
	{ item::RAW_BLOB, K::OPAQUE, 1, F::COUNT, 0, "RawBlob" },
	{ item::ANALOG_IN_1, K::U16, 1, F::ANALOG_IN_1, AT(analog_in_1), "AnalogIn1" },
	{ item::ANALOG_IN_2, K::U16, 1, F::ANALOG_IN_2, AT(analog_in_2), "AnalogIn2" },
	{ item::MAGNETIC_FIELD, K::REALS, 3, F::COUNT, 0, "MagneticField" },
	{ item::MAGNETIC_FIELD_CORRECTED, K::REALS, 3, F::MAGNETIC_FIELD_CORRECTED, AT(magnetic_field_corrected),
			"MagneticFieldCorrected" },
	{ item::AWINDA_SNAPSHOT, K::AWINDA, 1, F::SNAPSHOT, AT(snapshot), "AwindaSnapshot" },
	{ item::FULL_SNAPSHOT, K::FULL_SNAPSHOT, 1, F::SNAPSHOT, AT(snapshot), "FullSnapshot" },
	{ 0xC830, K::OPAQUE, 1, F::COUNT, 0, "GloveSnapshotLeft" },
	{ 0xC840, K::OPAQUE, 1, F::COUNT, 0, "GloveSnapshotRight" },
	{ 0xCA30, K::OPAQUE, 1, F::COUNT, 0, "GloveDataLeft" },
	{ 0xCA40, K::OPAQUE, 1, F::COUNT, 0, "GloveDataRight" },
	{ item::VELOCITY_XYZ, K::REALS, 3, F::VELOCITY, AT(velocity), "VelocityXYZ" },
	{ item::STATUS_BYTE, K::U8, 1, F::STATUS_BYTE, AT(status_byte), "StatusByte" },
	{ item::STATUS_WORD, K::U32, 1, F::COUNT, 0, "StatusWord" },
	{ item::RSSI, K::U8, 1, F::RSSI, AT(rssi), "RSSI" },
	{ item::DEVICE_ID, K::U32, 1, F::DEVICE_ID, AT(device_id), "DeviceID" },
	{ item::LOCATION_ID, K::U16, 1, F::LOCATION_ID, AT(location_id), "LocationID" },
};

#undef AT
#undef TRIGGER_AT

constexpr std::size_t TYPE_COUNT = sizeof(TYPES) / sizeof(TYPES[0]);

constexpr std::array<uint8_t, 4096> indices() {
	std::array<uint8_t, 4096> found{};
	for (std::size_t i = 1; i < TYPE_COUNT; i++) {
		found[TYPES[i].type >> 4U] = uint8_t(i);
	}
	return found;
}

/// Index in TYPES of each type; 0 if it has none.
constexpr std::array<uint8_t, 4096> INDICES = indices();

} // namespace

bool ItemType::has_axes() const {
	return type == item::QUATERNION || type == item::ROTATION_MATRIX || type == item::EULER_ANGLES ||
			type == item::VELOCITY_XYZ;
}

const ItemType &item_type(uint16_t p_id) {
	return TYPES[INDICES[uint32_t(p_id) >> 4U]];
}

const char *axes_name(Axes p_axes) {
	switch (p_axes) {
		case Axes::EAST_NORTH_UP:
			return "ENU";
		case Axes::NORTH_EAST_DOWN:
			return "NED";
		case Axes::NORTH_WEST_UP:
			return "NWU";
		case Axes::UNKNOWN:
			break;
	}
	return "unknown";
}

const char *number_format_name(NumberFormat p_format) {
	switch (p_format) {
		case NumberFormat::FLOAT:
			return "float32";
		case NumberFormat::FIXED_12_20:
			return "fixed12.20";
		case NumberFormat::FIXED_16_32:
			return "fixed16.32";
		case NumberFormat::DOUBLE:
			return "float64";
	}
	return "";
}

} // namespace xbus
