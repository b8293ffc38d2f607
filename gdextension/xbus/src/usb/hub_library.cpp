// SPDX-License-Identifier: MIT
#include "usb/hub_library.hpp"

#include <dlfcn.h>

namespace usb {

namespace {

using Maker = Hub *(*)(const xbus::SessionOptions *, HubListener *);

std::string folder_of_this_library() {
	Dl_info info{};
	if (dladdr(reinterpret_cast<const void *>(&make_hub), &info) == 0 || info.dli_fname == nullptr) {
		return "";
	}
	const std::string path = info.dli_fname;
	return path.substr(0, path.rfind('/') + 1);
}

} // namespace

std::unique_ptr<Hub> make_hub(const xbus::SessionOptions &p_options, HubListener *p_listener, std::string &r_fault) {
	// Never closed: threads of libusb may still be on their way out of it.
	static void *library = nullptr;
	if (library == nullptr) {
		library = dlopen((folder_of_this_library() + DISMOUNT_USB_LIBRARY).c_str(), RTLD_NOW | RTLD_LOCAL);
	}
	void *symbol = library != nullptr ? dlsym(library, "dismount_make_hub") : nullptr;
	if (symbol == nullptr) {
		const char *why = dlerror();
		r_fault = std::string("suits on USB can't be used, as libusb can't be loaded: ") +
				(why != nullptr ? why : "unknown") + ". Install libusb 1.0 (Debian: libusb-1.0-0)";
		return nullptr;
	}
	return std::unique_ptr<Hub>(reinterpret_cast<Maker>(symbol)(&p_options, p_listener));
}

} // namespace usb
