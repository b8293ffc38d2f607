// SPDX-License-Identifier: MIT
#include "session/setup_step.hpp"

namespace xbus {

namespace {

constexpr uint8_t FAST_BAUD_CODE = 0x00;

} // namespace

Patience patience(SetupStep p_step) {
	switch (p_step) {
		case SetupStep::GO_TO_CONFIG:
		case SetupStep::STOP:
			return { 150000, 3, false };
		case SetupStep::INIT_BUS:
			return { 3000000, 2, false };
		case SetupStep::CONFIGURATION:
			return { 800000, 2, true };
		case SetupStep::BATTERY:
		case SetupStep::DATA_LENGTH:
		case SetupStep::SKIP_FACTOR:
			return { 250000, 2, true };
		case SetupStep::SET_BAUD:
			return { 500000, 2, false };
		case SetupStep::MEASURE:
			return { 1000000, 3, false };
		default:
			return { 500000, 3, false };
	}
}

SetupStep step_after(SetupStep p_step, const KnownDevice &p_device) {
	switch (p_step) {
		case SetupStep::GO_TO_CONFIG:
			return SetupStep::DEVICE_ID;
		case SetupStep::DEVICE_ID:
			return p_device.is_master() ? SetupStep::INIT_BUS : SetupStep::CONFIGURATION;
		case SetupStep::BUS_POWER:
			return SetupStep::INIT_BUS;
		case SetupStep::INIT_BUS:
			return SetupStep::CONFIGURATION;
		case SetupStep::CONFIGURATION:
			return p_device.speaks_mtdata2() ? SetupStep::OUTPUT_CONFIGURATION : SetupStep::OUTPUT_MODE;
		case SetupStep::SET_BAUD:
			return SetupStep::REBOOT;
		case SetupStep::OUTPUT_MODE:
			return SetupStep::OUTPUT_SETTINGS;
		case SetupStep::OUTPUT_SETTINGS:
			return SetupStep::PERIOD;
		case SetupStep::PERIOD:
			return p_device.is_master() ? SetupStep::DATA_LENGTH : SetupStep::SKIP_FACTOR;
		case SetupStep::SKIP_FACTOR:
			return SetupStep::DATA_LENGTH;
		case SetupStep::DATA_LENGTH:
			return p_device.is_master() ? SetupStep::BATTERY : SetupStep::MEASURE;
		case SetupStep::OUTPUT_CONFIGURATION:
		case SetupStep::BATTERY:
			return SetupStep::MEASURE;
		case SetupStep::MEASURE:
			return SetupStep::MEASURING;
		default:
			return SetupStep::STOPPED;
	}
}

Request request_of(SetupStep p_step, const OutputChoice &p_choice, uint8_t p_bus_id) {
	switch (p_step) {
		case SetupStep::DEVICE_ID:
			return host::request_device_id();
		case SetupStep::INIT_BUS:
			return host::init_bus();
		case SetupStep::BUS_POWER:
			return host::set_bus_power(true);
		case SetupStep::CONFIGURATION:
			return host::request_configuration();
		case SetupStep::SET_BAUD:
			return host::set_baud_rate(FAST_BAUD_CODE);
		case SetupStep::OUTPUT_MODE:
			return host::set_output_mode(p_choice.outputs().mode, p_bus_id);
		case SetupStep::OUTPUT_SETTINGS:
			return host::set_output_settings(p_choice.outputs().settings, p_bus_id);
		case SetupStep::PERIOD:
			return host::set_period(p_choice.outputs().period);
		case SetupStep::SKIP_FACTOR:
			return host::set_skip_factor(0, MASTER);
		case SetupStep::DATA_LENGTH:
			return host::request_data_length();
		case SetupStep::OUTPUT_CONFIGURATION:
			return p_choice.mtdata2_request();
		case SetupStep::BATTERY:
			return host::request_battery_level();
		case SetupStep::MEASURE:
			return host::go_to_measurement();
		default:
			return host::go_to_config();
	}
}

} // namespace xbus
