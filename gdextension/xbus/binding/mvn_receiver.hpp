// SPDX-License-Identifier: MIT
#pragma once

#include "raw_recorder.hpp"

#include <recording/taps.hpp>
#include <source_clock.hpp>
#include <udp/receiver.hpp>

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <atomic>
#include <map>
#include <memory>
#include <mutex>

namespace godot {

/// Receives MVN's network stream. Documented in doc_classes/MvnReceiver.xml.
class MvnReceiver : public RefCounted {
	GDCLASS(MvnReceiver, RefCounted)

public:
	String open(int64_t p_port);
	void close();
	void set_recorder(const Ref<RawRecorder> &p_recorder);
	int64_t get_port() const { return _receiver.port(); }
	void put(const String &p_sender, const PackedByteArray &p_datagram, int64_t p_time_usec);
	TypedArray<Dictionary> get_characters() const;
	Dictionary get_stats() const;
	PackedStringArray take_messages();
	PackedStringArray take_news();
	TypedArray<Dictionary> take_poses(int64_t p_character);
	TypedArray<Dictionary> take_trackers(int64_t p_character);
	Dictionary get_newest(int64_t p_character, int64_t p_type) const;

protected:
	static void _bind_methods();

private:
	TypedArray<Dictionary> take_type(int64_t p_character, mvn::Type p_type);
	uint64_t now_usec() const;
	int64_t to_unix(uint64_t p_usec) const;

	/// Outlives the receiver's thread, which calls it.
	std::unique_ptr<recording::DatagramTap> _tap;
	std::shared_ptr<recording::Recorder> _recorder;
	mvn::Receiver _receiver;
	/// The time of the newest datagram that was put in, µs; 0 where they come from a port.
	std::atomic<uint64_t> _put_usec{ 0 };
	/// Of each character and type; threads may ask for different people at once.
	std::map<std::pair<int64_t, int>, clocks::SourceClock> _clocks;
	std::mutex _mutex;
};

} // namespace godot
