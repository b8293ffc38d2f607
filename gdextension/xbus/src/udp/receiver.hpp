// SPDX-License-Identifier: MIT
#pragma once

#include "mvn/collector.hpp"

#include <array>
#include <atomic>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace mvn {

/// A whole sample of one type, and when it came.
struct ReceivedSample {
	Content content;
	/// µs of CLOCK_MONOTONIC, when its last datagram came.
	uint64_t arrival_usec = 0;
};

/// What is known of a character, for people.
struct CharacterReport {
	int number = 0;
	/// Address and port of its sender.
	std::string sender;
	/// From the stream's meta data, or empty.
	std::string name;
	CharacterStatistics statistics;
	/// Types that have come, a bit each.
	uint32_t types = 0;
	Header header;
	/// What is wrong, or an empty text.
	std::string trouble;
};

/// What is known of all that comes in.
struct ReceiverReport {
	uint64_t datagrams = 0;
	std::array<uint64_t, FAULTS> refused{};
	std::vector<CharacterReport> characters;
};

/// Receives MVN's network stream (UDP) in a thread of its own.
class Receiver {
public:
	/// Hears every datagram as it came, in the receiver's thread: sender, bytes, µs of CLOCK_MONOTONIC.
	using RawListener = std::function<void(const std::string &, const uint8_t *, std::size_t, uint64_t)>;

	Receiver() = default;
	Receiver(const Receiver &) = delete;
	Receiver &operator=(const Receiver &) = delete;
	~Receiver();

	/// Opens a port of this machine; 0 takes any. Returns why it can't, or an empty text.
	std::string open(uint16_t p_port, RawListener p_raw = nullptr);
	void close();
	/// The port that is open, 0 if none is.
	uint16_t port() const { return _port; }

	/// Takes a datagram as if it had come from a sender: for recordings. Not while a port is open.
	void take(const std::string &p_sender, const uint8_t *p_bytes, std::size_t p_size, uint64_t p_now_usec);

	ReceiverReport report() const;
	/// What is wrong with the stream, said since the last call, a line each.
	std::vector<std::string> take_messages();
	/// Who came and left since the last call, a line each.
	std::vector<std::string> take_news();
	/// The samples of one type of motion (01, 02, 05, 23) of a character since the last call, oldest first.
	std::vector<ReceivedSample> take_samples(int p_character, Type p_type);
	/// The newest sample of a type of a character; false if there was none.
	bool newest(int p_character, Type p_type, ReceivedSample &r_sample) const;

private:
	struct Character {
		std::string sender;
		std::string name;
		uint32_t types = 0;
		Header header;
		std::string trouble;
		/// As of the last look.
		CharacterStatistics noted;
		std::map<Type, std::deque<ReceivedSample>> waiting;
		std::map<Type, ReceivedSample> newest;
	};

	void run();
	void take_locked(const std::string &p_sender, const uint8_t *p_bytes, std::size_t p_size, uint64_t p_now_usec);
	void keep(const Content &p_content, const std::string &p_sender, uint64_t p_now_usec);
	void complain(const std::string &p_sender, Outcome p_outcome);
	void look_after(uint64_t p_now_usec);
	void judge(int p_number, Character &p_character, const CharacterStatistics &p_statistics);
	void forget_all();
	void say(const std::string &p_key, const std::string &p_text, bool p_is_news = false);

	int _socket = -1;
	uint16_t _port = 0;
	std::thread _thread;
	std::atomic<bool> _stops{ false };
	RawListener _raw;
	uint64_t _looked_usec = 0;
	mutable std::mutex _mutex;
	// Guarded.
	Collector _collector;
	std::map<int, Character> _characters;
	std::vector<std::string> _messages;
	std::vector<std::string> _news;
	std::map<std::string, uint64_t> _said;
	uint64_t _now_usec = 0;
};

} // namespace mvn
