// SPDX-License-Identifier: MIT
#include "udp/receiver.hpp"

#include "clock/clock.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace mvn {

namespace {

constexpr int BUFFER_BYTES = 1024 * 1024;
constexpr int WAIT_MS = 50;
/// Samples of a pose that wait for who fetches them: a quarter of a second at least.
constexpr std::size_t MAX_WAITING = 64;
constexpr std::size_t MAX_MESSAGES = 64;
/// The same is said again after so long, µs.
constexpr uint64_t REPEAT_USEC = 10000000;
/// A character that is silent for so long has left, µs.
constexpr uint64_t GONE_USEC = 5000000;
constexpr uint64_t LOOK_USEC = 500000;

std::string address_of(const sockaddr_in &p_from) {
	std::array<char, INET_ADDRSTRLEN> text{};
	inet_ntop(AF_INET, &p_from.sin_addr, text.data(), text.size());
	return std::string(text.data()) + ":" + std::to_string(ntohs(p_from.sin_port));
}

std::string tag(const Content &p_content, const char *p_name) {
	for (const auto &[name, value] : p_content.tags) {
		if (name == p_name) {
			return value;
		}
	}
	return "";
}

} // namespace

Receiver::~Receiver() {
	close();
}

std::string Receiver::open(uint16_t p_port, RawListener p_raw) {
	close();
	_raw = std::move(p_raw);
	_socket = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
	sockaddr_in here{};
	here.sin_family = AF_INET;
	here.sin_port = htons(p_port);
	here.sin_addr.s_addr = htonl(INADDR_ANY);
	if (_socket < 0 || bind(_socket, reinterpret_cast<sockaddr *>(&here), sizeof(here)) != 0) {
		const int error = errno;
		const std::string where = "UDP port " + std::to_string(p_port);
		close();
		return error == EADDRINUSE ? where +
						" is in use: another program receives MVN's stream there; end it, or let MVN send to another "
						"port and name that one (--source=mvn:PORT)"
								   : where + " can't be opened: " + std::strerror(error);
	}
	setsockopt(_socket, SOL_SOCKET, SO_RCVBUF, &BUFFER_BYTES, sizeof(BUFFER_BYTES));
	socklen_t size = sizeof(here);
	getsockname(_socket, reinterpret_cast<sockaddr *>(&here), &size);
	_port = ntohs(here.sin_port);
	forget_all();
	_stops = false;
	_thread = std::thread(&Receiver::run, this);
	return "";
}

void Receiver::close() {
	_stops = true;
	if (_thread.joinable()) {
		_thread.join();
	}
	if (_socket >= 0) {
		::close(_socket);
	}
	_socket = -1;
	_port = 0;
}

void Receiver::forget_all() {
	const std::lock_guard<std::mutex> lock(_mutex);
	_collector = Collector();
	_characters.clear();
	_said.clear();
	_looked_usec = 0;
}

void Receiver::run() {
	std::vector<uint8_t> bytes(MAX_DATAGRAM + 1);
	while (!_stops) {
		pollfd wait{ _socket, POLLIN, 0 };
		if (poll(&wait, 1, WAIT_MS) > 0) {
			sockaddr_in from{};
			socklen_t size = sizeof(from);
			const ssize_t count = recvfrom(
					_socket, bytes.data(), bytes.size(), MSG_DONTWAIT, reinterpret_cast<sockaddr *>(&from), &size);
			if (count >= 0) {
				const std::string sender = address_of(from);
				const uint64_t now = clocks::now_usec();
				if (_raw) {
					_raw(sender, bytes.data(), std::size_t(count), now);
				}
				const std::lock_guard<std::mutex> lock(_mutex);
				take_locked(sender, bytes.data(), std::size_t(count), now);
			}
		}
		const std::lock_guard<std::mutex> lock(_mutex);
		look_after(clocks::now_usec());
	}
}

void Receiver::take(const std::string &p_sender, const uint8_t *p_bytes, std::size_t p_size, uint64_t p_now_usec) {
	const std::lock_guard<std::mutex> lock(_mutex);
	take_locked(p_sender, p_bytes, p_size, p_now_usec);
	look_after(p_now_usec);
}

void Receiver::take_locked(
		const std::string &p_sender, const uint8_t *p_bytes, std::size_t p_size, uint64_t p_now_usec) {
	_now_usec = p_now_usec;
	const uint64_t sender = std::hash<std::string>{}(p_sender);
	const Outcome outcome = _collector.take(p_bytes, p_size, sender, p_now_usec);
	for (const Content &partial : _collector.take_partial()) {
		keep(partial, p_sender, p_now_usec);
	}
	if (outcome == Outcome::SAMPLE) {
		keep(_collector.content(), p_sender, p_now_usec);
	} else if (outcome != Outcome::PART && outcome != Outcome::LATE) {
		complain(p_sender, outcome);
	}
}

void Receiver::keep(const Content &p_content, const std::string &p_sender, uint64_t p_now_usec) {
	const auto [found, is_new] = _characters.try_emplace(p_content.header.character);
	Character &character = found->second;
	character.sender = p_sender;
	character.types |= 1U << unsigned(p_content.header.type);
	if (is_new) {
		say("new " + std::to_string(found->first),
				"character " + std::to_string(found->first) + " comes from " + p_sender, true);
	}
	if (p_content.header.type == Type::META) {
		character.name = tag(p_content, "name");
	} else {
		character.header = p_content.header;
	}
	ReceivedSample &newest = character.newest[p_content.header.type];
	newest.content = p_content;
	newest.arrival_usec = p_now_usec;
	if (!is_motion(p_content.header.type)) {
		return;
	}
	std::deque<ReceivedSample> &waiting = character.waiting[p_content.header.type];
	waiting.push_back(newest);
	if (waiting.size() > MAX_WAITING) {
		waiting.pop_front();
	}
}

