# SPDX-License-Identifier: MIT
# Suits on USB, by libusb. Sanitized builds of the cores do without where there is none.
if(TARGET libusb::libusb)
	find_package(Threads REQUIRED)
	dismount_add_core_library(xbus_usb SOURCES
		src/usb/libusb_hub.cpp
		src/usb/port.cpp
		LIBRARIES xbus_session libusb::libusb Threads::Threads
	)
endif()
if(TARGET xbus_usb AND NOT DISMOUNT_SANITIZE)
	add_executable(suit_stream tools/suit_stream.cpp)
	target_link_libraries(suit_stream PRIVATE xbus_usb xbus_recording)
	_dismount_common(suit_stream)
endif()
# Hostile reads, as many as asked for: xbus_fuzz_ftdi EXECUTIONS [SEED].
dismount_add_core_test(xbus_fuzz_ftdi SOURCES tests/usb/fuzz_ftdi.cpp LIBRARIES xbus_bus)
dismount_add_core_test(xbus_ftdi_protocol SOURCES tests/usb/test_ftdi_protocol.cpp LIBRARIES xbus_bus)
