# SPDX-License-Identifier: MIT
# The kinds of target a module is made of:
#
#   dismount_add_core_library(<name> SOURCES <file>... [LIBRARIES <target>...])
#       Static library that knows nothing of the engine.
#   dismount_add_core_test(<name> SOURCES <file>... [LIBRARIES <target>...])
#       Executable that ctest runs; it passes when it exits with 0.
#   dismount_add_extension(<name> SOURCES <file>... [LIBRARIES <target>...] [DOCS <file>...])
#       gdextension/bin/lib<name>.linux.<architecture>.so, linked to godot::cpp.
include_guard()

set(DISMOUNT_BIN_DIR ${CMAKE_CURRENT_SOURCE_DIR}/bin CACHE PATH "Where the extensions go")

# The architecture as Godot's feature tags name it.
function(_dismount_architecture p_out)
	string(TOLOWER "${CMAKE_SYSTEM_PROCESSOR}" arch)
	if(arch MATCHES "^(amd64|x86-64|x86_64)$")
		set(arch x86_64)
	elseif(arch MATCHES "^(aarch64|arm64)")
		set(arch arm64)
	endif()
	set(${p_out} ${arch} PARENT_SCOPE)
endfunction()

function(_dismount_warnings p_target)
	target_compile_options(${p_target} PRIVATE -Wall -Wextra)
endfunction()

# Only cores and their tests are sanitized: what the engine loads must not be.
function(_dismount_sanitize p_target)
	if(DISMOUNT_SANITIZE)
		set(flags -fsanitize=${DISMOUNT_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer -g)
		target_compile_options(${p_target} PUBLIC ${flags})
		target_link_options(${p_target} PUBLIC ${flags})
	endif()
endfunction()

function(dismount_add_core_library p_name)
	cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LIBRARIES")
	add_library(${p_name} STATIC ${arg_SOURCES})
	target_include_directories(${p_name} PUBLIC ${CMAKE_CURRENT_SOURCE_DIR}/src)
	target_link_libraries(${p_name} PUBLIC ${arg_LIBRARIES})
	set_target_properties(${p_name} PROPERTIES
		POSITION_INDEPENDENT_CODE ON
		CXX_VISIBILITY_PRESET hidden
		VISIBILITY_INLINES_HIDDEN ON
	)
	_dismount_warnings(${p_name})
	_dismount_sanitize(${p_name})
endfunction()

function(dismount_add_core_test p_name)
	cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LIBRARIES")
	if(NOT BUILD_TESTING)
		return()
	endif()
	add_executable(${p_name} ${arg_SOURCES})
	# Assertions stay on in tests, and the shared check.hpp is found by its plain name.
	target_compile_options(${p_name} PRIVATE -UNDEBUG)
	target_include_directories(${p_name} PRIVATE ${CMAKE_SOURCE_DIR}/testing)
	target_link_libraries(${p_name} PRIVATE ${arg_LIBRARIES})
	_dismount_warnings(${p_name})
	_dismount_sanitize(${p_name})
	add_test(NAME ${p_name} COMMAND ${p_name})
	set_tests_properties(${p_name} PROPERTIES TIMEOUT 120)
endfunction()

function(dismount_add_extension p_name)
	cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LIBRARIES;DOCS")
	if(NOT DISMOUNT_EXTENSIONS)
		return()
	endif()
	_dismount_architecture(arch)
	add_library(${p_name} SHARED ${arg_SOURCES})
	target_link_libraries(${p_name} PRIVATE godot::cpp ${arg_LIBRARIES})
	target_link_options(${p_name} PRIVATE -Wl,--no-undefined $<$<CONFIG:Release>:-s>)
	set_target_properties(${p_name} PROPERTIES
		PREFIX lib
		SUFFIX .linux.${arch}.so
		LIBRARY_OUTPUT_DIRECTORY ${DISMOUNT_BIN_DIR}
		CXX_VISIBILITY_PRESET hidden
		VISIBILITY_INLINES_HIDDEN ON
	)
	_dismount_warnings(${p_name})
endfunction()
