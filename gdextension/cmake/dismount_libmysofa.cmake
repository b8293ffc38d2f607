# SPDX-License-Identifier: MIT
# Provides libmysofa::libmysofa (shared), from DISMOUNT_LIBMYSOFA_ROOT or from the system, and a way to
# ship it with an extension:
#
#   dismount_ship_libmysofa(<target>)
include_guard()
include(dismount_shipped)

set(DISMOUNT_LIBMYSOFA_ROOT "" CACHE PATH "Folder like /usr that holds libmysofa; empty for the system's")

dismount_find_in("${DISMOUNT_LIBMYSOFA_ROOT}" mysofa.h "" mysofa DISMOUNT_LIBMYSOFA_INCLUDE DISMOUNT_LIBMYSOFA_LIBRARY)
if(NOT DISMOUNT_LIBMYSOFA_INCLUDE OR NOT DISMOUNT_LIBMYSOFA_LIBRARY)
	message(FATAL_ERROR
		"libmysofa was not found: install its headers (Debian: libmysofa-dev), or set DISMOUNT_LIBMYSOFA_ROOT to a "
		"folder like /usr that holds it.")
endif()
# The compiler and the loader know it by the name that its file carries inside: take over what it is.
get_filename_component(_libmysofa_file ${DISMOUNT_LIBMYSOFA_LIBRARY} REALPATH)
get_filename_component(_libmysofa_folder ${DISMOUNT_LIBMYSOFA_LIBRARY} DIRECTORY)
string(REGEX REPLACE "^.*/(libmysofa\\.so\\.[0-9]+).*$" "\\1" DISMOUNT_LIBMYSOFA_NAME ${_libmysofa_file})
add_library(libmysofa::libmysofa SHARED IMPORTED GLOBAL)
set_target_properties(libmysofa::libmysofa PROPERTIES
	IMPORTED_LOCATION ${_libmysofa_file}
	IMPORTED_SONAME ${DISMOUNT_LIBMYSOFA_NAME}
	INTERFACE_INCLUDE_DIRECTORIES ${DISMOUNT_LIBMYSOFA_INCLUDE}
	# For zlib, which it needs: of the same folder where the system has none.
	INTERFACE_LINK_OPTIONS -Wl,-rpath-link,${_libmysofa_folder}
)

# With its licence, which must lie beside it.
function(dismount_ship_libmysofa p_target)
	configure_file(${PROJECT_SOURCE_DIR}/audio/licenses/libmysofa.txt ${DISMOUNT_BIN_DIR}/libmysofa.txt COPYONLY)
	dismount_ship(${p_target} libmysofa::libmysofa ${DISMOUNT_LIBMYSOFA_LIBRARY} ${DISMOUNT_LIBMYSOFA_NAME})
endfunction()
