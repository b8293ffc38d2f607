# SPDX-License-Identifier: MIT
if(DISMOUNT_EXTENSIONS)
	# What needs libusb lies in a library of its own, which the extension loads itself: usb/hub_library.hpp.
	_dismount_architecture(architecture)
	add_library(xbus_usb_library SHARED src/usb/hub_entry.cpp)
	target_link_libraries(xbus_usb_library PRIVATE xbus_usb)
	target_link_options(xbus_usb_library PRIVATE -Wl,--no-undefined $<$<CONFIG:Release>:-s>)
	set_target_properties(xbus_usb_library PROPERTIES
		OUTPUT_NAME xbus_usb
		SUFFIX .linux.${architecture}.so
		LIBRARY_OUTPUT_DIRECTORY ${DISMOUNT_BIN_DIR}
	)
	_dismount_common(xbus_usb_library)
	dismount_ship_libusb(xbus_usb_library)
	add_dependencies(extensions xbus_usb_library)

	dismount_add_extension(xbus
		SOURCES
			binding/mvn_dictionary.cpp
			binding/mvn_encoder.cpp
			binding/mvn_receiver.cpp
			binding/raw_player.cpp
			binding/raw_recorder.cpp
			binding/register_types.cpp
			binding/stream_time.cpp
			binding/suit_device.cpp
			binding/suit_frame.cpp
			binding/suit_hub.cpp
			binding/suit_message.cpp
			binding/suit_tracker.cpp
			src/usb/hub_library.cpp
		LIBRARIES
			xbus_recording
			xbus_session
			xbus_udp
			${CMAKE_DL_LIBS}
		DOCS
			doc_classes/MvnEncoder.xml
			doc_classes/MvnReceiver.xml
			doc_classes/RawPlayer.xml
			doc_classes/RawRecorder.xml
			doc_classes/StreamTime.xml
			doc_classes/SuitDevice.xml
			doc_classes/SuitFrame.xml
			doc_classes/SuitHub.xml
			doc_classes/SuitMessage.xml
			doc_classes/SuitTracker.xml
	)
	target_compile_definitions(xbus PRIVATE
		DISMOUNT_USB_LIBRARY="libxbus_usb.linux.${architecture}.so")
	add_dependencies(xbus xbus_usb_library)
endif()
