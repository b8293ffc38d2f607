# SPDX-License-Identifier: MIT
# The kinds of target a module is made of:
#
#   dismount_add_core_library(<name> SOURCES <file>... [LIBRARIES <target>...])
#       Static library that knows nothing of the engine.
#   dismount_add_core_test(<name> SOURCES <file>... [LIBRARIES <target>...] [THREADS])
#       Executable that ctest runs; it passes when it exits with 0. With THREADS it runs several threads: it has
#       ctest's label "threads" and belongs to the target thread_tests, for the thread sanitizer.
#   dismount_add_fuzzer(<name> CORPUS <folder> SOURCES <file>... [LIBRARIES <target>...])
#       The same for a fuzzer: <name> EXECUTIONS [SEED]. It finds its seeds in tests/corpus/<folder>.
#   dismount_add_extension(<name> SOURCES <file>... [LIBRARIES <target>...] [DOCS <file.xml>...])
#       ${DISMOUNT_BIN_DIR}/lib<name>.linux.<architecture>.so, linked to godot::cpp, with its class
#       documentation inside. Does nothing where the extensions are not built.
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

function(_dismount_common p_target)
	# Error messages carry the file: say it from the repository's root, wherever that is.
	target_compile_options(${p_target} PRIVATE
		-Wall -Wextra -ffile-prefix-map=${PROJECT_SOURCE_DIR}=gdextension)
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

# What is built to run the tests, and those of several threads alone.
add_custom_target(core_tests)
add_custom_target(thread_tests)
# Sanitizers slow a test down several times.
set(DISMOUNT_TEST_LIMIT_S 120)
if(DISMOUNT_SANITIZE)
	set(DISMOUNT_TEST_LIMIT_S 400)
endif()

function(dismount_add_core_library p_name)
	cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LIBRARIES")
	add_library(${p_name} STATIC ${arg_SOURCES})
	target_include_directories(${p_name} PUBLIC ${CMAKE_CURRENT_SOURCE_DIR}/src)
	target_link_libraries(${p_name} PUBLIC ${arg_LIBRARIES})
	set_target_properties(${p_name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
	_dismount_common(${p_name})
	_dismount_sanitize(${p_name})
endfunction()

function(dismount_add_core_test p_name)
	cmake_parse_arguments(PARSE_ARGV 1 arg "THREADS" "" "SOURCES;LIBRARIES")
	if(NOT BUILD_TESTING)
		return()
	endif()
	add_executable(${p_name} ${arg_SOURCES})
	# Assertions stay on in tests, and the shared check.hpp is found by its plain name.
	target_compile_options(${p_name} PRIVATE -UNDEBUG)
	target_include_directories(${p_name} PRIVATE ${PROJECT_SOURCE_DIR}/testing ${CMAKE_CURRENT_SOURCE_DIR}/tests)
	target_link_libraries(${p_name} PRIVATE ${arg_LIBRARIES})
	_dismount_common(${p_name})
	_dismount_sanitize(${p_name})
	add_test(NAME ${p_name} COMMAND ${p_name})
	set_tests_properties(${p_name} PROPERTIES TIMEOUT ${DISMOUNT_TEST_LIMIT_S})
	add_dependencies(core_tests ${p_name})
	if(arg_THREADS)
		dismount_mark_threaded(${p_name} ${p_name})
	endif()
endfunction()

function(dismount_add_fuzzer p_name)
	cmake_parse_arguments(PARSE_ARGV 1 arg "" "CORPUS" "SOURCES;LIBRARIES")
	if(NOT BUILD_TESTING)
		return()
	endif()
	dismount_add_core_test(${p_name} SOURCES ${arg_SOURCES} LIBRARIES ${arg_LIBRARIES})
	target_compile_definitions(${p_name} PRIVATE
		DISMOUNT_CORPUS="${CMAKE_CURRENT_SOURCE_DIR}/tests/corpus/${arg_CORPUS}")
endfunction()

# Says of a test that it runs several threads, and what is built for it.
function(dismount_mark_threaded p_test)
	set_tests_properties(${p_test} PROPERTIES LABELS threads)
	add_dependencies(thread_tests ${ARGN})
endfunction()

function(dismount_add_extension p_name)
	cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LIBRARIES;DOCS")
	if(NOT DISMOUNT_EXTENSIONS)
		return()
	endif()
	_dismount_architecture(architecture)
	add_library(${p_name} SHARED ${arg_SOURCES})
	target_link_libraries(${p_name} PRIVATE godot::cpp ${arg_LIBRARIES})
	# Stripped in a release; a missing symbol is found here rather than by the engine.
	target_link_options(${p_name} PRIVATE -Wl,--no-undefined $<$<CONFIG:Release>:-s>)
	set_target_properties(${p_name} PROPERTIES
		PREFIX lib
		SUFFIX .linux.${architecture}.so
		LIBRARY_OUTPUT_DIRECTORY ${DISMOUNT_BIN_DIR}
	)
	_dismount_common(${p_name})
	if(arg_DOCS)
		dismount_add_documentation(${p_name} ${arg_DOCS})
	endif()
endfunction()
