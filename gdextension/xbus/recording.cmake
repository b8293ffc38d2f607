# SPDX-License-Identifier: MIT
# Raw bytes kept and played: what came over a bus or a network, and when.
find_package(Threads REQUIRED)
dismount_add_core_library(xbus_recording SOURCES
	src/recording/bus_replay.cpp
	src/recording/reader.cpp
	src/recording/recorder.cpp
	src/recording/taps.cpp
	LIBRARIES xbus_session Threads::Threads
)
foreach(test recorder replay)
	dismount_add_core_test(recording_${test} SOURCES tests/recording/test_${test}.cpp LIBRARIES xbus_recording)
endforeach()
