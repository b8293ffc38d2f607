// SPDX-License-Identifier: MIT
#pragma once

#include <recording/recorder.hpp>

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/string.hpp>

#include <memory>

namespace godot {

/// Writes recordings of raw bytes. Documented in doc_classes/RawRecorder.xml.
class RawRecorder : public RefCounted {
	GDCLASS(RawRecorder, RefCounted)

public:
	String open(const String &p_path);
	void close() { _recorder->close(); }
	Dictionary get_stats() const;
	std::shared_ptr<recording::Recorder> share() const { return _recorder; }

protected:
	static void _bind_methods();

private:
	std::shared_ptr<recording::Recorder> _recorder = std::make_shared<recording::Recorder>();
};

} // namespace godot
