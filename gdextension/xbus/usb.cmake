# SPDX-License-Identifier: MIT
# Suits on USB, by libusb.
if(DISMOUNT_USB)
	find_package(Threads REQUIRED)
	dismount_add_core_library(xbus_usb SOURCES
		src/usb/libusb_hub.cpp
		src/usb/port.cpp
		LIBRARIES xbus_session libusb::libusb Threads::Threads
	)
	dismount_add_program(suit_stream SOURCES tools/suit_stream.cpp LIBRARIES xbus_usb xbus_recording)
	# Whoever has a suit tries it first.
	add_dependencies(extensions suit_stream)
endif()
# Hostile reads, as many as asked for: xbus_fuzz_ftdi EXECUTIONS [SEED].
dismount_add_fuzzer(xbus_fuzz_ftdi CORPUS ftdi SOURCE tests/usb/fuzz_ftdi.cpp LIBRARIES xbus_bus)
find_package(Threads REQUIRED)
dismount_add_core_test(xbus_ring SOURCE tests/usb/test_ring.cpp LIBRARIES xbus_bus Threads::Threads THREADS)
dismount_add_core_test(xbus_ftdi_protocol SOURCE tests/usb/test_ftdi_protocol.cpp LIBRARIES xbus_bus)
