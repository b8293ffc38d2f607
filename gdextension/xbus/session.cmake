# SPDX-License-Identifier: MIT
# Brings a suit up and keeps it measuring; no input, no output.
dismount_add_core_library(xbus_session SOURCES
	src/session/session.cpp
	src/session/session_stream.cpp
	src/session/suit_stream.cpp
	LIBRARIES xbus_bus
)
