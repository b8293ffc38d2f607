# SPDX-License-Identifier: MIT
# Suits on USB, by libusb.
if(DISMOUNT_USB)
	find_package(Threads REQUIRED)
	dismount_add_core_library(xbus_usb SOURCES
		src/usb/libusb_hub.cpp
		src/usb/port.cpp
		LIBRARIES xbus_session libusb::libusb Threads::Threads
	)
endif()
if(DISMOUNT_USB)
	add_executable(suit_stream tools/suit_stream.cpp)
	target_link_libraries(suit_stream PRIVATE xbus_usb xbus_recording)
	_dismount_common(suit_stream)
	_dismount_sanitize(suit_stream)
endif()
# Hostile reads, as many as asked for: xbus_fuzz_ftdi EXECUTIONS [SEED].
dismount_add_fuzzer(xbus_fuzz_ftdi CORPUS ftdi SOURCES tests/usb/fuzz_ftdi.cpp LIBRARIES xbus_bus)
find_package(Threads REQUIRED)
dismount_add_core_test(xbus_ring SOURCES tests/usb/test_ring.cpp LIBRARIES xbus_bus Threads::Threads THREADS)
dismount_add_core_test(xbus_ftdi_protocol SOURCES tests/usb/test_ftdi_protocol.cpp LIBRARIES xbus_bus)
