// SPDX-License-Identifier: MIT
#include "raw_player.hpp"

#include "text.hpp"

#include <bus/message.hpp>
#include <mvn/stranger_text.hpp>

#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>

#include <algorithm>
#include <cstdlib>

namespace godot {

namespace {

using recording::Kind;
using recording::Record;

/// Frames and datagrams that wait for who fetches them.
constexpr std::size_t MAX_FRAMES = 512;
constexpr std::size_t MAX_DATAGRAMS = 4096;

std::string text_of(const Record &p_record, const char *p_key) {
	const std::string value = recording::about(p_record, p_key);
	return mvn::clean_text(value.data(), value.size());
}

bool is_played(Kind p_kind) {
	return p_kind == Kind::BUS_IN || p_kind == Kind::BUS_OUT || p_kind == Kind::DATAGRAM;
}

const char *kind_text(Kind p_kind) {
	return p_kind == Kind::DATAGRAM ? "datagram" : (p_kind == Kind::BUS_OUT ? "out" : "in");
}

PackedByteArray packed(const uint8_t *p_bytes, std::size_t p_size) {
	PackedByteArray bytes;
	bytes.resize(int64_t(p_size));
	if (p_size > 0) {
		std::copy(p_bytes, p_bytes + p_size, bytes.ptrw());
	}
	return bytes;
}

} // namespace

String RawPlayer::open(const String &p_path) {
	const std::lock_guard<std::mutex> lock(_mutex);
	_has_next = false;
	_streams.clear();
	_datagrams.clear();
	const std::string fault = _reader.open_file(p_path.utf8().get_data());
	if (fault.empty()) {
		survey();
	}
	return as_string(fault);
}

/// Looks through the whole file once: streams, length, damage.
void RawPlayer::survey() {
	_first_usec = _last_usec = 0;
	Record record;
	while (_reader.next(record)) {
		if (record.kind == Kind::STREAM) {
			Stream &stream = _streams[record.stream];
			stream.is_bus = text_of(record, "kind") == "bus";
			stream.name = text_of(record, "name");
			stream.address = text_of(record, "place");
			stream.serial = text_of(record, "serial");
			stream.usb = text_of(record, "usb");
			stream.sender = text_of(record, "sender");
			stream.port = text_of(record, "port");
		} else if (is_played(record.kind)) {
			Stream &stream = _streams[record.stream];
			stream.is_bus = record.kind != Kind::DATAGRAM;
			++stream.records;
			stream.bytes += record.size;
			_first_usec = _first_usec == 0 ? record.time_usec : std::min(_first_usec, record.time_usec);
			_last_usec = std::max(_last_usec, record.time_usec);
		}
	}
	_whole = _reader.stats();
	_reader.rewind();
	for (auto &[number, stream] : _streams) {
		if (stream.is_bus) {
			stream.replay = std::make_unique<recording::BusReplay>();
		}
	}
	_at_usec = _first_usec;
	fetch();
}

/// Finds the next record that is to be played.
bool RawPlayer::fetch() {
	do {
		_has_next = _reader.next(_next);
	} while (_has_next && !is_played(_next.kind));
	return _has_next;
}

void RawPlayer::begin(int64_t p_unix_usec, double p_speed) {
	// Written so that NaN fails too.
	ERR_FAIL_COND_MSG(
			!(p_speed >= 0.01 && p_speed <= 1000.0), "A recording is played at 0.01 to 1000 times its speed.");
	const std::lock_guard<std::mutex> lock(_mutex);
	_begin_usec = p_unix_usec;
	_speed = p_speed;
	_streams.clear();
	_datagrams.clear();
	_reader.rewind();
	survey();
}

int64_t RawPlayer::played_usec(uint64_t p_time_usec) const {
	return _begin_usec + int64_t(double(int64_t(p_time_usec - _first_usec)) / _speed);
}

int64_t RawPlayer::advance(int64_t p_unix_usec) {
	const std::lock_guard<std::mutex> lock(_mutex);
	int64_t count = 0;
	while (_has_next && played_usec(_next.time_usec) <= p_unix_usec) {
		play_next();
		++count;
	}
	return count;
}

Dictionary RawPlayer::step() {
	const std::lock_guard<std::mutex> lock(_mutex);
	Dictionary result;
	if (_has_next) {
		result["kind"] = kind_text(_next.kind);
		result["stream"] = int64_t(_next.stream);
		result["time_s"] = double(int64_t(_next.time_usec - _first_usec)) / 1e6;
		result["bytes"] = packed(_next.payload, _next.size);
		play_next();
	}
	return result;
}

void RawPlayer::play_next() {
	Stream &stream = _streams[_next.stream];
	_at_usec = std::max(_at_usec, _next.time_usec);
	if (_next.kind == Kind::DATAGRAM) {
		_datagrams.push_back({ _next.stream, _next.time_usec, { _next.payload, _next.payload + _next.size } });
		if (_datagrams.size() > MAX_DATAGRAMS) {
			_datagrams.pop_front();
		}
	} else if (stream.replay != nullptr) {
		play_bus(stream, _next);
	}
	fetch();
}

void RawPlayer::play_bus(Stream &r_stream, const Record &p_record) {
	if (p_record.kind == Kind::BUS_OUT) {
		r_stream.replay->take_out(p_record.payload, p_record.size);
		return;
	}
	r_stream.replay->take_in(p_record.payload, p_record.size, p_record.time_usec, [&](const xbus::SuitFrame &p_frame) {
		r_stream.frames.push_back(p_frame);
		if (r_stream.frames.size() > MAX_FRAMES) {
			r_stream.frames.pop_front();
		}
	});
}

bool RawPlayer::is_at_end() const {
	const std::lock_guard<std::mutex> lock(_mutex);
	return !_has_next;
}

double RawPlayer::get_length_s() const {
	const std::lock_guard<std::mutex> lock(_mutex);
	return double(_last_usec - _first_usec) / 1e6;
}

TypedArray<Dictionary> RawPlayer::get_streams() const {
	const std::lock_guard<std::mutex> lock(_mutex);
	TypedArray<Dictionary> result;
	for (const auto &[number, stream] : _streams) {
		Dictionary entry;
		entry["number"] = int64_t(number);
		entry["kind"] = stream.is_bus ? "bus" : "mvn";
		entry["name"] = as_string(stream.name);
		entry["usb"] = as_string(stream.usb);
		entry["address"] = as_string(stream.address);
		entry["serial"] = as_string(stream.serial);
		entry["sender"] = as_string(stream.sender);
		entry["port"] = as_string(stream.port);
		entry["records"] = int64_t(stream.records);
		entry["bytes"] = int64_t(stream.bytes);
		result.push_back(entry);
	}
	return result;
}

Dictionary RawPlayer::get_stats() const {
	const std::lock_guard<std::mutex> lock(_mutex);
	Dictionary result;
	result["records"] = int64_t(_whole.records);
	result["bytes"] = int64_t(_whole.payload_bytes);
	result["damaged_records"] = int64_t(_whole.damaged_records);
	result["damaged_bytes"] = int64_t(_whole.damaged_bytes);
	result["cut_bytes"] = int64_t(_whole.cut_bytes);
	result["lost"] = int64_t(_whole.lost);
	result["is_whole"] = _whole.has_end && _whole.damaged_bytes == 0 && _whole.lost == 0;
	return result;
}

TypedArray<SuitDevice> RawPlayer::get_devices() const {
	const std::lock_guard<std::mutex> lock(_mutex);
	TypedArray<SuitDevice> devices;
	for (const auto &[number, stream] : _streams) {
		if (stream.replay != nullptr) {
			devices.push_back(device_of(number, stream));
		}
	}
	return devices;
}

Ref<SuitDevice> RawPlayer::device_of(int p_number, const Stream &p_stream) const {
	const recording::BusReplay &replay = *p_stream.replay;
	usb::DeviceReport report;
	report.number = p_number;
	const std::size_t colon = p_stream.usb.find(':');
	report.known.vendor = uint16_t(std::strtoul(p_stream.usb.c_str(), nullptr, 16));
	if (colon != std::string::npos) {
		report.known.product = uint16_t(std::strtoul(p_stream.usb.c_str() + colon + 1, nullptr, 16));
	}
	report.address = p_stream.address;
	report.serial = p_stream.serial;
	report.is_open = true;
	if (replay.undecoded() > 0) {
		report.fault = "the recording does not say how its samples are laid out: it began too late";
	}
	report.session.device_id = replay.device_id();
	report.session.kind = xbus::device_kind(replay.device_id());
	report.session.rate_hz = replay.rate_hz();
	report.session.framer = replay.framer();
	const std::size_t count = replay.is_master() ? replay.tracker_ids().size() : (replay.device_id() != 0 ? 1 : 0);
	for (std::size_t at = 0; at < count; ++at) {
		xbus::TrackerReport tracker;
		tracker.device_id = replay.is_master() ? replay.tracker_ids()[at] : replay.device_id();
		tracker.bus_id = replay.is_master() ? uint8_t(at + 1) : xbus::MASTER;
		tracker.samples = replay.tracker(int(at));
		tracker.flow = replay.flow(int(at), _at_usec);
		report.session.trackers.push_back(tracker);
	}
	const String name = p_stream.name.empty() ? String("a recorded suit") : as_string(p_stream.name);
	const SuitDevice::State state = _has_next ? SuitDevice::STATE_PLAYING : SuitDevice::STATE_PLAYED;
	return SuitDevice::make_recorded(report, name, state, _at_usec, _speed);
}

TypedArray<SuitFrame> RawPlayer::take_frames(int64_t p_device) {
	const std::lock_guard<std::mutex> lock(_mutex);
	TypedArray<SuitFrame> frames;
	const auto found = _streams.find(int(p_device));
	if (found != _streams.end()) {
		for (xbus::SuitFrame &frame : found->second.frames) {
			frame.time_usec = uint64_t(played_usec(frame.time_usec));
			frame.arrival_usec = uint64_t(played_usec(frame.arrival_usec));
			frames.push_back(SuitFrame::make(frame, 0));
		}
		found->second.frames.clear();
	}
	return frames;
}

TypedArray<Dictionary> RawPlayer::take_datagrams() {
	const std::lock_guard<std::mutex> lock(_mutex);
	TypedArray<Dictionary> result;
	for (const Datagram &datagram : _datagrams) {
		const std::string &sender = _streams[datagram.stream].sender;
		Dictionary entry;
		entry["sender"] = as_string(sender.empty() ? "recording" : sender);
		entry["port"] = as_string(_streams[datagram.stream].port);
		entry["time_usec"] = played_usec(datagram.time_usec);
		entry["bytes"] = packed(datagram.bytes.data(), datagram.bytes.size());
		result.push_back(entry);
	}
	_datagrams.clear();
	return result;
}

void RawPlayer::_bind_methods() {
	ClassDB::bind_method(D_METHOD("open", "path"), &RawPlayer::open);
	ClassDB::bind_method(D_METHOD("begin", "unix_usec", "speed"), &RawPlayer::begin, DEFVAL(1.0));
	ClassDB::bind_method(D_METHOD("advance", "unix_usec"), &RawPlayer::advance);
	ClassDB::bind_method(D_METHOD("step"), &RawPlayer::step);
	ClassDB::bind_method(D_METHOD("is_at_end"), &RawPlayer::is_at_end);
	ClassDB::bind_method(D_METHOD("get_length_s"), &RawPlayer::get_length_s);
	ClassDB::bind_method(D_METHOD("get_streams"), &RawPlayer::get_streams);
	ClassDB::bind_method(D_METHOD("get_stats"), &RawPlayer::get_stats);
	ClassDB::bind_method(D_METHOD("get_devices"), &RawPlayer::get_devices);
	ClassDB::bind_method(D_METHOD("take_frames", "device"), &RawPlayer::take_frames);
	ClassDB::bind_method(D_METHOD("take_datagrams"), &RawPlayer::take_datagrams);
}

} // namespace godot
