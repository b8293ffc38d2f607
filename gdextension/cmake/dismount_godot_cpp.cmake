# SPDX-License-Identifier: MIT
# Provides godot::cpp: our own small bindings (gdextension/bindings), or the real godot-cpp when
# GODOT_CPP_DIR names a checkout of it.
include_guard()

set(DISMOUNT_API_JSON ${GODOT_API_DIR}/extension_api.json)
set(DISMOUNT_INTERFACE_H ${GODOT_API_DIR}/gdextension_interface.h)
foreach(file ${DISMOUNT_API_JSON} ${DISMOUNT_INTERFACE_H})
	if(NOT EXISTS ${file})
		message(FATAL_ERROR
			"${file} does not exist. Set GODOT_API_DIR to the folder into which the engine wrote its API:\n"
			"  godot --headless --dump-extension-api --dump-gdextension-interface")
	endif()
endforeach()

if(GODOT_CPP_DIR)
	set(GODOTCPP_CUSTOM_API_FILE ${DISMOUNT_API_JSON} CACHE FILEPATH "The engine's API" FORCE)
	set(GODOTCPP_GDEXTENSION_DIR ${GODOT_API_DIR} CACHE PATH "The engine's interface header" FORCE)
	set(GODOTCPP_BUILD_PROFILE ${DISMOUNT_BUILD_PROFILE} CACHE FILEPATH "The engine classes in use" FORCE)
	add_subdirectory(${GODOT_CPP_DIR} ${CMAKE_BINARY_DIR}/godot-cpp EXCLUDE_FROM_ALL)
else()
	add_subdirectory(bindings)
endif()
