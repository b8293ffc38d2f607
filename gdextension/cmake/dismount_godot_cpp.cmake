# SPDX-License-Identifier: MIT
# Provides godot::cpp: our own small bindings (gdextension/bindings), or the real godot-cpp when
# GODOT_CPP_DIR names a checkout of it. And, for either, a way to give an extension its class
# documentation:
#
#   dismount_add_documentation(<target> <file.xml>...)
include_guard()

find_package(Python3 3.9 REQUIRED COMPONENTS Interpreter)

set(DISMOUNT_API_JSON ${GODOT_API_DIR}/extension_api.json)
set(DISMOUNT_INTERFACE_H ${GODOT_API_DIR}/gdextension_interface.h)
set(DISMOUNT_BINDINGS_DIR ${CMAKE_CURRENT_SOURCE_DIR}/bindings)
# The real godot-cpp brings an API and an interface of its own, which serve where the engine's are not
# given: the interface only ever grows. GODOTCPP_CUSTOM_API_FILE is its variable for any other API.
if(GODOT_CPP_DIR)
	if(NOT EXISTS ${GODOT_CPP_DIR}/CMakeLists.txt)
		message(FATAL_ERROR "GODOT_CPP_DIR (${GODOT_CPP_DIR}) is no checkout of godot-cpp.")
	endif()
	set(GODOTCPP_TARGET template_debug CACHE STRING "Build target of godot-cpp")
	set(GODOTCPP_BUILD_PROFILE ${DISMOUNT_BUILD_PROFILE} CACHE FILEPATH "The engine classes in use" FORCE)
	if(EXISTS ${DISMOUNT_API_JSON})
		set(GODOTCPP_CUSTOM_API_FILE ${DISMOUNT_API_JSON} CACHE FILEPATH "The engine's API" FORCE)
	else()
		set(GODOTCPP_API_VERSION 4.6 CACHE STRING "Version of the API that godot-cpp brings")
	endif()
	if(EXISTS ${GODOT_API_DIR}/gdextension_interface.json)
		set(GODOTCPP_GDEXTENSION_DIR ${GODOT_API_DIR} CACHE PATH "The engine's interface" FORCE)
	endif()
	set(GODOTCPP_SYSTEM_HEADERS ON CACHE BOOL "No warnings from godot-cpp's headers")
	add_subdirectory(${GODOT_CPP_DIR} ${CMAKE_BINARY_DIR}/godot-cpp EXCLUDE_FROM_ALL)
else()
	foreach(file ${DISMOUNT_API_JSON} ${DISMOUNT_INTERFACE_H})
		if(NOT EXISTS ${file})
			message(FATAL_ERROR
				"${file} does not exist. Set GODOT_API_DIR to the folder into which the engine wrote its API:\n"
				"  godot --headless --dump-extension-api --dump-gdextension-interface")
		endif()
	endforeach()
	add_subdirectory(bindings)
endif()

function(dismount_add_documentation p_target)
	list(TRANSFORM ARGN PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/ OUTPUT_VARIABLE pages)
	if(GODOT_CPP_DIR)
		if(NOT COMMAND target_doc_sources OR TARGET generate_doc_source)
			# godot-cpp's function makes a target of a fixed name.
			message(STATUS "godot-cpp can embed documentation once per build: not in ${p_target}")
			return()
		endif()
		target_doc_sources(${p_target} "${pages}")
		return()
	endif()
	set(source ${CMAKE_CURRENT_BINARY_DIR}/${p_target}_documentation.cpp)
	add_custom_command(
		OUTPUT ${source}
		COMMAND ${CMAKE_COMMAND} -E env PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=${DISMOUNT_BINDINGS_DIR}
			${Python3_EXECUTABLE} -m generator.embed_documentation --output ${source} ${pages}
		DEPENDS ${pages} ${DISMOUNT_BINDINGS_DIR}/generator/embed_documentation.py
		COMMENT "Embedding the documentation of ${p_target}"
		VERBATIM
	)
	target_sources(${p_target} PRIVATE ${source})
endfunction()