void Receiver::complain(const std::string &p_sender, Outcome p_outcome) {
	const std::string number = std::to_string(_collector.header().character);
	switch (p_outcome) {
		case Outcome::REFUSED:
			say("refused " + std::string(fault_text(_collector.fault())),
					p_sender + " sent a datagram that was dropped: " + fault_text(_collector.fault()));
			break;
		case Outcome::FOREIGN: {
			const auto found = _characters.find(_collector.header().character);
			if (found == _characters.end()) {
				break;
			}
			Character &character = found->second;
			character.trouble = "character " + number + " comes from two senders, " + character.sender + " and " +
					p_sender + ": only the first is taken; give one another number in MVN, or another port";
			say("foreign " + number, character.trouble);
			break;
		}
		case Outcome::CROWDED:
			say("crowded",
					"more than " + std::to_string(MAX_CHARACTERS) + " characters come in: " + number + " from " +
							p_sender + " is left out");
			break;
		default:
			break;
	}
}

/// Notices who left, and characters that come twice in every sample.
void Receiver::look_after(uint64_t p_now_usec) {
	if (p_now_usec >= _looked_usec && p_now_usec < _looked_usec + LOOK_USEC) {
		return;
	}
	_looked_usec = p_now_usec;
	for (auto at = _characters.begin(); at != _characters.end();) {
		const CharacterStatistics statistics = _collector.statistics(at->first);
		judge(at->first, at->second, statistics);
		if (p_now_usec > statistics.newest_usec + GONE_USEC) {
			say("gone " + std::to_string(at->first), "character " + std::to_string(at->first) + " comes no more", true);
			at = _characters.erase(at);
		} else {
			++at;
		}
	}
	if (p_now_usec > GONE_USEC) {
		_collector.forget_silent(p_now_usec - GONE_USEC);
	}
}

/// Says what is wrong with how a character came since the last look.
void Receiver::judge(int p_number, Character &p_character, const CharacterStatistics &p_statistics) {
	CharacterStatistics &noted = p_character.noted;
	if (p_statistics.samples < noted.samples) {
		noted = CharacterStatistics(); // Another sender took its number over.
	}
	const uint64_t samples = p_statistics.samples - noted.samples;
	// A datagram that the network brings twice is the same both times, one of another person is not.
	const uint64_t conflicting = p_statistics.conflicting - noted.conflicting;
	const bool comes_twice = conflicting * 4 > samples || p_statistics.jumps - noted.jumps > 5;
	if (samples > 10 && comes_twice) {
		p_character.trouble = "character " + std::to_string(p_number) +
				" comes twice in each sample: two people have one number in MVN; give one of them another";
		say("twice " + std::to_string(p_number), p_character.trouble);
	} else if (samples > 10 && conflicting == 0 && p_statistics.foreign == noted.foreign) {
		p_character.trouble.clear();
	}
	noted = p_statistics;
}

void Receiver::say(const std::string &p_key, const std::string &p_text, bool p_is_news) {
	const auto [found, is_new] = _said.try_emplace(p_key, _now_usec);
	if (!is_new && _now_usec < found->second + REPEAT_USEC) {
		return;
	}
	found->second = _now_usec;
	std::vector<std::string> &said = p_is_news ? _news : _messages;
	if (said.size() < MAX_MESSAGES) {
		said.push_back(p_text);
	}
}

ReceiverReport Receiver::report() const {
	const std::lock_guard<std::mutex> lock(_mutex);
	ReceiverReport report;
	report.datagrams = _collector.datagrams();
	for (int fault = 0; fault < FAULTS; ++fault) {
		report.refused[std::size_t(fault)] = _collector.refused(Fault(fault));
	}
	report.characters.reserve(_characters.size());
	for (const auto &[number, character] : _characters) {
		CharacterReport entry;
		entry.number = number;
		entry.sender = character.sender;
		entry.name = character.name;
		entry.statistics = _collector.statistics(number);
		entry.types = character.types;
		entry.header = character.header;
		entry.trouble = character.trouble;
		report.characters.push_back(entry);
	}
	return report;
}

std::vector<std::string> Receiver::take_messages() {
	const std::lock_guard<std::mutex> lock(_mutex);
	std::vector<std::string> messages;
	messages.swap(_messages);
	return messages;
}

std::vector<std::string> Receiver::take_news() {
	const std::lock_guard<std::mutex> lock(_mutex);
	std::vector<std::string> news;
	news.swap(_news);
	return news;
}

std::vector<ReceivedSample> Receiver::take_samples(int p_character, Type p_type) {
	const std::lock_guard<std::mutex> lock(_mutex);
	std::vector<ReceivedSample> samples;
	const auto found = _characters.find(p_character);
	if (found != _characters.end()) {
		std::deque<ReceivedSample> &waiting = found->second.waiting[p_type];
		samples.assign(waiting.begin(), waiting.end());
		waiting.clear();
	}
	return samples;
}

bool Receiver::newest(int p_character, Type p_type, ReceivedSample &r_sample) const {
	const std::lock_guard<std::mutex> lock(_mutex);
	const auto character = _characters.find(p_character);
	if (character == _characters.end()) {
		return false;
	}
	const auto found = character->second.newest.find(p_type);
	if (found == character->second.newest.end()) {
		return false;
	}
	r_sample = found->second;
	return true;
}

} // namespace mvn
