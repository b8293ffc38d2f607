// SPDX-License-Identifier: MIT
#pragma once

#include "device/full_sample.hpp"

// Structures as they lie on the bus. Readers take bytes that are there; writers return what they wrote.

namespace xbus {

constexpr std::size_t GNSS_PVT_SIZE = 94;
constexpr std::size_t AWINDA_SNAPSHOT_SIZE = 46;
constexpr std::size_t FULL_SNAPSHOT_SIZE = 70;

void read_utc(const uint8_t *p_data, UtcTime &r_utc);
std::size_t write_utc(const UtcTime &p_utc, uint8_t *r_bytes);

void read_trigger(const uint8_t *p_data, Trigger &r_trigger);
std::size_t write_trigger(const Trigger &p_trigger, uint8_t *r_bytes);

void read_gnss_pvt(const uint8_t *p_data, GnssPvt &r_pvt);
std::size_t write_gnss_pvt(const GnssPvt &p_pvt, uint8_t *r_bytes);

/// The bytes' own count of satellites has been checked against their number.
void read_satellites(const uint8_t *p_data, GnssSatellites &r_satellites);
std::size_t write_satellites(const GnssSatellites &p_satellites, uint8_t *r_bytes);

void read_awinda_snapshot(const uint8_t *p_data, Snapshot &r_snapshot);
std::size_t write_awinda_snapshot(const Snapshot &p_snapshot, uint8_t *r_bytes);
void read_full_snapshot(const uint8_t *p_data, Snapshot &r_snapshot);
std::size_t write_full_snapshot(const Snapshot &p_snapshot, uint8_t *r_bytes);

void read_raw_vector(const uint8_t *p_data, std::array<uint16_t, 3> &r_vector);
std::size_t write_raw_vector(const std::array<uint16_t, 3> &p_vector, uint8_t *r_bytes);
/// Accelerations, rates, magnetic field, temperature: ten numbers of 16 bits.
void read_raw(const uint8_t *p_data, FullSample &r_sample);
std::size_t write_raw(const FullSample &p_sample, uint8_t *r_bytes);

void read_gps_pvt(const uint8_t *p_data, GpsPvt &r_pvt);
std::size_t write_gps_pvt(const GpsPvt &p_pvt, uint8_t *r_bytes);

} // namespace xbus
