# SPDX-License-Identifier: MIT
# Brings a suit up and keeps it measuring; no input, no output.
dismount_add_core_library(xbus_session SOURCES
	src/session/session.cpp
	src/session/session_answers.cpp
	src/session/session_requests.cpp
	src/session/session_stream.cpp
	src/session/suit_stream.cpp
	LIBRARIES xbus_bus
)
foreach(test no_session_allocation session)
	dismount_add_core_test(xbus_test_${test} SOURCES tests/session/test_${test}.cpp LIBRARIES xbus_session xbus_emulator)
endforeach()
foreach(test source_clock stream_time)
	dismount_add_core_test(xbus_${test} SOURCES tests/clock/test_${test}.cpp LIBRARIES xbus_bus)
endforeach()
