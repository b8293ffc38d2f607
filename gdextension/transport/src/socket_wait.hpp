// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>

namespace transport {

/// The process's UDP socket of a port, or -1 if there is none or several: ENet does not give its own
/// away. It stays its owner's.
int find_udp_socket(uint16_t p_port);

/// Lets a thread wait until its socket has something to read or another thread calls wake(), whichever
/// comes first. ENet can only wait for its socket: who has something to send would have to wait until
/// that wait times out.
///
/// All but wake() belong to the waiting thread, or to its owner while it does not run.
class SocketWait {
public:
	SocketWait() = default;
	~SocketWait();
	SocketWait(const SocketWait &) = delete;
	SocketWait &operator=(const SocketWait &) = delete;

	/// Watches a socket. False if it is none, or the system has no descriptor left. It stays its
	/// owner's, who calls close() before it ends.
	bool open(int p_socket);
	void close();
	bool is_open() const { return _event >= 0 && _socket >= 0; }

	/// Waits for at most this long, ms; not at all if wake() was called since the last take().
	void wait(int p_max_ms) const;
	/// Whether wake() was called since the last take(). What its caller did before is visible now.
	bool take();
	/// From any thread, also while the object is not open: there is something to do. Many calls in a
	/// row cost as much as one.
	void wake();

private:
	int _socket = -1;
	// Made once: wake() may be called while the object is opened or closed.
	std::atomic<int> _event{ -1 };
	std::atomic<bool> _pending{ false };
};

} // namespace transport
