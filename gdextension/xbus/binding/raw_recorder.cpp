// SPDX-License-Identifier: MIT
#include "raw_recorder.hpp"

#include <recording/taps.hpp>

namespace godot {

String RawRecorder::open(const String &p_path) {
	return String::utf8(_recorder->open(p_path.utf8().get_data(), recording::about_file()).c_str());
}

Dictionary RawRecorder::get_stats() const {
	const recording::RecorderStats stats = _recorder->stats();
	Dictionary result;
	result["records"] = int64_t(stats.records);
	result["bytes"] = int64_t(stats.bytes);
	result["lost"] = int64_t(stats.lost);
	result["fault"] = String::utf8(stats.fault.c_str());
	return result;
}

void RawRecorder::_bind_methods() {
	ClassDB::bind_method(D_METHOD("open", "path"), &RawRecorder::open);
	ClassDB::bind_method(D_METHOD("close"), &RawRecorder::close);
	ClassDB::bind_method(D_METHOD("get_stats"), &RawRecorder::get_stats);
}

} // namespace godot
