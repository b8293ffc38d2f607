# SPDX-License-Identifier: MIT
# Provides umockdev::umockdev, which gives programs USB devices that are not there: the suit emulator
# stands behind it. From DISMOUNT_UMOCKDEV_ROOT or from the system. A missing umockdev is an error,
# unless DISMOUNT_UMOCKDEV is off: then the target does not exist, and there is no emulator.
include_guard()
include(dismount_libusb)

set(DISMOUNT_UMOCKDEV_ROOT "" CACHE PATH "Folder like /usr that holds umockdev and glib; empty for the system's")

if(NOT DISMOUNT_UMOCKDEV)
	return()
endif()
dismount_find_in("${DISMOUNT_UMOCKDEV_ROOT}" umockdev.h umockdev-1.0 umockdev DISMOUNT_UMOCKDEV_INCLUDE DISMOUNT_UMOCKDEV_LIBRARY)
dismount_find_in("${DISMOUNT_UMOCKDEV_ROOT}" glib.h glib-2.0 glib-2.0 DISMOUNT_GLIB_INCLUDE DISMOUNT_GLIB_LIBRARY)
dismount_find_in("${DISMOUNT_UMOCKDEV_ROOT}" glib-object.h glib-2.0 gobject-2.0 DISMOUNT_GOBJECT_INCLUDE DISMOUNT_GOBJECT_LIBRARY)
dismount_find_in("${DISMOUNT_UMOCKDEV_ROOT}" gio/gio.h glib-2.0 gio-2.0 DISMOUNT_GIO_INCLUDE DISMOUNT_GIO_LIBRARY)
if(NOT DISMOUNT_UMOCKDEV_LIBRARY OR NOT DISMOUNT_UMOCKDEV_INCLUDE OR NOT DISMOUNT_GIO_LIBRARY OR NOT DISMOUNT_GIO_INCLUDE)
	message(FATAL_ERROR
		"umockdev with its headers and glib's was not found: install them (Debian: libumockdev-dev), or set "
		"DISMOUNT_UMOCKDEV_ROOT to a folder like /usr that holds them. -DDISMOUNT_UMOCKDEV=OFF does without the "
		"suit emulator and the tests that need it.")
endif()

get_filename_component(DISMOUNT_UMOCKDEV_FOLDER ${DISMOUNT_UMOCKDEV_LIBRARY} DIRECTORY)
get_filename_component(_glib_folder ${DISMOUNT_GLIB_LIBRARY} DIRECTORY)
find_path(DISMOUNT_GLIB_CONFIG glibconfig.h
	PATHS ${_glib_folder}/glib-2.0/include NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH)
mark_as_advanced(DISMOUNT_GLIB_CONFIG)
add_library(umockdev::umockdev INTERFACE IMPORTED GLOBAL)
set_target_properties(umockdev::umockdev PROPERTIES
	INTERFACE_INCLUDE_DIRECTORIES
		"${DISMOUNT_UMOCKDEV_INCLUDE};${DISMOUNT_GLIB_INCLUDE};${DISMOUNT_GLIB_CONFIG}"
	INTERFACE_LINK_LIBRARIES
		"${DISMOUNT_UMOCKDEV_LIBRARY};${DISMOUNT_GIO_LIBRARY};${DISMOUNT_GOBJECT_LIBRARY};${DISMOUNT_GLIB_LIBRARY}"
)
if(DISMOUNT_UMOCKDEV_ROOT)
	# A path that also serves the libraries of the libraries, of which the system may have none.
	set_property(TARGET umockdev::umockdev PROPERTY INTERFACE_LINK_OPTIONS
		-Wl,--disable-new-dtags -Wl,-rpath,${DISMOUNT_UMOCKDEV_FOLDER} -Wl,-rpath-link,${DISMOUNT_UMOCKDEV_FOLDER})
endif()
