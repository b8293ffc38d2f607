// SPDX-License-Identifier: MIT
#pragma once

#include "recording/format.hpp"

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace recording {

/// How a recording goes.
struct RecorderStats {
	uint64_t records = 0;
	uint64_t bytes = 0;
	/// Records for which the disk was too slow.
	uint64_t lost = 0;
	/// Why nothing is written any more, or an empty text.
	std::string fault;
};

/// Writes a recording. Who hands records over never waits for the disk: a thread writes, and what does not fit
/// between the two is counted and left out.
class Recorder {
public:
	/// `p_room`: bytes that may wait for the disk.
	explicit Recorder(std::size_t p_room = 8U << 20U);
	Recorder(const Recorder &) = delete;
	Recorder &operator=(const Recorder &) = delete;
	~Recorder();

	/// Begins a file, which must not be there yet. `p_about`: lines "key=value" on the whole file. Returns why it
	/// can't, or an empty text.
	std::string open(const std::string &p_path, const std::string &p_about);
	/// The same with an open descriptor, which it closes.
	void open_descriptor(int p_descriptor, const std::string &p_about);
	/// Writes what is left and ends the file in order.
	void close();

	/// A new stream; `p_about` as above. Returns its number.
	int add_stream(const std::string &p_about, uint64_t p_time_usec);
	/// Takes a record. Any thread may call it; allocates nothing.
	void add(Kind p_kind, int p_stream, const uint8_t *p_payload, std::size_t p_size, uint64_t p_time_usec);

	RecorderStats stats() const;

private:
	void run();
	void add_locked(Kind p_kind, int p_stream, const uint8_t *p_payload, std::size_t p_size, uint64_t p_time_usec);
	void append(Kind p_kind, int p_stream, const uint8_t *p_payload, std::size_t p_size, uint64_t p_time_usec);
	bool write_all(const std::vector<uint8_t> &p_bytes);

	const std::size_t _room;
	int _descriptor = -1;
	std::thread _thread;
	mutable std::mutex _mutex;
	std::condition_variable _wakes;
	// Guarded.
	std::vector<uint8_t> _waiting;
	bool _is_open = false;
	bool _stops = false;
	int _streams = 0;
	uint64_t _newest_usec = 0;
	uint64_t _lost_unreported = 0;
	RecorderStats _stats;
	// Of the thread alone.
	std::vector<uint8_t> _writing;
};

} // namespace recording
