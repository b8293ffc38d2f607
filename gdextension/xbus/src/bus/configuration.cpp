// SPDX-License-Identifier: MIT
#include "bus/configuration.hpp"

#include "bus/bytes.hpp"

namespace xbus {

namespace {

constexpr std::size_t DATE_AT = 16;
constexpr std::size_t TIME_AT = 24;
constexpr std::size_t HOST_AT = 32;
constexpr std::size_t CLIENT_AT = 64;
constexpr std::size_t COUNT_AT = 96;
/// Length of SetPeriod's unit.
constexpr double TICKS_PER_SECOND = 115200.0;

void parse_device(const uint8_t *p_data, DeviceConfiguration &r_device) {
	r_device.device_id = read_u32(p_data);
	r_device.data_length = read_u16(p_data + 4);
	r_device.format.mode = read_u16(p_data + 6);
	r_device.format.settings = read_u32(p_data + 8);
	r_device.scenario = read_u16(p_data + 12);
	std::memcpy(r_device.firmware.data(), p_data + 14, r_device.firmware.size());
	std::memcpy(r_device.filter.data(), p_data + 17, r_device.filter.size());
}

void write_device(const DeviceConfiguration &p_device, uint8_t *r_bytes) {
	write_u32(p_device.device_id, r_bytes);
	write_u16(p_device.data_length, r_bytes + 4);
	write_u16(p_device.format.mode, r_bytes + 6);
	write_u32(p_device.format.settings, r_bytes + 8);
	write_u16(p_device.scenario, r_bytes + 12);
	std::memcpy(r_bytes + 14, p_device.firmware.data(), p_device.firmware.size());
	std::memcpy(r_bytes + 17, p_device.filter.data(), p_device.filter.size());
}

} // namespace

const char *configuration_fault_text(ConfigurationFault p_fault) {
	switch (p_fault) {
		case ConfigurationFault::NONE:
			return "no fault";
		case ConfigurationFault::TOO_SHORT:
			return "shorter than its 98 bytes without trackers";
		case ConfigurationFault::WRONG_LENGTH:
			return "its length does not fit the number of trackers that it claims";
		case ConfigurationFault::TOO_MANY:
			return "it claims more than 64 trackers";
	}
	return "";
}

double Configuration::rate() const {
	return period > 0 ? TICKS_PER_SECOND / (double(period) * (double(skip_factor) + 1.0)) : 0.0;
}

ConfigurationFault Configuration::parse(const uint8_t *p_data, std::size_t p_size) {
	if (p_size < HEAD) {
		return ConfigurationFault::TOO_SHORT;
	}
	const std::size_t count = read_u16(p_data + COUNT_AT);
	if (p_size != HEAD + count * DEVICE) {
		return ConfigurationFault::WRONG_LENGTH;
	}
	if (count > MAX_DEVICES) {
		return ConfigurationFault::TOO_MANY;
	}
	master_id = read_u32(p_data);
	period = read_u16(p_data + 4);
	skip_factor = read_u16(p_data + 6);
	sync_in_mode = read_u16(p_data + 8);
	sync_in_skip = read_u16(p_data + 10);
	sync_in_offset = read_u32(p_data + 12);
	std::memcpy(date.data(), p_data + DATE_AT, date.size());
	std::memcpy(time.data(), p_data + TIME_AT, time.size());
	std::memcpy(reserved_host.data(), p_data + HOST_AT, reserved_host.size());
	std::memcpy(reserved_client.data(), p_data + CLIENT_AT, reserved_client.size());
	device_count = count;
	for (std::size_t i = 0; i < count; i++) {
		parse_device(p_data + HEAD + i * DEVICE, devices[i]);
	}
	return ConfigurationFault::NONE;
}

std::size_t Configuration::write(uint8_t *r_bytes) const {
	const std::size_t count = device_count < MAX_DEVICES ? device_count : MAX_DEVICES;
	write_u32(master_id, r_bytes);
	write_u16(period, r_bytes + 4);
	write_u16(skip_factor, r_bytes + 6);
	write_u16(sync_in_mode, r_bytes + 8);
	write_u16(sync_in_skip, r_bytes + 10);
	write_u32(sync_in_offset, r_bytes + 12);
	std::memcpy(r_bytes + DATE_AT, date.data(), date.size());
	std::memcpy(r_bytes + TIME_AT, time.data(), time.size());
	std::memcpy(r_bytes + HOST_AT, reserved_host.data(), reserved_host.size());
	std::memcpy(r_bytes + CLIENT_AT, reserved_client.data(), reserved_client.size());
	write_u16(uint16_t(count), r_bytes + COUNT_AT);
	for (std::size_t i = 0; i < count; i++) {
		write_device(devices[i], r_bytes + HEAD + i * DEVICE);
	}
	return HEAD + count * DEVICE;
}

} // namespace xbus
