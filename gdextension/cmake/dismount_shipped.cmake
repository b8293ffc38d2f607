# SPDX-License-Identifier: MIT
# Finds libraries that are not ours, and ships them with an extension:
#
#   dismount_find_in(<folder like /usr, or empty> <header> <suffix> <library> <header's variable> <library's variable>)
#       Finds a header and a library in the folder that was named, and nowhere else; or in the system.
#   dismount_ship(<target> <imported target> <library> <name>)
#       Copies the library under that name beside the built extensions, where the target then finds
#       it. Name it under [dependencies] in the extension's .gdextension file: exports carry it then.
#   dismount_import(<name> <header> <library> <Debian package>)
#       Provides <name>::<name> (shared) from DISMOUNT_<NAME>_ROOT or from the system.
#   dismount_ship_imported(<target> <name> <licence>)
#       Ships what dismount_import has found, with its licence, which must lie beside it.
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

function(dismount_import p_name p_header p_library p_package)
	string(TOUPPER ${p_name} NAME)
	set(DISMOUNT_${NAME}_ROOT "" CACHE PATH "Folder like /usr that holds ${p_name}; empty for the system's")
	dismount_find_in("${DISMOUNT_${NAME}_ROOT}" ${p_header} "" ${p_library} DISMOUNT_${NAME}_INCLUDE DISMOUNT_${NAME}_LIBRARY)
	if(NOT DISMOUNT_${NAME}_INCLUDE OR NOT DISMOUNT_${NAME}_LIBRARY)
		message(FATAL_ERROR
			"${p_name} was not found: install its headers (Debian: ${p_package}), or set DISMOUNT_${NAME}_ROOT to a "
			"folder like /usr that holds it.")
	endif()
	# The compiler and the loader know it by the name that its file carries inside: take over what it is.
	get_filename_component(file ${DISMOUNT_${NAME}_LIBRARY} REALPATH)
	get_filename_component(folder ${DISMOUNT_${NAME}_LIBRARY} DIRECTORY)
	string(REGEX REPLACE "^.*/(${p_name}\\.so\\.[0-9]+).*$" "\\1" soname ${file})
	add_library(${p_name}::${p_name} SHARED IMPORTED GLOBAL)
	set_target_properties(${p_name}::${p_name} PROPERTIES
		IMPORTED_LOCATION ${file}
		IMPORTED_SONAME ${soname}
		INTERFACE_INCLUDE_DIRECTORIES ${DISMOUNT_${NAME}_INCLUDE}
		# For libraries that it needs: of the same folder where the system has none.
		INTERFACE_LINK_OPTIONS -Wl,-rpath-link,${folder}
	)
endfunction()

function(dismount_ship_imported p_target p_name p_licence)
	get_target_property(library ${p_name}::${p_name} IMPORTED_LOCATION)
	get_target_property(soname ${p_name}::${p_name} IMPORTED_SONAME)
	configure_file(${p_licence} ${DISMOUNT_BIN_DIR}/${p_name}.txt COPYONLY)
	dismount_ship(${p_target} ${p_name}::${p_name} ${library} ${soname})
endfunction()
