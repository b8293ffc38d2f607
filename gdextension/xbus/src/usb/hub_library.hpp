// SPDX-License-Identifier: MIT
#pragma once

#include "usb/hub.hpp"

#include <memory>
#include <string>

namespace usb {

/// Makes a hub with the library that lies beside the calling one and holds everything that needs libusb.
///
/// It is loaded when it is needed: a machine without libusb loses its suits, not everything else of the module.
/// And it is loaded by ourselves: the engine loads extensions so that they bind to their own libraries first
/// (RTLD_DEEPBIND), which would hide an emulated bus (umockdev) from libusb.
///
/// Returns null, and why in `r_fault`, where that cannot be.
std::unique_ptr<Hub> make_hub(const xbus::SessionOptions &p_options, HubListener *p_listener, std::string &r_fault);

} // namespace usb
