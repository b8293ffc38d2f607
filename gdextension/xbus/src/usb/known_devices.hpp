// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

namespace usb {

/// How a device is talked to.
enum class DeviceLink : uint8_t {
	OTHER, ///< Not ours.
	NATIVE, ///< Bulk endpoints that carry the bus' bytes as they are.
	FTDI, ///< Behind FTDI's serial chip: status bytes, baud rate.
	AWINDA, ///< Recognised, but its radio protocol is not public.
	BODY_PACK, ///< Recognised, not spoken to.
};

/// A device by its USB numbers.
struct KnownDevice {
	uint16_t vendor;
	uint16_t product;
	DeviceLink kind;
	const char *name;
};

constexpr uint16_t VENDOR_FTDI = 0x0403;
constexpr uint16_t VENDOR_XSENS = 0x2639;

/// Numbers from Linux' ftdi_sio_ids.h and xsens_mt.c.
constexpr std::array<KnownDevice, 22> KNOWN_DEVICES = { {
		{ VENDOR_FTDI, 0xD388, DeviceLink::FTDI, "Xsens USB converter" },
		{ VENDOR_FTDI, 0xD389, DeviceLink::FTDI, "Xsens wireless receiver" },
		{ VENDOR_FTDI, 0xD38A, DeviceLink::FTDI, "Xsens device" },
		{ VENDOR_FTDI, 0xD38B, DeviceLink::FTDI, "Xsens USB-serial converter" },
		{ VENDOR_FTDI, 0xD38C, DeviceLink::FTDI, "Xsens wireless receiver" },
		{ VENDOR_FTDI, 0xD38D, DeviceLink::AWINDA, "Xsens Awinda station" },
		{ VENDOR_FTDI, 0xD38E, DeviceLink::FTDI, "Xsens device" },
		{ VENDOR_FTDI, 0xD38F, DeviceLink::FTDI, "Xsens device" },
		{ VENDOR_XSENS, 0x0001, DeviceLink::NATIVE, "Xsens MTi-10" },
		{ VENDOR_XSENS, 0x0002, DeviceLink::NATIVE, "Xsens MTi-20" },
		{ VENDOR_XSENS, 0x0003, DeviceLink::NATIVE, "Xsens MTi-30" },
		{ VENDOR_XSENS, 0x0011, DeviceLink::NATIVE, "Xsens MTi-100" },
		{ VENDOR_XSENS, 0x0012, DeviceLink::NATIVE, "Xsens MTi-200" },
		{ VENDOR_XSENS, 0x0013, DeviceLink::NATIVE, "Xsens MTi-300" },
		{ VENDOR_XSENS, 0x0017, DeviceLink::NATIVE, "Xsens MTi-G-700" },
		{ VENDOR_XSENS, 0x0100, DeviceLink::BODY_PACK, "Xsens BodyPack" },
		{ VENDOR_XSENS, 0x0101, DeviceLink::AWINDA, "Xsens Awinda station" },
		{ VENDOR_XSENS, 0x0102, DeviceLink::AWINDA, "Xsens Awinda dongle" },
		{ VENDOR_XSENS, 0x0200, DeviceLink::AWINDA, "Xsens MTw" },
		{ VENDOR_XSENS, 0x0300, DeviceLink::FTDI, "Xsens motion tracker board" },
		{ VENDOR_XSENS, 0x0301, DeviceLink::FTDI, "Xsens MTi USB converter" },
		{ VENDOR_XSENS, 0xD00D, DeviceLink::FTDI, "Xsens converter" },
} };

/// What a device is, by its USB numbers. An unknown one of Xsens' is tried as a native one.
constexpr KnownDevice identify(uint16_t p_vendor, uint16_t p_product) {
	for (const KnownDevice &known : KNOWN_DEVICES) {
		if (known.vendor == p_vendor && known.product == p_product) {
			return known;
		}
	}
	if (p_vendor == VENDOR_XSENS) {
		return { p_vendor, p_product, DeviceLink::NATIVE, "unknown Xsens device" };
	}
	return { p_vendor, p_product, DeviceLink::OTHER, "" };
}

} // namespace usb
