# SPDX-License-Identifier: MIT
# Finds libraries that are not ours, and ships them with an extension:
#
#   dismount_find_in(<folder like /usr, or empty> <header> <suffix> <library> <header's variable> <library's variable>)
#       Finds a header and a library in the folder that was named, and nowhere else; or in the system.
#   dismount_ship(<target> <imported target> <library> <name>)
#       Copies the library under that name beside the built extensions, where the target then finds
#       it. Name it under [dependencies] in the extension's .gdextension file: exports carry it then.
include_guard()

# Where the libraries of a folder like /usr are: Debian's way, and everybody else's.
set(DISMOUNT_LIBRARY_SUFFIXES lib/${CMAKE_LIBRARY_ARCHITECTURE} lib/x86_64-linux-gnu lib64 lib)

function(dismount_find_in p_root p_header p_suffix p_library r_header r_library)
	if(p_root)
		set(where PATHS ${p_root} NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH)
	endif()
	find_path(${r_header} ${p_header} ${where} PATH_SUFFIXES include/${p_suffix} ${p_suffix})
	find_library(${r_library} ${p_library} ${where} PATH_SUFFIXES ${DISMOUNT_LIBRARY_SUFFIXES})
	mark_as_advanced(${r_header} ${r_library})
endfunction()

function(dismount_ship p_target p_imported p_library p_name)
	get_filename_component(library ${p_library} REALPATH)
	set(shipped ${DISMOUNT_BIN_DIR}/${p_name})
	add_custom_command(
		OUTPUT ${shipped}
		COMMAND ${CMAKE_COMMAND} -E make_directory ${DISMOUNT_BIN_DIR}
		COMMAND ${CMAKE_COMMAND} -E copy ${library} ${shipped}
		DEPENDS ${library}
		COMMENT "Copying ${p_name} beside the extensions"
		VERBATIM
	)
	target_sources(${p_target} PRIVATE ${shipped})
	target_link_libraries(${p_target} PRIVATE ${p_imported})
	set_target_properties(${p_target} PROPERTIES
		BUILD_WITH_INSTALL_RPATH ON
		INSTALL_RPATH "$ORIGIN"
	)
endfunction()
