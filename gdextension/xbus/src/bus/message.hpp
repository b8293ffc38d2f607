// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace xbus {

/// First byte of every message.
constexpr uint8_t PREAMBLE = 0xFA;
/// Bus identifier of the master, or of a tracker that stands alone.
constexpr uint8_t MASTER = 0xFF;
/// Bus identifier of everybody.
constexpr uint8_t BROADCAST = 0x00;
/// Value of the length byte that announces a 16-bit length.
constexpr uint8_t EXTENDED = 0xFF;
/// Most data bytes of the short form.
constexpr std::size_t MAX_SHORT_DATA = 254;
/// Most data bytes of any message that is taken.
constexpr std::size_t MAX_DATA = 8192;
/// Preamble, bus identifier, message identifier, length, two bytes of extended length, checksum.
constexpr std::size_t MAX_FRAME = MAX_DATA + 7;
/// Most trackers behind one master that are taken; Xsens' own hosts allow 10 to 20.
constexpr std::size_t MAX_DEVICES = 64;

/// Message identifiers. A request is even, its acknowledgement is the next number. Where the same number
/// means one thing to a master and another to a tracker, both names stand here.
enum class Message : uint8_t {
	REQ_DEVICE_ID = 0x00,
	DEVICE_ID = 0x01,
	INIT_BUS = 0x02,
	INIT_BUS_RESULTS = 0x03,
	SET_PERIOD = 0x04,
	SET_PERIOD_ACK = 0x05,
	SET_BUS_ID = 0x06,
	SET_BUS_ID_ACK = 0x07,
	AUTO_START = 0x06,
	BUS_POWER = 0x08,
	BUS_POWER_ACK = 0x09,
	REQ_DATA_LENGTH = 0x0A,
	DATA_LENGTH = 0x0B,
	REQ_CONFIGURATION = 0x0C,
	CONFIGURATION = 0x0D,
	RESTORE_FACTORY_DEFAULTS = 0x0E,
	RESTORE_FACTORY_DEFAULTS_ACK = 0x0F,
	GO_TO_MEASUREMENT = 0x10,
	GO_TO_MEASUREMENT_ACK = 0x11,
	REQ_FIRMWARE_REVISION = 0x12,
	FIRMWARE_REVISION = 0x13,
	DISABLE_BLUETOOTH = 0x14,
	DISABLE_BLUETOOTH_ACK = 0x15,
	OPERATING_MODE = 0x16,
	OPERATING_MODE_ACK = 0x17,
	SET_BAUD_RATE = 0x18,
	SET_BAUD_RATE_ACK = 0x19,
	SET_SYNC_MODE = 0x1A,
	SET_SYNC_MODE_ACK = 0x1B,
	REQ_PRODUCT_CODE = 0x1C,
	PRODUCT_CODE = 0x1D,
	REQ_HARDWARE_VERSION = 0x1E,
	HARDWARE_VERSION = 0x1F,
	GO_TO_CONFIG = 0x30,
	GO_TO_CONFIG_ACK = 0x31,
	MT_DATA = 0x32,
	REQ_DATA = 0x34,
	REQ_DATA_ACK = 0x35,
	MT_DATA2 = 0x36,
	WAKE_UP = 0x3E,
	WAKE_UP_ACK = 0x3F,
	RESET = 0x40,
	RESET_ACK = 0x41,
	ERROR = 0x42,
	WARNING = 0x43,
	XM_POWER_OFF = 0x44,
	MASTER_INDICATION = 0x46,
	XSB_DATA = 0x47,
	KEEP_ALIVE = 0x70,
	KEEP_ALIVE_ACK = 0x71,
	XM_ERROR_MODE = 0x82,
	XM_ERROR_MODE_ACK = 0x83,
	HEADING = 0x82,
	HEADING_ACK = 0x83,
	BUFFER_SIZE = 0x84,
	BUFFER_SIZE_ACK = 0x85,
	LOCATION_ID = 0x84,
	LOCATION_ID_ACK = 0x85,
	REQ_BATTERY_LEVEL = 0x88,
	BATTERY_LEVEL = 0x89,
	INIT_TRACK_MODE = 0x88,
	INIT_TRACK_MODE_ACK = 0x89,
	RESET_ORIENTATION = 0xA4,
	RESET_ORIENTATION_ACK = 0xA5,
	SCAN_CHANNELS = 0xB0,
	SCAN_CHANNELS_ACK = 0xB1,
	ENABLE_MASTER = 0xB2,
	ENABLE_MASTER_ACK = 0xB3,
	DISABLE_MASTER = 0xB4,
	DISABLE_MASTER_ACK = 0xB5,
	RADIO_CHANNEL = 0xB6,
	RADIO_CHANNEL_ACK = 0xB7,
	WIRELESS_CONFIG = 0xBA,
	WIRELESS_CONFIG_ACK = 0xBB,
	SET_OUTPUT_CONFIGURATION = 0xC0,
	SET_OUTPUT_CONFIGURATION_ACK = 0xC1,
	GO_TO_OPERATIONAL = 0xC0,
	ACCEPT_MTW = 0xC4,
	ACCEPT_MTW_ACK = 0xC5,
	REJECT_MTW = 0xC6,
	REJECT_MTW_ACK = 0xC7,
	START_RECORDING = 0xCC,
	START_RECORDING_ACK = 0xCD,
	STOP_RECORDING = 0xCE,
	STOP_RECORDING_ACK = 0xCF,
	SET_OUTPUT_MODE = 0xD0,
	SET_OUTPUT_MODE_ACK = 0xD1,
	SET_OUTPUT_SETTINGS = 0xD2,
	SET_OUTPUT_SETTINGS_ACK = 0xD3,
	SET_OUTPUT_SKIP_FACTOR = 0xD4,
	SET_OUTPUT_SKIP_FACTOR_ACK = 0xD5,
	SET_ERROR_MODE = 0xDA,
	SET_ERROR_MODE_ACK = 0xDB,
	SET_OBJECT_ALIGNMENT = 0xE0,
	SET_OBJECT_ALIGNMENT_ACK = 0xE1,
};

/// One message where it lies in memory: a view, valid only while its bytes are.
struct Frame {
	uint8_t bus_id = MASTER;
	Message message = Message::REQ_DEVICE_ID;
	const uint8_t *data = nullptr;
	std::size_t size = 0;
};

/// What answers this request.
constexpr Message acknowledgement(Message p_request) {
	return Message(uint8_t(p_request) | 1U);
}

/// The name that Xsens' manuals use, as a master would mean it, or null where the number has none.
const char *message_name(Message p_message);

/// What the code of an Error message (0x42) says, or null where it is unknown.
const char *error_text(uint8_t p_code);

/// The baud rate that a code of SetBaudrate (0x18) stands for, 0 where it is unknown.
uint32_t baud_rate(uint8_t p_code);
/// The code of a baud rate; false where there is none.
bool baud_code(uint32_t p_rate, uint8_t &r_code);

/// What a device is, from the class in its identifier.
enum class DeviceKind : uint8_t {
	UNKNOWN,
	/// Wired master of a suit.
	XBUS_MASTER,
	/// MTi or MTx: gives orientations.
	MTI_MTX,
	MTI_G,
	MTI_10,
	MTI_100,
	/// Wireless masters and trackers, which give no orientations.
	AWINDA_STATION,
	AWINDA_DONGLE,
	BODY_PACK,
	MTW2_MTX2,
};

DeviceKind device_kind(uint32_t p_device_id);
const char *device_kind_name(DeviceKind p_kind);

} // namespace xbus
