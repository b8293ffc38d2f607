# SPDX-License-Identifier: MIT
# The kinds of tests a module has; all belong to the target core_tests:
#
#   dismount_add_core_test(<name> SOURCE <file> [LIBRARIES <target>...] [THREADS])
#       The tests of a file, which ctest runs by themselves. All files of a module make one program, so each has its
#       own namespace. With THREADS they run several threads: they have ctest's label "threads" and belong to the
#       target thread_tests, for the thread sanitizer.
#   dismount_add_test_program(<name> SOURCE <file> [LIBRARIES <target>...] [THREADS])
#       Tests that need a program of their own: it passes when it exits with 0.
#   dismount_add_fuzzer(<name> CORPUS <folder> SOURCE <file> [LIBRARIES <target>...])
#       The same for a fuzzer: <name> EXECUTIONS [SEED]. It finds its seeds in tests/corpus/<folder>.
include_guard()

add_custom_target(core_tests)
add_custom_target(thread_tests)
# Sanitizers slow a test down several times.
set(DISMOUNT_TEST_LIMIT_S 120)
if(DISMOUNT_SANITIZE)
	set(DISMOUNT_TEST_LIMIT_S 400)
endif()

# Where tests find their data. A file of its own: in commands the path would keep ccache from finding anything for a
# clone in another folder.
if(BUILD_TESTING)
	set(_source ${PROJECT_BINARY_DIR}/test_data.cpp)
	file(GENERATE OUTPUT ${_source} CONTENT
		"#include <test_data.hpp>\nconst char *const test_data::SOURCES = \"${PROJECT_SOURCE_DIR}\";\n")
	add_library(test_data STATIC ${_source})
	target_include_directories(test_data PUBLIC ${PROJECT_SOURCE_DIR}/testing)
endif()

function(_dismount_add_test_target p_name)
	add_executable(${p_name} ${ARGN})
	# Assertions stay on in tests, and the shared check.hpp is found by its plain name.
	target_compile_options(${p_name} PRIVATE -UNDEBUG)
	target_include_directories(${p_name} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/tests)
	target_link_libraries(${p_name} PRIVATE test_data)
	_dismount_common(${p_name})
	_dismount_sanitize(${p_name})
endfunction()

function(_dismount_add_test p_name)
	add_test(NAME ${p_name} COMMAND ${ARGN})
	set_tests_properties(${p_name} PROPERTIES TIMEOUT ${DISMOUNT_TEST_LIMIT_S})
endfunction()

function(dismount_add_test_program p_name)
	cmake_parse_arguments(PARSE_ARGV 1 arg "THREADS" "SOURCE" "LIBRARIES")
	if(BUILD_TESTING)
		_dismount_add_test_target(${p_name} ${arg_SOURCE})
		target_link_libraries(${p_name} PRIVATE ${arg_LIBRARIES})
		add_dependencies(core_tests ${p_name})
		_dismount_add_test(${p_name} ${p_name})
		if(arg_THREADS)
			dismount_mark_threaded(${p_name} ${p_name})
		endif()
	endif()
endfunction()

function(dismount_add_fuzzer p_name)
	cmake_parse_arguments(PARSE_ARGV 1 arg "" "CORPUS;SOURCE" "LIBRARIES")
	if(BUILD_TESTING)
		dismount_add_test_program(${p_name} SOURCE ${arg_SOURCE} LIBRARIES ${arg_LIBRARIES})
		file(RELATIVE_PATH corpus ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR}/tests/corpus/${arg_CORPUS})
		target_compile_definitions(${p_name} PRIVATE DISMOUNT_CORPUS="${corpus}")
	endif()
endfunction()

function(dismount_add_core_test p_name)
	cmake_parse_arguments(PARSE_ARGV 1 arg "THREADS" "SOURCE" "LIBRARIES")
	if(NOT BUILD_TESTING)
		return()
	endif()
	get_filename_component(module ${CMAKE_CURRENT_SOURCE_DIR} NAME)
	set(program ${module}_tests)
	if(arg_THREADS)
		set(program ${module}_thread_tests)
	endif()
	if(NOT TARGET ${program})
		_dismount_add_test_target(${program} ${PROJECT_SOURCE_DIR}/testing/main.cpp)
		add_dependencies(core_tests ${program})
		cmake_language(EVAL CODE "cmake_language(DEFER CALL _dismount_add_tested ${program})")
	endif()
	set_property(TARGET ${program} APPEND PROPERTY DISMOUNT_TESTED ${arg_SOURCE})
	target_link_libraries(${program} PRIVATE ${arg_LIBRARIES})
	get_filename_component(file ${arg_SOURCE} NAME_WE)
	_dismount_add_test(${p_name} ${program} ${file})
	if(arg_THREADS)
		dismount_mark_threaded(${p_name} ${program})
	endif()
endfunction()

function(_dismount_add_tested p_program)
	get_target_property(sources ${p_program} DISMOUNT_TESTED)
	dismount_add_sources(${p_program} ${sources})
endfunction()

# Says of a test that it runs several threads, and what is built for it.
function(dismount_mark_threaded p_test)
	set_tests_properties(${p_test} PROPERTIES LABELS threads)
	add_dependencies(thread_tests ${ARGN})
endfunction()
