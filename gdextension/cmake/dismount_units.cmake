# SPDX-License-Identifier: MIT
# Compiles several sources as one: most of the work of compiling is in headers.
#
#   dismount_add_sources(<target> <file>...)
#       Adds sources to a target in units of DISMOUNT_UNIT. Sources with options of their own stay alone.
#
# CMake's own UNITY_BUILD names sources by their full paths: with it, ccache finds nothing for a clone in another
# folder.
include_guard()

set(DISMOUNT_UNIT 16 CACHE STRING "How many sources are compiled as one; 1: each alone")

function(dismount_add_sources p_target)
	set(alone)
	set(together)
	foreach(source ${ARGN})
		get_filename_component(source ${source} ABSOLUTE)
		get_source_file_property(options ${source} COMPILE_OPTIONS)
		if(DISMOUNT_UNIT EQUAL 1 OR options)
			list(APPEND alone ${source})
		else()
			list(APPEND together ${source})
		endif()
	endforeach()
	target_sources(${p_target} PRIVATE ${alone})
	if(together)
		_dismount_unite(${p_target} "${together}")
	endif()
endfunction()

# Equal shares, so that no processor is left with a large unit at the end.
function(_dismount_unite p_target p_sources)
	list(LENGTH p_sources count)
	math(EXPR units "(${count} + ${DISMOUNT_UNIT} - 1) / ${DISMOUNT_UNIT}")
	set(begin 0)
	foreach(number RANGE 1 ${units})
		math(EXPR end "${count} * ${number} / ${units}")
		math(EXPR size "${end} - ${begin}")
		list(SUBLIST p_sources ${begin} ${size} share)
		set(begin ${end})
		_dismount_add_unit(${p_target} "${share}")
	endforeach()
endfunction()

# Named after its first source.
function(_dismount_add_unit p_target p_sources)
	set(text "// Made by dismount_units.cmake.\n")
	foreach(source ${p_sources})
		# Found by -iquote: the text is the same in all clones.
		string(REPLACE "${PROJECT_SOURCE_DIR}/" "" source ${source})
		string(REPLACE "${PROJECT_BINARY_DIR}/" "" source ${source})
		string(APPEND text "#include \"${source}\" // NOLINT(bugprone-suspicious-include)\n")
	endforeach()
	list(GET p_sources 0 first)
	get_filename_component(first ${first} NAME_WE)
	set(unit ${CMAKE_CURRENT_BINARY_DIR}/units/${p_target}_from_${first}.cpp)
	file(GENERATE OUTPUT ${unit} CONTENT "${text}")
	target_sources(${p_target} PRIVATE ${unit})
	target_compile_options(${p_target} PRIVATE
		"SHELL:-iquote ${PROJECT_SOURCE_DIR}" "SHELL:-iquote ${PROJECT_BINARY_DIR}")
endfunction()
