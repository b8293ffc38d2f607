// SPDX-License-Identifier: MIT
#pragma once

#include <recording/recorder.hpp>
#include <usb/hub.hpp>

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/string.hpp>

#include <map>
#include <memory>

namespace godot {

/// Puts the bytes of all suits into a recording.
class BusTap final : public usb::HubListener {
public:
	/// For the next hub; null records nothing.
	void record_to(std::shared_ptr<recording::Recorder> p_recorder);
	void take_frame(int, const xbus::SuitFrame &) override {}
	void take_raw(
			int p_device, bool p_is_out, const uint8_t *p_bytes, std::size_t p_size, uint64_t p_time_usec) override;
	void device_opened(const usb::DeviceReport &p_report) override;

private:
	std::shared_ptr<recording::Recorder> recorder;
	std::map<int, int> streams;
};

/// Puts the datagrams of MVN's stream into a recording.
class DatagramTap {
public:
	DatagramTap(std::shared_ptr<recording::Recorder> p_recorder, int64_t p_port) :
			recorder(std::move(p_recorder)), port(p_port) {}
	void take(const std::string &p_sender, const uint8_t *p_bytes, std::size_t p_size, uint64_t p_time_usec);

private:
	std::shared_ptr<recording::Recorder> recorder;
	int64_t port;
	std::map<std::string, int> streams;
};

/// Writes recordings of raw bytes. Documented in doc_classes/RawRecorder.xml.
class RawRecorder : public RefCounted {
	GDCLASS(RawRecorder, RefCounted)

public:
	String open(const String &p_path);
	void close() { recorder->close(); }
	Dictionary get_figures() const;
	std::shared_ptr<recording::Recorder> share() const { return recorder; }

protected:
	static void _bind_methods();

private:
	std::shared_ptr<recording::Recorder> recorder = std::make_shared<recording::Recorder>();
};

} // namespace godot
