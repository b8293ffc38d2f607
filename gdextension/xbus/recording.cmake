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
# Counts allocations: it replaces its program's operators.
dismount_add_test_program(recording_recorder
	SOURCE tests/recording/test_recorder.cpp LIBRARIES xbus_recording THREADS)
dismount_add_core_test(recording_replay SOURCE tests/recording/test_replay.cpp LIBRARIES xbus_recording xbus_device)
