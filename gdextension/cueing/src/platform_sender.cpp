// SPDX-License-Identifier: MIT
#include "platform_sender.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstring>

#include <netdb.h>
#include <sys/socket.h>
#include <unistd.h>

namespace cueing {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double LOWEST_RATE_HZ = 10.0;
constexpr double HIGHEST_RATE_HZ = 1000.0;

double seconds_now() {
	return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

/// A socket that sends to an address without waiting; closed when it goes.
class UdpSocket {
public:
	UdpSocket(const std::string &p_host, int p_port, std::string &r_error) {
		addrinfo hints{};
		hints.ai_socktype = SOCK_DGRAM;
		addrinfo *found = nullptr;
		const int fault = getaddrinfo(p_host.c_str(), std::to_string(p_port).c_str(), &hints, &found);
		if (fault != 0) {
			r_error = "there is no address " + p_host + ": " + gai_strerror(fault);
			return;
		}
		_socket = socket(found->ai_family, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
		if (_socket < 0 || connect(_socket, found->ai_addr, found->ai_addrlen) != 0) {
			r_error = "nothing can be sent to " + p_host + ": " + std::strerror(errno);
		}
		freeaddrinfo(found);
	}
	~UdpSocket() {
		if (_socket >= 0) {
			::close(_socket);
		}
	}
	UdpSocket(const UdpSocket &) = delete;
	UdpSocket &operator=(const UdpSocket &) = delete;
	int raw() const { return _socket; }

private:
	int _socket = -1;
};

} // namespace

std::string PlatformSender::open(const SenderOptions &p_options, const MotionCueing &p_cueing) {
	close();
	if (p_options.host.empty()) {
		return "a platform needs an address such as 127.0.0.1";
	}
	if (p_options.port < 1 || p_options.port > 65535) {
		return "a UDP port is 1 to 65535";
	}
	if (!(p_options.rate_hz >= LOWEST_RATE_HZ && p_options.rate_hz <= HIGHEST_RATE_HZ)) {
		return "a platform is sent 10 to 1000 datagrams a second";
	}
	_options = p_options;
	_stream = CueStream();
	_stream.cueing = p_cueing;
	_stream.cueing.reset();
	_report = SenderReport();
	_is_stopping = false;
	_thread = std::thread([this]() { run(); });
	return "";
}

void PlatformSender::close() {
	if (!_thread.joinable()) {
		return;
	}
	{
		const std::lock_guard<std::mutex> lock(_mutex);
		_is_stopping = true;
	}
	_stop_asked.notify_all();
	_thread.join();
}

void PlatformSender::push(const SeatState &p_state, uint32_t p_tick) {
	const std::lock_guard<std::mutex> lock(_mutex);
	_stream.push(p_state, p_tick, seconds_now());
}

void PlatformSender::teleport() {
	const std::lock_guard<std::mutex> lock(_mutex);
	_stream.teleport(seconds_now());
}

void PlatformSender::set_paused(bool p_is_paused) {
	const std::lock_guard<std::mutex> lock(_mutex);
	_stream.set_paused(p_is_paused);
}

SenderReport PlatformSender::report() const {
	const std::lock_guard<std::mutex> lock(_mutex);
	SenderReport report = _report;
	report.message = _stream.message();
	return report;
}

void PlatformSender::run() {
	std::string error;
	const UdpSocket socket(_options.host, _options.port, error);
	std::unique_lock<std::mutex> lock(_mutex);
	_report.error = error;
	if (!error.empty()) {
		return;
	}
	const auto period =
			std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1.0 / _options.rate_hz));
	Clock::time_point due = Clock::now();
	while (!_stop_asked.wait_until(lock, due, [this]() { return _is_stopping; })) {
		const Clock::time_point now = Clock::now();
		_report.latest_s = std::max(_report.latest_s, std::chrono::duration<double>(now - due).count());
		send(socket.raw(), _stream.step(std::chrono::duration<double>(now.time_since_epoch()).count()));
		due += period;
		// After a long wait it goes on from now: a bunch of old datagrams helps nobody.
		if (due < now) {
			due = now + period;
		}
	}
}

void PlatformSender::send(int p_socket, const CueMessage &p_message) {
	std::array<uint8_t, MAX_DATAGRAM> bytes{};
	std::size_t size = 0;
	if (_options.format == CueFormat::OWN) {
		size = encode_cue(p_message, bytes);
	} else {
		size = encode_outsim(p_message, _options.format == CueFormat::OUTSIM ? -1 : _options.outsim_id, bytes);
	}
	// Does not wait. Where nobody listens on this machine, every other one is refused: it may come later.
	const bool went = ::send(p_socket, bytes.data(), size, MSG_NOSIGNAL) == ssize_t(size);
	(went ? _report.sent : _report.failed)++;
}

} // namespace cueing
