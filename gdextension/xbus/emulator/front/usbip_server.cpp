// SPDX-License-Identifier: MIT
#include "front/usbip_server.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace emulator {

/// What every message of USB/IP begins with; all numbers are big-endian (Documentation/usb/usbip_protocol.rst
/// of the kernel).
struct UsbipServer::Header {
	uint32_t command = 0;
	uint32_t number = 0;
	uint32_t device = 0;
	uint32_t is_in = 0;
	uint32_t endpoint = 0;
	/// Of a submission: flags, length, first frame, packets, interval. Of an answer: status, length, ...
	std::array<uint32_t, 5> values{};
	std::array<uint8_t, 8> setup{};

	void swap() {
		for (uint32_t *value : { &command, &number, &device, &is_in, &endpoint }) {
			*value = ntohl(*value);
		}
		for (uint32_t &value : values) {
			value = ntohl(value);
		}
	}
};

namespace {

constexpr uint32_t SUBMIT = 1;
constexpr uint32_t UNLINK = 2;
constexpr uint32_t SUBMITTED = 3;
constexpr uint32_t UNLINKED = 4;
constexpr uint32_t DEVICE = 0x00010002;
constexpr uint32_t MAX = 1U << 20U;

} // namespace

UsbipServer::UsbipServer(UsbPort &p_port, std::function<Usec()> p_clock, int p_index) :
		_port(p_port), _clock(std::move(p_clock)), _index(p_index) {}

UsbipServer::~UsbipServer() {
	unplug();
}

bool UsbipServer::plug() {
	static_assert(sizeof(Header) == 48);
	constexpr int FULL_SPEED = 2;
	constexpr int HIGH_SPEED = 3;
	std::array<int, 2> ends{};
	if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) != 0) {
		return false;
	}
	_port.plug(true, _clock());
	_socket = ends[0];
	_is_over = false;
	_thread = std::thread([this]() { _serve(); });
	const int speed = _port.description().speed == 480 ? HIGH_SPEED : FULL_SPEED;
	std::ofstream attach("/sys/devices/platform/vhci_hcd.0/attach");
	attach << _index << ' ' << ends[1] << ' ' << DEVICE << ' ' << speed << std::flush;
	const bool is_taken = bool(attach);
	close(ends[1]);
	return is_taken;
}

void UsbipServer::unplug() {
	_is_over = true;
	if (_socket >= 0) {
		shutdown(_socket, SHUT_RDWR);
	}
	if (_thread.joinable()) {
		_thread.join();
	}
	if (_socket >= 0) {
		close(_socket);
		_socket = -1;
		_port.plug(false, _clock());
	}
}

void UsbipServer::_serve() {
	while (!_is_over) {
		_port.advance(_clock());
		if (!_answer()) {
			return;
		}
		const Usec left = std::max<Usec>(std::min(_port.next_event() - _clock(), SECOND / 10), 0);
		const timespec timeout = { 0, long(left) * 1000 };
		pollfd wait = { _socket, POLLIN, 0 };
		if (ppoll(&wait, 1, &timeout, nullptr) > 0 && !_take()) {
			return;
		}
	}
}

bool UsbipServer::_read(void *r_bytes, std::size_t p_size) const {
	return p_size == 0 || recv(_socket, r_bytes, p_size, MSG_WAITALL) == ssize_t(p_size);
}

bool UsbipServer::_write(const void *p_bytes, std::size_t p_size) const {
	const auto *bytes = static_cast<const uint8_t *>(p_bytes);
	std::size_t sent = 0;
	while (sent < p_size) {
		const ssize_t went = send(_socket, bytes + sent, p_size - sent, MSG_NOSIGNAL);
		if (went <= 0) {
			return false;
		}
		sent += std::size_t(went);
	}
	return true;
}

bool UsbipServer::_take() {
	Header header;
	if (!_read(&header, sizeof(header))) {
		return false;
	}
	header.swap();
	if (header.command == SUBMIT) {
		return _submit(header);
	}
	if (header.command == UNLINK) {
		_unlink(header);
		return true;
	}
	return false;
}

bool UsbipServer::_submit(const Header &p_header) {
	const uint32_t length = p_header.values[1];
	if (length > MAX || p_header.endpoint > 15) {
		return false;
	}
	auto urb = std::make_unique<Urb>();
	urb->id = p_header.number;
	urb->endpoint = uint8_t(p_header.endpoint | (p_header.is_in != 0 ? 0x80U : 0U));
	urb->data.resize(length);
	if (p_header.is_in == 0 && !_read(urb->data.data(), length)) {
		return false;
	}
	if (p_header.endpoint == 0) {
		urb->type = Urb::Type::CONTROL;
		urb->setup = UsbSetup::parse(p_header.setup.data());
	}
	if (const int fault = _port.submit(std::move(urb), _clock()); fault != 0) {
		Header answer;
		answer.command = SUBMITTED;
		answer.number = p_header.number;
		answer.values[0] = uint32_t(fault);
		answer.swap();
		return _write(&answer, sizeof(answer));
	}
	return true;
}

void UsbipServer::_unlink(const Header &p_header) {
	// What was completed before is answered before: the kernel then learns that there was nothing to unlink.
	_answer();
	const bool is_found = _port.discard(p_header.values[0], -ECONNRESET);
	if (is_found) {
		_port.take_completed();
	}
	Header answer;
	answer.command = UNLINKED;
	answer.number = p_header.number;
	answer.values[0] = is_found ? uint32_t(-ECONNRESET) : 0;
	answer.swap();
	_write(&answer, sizeof(answer));
}

bool UsbipServer::_answer() {
	while (const std::unique_ptr<Urb> done = _port.take_completed()) {
		const bool is_in = (done->endpoint & 0x80U) != 0;
		Header answer;
		answer.command = SUBMITTED;
		answer.number = uint32_t(done->id);
		answer.values[0] = uint32_t(done->status);
		answer.values[1] = uint32_t(done->done);
		answer.swap();
		if (!_write(&answer, sizeof(answer)) || (is_in && !_write(done->data.data(), done->done))) {
			return false;
		}
	}
	return true;
}

} // namespace emulator
