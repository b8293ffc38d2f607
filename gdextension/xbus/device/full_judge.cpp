// SPDX-License-Identifier: MIT
#include "device/full_judge.hpp"

#include <cstdlib>

namespace xbus {

namespace {

constexpr double MAX_TEMPERATURE = 200.0;
constexpr double MAX_SPEED = 10000.0;
constexpr double MAX_ALTITUDE = 1.0e6;
constexpr double MAX_DISTANCE = 1.0e8;
constexpr uint32_t MAX_PRESSURE = 200000;

/// A device without a fix may send zeros: only what no clock shows is refused.
bool is_time(const UtcTime &p_utc) {
	return p_utc.nanoseconds < 1000000000U && p_utc.month <= 12 && p_utc.day <= 31 && p_utc.hour <= 23 &&
			p_utc.minute <= 59 && p_utc.second <= 60;
}

bool is_pvt(const GnssPvt &p_pvt) {
	UtcTime utc = p_pvt.utc;
	utc.nanoseconds = 0;
	return is_time(utc) && std::abs(int64_t(p_pvt.longitude)) <= 1800000000 &&
			std::abs(int64_t(p_pvt.latitude)) <= 900000000;
}

bool is_position_in_range(const FullSample &p_sample) {
	const auto good = [&](Further p_field, bool p_good) { return !p_sample.has(p_field) || p_good; };
	const auto &lat_lon = p_sample.lat_lon;
	const auto &position = p_sample.position;
	return good(Further::LAT_LON, is_within(lat_lon[0], 90.0) && is_within(lat_lon[1], 360.0)) &&
			good(Further::POSITION,
					is_within(position[0], 90.0) && is_within(position[1], 360.0) &&
							is_within(position[2], MAX_ALTITUDE)) &&
			good(Further::ALTITUDE_MSL, is_within(p_sample.altitude_msl, MAX_ALTITUDE)) &&
			good(Further::ALTITUDE_ELLIPSOID, is_within(p_sample.altitude_ellipsoid, MAX_ALTITUDE)) &&
			good(Further::POSITION_ECEF, is_within(p_sample.position_ecef, MAX_DISTANCE)) &&
			good(Further::VELOCITY, is_within(p_sample.velocity, MAX_SPEED));
}

bool is_further_in_range(const FullSample &p_sample) {
	const auto good = [&](Further p_field, bool p_good) { return !p_sample.has(p_field) || p_good; };
	return is_position_in_range(p_sample) &&
			good(Further::FREE_ACCELERATION, is_within(p_sample.free_acceleration, MAX_ACCELERATION)) &&
			good(Further::ACCELERATION_HR, is_within(p_sample.acceleration_hr, MAX_ACCELERATION)) &&
			good(Further::DELTA_V, is_within(p_sample.delta_v, MAX_ACCELERATION)) &&
			good(Further::RATE_OF_TURN_HR, is_within(p_sample.rate_of_turn_hr, MAX_RATE)) &&
			good(Further::MAGNETIC_FIELD_CORRECTED, is_within(p_sample.magnetic_field_corrected, MAX_FIELD)) &&
			good(Further::TEMPERATURE, is_within(p_sample.temperature, MAX_TEMPERATURE)) &&
			good(Further::PRESSURE, p_sample.pressure <= MAX_PRESSURE) &&
			good(Further::UTC_TIME, is_time(p_sample.utc)) && good(Further::GNSS_PVT, is_pvt(p_sample.gnss_pvt));
}

} // namespace

bool is_in_range(const FullSample &p_sample) {
	return is_in_range(static_cast<const Sample &>(p_sample)) && is_further_in_range(p_sample);
}

bool FurtherJudge::accept(const FullSample &p_sample) {
	const bool good = is_further_in_range(p_sample) &&
			(!p_sample.has(Further::DELTA_Q) || _delta_q.accept(norm_deviation(p_sample.delta_q)));
	const bool is_sick = _nonsense.is_sick(good);
	return good || is_sick;
}

} // namespace xbus
