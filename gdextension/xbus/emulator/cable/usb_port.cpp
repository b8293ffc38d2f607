// SPDX-License-Identifier: MIT
#include "cable/usb_port.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

namespace emulator {

UsbPort::UsbPort(UsbDevice &p_device, Log p_log) : _device(p_device), _log(std::move(p_log)) {}

void UsbPort::plug(bool p_in, Usec p_now) {
	if (p_in == _is_plugged) {
		return;
	}
	_is_plugged = p_in;
	if (!p_in) {
		discard_all(-ESHUTDOWN);
	}
	_device.plug(p_in, p_now);
}

void UsbPort::_complete(std::unique_ptr<Urb> p_urb, int p_status) {
	p_urb->status = p_status;
	_completed.push_back(std::move(p_urb));
}

int UsbPort::submit(std::unique_ptr<Urb> p_urb, Usec p_now) {
	if (!_is_plugged) {
		return -ENODEV;
	}
	if (p_urb->type == Urb::Type::CONTROL) {
		_control(std::move(p_urb), p_now);
		return 0;
	}
	const UsbEndpoint *endpoint = description().find_endpoint(p_urb->endpoint);
	if (endpoint == nullptr || p_urb->type == Urb::Type::ISOCHRONOUS) {
		return -ENOENT;
	}
	if ((p_urb->endpoint & 0x80U) != 0) {
		_reads[p_urb->endpoint].push_back(std::move(p_urb));
		advance(p_now);
		return 0;
	}
	const int went = _device.write(p_urb->endpoint, p_urb->data.data(), p_urb->data.size(), p_now);
	p_urb->done = std::size_t(std::max(went, 0));
	_complete(std::move(p_urb), std::min(went, 0));
	return 0;
}

void UsbPort::_control(std::unique_ptr<Urb> p_urb, Usec p_now) {
	constexpr uint8_t KIND = 0x60;
	constexpr uint8_t CLEAR_ENDPOINT_FEATURE = 0x02;
	const UsbSetup &setup = p_urb->setup;
	p_urb->data.resize(std::max(p_urb->data.size(), std::size_t(setup.length)));
	int went = 0;
	if ((setup.type & KIND) == 0) {
		went = standard_control(description(), setup, p_urb->data.data());
		if (setup.type == CLEAR_ENDPOINT_FEATURE && setup.request == 1) {
			clear_halt(uint8_t(setup.index));
		}
	} else {
		went = _device.control(setup, p_urb->data.data(), p_now);
		_log("control " + setup.text() + (went < 0 ? " refused" : ""));
	}
	p_urb->done = std::size_t(std::max(went, 0));
	_complete(std::move(p_urb), std::min(went, 0));
}

bool UsbPort::discard(uint64_t p_id, int p_status) {
	for (auto &[endpoint, queue] : _reads) {
		const auto is_it = [p_id](const std::unique_ptr<Urb> &p_urb) { return p_urb->id == p_id; };
		const auto found = std::find_if(queue.begin(), queue.end(), is_it);
		if (found != queue.end()) {
			std::unique_ptr<Urb> urb = std::move(*found);
			queue.erase(found);
			_complete(std::move(urb), p_status);
			return true;
		}
	}
	return false;
}

void UsbPort::discard_all(int p_status) {
	for (auto &[endpoint, queue] : _reads) {
		while (!queue.empty()) {
			std::unique_ptr<Urb> urb = std::move(queue.front());
			queue.pop_front();
			_complete(std::move(urb), p_status);
		}
	}
}

void UsbPort::_serve(uint8_t p_endpoint, Queue &r_queue, Usec p_now) {
	std::array<uint8_t, 512> packet{};
	const std::size_t longest = description().find_endpoint(p_endpoint)->packet;
	while (!r_queue.empty()) {
		Urb &urb = *r_queue.front();
		Usec time = p_now;
		const int size = _device.read_packet(p_endpoint, packet.data(), p_now, time);
		if (size == USB_NAK) {
			return;
		}
		int status = std::min(size, 0);
		bool is_over = size < int(longest);
		if (size > 0) {
			const std::size_t room = urb.data.size() - urb.done;
			const std::size_t taken = std::min(std::size_t(size), room);
			std::memcpy(urb.data.data() + urb.done, packet.data(), taken);
			urb.done += taken;
			status = std::size_t(size) > room ? -EOVERFLOW : 0;
			is_over = is_over || urb.done == urb.data.size();
		}
		if (is_over) {
			std::unique_ptr<Urb> done = std::move(r_queue.front());
			r_queue.pop_front();
			_complete(std::move(done), status);
		}
	}
}

void UsbPort::advance(Usec p_now) {
	if (!_is_plugged) {
		return;
	}
	bool was_read = false;
	bool is_read = false;
	for (auto &[endpoint, queue] : _reads) {
		was_read = was_read || !queue.empty();
		_serve(endpoint, queue, p_now);
		is_read = is_read || !queue.empty();
	}
	_last_read = was_read ? p_now : _last_read;
	if (!is_read) {
		_device.wait(p_now, _last_read);
	}
}

Usec UsbPort::next_event() const {
	const auto waits = [](const auto &p_pair) { return !p_pair.second.empty(); };
	return _is_plugged ? _device.next_event(std::any_of(_reads.begin(), _reads.end(), waits)) : NEVER;
}

std::unique_ptr<Urb> UsbPort::take_completed() {
	if (_completed.empty()) {
		return nullptr;
	}
	std::unique_ptr<Urb> urb = std::move(_completed.front());
	_completed.pop_front();
	return urb;
}

void UsbPort::clear_halt(uint8_t p_endpoint) {
	_device.clear_halt(p_endpoint);
}

} // namespace emulator
