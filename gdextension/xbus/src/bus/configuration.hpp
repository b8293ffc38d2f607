// SPDX-License-Identifier: MIT
#pragma once

#include "bus/mt_data.hpp"

namespace xbus {

/// One tracker as a Configuration message (0x0D) describes it.
struct DeviceConfiguration {
	uint32_t device_id = 0;
	uint16_t data_length = 0;
	OutputFormat format;
	uint16_t scenario = 0;
	/// Major, minor, revision.
	std::array<uint8_t, 3> firmware{};
	/// Type, major, minor.
	std::array<uint8_t, 3> filter{};
};

/// How a parse went wrong.
enum class ConfigurationFault : uint8_t {
	NONE,
	/// Fewer bytes than the part that is always there.
	TOO_SHORT,
	/// The bytes do not fit the number of trackers that the message claims.
	WRONG_LENGTH,
	/// More trackers than MAX_DEVICES.
	TOO_MANY,
};

const char *configuration_fault_text(ConfigurationFault p_fault);

/// What a master (or a tracker that stands alone) is set to.
struct Configuration {
	/// Bytes before the trackers, and of each tracker.
	static constexpr std::size_t HEAD = 98;
	static constexpr std::size_t DEVICE = 20;
	static constexpr std::size_t MAX_BYTES = HEAD + DEVICE * MAX_DEVICES;

	uint32_t master_id = 0;
	/// 1/115200 s.
	uint16_t period = 0;
	uint16_t skip_factor = 0;
	uint16_t sync_in_mode = 0;
	uint16_t sync_in_skip = 0;
	uint32_t sync_in_offset = 0;
	/// ASCII, without a terminating zero: YYYYMMDD, HHMMSShh.
	std::array<char, 8> date{};
	std::array<char, 8> time{};
	std::array<uint8_t, 32> reserved_host{};
	std::array<uint8_t, 32> reserved_client{};
	std::size_t device_count = 0;
	std::array<DeviceConfiguration, MAX_DEVICES> devices{};

	/// Samples a second, with the skip factor; 0 if there is no period.
	double rate() const;
	/// Reads the data of a Configuration message. On a fault nothing is changed.
	ConfigurationFault parse(const uint8_t *p_data, std::size_t p_size);
	/// Writes the data; returns its size, at most MAX_BYTES.
	std::size_t write(uint8_t *r_bytes) const;
};

} // namespace xbus
