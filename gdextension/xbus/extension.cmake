# SPDX-License-Identifier: MIT
if(DISMOUNT_EXTENSIONS)
	dismount_add_extension(xbus
		SOURCES
			binding/register_types.cpp
			binding/suit_hub.cpp
		LIBRARIES
			xbus_usb
		DOCS
			doc_classes/SuitHub.xml
	)
	dismount_ship_libusb(xbus)
endif()
