// SPDX-License-Identifier: MIT
#include "check.hpp"
#include "socket_wait.hpp"

#include <algorithm>
#include <arpa/inet.h>
#include <atomic>
#include <chrono>
#include <netinet/in.h>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>

namespace test_socket_wait {

using transport::find_udp_socket;
using transport::SocketWait;

namespace {

/// Far longer than a wake-up takes on any machine, ms: what ends a wait is never the time.
constexpr int FOREVER_MS = 20000;

/// A bound UDP socket, as ENet has one.
class Port {
public:
	explicit Port(uint16_t p_port = 0, in_addr_t p_address = INADDR_LOOPBACK) {
		sockaddr_in at{};
		at.sin_family = AF_INET;
		at.sin_port = htons(p_port);
		at.sin_addr.s_addr = htonl(p_address);
		CHECK(bind(_socket, reinterpret_cast<const sockaddr *>(&at), sizeof(at)) == 0);
	}
	~Port() { close(_socket); }
	Port(const Port &) = delete;
	Port &operator=(const Port &) = delete;

	uint16_t number() const { return ntohs(address().sin_port); }

	bool send_to(const Port &p_other) const {
		const sockaddr_in to = p_other.address();
		const char byte = 1;
		return sendto(_socket, &byte, 1, 0, reinterpret_cast<const sockaddr *>(&to), sizeof(to)) == 1;
	}

	bool receives() const {
		char byte = 0;
		return recv(_socket, &byte, sizeof(byte), MSG_DONTWAIT) == 1;
	}

private:
	sockaddr_in address() const {
		sockaddr_in at{};
		socklen_t size = sizeof(at);
		getsockname(_socket, reinterpret_cast<sockaddr *>(&at), &size);
		return at;
	}

	int _socket = socket(AF_INET, SOCK_DGRAM, 0);
};

/// How long a call takes, ms.
template <typename Call>
int64_t milliseconds(Call p_call) {
	const auto begin = std::chrono::steady_clock::now();
	p_call();
	const auto end = std::chrono::steady_clock::now();
	return std::chrono::duration_cast<std::chrono::milliseconds>(end - begin).count();
}

} // namespace

TEST(a_wait_ends_with_its_time) {
	const Port port;
	SocketWait wait;
	CHECK(wait.open(find_udp_socket(port.number())));
	CHECK(milliseconds([&] { wait.wait(30); }) >= 29);
	CHECK(!wait.take());
}

TEST(a_datagram_ends_a_wait) {
	const Port port;
	const Port other;
	SocketWait wait;
	CHECK(wait.open(find_udp_socket(port.number())));
	bool sent = false;
	std::thread sender([&] { sent = other.send_to(port); });
	CHECK(milliseconds([&] { wait.wait(FOREVER_MS); }) < FOREVER_MS);
	sender.join();
	CHECK(sent);
	CHECK(port.receives());
	CHECK(!wait.take());
}

TEST(another_thread_ends_a_wait) {
	const Port port;
	SocketWait wait;
	CHECK(wait.open(find_udp_socket(port.number())));
	std::thread caller([&] { wait.wake(); });
	CHECK(milliseconds([&] { wait.wait(FOREVER_MS); }) < FOREVER_MS);
	caller.join();
	CHECK(wait.take());
	CHECK(!wait.take());
	CHECK(!port.receives());
}

TEST(a_call_before_the_wait_counts_and_is_taken_once) {
	const Port port;
	SocketWait wait;
	wait.wake();
	CHECK(wait.open(find_udp_socket(port.number())));
	for (int i = 0; i < 100; i++) {
		wait.wake();
	}
	CHECK(milliseconds([&] { wait.wait(FOREVER_MS); }) < FOREVER_MS);
	CHECK(wait.take());
	CHECK(milliseconds([&] { wait.wait(20); }) >= 19);
}

TEST(no_call_is_missed_between_threads) {
	const Port port;
	SocketWait wait;
	CHECK(wait.open(find_udp_socket(port.number())));
	constexpr int ROUNDS = 20000;
	std::atomic<int> posted{ 0 };
	std::atomic<int> seen{ 0 };
	std::thread caller([&] {
		for (int i = 1; i <= ROUNDS; i++) {
			posted = i;
			wait.wake();
			while (i % 16 == 0 && seen < i) {
				std::this_thread::yield(); // Let the other thread fall asleep.
			}
		}
	});
	int64_t longest = 0;
	while (seen < ROUNDS) {
		longest = std::max(longest, milliseconds([&] { wait.wait(FOREVER_MS); }));
		wait.take();
		seen = posted.load();
	}
	caller.join();
	CHECK(longest < FOREVER_MS);
}

TEST(only_the_one_socket_of_a_port_is_watched) {
	SocketWait wait;
	CHECK(!wait.open(find_udp_socket(0)));
	uint16_t gone = 0;
	{
		const Port port;
		gone = port.number();
		CHECK(wait.open(find_udp_socket(gone)));
		wait.close();
		CHECK(!wait.is_open());
		const Port twin(gone, INADDR_LOOPBACK + 1);
		CHECK(!wait.open(find_udp_socket(gone)));
	}
	CHECK(!wait.open(find_udp_socket(gone)));
	wait.wake();
	CHECK(wait.take());
}

} // namespace test_socket_wait
