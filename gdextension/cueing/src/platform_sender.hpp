// SPDX-License-Identifier: MIT
#pragma once

#include "cue_stream.hpp"

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace cueing {

enum class CueFormat {
	OWN,
	OUTSIM,
	OUTSIM_WITH_ID,
};

struct SenderOptions {
	/// A number such as 127.0.0.1 or ::1, or a name, which is looked up in the sender's thread.
	std::string host = "127.0.0.1";
	int port = 4123;
	CueFormat format = CueFormat::OWN;
	int32_t outsim_id = 1;
	/// Datagrams a second.
	double rate_hz = 200.0;
};

struct SenderReport {
	uint64_t sent = 0;
	/// Datagrams that the system did not take.
	uint64_t failed = 0;
	/// The longest that a datagram was sent after it was due, s.
	double latest_s = 0.0;
	/// Why there is no sending, or empty.
	std::string error;
	CueMessage message;
};

/// Sends messages over UDP at an even rate, in a thread of its own: what feeds it is never kept waiting by a network.
class PlatformSender {
public:
	PlatformSender() = default;
	~PlatformSender() { close(); }
	PlatformSender(const PlatformSender &) = delete;
	PlatformSender &operator=(const PlatformSender &) = delete;

	/// Starts sending neutral; returns what is wrong with the options, or an empty text.
	std::string open(const SenderOptions &p_options, const MotionCueing &p_cueing);
	void close();
	bool is_open() const { return _thread.joinable(); }
	void push(const SeatState &p_state, uint32_t p_tick);
	void teleport();
	void set_paused(bool p_is_paused);
	SenderReport report() const;

private:
	void run();
	void send(int p_socket, const CueMessage &p_message);

	SenderOptions _options;
	std::thread _thread;
	mutable std::mutex _mutex;
	std::condition_variable _stop_asked;
	bool _is_stopping = false;
	CueStream _stream;
	SenderReport _report;
};

} // namespace cueing
