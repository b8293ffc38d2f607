// SPDX-License-Identifier: MIT
#include <platform_sender.hpp>

#include "check.hpp"

#include <chrono>
#include <vector>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

namespace test_platform_sender {

using namespace cueing;

namespace {

/// A socket on a free port of this machine.
class Listener {
public:
	Listener() : _socket(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
		sockaddr_in address{};
		address.sin_family = AF_INET;
		address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
		socklen_t size = sizeof(address);
		const timeval patience{ 5, 0 };
		setsockopt(_socket, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof(patience));
		CHECK(bind(_socket, reinterpret_cast<sockaddr *>(&address), size) == 0);
		CHECK(getsockname(_socket, reinterpret_cast<sockaddr *>(&address), &size) == 0);
		port = ntohs(address.sin_port);
	}
	~Listener() { close(_socket); }
	Listener(const Listener &) = delete;
	Listener &operator=(const Listener &) = delete;

	std::vector<uint8_t> take() {
		std::vector<uint8_t> bytes(2000);
		const ssize_t size = recv(_socket, bytes.data(), bytes.size(), 0);
		bytes.resize(size > 0 ? std::size_t(size) : 0);
		return bytes;
	}
	int port = 0;

private:
	int _socket;
};

MotionCueing platform() {
	MotionCueing cueing;
	const AxisLimits limits{ 0.4, 0.6, 6.0 };
	cueing.set_limits({ limits, limits, limits }, { limits, limits, limits });
	return cueing;
}

} // namespace

TEST(datagrams_leave_in_order_whether_or_not_anything_is_heard) {
	Listener listener;
	PlatformSender sender;
	SenderOptions options;
	options.port = listener.port;
	CHECK(sender.open(options, platform()).empty());
	CHECK(sender.is_open());
	uint32_t before = 0;
	for (int i = 0; i < 40; i++) {
		SeatState state;
		state.time = i * 0.005;
		sender.push(state, uint32_t(i));
		const std::vector<uint8_t> bytes = listener.take();
		CHECK(bytes.size() == CUE_SIZE);
		if (bytes.size() == CUE_SIZE) {
			const uint32_t sequence = bytes[8] | (bytes[9] << 8U) | (bytes[10] << 16U) | (uint32_t(bytes[11]) << 24U);
			CHECK(sequence == before + 1);
			before = sequence;
		}
	}
	sender.set_paused(true);
	sender.teleport();
	CHECK(sender.report().sent >= 40);
	CHECK(sender.report().error.empty());
	sender.close();
	CHECK(!sender.is_open());
}

TEST(outsim_leaves_with_and_without_an_id) {
	Listener listener;
	PlatformSender sender;
	SenderOptions options;
	options.port = listener.port;
	options.rate_hz = 250.0;
	options.format = CueFormat::OUTSIM;
	CHECK(sender.open(options, platform()).empty());
	CHECK(listener.take().size() == OUTSIM_SIZE);
	options.format = CueFormat::OUTSIM_WITH_ID;
	CHECK(sender.open(options, platform()).empty());
	std::size_t size = 0;
	for (int i = 0; i < 200 && size != OUTSIM_ID_SIZE; i++) {
		size = listener.take().size();
	}
	CHECK(size == OUTSIM_ID_SIZE);
}

TEST(options_without_sense_are_named) {
	PlatformSender sender;
	SenderOptions options;
	options.port = 0;
	CHECK(sender.open(options, platform()).find("port") != std::string::npos);
	options = SenderOptions();
	options.rate_hz = 5000.0;
	CHECK(sender.open(options, platform()).find("10 to 1000") != std::string::npos);
	options = SenderOptions();
	options.host = "";
	CHECK(sender.open(options, platform()).find("address") != std::string::npos);
	CHECK(!sender.is_open());
	options = SenderOptions();
	options.host = "999.1.1.1";
	CHECK(sender.open(options, platform()).empty());
	for (int i = 0; i < 2000 && sender.report().error.empty(); i++) {
		std::this_thread::sleep_for(std::chrono::milliseconds(5));
	}
	CHECK(sender.report().error.find("999.1.1.1") != std::string::npos);
}

} // namespace test_platform_sender
