# SPDX-License-Identifier: MIT
# Provides libusb::libusb (libusb 1.0, shared), from DISMOUNT_LIBUSB_ROOT or from the system, and a way
# to ship it with an extension:
#
#   dismount_ship_libusb(<target>)
#
# A missing libusb is an error, unless DISMOUNT_USB is off: then the target does not exist.
include_guard()
include(dismount_shipped)

set(DISMOUNT_LIBUSB_ROOT "" CACHE PATH "Folder like /usr that holds libusb 1.0; empty for the system's")

if(DISMOUNT_USB)
	dismount_find_in("${DISMOUNT_LIBUSB_ROOT}" libusb.h libusb-1.0 usb-1.0 DISMOUNT_LIBUSB_INCLUDE DISMOUNT_LIBUSB_LIBRARY)
	if(NOT DISMOUNT_LIBUSB_INCLUDE OR NOT DISMOUNT_LIBUSB_LIBRARY)
		message(FATAL_ERROR
			"libusb 1.0 was not found: install its headers (Debian: libusb-1.0-0-dev), "
			"or set DISMOUNT_LIBUSB_ROOT to a folder like /usr that holds it. The engine-free C++ builds without: "
			"-DDISMOUNT_EXTENSIONS=OFF -DDISMOUNT_USB=OFF -DDISMOUNT_UMOCKDEV=OFF.")
	endif()
	get_filename_component(_libusb_folder ${DISMOUNT_LIBUSB_LIBRARY} DIRECTORY)
	add_library(libusb::libusb SHARED IMPORTED GLOBAL)
	set_target_properties(libusb::libusb PROPERTIES
		IMPORTED_LOCATION ${DISMOUNT_LIBUSB_LIBRARY}
		IMPORTED_SONAME libusb-1.0.so.0
		INTERFACE_INCLUDE_DIRECTORIES ${DISMOUNT_LIBUSB_INCLUDE}
		# For libudev, which libusb needs: of the same folder where the system has none.
		INTERFACE_LINK_OPTIONS -Wl,-rpath-link,${_libusb_folder}
	)
endif()

function(dismount_ship_libusb p_target)
	dismount_ship(${p_target} libusb::libusb ${DISMOUNT_LIBUSB_LIBRARY} libusb-1.0.so.0)
endfunction()
