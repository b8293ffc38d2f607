# SPDX-License-Identifier: MIT
# A suit that is not there: an Xbus Master with trackers behind USB chips, without any input or output
# (xbus_emulator), and what lets programs find it: suit_emulator behind umockdev.
dismount_add_core_library(xbus_emulator SOURCES
	emulator/suit/master.cpp
	emulator/suit/motion_stream.cpp
	emulator/suit/sample.cpp
	emulator/suit/stand_alone.cpp
	emulator/suit/suit.cpp
	emulator/suit/suit_options.cpp
	emulator/suit/tracker.cpp
	emulator/suit/xbus_device.cpp
	emulator/cable/ftdi_chip.cpp
	emulator/cable/native_chip.cpp
	emulator/cable/serial_line.cpp
	emulator/cable/usb_device.cpp
	emulator/cable/usb_port.cpp
	LIBRARIES xbus_device kinematics
)
target_include_directories(xbus_emulator PUBLIC ${CMAKE_CURRENT_SOURCE_DIR}/emulator)

if(DISMOUNT_UMOCKDEV)
	find_package(Threads REQUIRED)
	dismount_add_program(suit_emulator SOURCES
		emulator/front/device_node.cpp
		emulator/front/interface_claims.cpp
		emulator/front/session.cpp
		emulator/front/suit_emulator.cpp
		emulator/front/usbfs_node.cpp
		LIBRARIES xbus_emulator umockdev::umockdev Threads::Threads ${CMAKE_DL_LIBS}
	)
	# Preloaded before umockdev's library; the emulator looks for it beside itself.
	add_library(suit_device_gate SHARED emulator/front/device_gate.cpp)
	target_link_libraries(suit_device_gate PRIVATE ${CMAKE_DL_LIBS})
	_dismount_common(suit_device_gate)
	add_dependencies(suit_emulator suit_device_gate)
endif()
# The hub with its threads, at an emulated suit of several trackers that comes, streams and is given back.
if(DISMOUNT_SUIT_EMULATOR AND DISMOUNT_USB AND BUILD_TESTING)
	add_test(NAME xbus_hub_threads
		COMMAND ${DISMOUNT_SUIT_EMULATOR} --sensors=4 -- $<TARGET_FILE:suit_stream> --frames=150 --seconds=60)
	set_tests_properties(xbus_hub_threads PROPERTIES TIMEOUT ${DISMOUNT_TEST_LIMIT_S})
	dismount_mark_threaded(xbus_hub_threads suit_stream)
endif()
foreach(test emulated_chips emulated_master emulated_motion)
	dismount_add_core_test(xbus_${test} SOURCE emulator/tests/test_${test}.cpp LIBRARIES xbus_emulator)
endforeach()
