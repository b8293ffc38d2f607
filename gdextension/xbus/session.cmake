# SPDX-License-Identifier: MIT
# Brings a suit up and keeps it measuring; no input, no output.
dismount_add_core_library(xbus_session SOURCES
	src/session/device_setup.cpp
	src/session/exchange.cpp
	src/session/measurement.cpp
	src/session/output_choice.cpp
	src/session/session.cpp
	src/session/session_log.cpp
	src/session/session_report.cpp
	src/session/setup_step.cpp
	src/session/stream_health.cpp
	src/session/suit_stream.cpp
	LIBRARIES clock_core xbus_bus
)
dismount_add_core_test(xbus_test_session SOURCE tests/session/test_session.cpp LIBRARIES xbus_session xbus_emulator)
# Counts allocations: it replaces its program's operators.
dismount_add_test_program(xbus_test_no_session_allocation
	SOURCE tests/session/test_no_session_allocation.cpp LIBRARIES xbus_session xbus_emulator)
