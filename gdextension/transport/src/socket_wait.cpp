// SPDX-License-Identifier: MIT
#include "socket_wait.hpp"

#include <array>
#include <charconv>
#include <cstring>
#include <dirent.h>
#include <memory>
#include <netinet/in.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

namespace transport {

namespace {

struct CloseFolder {
	void operator()(DIR *p_folder) const { closedir(p_folder); }
};

/// The local port of a descriptor that is a UDP socket, else 0.
uint16_t udp_port(int p_descriptor) {
	int type = 0;
	socklen_t size = sizeof(type);
	if (getsockopt(p_descriptor, SOL_SOCKET, SO_TYPE, &type, &size) != 0 || type != SOCK_DGRAM) {
		return 0;
	}
	sockaddr_storage at{};
	size = sizeof(at);
	if (getsockname(p_descriptor, reinterpret_cast<sockaddr *>(&at), &size) != 0) {
		return 0;
	}
	if (at.ss_family == AF_INET) {
		return ntohs(reinterpret_cast<const sockaddr_in &>(at).sin_port);
	}
	return at.ss_family == AF_INET6 ? ntohs(reinterpret_cast<const sockaddr_in6 &>(at).sin6_port) : 0;
}

} // namespace

int find_udp_socket(uint16_t p_port) {
	const std::unique_ptr<DIR, CloseFolder> folder(opendir("/proc/self/fd"));
	if (!folder || p_port == 0) {
		return -1;
	}
	int found = -1;
	while (const dirent *entry = readdir(folder.get())) {
		const char *name = entry->d_name;
		int descriptor = -1;
		const auto read = std::from_chars(name, name + std::strlen(name), descriptor);
		if (read.ec == std::errc() && *read.ptr == '\0' && udp_port(descriptor) == p_port) {
			if (found >= 0) {
				return -1; // Of two addresses: no telling which is meant.
			}
			found = descriptor;
		}
	}
	return found;
}

SocketWait::~SocketWait() {
	if (_event >= 0) {
		::close(_event);
	}
}

bool SocketWait::open(int p_socket) {
	if (_event < 0) {
		_event = eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
	}
	_socket = p_socket;
	return is_open();
}

void SocketWait::close() {
	_socket = -1;
}

void SocketWait::wait(int p_max_ms) const {
	std::array<pollfd, 2> watched{ { { _socket, POLLIN, 0 }, { _event, POLLIN, 0 } } };
	// A signal or an error ends the wait early, which does no harm.
	poll(watched.data(), watched.size(), _pending.load() ? 0 : p_max_ms);
}

bool SocketWait::take() {
	if (!_pending.load()) {
		return false;
	}
	uint64_t count = 0;
	// Before the flag is lowered: who raises it again then finds the event empty and fills it anew.
	if (_event >= 0 && read(_event, &count, sizeof(count)) < 0) {
		count = 0; // It was empty: nobody had to be woken.
	}
	return _pending.exchange(false);
}

void SocketWait::wake() {
	if (!_pending.exchange(true) && _event >= 0) {
		const uint64_t one = 1;
		if (write(_event, &one, sizeof(one)) < 0) {
			return; // It is full: that wakes as well.
		}
	}
}

} // namespace transport
