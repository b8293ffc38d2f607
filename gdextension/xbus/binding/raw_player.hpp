// SPDX-License-Identifier: MIT
#pragma once

#include "suit_device.hpp"
#include "suit_frame.hpp"

#include <recording/bus_replay.hpp>

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <deque>
#include <map>
#include <memory>
#include <mutex>

namespace godot {

/// Plays recordings of raw bytes. Documented in doc_classes/RawPlayer.xml.
class RawPlayer : public RefCounted {
	GDCLASS(RawPlayer, RefCounted)

public:
	String open(const String &p_path);
	void begin(int64_t p_unix_usec, double p_speed);
	int64_t advance(int64_t p_unix_usec);
	Dictionary step();
	bool is_at_end() const;
	double get_length_s() const;
	TypedArray<Dictionary> get_streams() const;
	Dictionary get_stats() const;
	TypedArray<SuitDevice> get_devices() const;
	TypedArray<SuitFrame> take_frames(int64_t p_device);
	TypedArray<Dictionary> take_datagrams();

protected:
	static void _bind_methods();

private:
	struct Stream {
		bool is_bus = false;
		std::string name;
		std::string address;
		std::string serial;
		std::string usb;
		std::string sender;
		std::string port;
		uint64_t records = 0;
		uint64_t bytes = 0;
		std::unique_ptr<recording::BusReplay> replay;
		std::deque<xbus::SuitFrame> frames;
	};
	struct Datagram {
		int stream = 0;
		uint64_t time_usec = 0;
		std::vector<uint8_t> bytes;
	};

	void survey();
	bool fetch();
	void play_next();
	void play_bus(Stream &r_stream, const recording::Record &p_record);
	int64_t played_usec(uint64_t p_time_usec) const;
	Ref<SuitDevice> device_of(int p_number, const Stream &p_stream) const;

	mutable std::mutex _mutex;
	// Guarded.
	recording::Reader _reader;
	recording::ReaderStats _whole;
	std::map<int, Stream> _streams;
	std::deque<Datagram> _datagrams;
	/// The next one, if there is one.
	recording::Record _next;
	bool _has_next = false;
	uint64_t _first_usec = 0;
	uint64_t _last_usec = 0;
	uint64_t _at_usec = 0;
	int64_t _begin_usec = 0;
	double _speed = 1.0;
};

} // namespace godot
