// SPDX-License-Identifier: MIT
#include "usb/libusb_hub.hpp"

/// What `usb::make_hub` looks for.
extern "C" __attribute__((visibility("default"))) usb::Hub *dismount_make_hub(
		const xbus::SessionOptions *p_options, usb::HubListener *p_listener) {
	return std::make_unique<usb::LibusbHub>(*p_options, p_listener).release();
}
