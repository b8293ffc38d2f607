# SPDX-License-Identifier: MIT
# MVN's network stream, without input and output.
dismount_add_core_library(xbus_mvn SOURCES
	src/mvn/collector.cpp
	src/mvn/datagram.cpp
	src/mvn/encoder.cpp
	LIBRARIES xbus_bus
)
