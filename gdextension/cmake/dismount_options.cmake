# SPDX-License-Identifier: MIT
# Settings that hold for every target, and the options a user may set.
include_guard()

option(DISMOUNT_EXTENSIONS "Build the bindings and the extensions; OFF builds the engine-free cores and their tests only" ON)
set(DISMOUNT_SANITIZE "" CACHE STRING "Sanitizers for the cores and their tests, e.g. address,undefined")
set(GODOT_API_DIR "" CACHE PATH "Folder with the engine's extension_api.json and gdextension_interface.h")
set(GODOT_CPP_DIR "" CACHE PATH "Checkout of the real godot-cpp, to build against it instead of gdextension/bindings")
set(DISMOUNT_BUILD_PROFILE ${CMAKE_CURRENT_SOURCE_DIR}/build_profile.json
	CACHE FILEPATH "Build profile that names the engine classes in use")

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
	set(CMAKE_BUILD_TYPE Release CACHE STRING "Kind of build" FORCE)
endif()

# The library is the same for the debug and the release engine: -O2 with assertions off.
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG" CACHE STRING "Flags of a release build" FORCE)
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

if(DISMOUNT_SANITIZE AND DISMOUNT_EXTENSIONS)
	message(STATUS "DISMOUNT_SANITIZE is set: the engine could not load sanitized extensions, so only the cores and their tests are built.")
	set(DISMOUNT_EXTENSIONS OFF)
endif()
