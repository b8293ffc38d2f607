# SPDX-License-Identifier: MIT
# The Xbus protocol without any input or output: framing, decoding, encoding, judging a stream.
dismount_add_core_library(xbus_bus SOURCES
	src/bus/configuration.cpp
	src/bus/counter_track.cpp
	src/bus/data_item.cpp
	src/bus/encoder.cpp
	src/bus/framer.cpp
	src/bus/message.cpp
	src/bus/mt_data.cpp
	src/bus/number.cpp
	src/bus/plausibility.cpp
	src/bus/requests.cpp
	src/bus/sample.cpp
	src/bus/stream_check.cpp
)
# What the product does not need: all that devices can send, read and written. For the decoder, the emulated suit,
# tests and benchmarks.
dismount_add_core_library(xbus_device SOURCES
	device/full_judge.cpp
	device/full_mt_data.cpp
	device/item_structs.cpp
	device/item_types.cpp
	device/items.cpp
	device/number_writer.cpp
	device/replies.cpp
	LIBRARIES xbus_bus
)
target_include_directories(xbus_device PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
foreach(test configuration corruption examples framer golden mt_data mt_data2)
	dismount_add_core_test(xbus_${test} SOURCE tests/test_${test}.cpp LIBRARIES xbus_device)
endforeach()
# Counts allocations: it replaces its program's operators.
dismount_add_test_program(xbus_stream_check SOURCE tests/test_stream_check.cpp LIBRARIES xbus_device)
# Hostile bytes, as many as asked for: xbus_fuzz EXECUTIONS [SEED].
dismount_add_fuzzer(xbus_fuzz CORPUS bus SOURCE tests/fuzz_bus.cpp LIBRARIES xbus_device)
# What a recording holds: ./run xbus-decode FILE.
dismount_add_program(xbus_decode SOURCES
	tools/decode/analysis.cpp
	tools/decode/control_json.cpp
	tools/decode/formats.cpp
	tools/decode/guess.cpp
	tools/decode/main.cpp
	tools/decode/recording.cpp
	tools/decode/report_json.cpp
	tools/decode/report_text.cpp
	tools/decode/sample_json.cpp
	tools/decode/status_bytes.cpp
	LIBRARIES xbus_recording xbus_device
)
# The figures of ./run bench xbus.
dismount_add_program(xbus_bench SOURCES tools/bench_bus.cpp LIBRARIES xbus_recording xbus_device)
target_include_directories(xbus_bench PRIVATE tests ${PROJECT_SOURCE_DIR}/testing)
