// SPDX-License-Identifier: MIT
#include "mvn_receiver.hpp"

#include "mvn_dictionary.hpp"

#include <clock/clock.hpp>

#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>

namespace godot {

namespace {

/// A pose that came so much earlier than another has ended, µs.
constexpr uint64_t STALE_USEC = 1000000;
constexpr int64_t MAX_CHARACTER = 255;

String text(const std::string &p_text) {
	return String::utf8(p_text.c_str());
}

Dictionary character_dictionary(const mvn::CharacterReport &p_character, uint64_t p_now_usec) {
	const mvn::CharacterStatistics &statistics = p_character.statistics;
	PackedInt32Array types;
	for (int type = 0; type < mvn::TYPES; ++type) {
		if (((p_character.types >> unsigned(type)) & 1U) != 0) {
			types.push_back(type);
		}
	}
	Dictionary result;
	result["number"] = int64_t(p_character.number);
	result["name"] = text(p_character.name);
	result["sender"] = text(p_character.sender);
	result["types"] = types;
	result["props"] = int64_t(p_character.header.props);
	result["fingers"] = int64_t(p_character.header.fingers);
	result["samples"] = int64_t(statistics.samples);
	result["lost"] = int64_t(statistics.lost);
	result["incomplete"] = int64_t(statistics.incomplete);
	result["late"] = int64_t(statistics.late);
	result["foreign"] = int64_t(statistics.foreign);
	result["rate_hz"] = statistics.rate_hz;
	result["age_s"] = p_now_usec > statistics.newest_usec ? double(p_now_usec - statistics.newest_usec) / 1e6 : 0.0;
	result["trouble"] = text(p_character.trouble);
	return result;
}

} // namespace

uint64_t MvnReceiver::now_usec() const {
	return _put_usec > 0 ? _put_usec.load() : clocks::now_usec();
}

/// Datagrams from a port bear the times of the steady clock, others those that came with them.
int64_t MvnReceiver::to_unix(uint64_t p_usec) const {
	const int64_t ahead = _put_usec > 0 ? 0 : clocks::unix_ahead_usec();
	return int64_t(p_usec) + ahead;
}

String MvnReceiver::open(int64_t p_port) {
	if (p_port < 0 || p_port > 65535) {
		return "a UDP port is 1 to 65535 (0 for any that is free)";
	}
	_put_usec = 0;
	_receiver.close();
	{
		const std::lock_guard<std::mutex> lock(_mutex);
		_clocks.clear();
	}
	_tap = _recorder != nullptr ? std::make_unique<recording::DatagramTap>(_recorder, int(p_port)) : nullptr;
	mvn::Receiver::RawListener listener;
	if (_tap != nullptr) {
		listener = [this](const std::string &p_sender, const uint8_t *p_bytes, std::size_t p_size,
						   uint64_t p_time_usec) { _tap->take(p_sender, p_bytes, p_size, p_time_usec); };
	}
	return text(_receiver.open(uint16_t(p_port), listener));
}

void MvnReceiver::close() {
	_receiver.close();
}

void MvnReceiver::set_recorder(const Ref<RawRecorder> &p_recorder) {
	ERR_FAIL_COND_MSG(_receiver.port() != 0, "A recording begins before the port is opened.");
	_recorder = p_recorder.is_valid() ? p_recorder->share() : nullptr;
}

void MvnReceiver::put(const String &p_sender, const PackedByteArray &p_datagram, int64_t p_time_usec) {
	ERR_FAIL_COND_MSG(_receiver.port() != 0, "Datagrams come from the port while one is open.");
	ERR_FAIL_COND_MSG(p_time_usec <= 0, "A datagram comes at a time after 1970.");
	_put_usec = uint64_t(p_time_usec);
	const uint8_t nothing = 0;
	const int64_t size = p_datagram.size();
	_receiver.take(p_sender.utf8().get_data(), size > 0 ? p_datagram.ptr() : &nothing, std::size_t(size), _put_usec);
}

TypedArray<Dictionary> MvnReceiver::get_characters() const {
	TypedArray<Dictionary> characters;
	const uint64_t now = now_usec();
	for (const mvn::CharacterReport &character : _receiver.report().characters) {
		characters.push_back(character_dictionary(character, now));
	}
	return characters;
}

Dictionary MvnReceiver::get_stats() const {
	const mvn::ReceiverReport report = _receiver.report();
	Dictionary refused;
	int64_t sum = 0;
	for (int fault = 1; fault < mvn::FAULTS; ++fault) {
		const auto count = int64_t(report.refused[std::size_t(fault)]);
		sum += count;
		if (count > 0) {
			refused[mvn::fault_text(mvn::Fault(fault))] = count;
		}
	}
	Dictionary result;
	result["datagrams"] = int64_t(report.datagrams);
	result["refused"] = sum;
	result["refused_why"] = refused;
	return result;
}

PackedStringArray MvnReceiver::take_messages() {
	PackedStringArray messages;
	for (const std::string &message : _receiver.take_messages()) {
		messages.push_back(text(message));
	}
	return messages;
}

PackedStringArray MvnReceiver::take_news() {
	PackedStringArray news;
	for (const std::string &line : _receiver.take_news()) {
		news.push_back(text(line));
	}
	return news;
}

TypedArray<Dictionary> MvnReceiver::take_poses(int64_t p_character) {
	// The best that has come of late: 02 is exact, 01 has angles, 05 lacks what is above the segments.
	mvn::Type best = mvn::Type::POSE;
	uint64_t best_usec = 0;
	mvn::ReceivedSample newest;
	for (const mvn::Type type : { mvn::Type::POSE, mvn::Type::EULER_POSE, mvn::Type::UNITY_POSE }) {
		if (p_character >= 0 && p_character <= MAX_CHARACTER && _receiver.newest(int(p_character), type, newest) &&
				(best_usec == 0 || newest.arrival_usec > best_usec + STALE_USEC)) {
			best = type;
			best_usec = newest.arrival_usec;
		}
	}
	return take_type(p_character, best);
}

TypedArray<Dictionary> MvnReceiver::take_trackers(int64_t p_character) {
	return take_type(p_character, mvn::Type::TRACKERS);
}

TypedArray<Dictionary> MvnReceiver::take_type(int64_t p_character, mvn::Type p_type) {
	TypedArray<Dictionary> samples;
	if (p_character < 0 || p_character > MAX_CHARACTER) {
		return samples;
	}
	const std::lock_guard<std::mutex> lock(_mutex);
	clocks::SourceClock &clock = _clocks[{ p_character, int(p_type) }];
	for (const mvn::ReceivedSample &sample : _receiver.take_samples(int(p_character), p_type)) {
		Dictionary entry = mvn_to_dictionary(sample.content);
		entry["time_usec"] =
				to_unix(clock.timestamp(int64_t(sample.content.header.time_code_ms) * 1000, sample.arrival_usec));
		entry["arrival_usec"] = to_unix(sample.arrival_usec);
		samples.push_back(entry);
	}
	return samples;
}

Dictionary MvnReceiver::get_newest(int64_t p_character, int64_t p_type) const {
	mvn::ReceivedSample sample;
	const bool can_be = p_character >= 0 && p_character <= MAX_CHARACTER && p_type >= 0 && p_type < mvn::TYPES;
	Dictionary entry;
	if (can_be && _receiver.newest(int(p_character), mvn::Type(p_type), sample)) {
		entry = mvn_to_dictionary(sample.content);
		entry["arrival_usec"] = to_unix(sample.arrival_usec);
	}
	return entry;
}

void MvnReceiver::_bind_methods() {
	ClassDB::bind_method(D_METHOD("open", "port"), &MvnReceiver::open);
	ClassDB::bind_method(D_METHOD("close"), &MvnReceiver::close);
	ClassDB::bind_method(D_METHOD("set_recorder", "recorder"), &MvnReceiver::set_recorder);
	ClassDB::bind_method(D_METHOD("get_port"), &MvnReceiver::get_port);
	ClassDB::bind_method(D_METHOD("put", "sender", "datagram", "time_usec"), &MvnReceiver::put);
	ClassDB::bind_method(D_METHOD("get_characters"), &MvnReceiver::get_characters);
	ClassDB::bind_method(D_METHOD("get_stats"), &MvnReceiver::get_stats);
	ClassDB::bind_method(D_METHOD("take_messages"), &MvnReceiver::take_messages);
	ClassDB::bind_method(D_METHOD("take_news"), &MvnReceiver::take_news);
	ClassDB::bind_method(D_METHOD("take_poses", "character"), &MvnReceiver::take_poses);
	ClassDB::bind_method(D_METHOD("take_trackers", "character"), &MvnReceiver::take_trackers);
	ClassDB::bind_method(D_METHOD("get_newest", "character", "type"), &MvnReceiver::get_newest);
}

} // namespace godot
