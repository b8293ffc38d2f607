// SPDX-License-Identifier: MIT
#include "recording/recorder.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>

namespace recording {

namespace {

/// What waits for the disk is written at least so often; a kill costs no more than that.
constexpr auto WRITE_EVERY = std::chrono::milliseconds(50);
/// Power may go: the disk itself has everything at least so often.
constexpr auto SYNC_EVERY = std::chrono::seconds(1);

} // namespace

Recorder::Recorder(std::size_t p_room) : _room(p_room) {}

Recorder::~Recorder() {
	close();
}

std::string Recorder::open(const std::string &p_path, const std::string &p_about) {
	close();
	const int descriptor = ::open(p_path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
	if (descriptor < 0) {
		return errno == EEXIST ? p_path + " is there already: a recording is never overwritten"
							   : p_path + " can't be written: " + std::strerror(errno);
	}
	open_descriptor(descriptor, p_about);
	return "";
}

void Recorder::open_descriptor(int p_descriptor, const std::string &p_about) {
	close();
	_descriptor = p_descriptor;
	const std::lock_guard<std::mutex> lock(_mutex);
	_waiting.clear();
	_waiting.reserve(_room);
	_writing.clear();
	_writing.reserve(_room);
	_waiting.insert(_waiting.end(), MAGIC.begin(), MAGIC.end());
	_stats = RecorderStats();
	_stops = false;
	_is_open = true;
	_streams = 0;
	_lost_unreported = 0;
	_newest_usec = 0;
	add_locked(Kind::FILE_HEAD, 0, reinterpret_cast<const uint8_t *>(p_about.data()), p_about.size(), 0);
	_thread = std::thread(&Recorder::run, this);
}

void Recorder::close() {
	if (!_thread.joinable()) {
		return;
	}
	{
		const std::lock_guard<std::mutex> lock(_mutex);
		_stops = true;
		_is_open = false;
	}
	_wakes.notify_one();
	_thread.join();
	::close(_descriptor);
	_descriptor = -1;
}

int Recorder::add_stream(const std::string &p_about, uint64_t p_time_usec) {
	const std::lock_guard<std::mutex> lock(_mutex);
	if (_streams >= MAX_STREAMS) {
		return MAX_STREAMS - 1;
	}
	const int number = _streams++;
	add_locked(Kind::STREAM, number, reinterpret_cast<const uint8_t *>(p_about.data()), p_about.size(), p_time_usec);
	return number;
}

void Recorder::add(Kind p_kind, int p_stream, const uint8_t *p_payload, std::size_t p_size, uint64_t p_time_usec) {
	bool is_much = false;
	{
		const std::lock_guard<std::mutex> lock(_mutex);
		// What is longer than a record goes into several: only bytes of a bus are.
		std::size_t at = 0;
		do {
			const std::size_t size = p_size - at < MAX_PAYLOAD ? p_size - at : MAX_PAYLOAD;
			add_locked(p_kind, p_stream, p_payload + at, size, p_time_usec);
			at += size;
		} while (at < p_size);
		is_much = _waiting.size() > _room / 2;
	}
	if (is_much) {
		_wakes.notify_one();
	}
}

void Recorder::add_locked(
		Kind p_kind, int p_stream, const uint8_t *p_payload, std::size_t p_size, uint64_t p_time_usec) {
	if (!_is_open || !_stats.fault.empty()) {
		_stats.lost += _is_open ? 1U : 0U;
		return;
	}
	// There is always room left to note a loss, and the end.
	const std::size_t reserve = 3 * HEAD_SIZE + 8;
	if (_waiting.size() + HEAD_SIZE + p_size + reserve > _room) {
		++_stats.lost;
		++_lost_unreported;
		return;
	}
	_newest_usec = p_time_usec > _newest_usec ? p_time_usec : _newest_usec;
	if (_lost_unreported > 0) {
		std::array<uint8_t, 8> count{};
		put_little(_lost_unreported, count.size(), count.data());
		append(Kind::LOST, 0, count.data(), count.size(), p_time_usec);
		_lost_unreported = 0;
	}
	append(p_kind, p_stream, p_payload, p_size, p_time_usec);
}

void Recorder::append(Kind p_kind, int p_stream, const uint8_t *p_payload, std::size_t p_size, uint64_t p_time_usec) {
	std::array<uint8_t, HEAD_SIZE> head{};
	put_head(p_kind, p_stream, p_time_usec, p_payload, p_size, head.data());
	_waiting.insert(_waiting.end(), head.begin(), head.end());
	_waiting.insert(_waiting.end(), p_payload, p_payload + p_size);
	++_stats.records;
	_stats.bytes += HEAD_SIZE + p_size;
}

RecorderStats Recorder::stats() const {
	const std::lock_guard<std::mutex> lock(_mutex);
	return _stats;
}

void Recorder::run() {
	auto synced = std::chrono::steady_clock::now();
	bool stops = false;
	while (!stops) {
		{
			std::unique_lock<std::mutex> lock(_mutex);
			_wakes.wait_for(lock, WRITE_EVERY, [this]() { return _stops || _waiting.size() > _room / 2; });
			stops = _stops;
			if (stops && _stats.fault.empty()) {
				if (_lost_unreported > 0) {
					std::array<uint8_t, 8> count{};
					put_little(_lost_unreported, count.size(), count.data());
					append(Kind::LOST, 0, count.data(), count.size(), _newest_usec);
				}
				append(Kind::END, 0, nullptr, 0, _newest_usec);
			}
			_writing.swap(_waiting);
		}
		if (!_writing.empty() && !write_all(_writing)) {
			const std::lock_guard<std::mutex> lock(_mutex);
			_stats.fault = std::string("the recording can't be written any more: ") + std::strerror(errno);
		}
		_writing.clear();
		const auto now = std::chrono::steady_clock::now();
		if (now - synced > SYNC_EVERY || stops) {
			synced = now;
			::fdatasync(_descriptor);
		}
	}
}

bool Recorder::write_all(const std::vector<uint8_t> &p_bytes) {
	std::size_t at = 0;
	while (at < p_bytes.size()) {
		const ssize_t count = ::write(_descriptor, p_bytes.data() + at, p_bytes.size() - at);
		if (count > 0) {
			at += std::size_t(count);
		} else if (count == 0 || errno != EINTR) {
			return false;
		}
	}
	return true;
}

} // namespace recording
