# SPDX-License-Identifier: MIT
# Provides libsodium::libsodium (shared), from DISMOUNT_LIBSODIUM_ROOT or from the system, and a way to
# ship it with an extension:
#
#   dismount_ship_libsodium(<target>)
include_guard()
include(dismount_shipped)

set(DISMOUNT_LIBSODIUM_ROOT "" CACHE PATH "Folder like /usr that holds libsodium; empty for the system's")

dismount_find_in("${DISMOUNT_LIBSODIUM_ROOT}" sodium.h "" sodium DISMOUNT_LIBSODIUM_INCLUDE DISMOUNT_LIBSODIUM_LIBRARY)
if(NOT DISMOUNT_LIBSODIUM_INCLUDE OR NOT DISMOUNT_LIBSODIUM_LIBRARY)
	message(FATAL_ERROR
		"libsodium was not found: install its headers (Debian: libsodium-dev), or set DISMOUNT_LIBSODIUM_ROOT to a "
		"folder like /usr that holds it.")
endif()
# The compiler and the loader know it by the name that its file carries inside: take over what it is.
get_filename_component(_libsodium_file ${DISMOUNT_LIBSODIUM_LIBRARY} REALPATH)
string(REGEX REPLACE "^.*/(libsodium\\.so\\.[0-9]+).*$" "\\1" DISMOUNT_LIBSODIUM_NAME ${_libsodium_file})
add_library(libsodium::libsodium SHARED IMPORTED GLOBAL)
set_target_properties(libsodium::libsodium PROPERTIES
	IMPORTED_LOCATION ${_libsodium_file}
	IMPORTED_SONAME ${DISMOUNT_LIBSODIUM_NAME}
	INTERFACE_INCLUDE_DIRECTORIES ${DISMOUNT_LIBSODIUM_INCLUDE}
)

# With its licence, which must lie beside it.
function(dismount_ship_libsodium p_target)
	configure_file(${PROJECT_SOURCE_DIR}/transport/licenses/libsodium.txt ${DISMOUNT_BIN_DIR}/libsodium.txt COPYONLY)
	dismount_ship(${p_target} libsodium::libsodium ${DISMOUNT_LIBSODIUM_LIBRARY} ${DISMOUNT_LIBSODIUM_NAME})
endfunction()
