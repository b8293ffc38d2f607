# SPDX-License-Identifier: MIT
# Provides libusb::libusb (libusb 1.0, shared), from DISMOUNT_LIBUSB_ROOT or from the system, and a way
# to ship it with an extension:
#
#   dismount_ship_libusb(<target>)
#       Copies libusb-1.0.so.0 beside the built extensions, where the target then finds it. Name it
#       under [dependencies] in the extension's .gdextension file: exports carry it then.
#
# A missing libusb is an error, unless DISMOUNT_USB is off: then the target does not exist.
include_guard()

set(DISMOUNT_LIBUSB_ROOT "" CACHE PATH "Folder like /usr that holds libusb 1.0; empty for the system's")

# Where the libraries of a folder like /usr are: Debian's way, and everybody else's.
set(DISMOUNT_LIBRARY_SUFFIXES lib/${CMAKE_LIBRARY_ARCHITECTURE} lib/x86_64-linux-gnu lib64 lib)

# Finds a header and a library in the folder that was named, and nowhere else; or in the system.
function(dismount_find_in p_root p_header p_suffix p_library r_header r_library)
	if(p_root)
		set(where PATHS ${p_root} NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH)
	endif()
	find_path(${r_header} ${p_header} ${where} PATH_SUFFIXES include/${p_suffix} ${p_suffix})
	find_library(${r_library} ${p_library} ${where} PATH_SUFFIXES ${DISMOUNT_LIBRARY_SUFFIXES})
	mark_as_advanced(${r_header} ${r_library})
endfunction()

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
	get_filename_component(library ${DISMOUNT_LIBUSB_LIBRARY} REALPATH)
	set(shipped ${DISMOUNT_BIN_DIR}/libusb-1.0.so.0)
	add_custom_command(
		OUTPUT ${shipped}
		COMMAND ${CMAKE_COMMAND} -E make_directory ${DISMOUNT_BIN_DIR}
		COMMAND ${CMAKE_COMMAND} -E copy ${library} ${shipped}
		DEPENDS ${library}
		COMMENT "Copying libusb beside the extensions"
		VERBATIM
	)
	target_sources(${p_target} PRIVATE ${shipped})
	target_link_libraries(${p_target} PRIVATE libusb::libusb)
	set_target_properties(${p_target} PROPERTIES
		BUILD_WITH_INSTALL_RPATH ON
		INSTALL_RPATH "$ORIGIN"
	)
endfunction()
