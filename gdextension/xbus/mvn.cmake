# SPDX-License-Identifier: MIT
# MVN's network stream, without input and output.
dismount_add_core_library(xbus_mvn SOURCES
	src/mvn/collector.cpp
	src/mvn/datagram.cpp
	src/mvn/encoder.cpp
	LIBRARIES xbus_bus
)
foreach(test datagram collector)
	dismount_add_core_test(mvn_${test} SOURCE tests/mvn/test_${test}.cpp LIBRARIES xbus_mvn)
endforeach()
# Hostile datagrams, as many as asked for: mvn_fuzz EXECUTIONS [SEED].
dismount_add_fuzzer(mvn_fuzz CORPUS mvn SOURCE tests/mvn/fuzz_datagrams.cpp LIBRARIES xbus_mvn)
