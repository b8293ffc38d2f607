# SPDX-License-Identifier: MIT
# MVN's network stream from a socket.
find_package(Threads REQUIRED)
dismount_add_core_library(xbus_udp SOURCES
	src/udp/receiver.cpp
	LIBRARIES xbus_mvn Threads::Threads
)
dismount_add_core_test(mvn_receiver SOURCE tests/mvn/test_receiver.cpp LIBRARIES xbus_udp THREADS)
