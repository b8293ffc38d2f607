// SPDX-License-Identifier: MIT
#include "bus/message.hpp"

#include <array>

namespace xbus {

namespace {

struct MessageName {
	Message message;
	const char *name;
};

constexpr MessageName NAMES[] = {
	{ Message::REQ_DEVICE_ID, "ReqDID" },
	{ Message::DEVICE_ID, "DeviceID" },
	{ Message::INIT_BUS, "InitBus" },
	{ Message::INIT_BUS_RESULTS, "InitBusResults" },
	{ Message::SET_PERIOD, "SetPeriod" },
	{ Message::SET_PERIOD_ACK, "SetPeriodAck" },
	{ Message::SET_BUS_ID, "SetBID" },
	{ Message::SET_BUS_ID_ACK, "SetBIDAck" },
	{ Message::BUS_POWER, "BusPower" },
	{ Message::BUS_POWER_ACK, "BusPowerAck" },
	{ Message::REQ_DATA_LENGTH, "ReqDataLength" },
	{ Message::DATA_LENGTH, "DataLength" },
	{ Message::REQ_CONFIGURATION, "ReqConfiguration" },
	{ Message::CONFIGURATION, "Configuration" },
	{ Message::RESTORE_FACTORY_DEFAULTS, "RestoreFactoryDef" },
	{ Message::RESTORE_FACTORY_DEFAULTS_ACK, "RestoreFactoryDefAck" },
	{ Message::GO_TO_MEASUREMENT, "GoToMeasurement" },
	{ Message::GO_TO_MEASUREMENT_ACK, "GoToMeasurementAck" },
	{ Message::REQ_FIRMWARE_REVISION, "ReqFWRev" },
	{ Message::FIRMWARE_REVISION, "FirmwareRev" },
	{ Message::DISABLE_BLUETOOTH, "DisableBT" },
	{ Message::DISABLE_BLUETOOTH_ACK, "DisableBTAck" },
	{ Message::OPERATING_MODE, "SetOperatingMode" },
	{ Message::OPERATING_MODE_ACK, "SetOperatingModeAck" },
	{ Message::SET_BAUD_RATE, "SetBaudrate" },
	{ Message::SET_BAUD_RATE_ACK, "SetBaudrateAck" },
	{ Message::SET_SYNC_MODE, "SetSyncMode" },
	{ Message::SET_SYNC_MODE_ACK, "SetSyncModeAck" },
	{ Message::REQ_PRODUCT_CODE, "ReqProductCode" },
	{ Message::PRODUCT_CODE, "ProductCode" },
	{ Message::REQ_HARDWARE_VERSION, "ReqHardwareVersion" },
	{ Message::HARDWARE_VERSION, "HardwareVersion" },
	{ Message::GO_TO_CONFIG, "GoToConfig" },
	{ Message::GO_TO_CONFIG_ACK, "GoToConfigAck" },
	{ Message::MT_DATA, "MTData" },
	{ Message::REQ_DATA, "ReqData" },
	{ Message::REQ_DATA_ACK, "ReqDataAck" },
	{ Message::MT_DATA2, "MTData2" },
	{ Message::WAKE_UP, "WakeUp" },
	{ Message::WAKE_UP_ACK, "WakeUpAck" },
	{ Message::RESET, "Reset" },
	{ Message::RESET_ACK, "ResetAck" },
	{ Message::ERROR, "Error" },
	{ Message::WARNING, "Warning" },
	{ Message::XM_POWER_OFF, "XMOff" },
	{ Message::MASTER_INDICATION, "MasterIndication" },
	{ Message::XSB_DATA, "XsbData" },
	{ Message::KEEP_ALIVE, "KeepAlive" },
	{ Message::KEEP_ALIVE_ACK, "KeepAliveAck" },
	{ Message::XM_ERROR_MODE, "SetXmErrorMode" },
	{ Message::XM_ERROR_MODE_ACK, "SetXmErrorModeAck" },
	{ Message::BUFFER_SIZE, "SetBufferSize" },
	{ Message::BUFFER_SIZE_ACK, "SetBufferSizeAck" },
	{ Message::REQ_BATTERY_LEVEL, "ReqBatteryLevel" },
	{ Message::BATTERY_LEVEL, "BatteryLevel" },
	{ Message::RESET_ORIENTATION, "ResetOrientation" },
	{ Message::RESET_ORIENTATION_ACK, "ResetOrientationAck" },
	{ Message::SCAN_CHANNELS, "ScanChannels" },
	{ Message::SCAN_CHANNELS_ACK, "ScanChannelsAck" },
	{ Message::ENABLE_MASTER, "EnableMaster" },
	{ Message::ENABLE_MASTER_ACK, "EnableMasterAck" },
	{ Message::DISABLE_MASTER, "DisableMaster" },
	{ Message::DISABLE_MASTER_ACK, "DisableMasterAck" },
	{ Message::RADIO_CHANNEL, "ReqRadioChannel" },
	{ Message::RADIO_CHANNEL_ACK, "ReqRadioChannelAck" },
	{ Message::WIRELESS_CONFIG, "SetWirelessConfig" },
	{ Message::WIRELESS_CONFIG_ACK, "SetWirelessConfigAck" },
	{ Message::SET_OUTPUT_CONFIGURATION, "SetOutputConfiguration" },
	{ Message::SET_OUTPUT_CONFIGURATION_ACK, "SetOutputConfigurationAck" },
	{ Message::ACCEPT_MTW, "AcceptMtw" },
	{ Message::ACCEPT_MTW_ACK, "AcceptMtwAck" },
	{ Message::REJECT_MTW, "RejectMtw" },
	{ Message::REJECT_MTW_ACK, "RejectMtwAck" },
	{ Message::START_RECORDING, "StartRecording" },
	{ Message::START_RECORDING_ACK, "StartRecordingAck" },
	{ Message::STOP_RECORDING, "StopRecording" },
	{ Message::STOP_RECORDING_ACK, "StopRecordingAck" },
	{ Message::SET_OUTPUT_MODE, "SetOutputMode" },
	{ Message::SET_OUTPUT_MODE_ACK, "SetOutputModeAck" },
	{ Message::SET_OUTPUT_SETTINGS, "SetOutputSettings" },
	{ Message::SET_OUTPUT_SETTINGS_ACK, "SetOutputSettingsAck" },
	{ Message::SET_OUTPUT_SKIP_FACTOR, "SetOutputSkipFactor" },
	{ Message::SET_OUTPUT_SKIP_FACTOR_ACK, "SetOutputSkipFactorAck" },
	{ Message::SET_ERROR_MODE, "SetErrorMode" },
	{ Message::SET_ERROR_MODE_ACK, "SetErrorModeAck" },
	{ Message::SET_OBJECT_ALIGNMENT, "SetObjectAlignment" },
	{ Message::SET_OBJECT_ALIGNMENT_ACK, "SetObjectAlignmentAck" },
};

struct ErrorText {
	uint8_t code;
	const char *text;
};

constexpr ErrorText ERRORS[] = {
	{ 0x01, "no bus communication" },
	{ 0x02, "bus not ready (InitBus is missing)" },
	{ 0x03, "period out of range" },
	{ 0x04, "message invalid" },
	{ 0x10, "InitBus failed" },
	{ 0x11, "InitBus failed" },
	{ 0x12, "InitBus failed" },
	{ 0x14, "SetBID failed" },
	{ 0x15, "SetBID failed" },
	{ 0x18, "measurement failed" },
	{ 0x19, "measurement failed" },
	{ 0x1A, "measurement failed: more than 255 bytes in total" },
	{ 0x1B, "measurement failed" },
	{ 0x1C, "measurement failed" },
	{ 0x1D, "measurement failed: a tracker gave no right answer" },
	{ 0x1E, "timer overflow" },
	{ 0x20, "baud rate out of range" },
	{ 0x21, "parameter invalid or out of range" },
	{ 0x23, "measurement failed: transmit buffer full" },
	{ 0x24, "measurement failed" },
	{ 0x28, "device error" },
	{ 0x29, "data overflow" },
	{ 0x2A, "buffer overflow" },
	{ 0x30, "battery low" },
};

struct BaudCode {
	uint8_t code;
	uint32_t rate;
};

constexpr BaudCode BAUD_CODES[] = {
	{ 0x80, 921600 },
	{ 0x0A, 921600 },
	{ 0x00, 460800 },
	{ 0x01, 230400 },
	{ 0x02, 115200 },
	{ 0x04, 57600 },
	{ 0x05, 38400 },
	{ 0x07, 19200 },
	{ 0x09, 9600 },
	{ 0x0B, 4800 },
};

std::array<const char *, 256> name_table() {
	std::array<const char *, 256> names{};
	for (const MessageName &entry : NAMES) {
		names[uint8_t(entry.message)] = entry.name;
	}
	return names;
}

} // namespace

const char *message_name(Message p_message) {
	static const std::array<const char *, 256> names = name_table();
	return names[uint8_t(p_message)];
}

const char *error_text(uint8_t p_code) {
	for (const ErrorText &error : ERRORS) {
		if (error.code == p_code) {
			return error.text;
		}
	}
	return nullptr;
}

uint32_t baud_rate(uint8_t p_code) {
	for (const BaudCode &baud : BAUD_CODES) {
		if (baud.code == p_code) {
			return baud.rate;
		}
	}
	return 0;
}

bool baud_code(uint32_t p_rate, uint8_t &r_code) {
	for (const BaudCode &baud : BAUD_CODES) {
		if (baud.rate == p_rate) {
			r_code = baud.code;
			return true;
		}
	}
	return false;
}

DeviceKind device_kind(uint32_t p_device_id) {
	switch ((p_device_id >> 20U) & 0xFU) {
		case 0x1:
			return DeviceKind::XBUS_MASTER;
		case 0x2:
			return ((p_device_id >> 16U) & 0xFU) == 1 ? DeviceKind::AWINDA_DONGLE : DeviceKind::AWINDA_STATION;
		case 0x3:
			return DeviceKind::MTI_MTX;
		case 0x5:
			return DeviceKind::MTI_G;
		case 0x6:
			return DeviceKind::MTI_10;
		case 0x7:
			return DeviceKind::MTI_100;
		case 0xA:
			return DeviceKind::BODY_PACK;
		case 0xB:
			return DeviceKind::MTW2_MTX2;
		default:
			return DeviceKind::UNKNOWN;
	}
}

const char *device_kind_name(DeviceKind p_kind) {
	switch (p_kind) {
		case DeviceKind::XBUS_MASTER:
			return "Xbus Master";
		case DeviceKind::MTI_MTX:
			return "MTi/MTx";
		case DeviceKind::MTI_G:
			return "MTi-G";
		case DeviceKind::MTI_10:
			return "MTi 10-series";
		case DeviceKind::MTI_100:
			return "MTi 100-series";
		case DeviceKind::AWINDA_STATION:
			return "Awinda station";
		case DeviceKind::AWINDA_DONGLE:
			return "Awinda dongle";
		case DeviceKind::BODY_PACK:
			return "BodyPack";
		case DeviceKind::MTW2_MTX2:
			return "MTw2/MTx2";
		default:
			return "unknown device";
	}
}

} // namespace xbus
