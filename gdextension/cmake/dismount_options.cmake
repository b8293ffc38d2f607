# SPDX-License-Identifier: MIT
# Settings that hold for every target, and the options a user may set.
include_guard()

option(DISMOUNT_EXTENSIONS "Build the bindings and the extensions; OFF builds the engine-free cores and their tests only" ON)
option(DISMOUNT_USB "Build what needs libusb: suits on USB; the extensions need it" ON)
option(DISMOUNT_UMOCKDEV "Build what needs umockdev: the suit emulator, with which suits on USB are tested" ON)
set(DISMOUNT_SUIT_EMULATOR "" CACHE FILEPATH
	"Suit emulator of another build, for tests of the USB hub: umockdev's threads would be findings of the thread sanitizer")
set(DISMOUNT_SANITIZE "" CACHE STRING "Sanitizers for the cores and their tests: address,undefined or thread")
set(GODOT_API_DIR "" CACHE PATH "Folder with the engine's extension_api.json and gdextension_interface.h")
set(GODOT_CPP_DIR "" CACHE PATH "Checkout of the real godot-cpp, to build against it instead of gdextension/bindings")
set(DISMOUNT_BUILD_PROFILE ${CMAKE_CURRENT_SOURCE_DIR}/build_profile.json
	CACHE FILEPATH "Build profile that names the engine classes in use")

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
	set(CMAKE_BUILD_TYPE Release CACHE STRING "Kind of build" FORCE)
endif()

# The library is the same for the debug and the release engine: -O2 with assertions off. With sanitizers: quick to
# build, with assertions, and with lines to name.
set(_release_flags "-O2 -DNDEBUG")
if(DISMOUNT_SANITIZE)
	set(_release_flags "-Og -g1")
endif()
set(CMAKE_CXX_FLAGS_RELEASE ${_release_flags} CACHE STRING "Flags of a release build" FORCE)
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
# Compiles through ccache where the environment names one.
set(CMAKE_CXX_COMPILER_LAUNCHER ${PROJECT_SOURCE_DIR}/../tools/compile.sh)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

if(DISMOUNT_SANITIZE AND DISMOUNT_EXTENSIONS)
	message(STATUS "DISMOUNT_SANITIZE is set: the engine could not load sanitized extensions, so only the cores and their tests are built.")
	set(DISMOUNT_EXTENSIONS OFF)
endif()
if(DISMOUNT_EXTENSIONS AND NOT DISMOUNT_USB)
	message(FATAL_ERROR "The extensions need libusb: leave DISMOUNT_USB on, or turn DISMOUNT_EXTENSIONS off as well.")
endif()
