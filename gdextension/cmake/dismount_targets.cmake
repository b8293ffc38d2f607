# SPDX-License-Identifier: MIT
# The kinds of target a module is made of, besides tests (dismount_tests.cmake):
#
#   dismount_add_core_library(<name> SOURCES <file>... [LIBRARIES <target>...])
#       Static library that knows nothing of the engine.
#   dismount_add_program(<name> SOURCES <file>... [LIBRARIES <target>...])
#       Executable without the engine; belongs to the target programs.
#   dismount_add_extension(<name> SOURCES <file>... [LIBRARIES <target>...] [DOCS <file.xml>...])
#       ${DISMOUNT_BIN_DIR}/lib<name>.linux.<architecture>.so, linked to godot::cpp, with its class
#       documentation inside; belongs to the target extensions. Does nothing where the extensions are not built.
include_guard()

set(DISMOUNT_BIN_DIR ${CMAKE_CURRENT_SOURCE_DIR}/bin CACHE PATH "Folder for the built extensions")

# The architecture as Godot's feature tags name it.
function(_dismount_architecture p_out)
	string(TOLOWER "${CMAKE_SYSTEM_PROCESSOR}" architecture)
	if(architecture MATCHES "^(amd64|x86-64|x86_64)$")
		set(architecture x86_64)
	elseif(architecture MATCHES "^(aarch64|arm64)")
		set(architecture arm64)
	endif()
	set(${p_out} ${architecture} PARENT_SCOPE)
endfunction()

# Error messages carry the file: they say it from the repository's root, wherever that is. ccache compiles by
# relative paths.
file(RELATIVE_PATH _relative ${PROJECT_BINARY_DIR} ${PROJECT_SOURCE_DIR})
set(DISMOUNT_COMMON_OPTIONS -Wall -Wextra
	-ffile-prefix-map=${PROJECT_SOURCE_DIR}=gdextension -ffile-prefix-map=${_relative}=gdextension)

function(_dismount_common p_target)
	target_compile_options(${p_target} PRIVATE ${DISMOUNT_COMMON_OPTIONS})
	set_target_properties(${p_target} PROPERTIES
		CXX_VISIBILITY_PRESET hidden
		VISIBILITY_INLINES_HIDDEN ON
	)
endfunction()

# Only cores and their tests are sanitized: the engine could not load a sanitized extension.
function(_dismount_sanitize p_target)
	if(DISMOUNT_SANITIZE)
		set(flags -fsanitize=${DISMOUNT_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
		target_compile_options(${p_target} PUBLIC ${flags})
		target_link_options(${p_target} PUBLIC ${flags})
	endif()
endfunction()

# What the program itself needs; and what runs without the engine: the emulated suit, the decoder.
add_custom_target(extensions)
add_custom_target(programs)

function(dismount_add_core_library p_name)
	cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LIBRARIES")
	add_library(${p_name} STATIC)
	dismount_add_sources(${p_name} ${arg_SOURCES})
	target_include_directories(${p_name} PUBLIC ${CMAKE_CURRENT_SOURCE_DIR}/src)
	target_link_libraries(${p_name} PUBLIC ${arg_LIBRARIES})
	set_target_properties(${p_name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
	_dismount_common(${p_name})
	_dismount_sanitize(${p_name})
endfunction()

function(dismount_add_program p_name)
	cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LIBRARIES")
	add_executable(${p_name})
	dismount_add_sources(${p_name} ${arg_SOURCES})
	target_link_libraries(${p_name} PRIVATE ${arg_LIBRARIES})
	_dismount_common(${p_name})
	_dismount_sanitize(${p_name})
	add_dependencies(programs ${p_name})
endfunction()

function(dismount_add_extension p_name)
	cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LIBRARIES;DOCS")
	if(NOT DISMOUNT_EXTENSIONS)
		return()
	endif()
	_dismount_architecture(architecture)
	add_library(${p_name} SHARED)
	dismount_add_sources(${p_name} ${arg_SOURCES})
	target_link_libraries(${p_name} PRIVATE godot::cpp ${arg_LIBRARIES})
	# Stripped in a release; a missing symbol is found here rather than by the engine.
	target_link_options(${p_name} PRIVATE -Wl,--no-undefined $<$<CONFIG:Release>:-s>)
	set_target_properties(${p_name} PROPERTIES
		PREFIX lib
		SUFFIX .linux.${architecture}.so
		LIBRARY_OUTPUT_DIRECTORY ${DISMOUNT_BIN_DIR}
	)
	_dismount_common(${p_name})
	add_dependencies(extensions ${p_name})
	if(arg_DOCS)
		dismount_add_documentation(${p_name} ${arg_DOCS})
	endif()
endfunction()
