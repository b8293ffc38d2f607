// SPDX-License-Identifier: MIT
#include "session/setup_step.hpp"

namespace xbus {

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

} // namespace xbus
