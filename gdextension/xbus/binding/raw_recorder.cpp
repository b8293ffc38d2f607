// SPDX-License-Identifier: MIT
#include "raw_recorder.hpp"

#include <recording/taps.hpp>

namespace godot {

String RawRecorder::open(const String &p_path) {
	return String::utf8(_recorder->open(p_path.utf8().get_data(), recording::about_file()).c_str());
}

Dictionary RawRecorder::get_figures() const {
	const recording::RecorderFigures figures = _recorder->figures();
	Dictionary result;
	result["records"] = int64_t(figures.records);
	result["bytes"] = int64_t(figures.bytes);
	result["lost"] = int64_t(figures.lost);
	result["fault"] = String::utf8(figures.fault.c_str());
	return result;
}

void RawRecorder::_bind_methods() {
	ClassDB::bind_method(D_METHOD("open", "path"), &RawRecorder::open);
	ClassDB::bind_method(D_METHOD("close"), &RawRecorder::close);
	ClassDB::bind_method(D_METHOD("get_figures"), &RawRecorder::get_figures);
}

} // namespace godot
