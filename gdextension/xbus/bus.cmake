# SPDX-License-Identifier: MIT
# The Xbus protocol without any input or output: framing, decoding, encoding, judging a stream.
dismount_add_core_library(xbus_bus SOURCES
	src/bus/configuration.cpp
	src/bus/counter_track.cpp
	src/bus/data_item.cpp
	src/bus/encoder.cpp
	src/bus/framer.cpp
	src/bus/item_structs.cpp
	src/bus/item_types.cpp
	src/bus/message.cpp
	src/bus/mt_data.cpp
	src/bus/mt_data2.cpp
	src/bus/number.cpp
	src/bus/plausibility.cpp
	src/bus/replies.cpp
	src/bus/requests.cpp
	src/bus/sample.cpp
	src/bus/stream_check.cpp
)
foreach(test corruption examples framer golden)
	dismount_add_core_test(xbus_${test} SOURCES tests/test_${test}.cpp LIBRARIES xbus_bus)
endforeach()
if(TARGET xbus_golden)
	target_compile_definitions(xbus_golden PRIVATE DISMOUNT_TEST_DATA="${PROJECT_SOURCE_DIR}/../tests/data")
endif()
# Hostile bytes, as many as asked for: xbus_fuzz EXECUTIONS [SEED].
dismount_add_core_test(xbus_fuzz SOURCES tests/fuzz_bus.cpp LIBRARIES xbus_bus)
