// SPDX-License-Identifier: MIT
#include "usb/port.hpp"

#include "clock/clock.hpp"

#include <algorithm>
#include <cstring>

namespace usb {

namespace {

/// An FTDI chip completes a read each millisecond: so many can wait for a thread that gets no processor.
constexpr int READS = 64;
constexpr int WRITES = 16;
constexpr std::size_t READ_SIZE = 4096;
constexpr std::size_t WRITE_SIZE = 512;
constexpr unsigned WRITE_LIMIT_MS = 1000;
constexpr unsigned CONTROL_LIMIT_MS = 500;
/// Reads that fail in a row before the device counts as dead.
constexpr int MAX_FAILURES = 64;
/// The shortest that the chip knows: with the default of 16 ms samples are 10 ms late on average.
constexpr uint16_t LATENCY_MS = 1;

std::string hex(uint16_t p_number) {
	constexpr char DIGITS[] = "0123456789abcdef";
	std::string text(4, '0');
	for (unsigned digit = 0; digit < 4; ++digit) {
		text[3 - digit] = DIGITS[(unsigned(p_number) >> (4 * digit)) & 15U];
	}
	return text;
}

std::string node_of(libusb_device *p_device) {
	char text[40];
	snprintf(text, sizeof(text), "/dev/bus/usb/%03d/%03d", libusb_get_bus_number(p_device),
			libusb_get_device_address(p_device));
	return text;
}

PortFault fault_of(int p_error, libusb_device *p_device, const KnownDevice &p_known) {
	const std::string which = std::string(p_known.name) + " (" + hex(p_known.vendor) + ":" + hex(p_known.product) +
			", " + node_of(p_device) + ")";
	switch (p_error) {
		case LIBUSB_ERROR_ACCESS:
			return { "no permission for " + which +
						": copy 60-dismount-suits.rules to /etc/udev/rules.d/ (sudo), run 'sudo udevadm control "
						"--reload-rules' and plug the device in again",
				true };
		case LIBUSB_ERROR_BUSY:
			return { which + " is in use by another program: end that one", true };
		case LIBUSB_ERROR_NO_DEVICE:
			return { which + " was unplugged", false };
		case LIBUSB_ERROR_NOT_FOUND:
			return { which + " has no pair of bulk endpoints: it is no suit, or it is in another mode", false };
		default:
			return { which + " can't be opened: " + libusb_strerror(p_error), true };
	}
}

} // namespace

std::unique_ptr<Port> Port::open(
		libusb_device *p_device, const KnownDevice &p_known, PortListener &p_listener, PortFault &r_fault) {
	std::unique_ptr<Port> port(new Port(p_known, p_listener));
	libusb_device_handle *handle = nullptr;
	const int error = libusb_open(p_device, &handle);
	if (error != LIBUSB_SUCCESS) {
		r_fault = fault_of(error, p_device, p_known);
		return nullptr;
	}
	port->_handle.reset(handle);
	if (!port->claim(p_device, r_fault) || !port->set_up_chip(r_fault)) {
		return nullptr;
	}
	if (!port->prepare_transfers()) {
		r_fault = { "there is no memory for the transfers of " + node_of(p_device), true };
		return nullptr;
	}
	return port;
}

Port::~Port() {
	if (_is_claimed) {
		if (!_gone && has_baud()) {
			control(ftdi::FLOW_CONTROL, 0, chip_port());
			control(ftdi::MODEM_CONTROL, ftdi::DTR_RTS_OFF, chip_port());
		}
		// The kernel's driver gets the interface back, if it had it.
		libusb_release_interface(_handle.get(), _ends.interface);
	}
}

bool Port::find_endpoints(libusb_device *p_device, Endpoints &r_endpoints) {
	libusb_config_descriptor *raw = nullptr;
	if (libusb_get_active_config_descriptor(p_device, &raw) != LIBUSB_SUCCESS &&
			libusb_get_config_descriptor(p_device, 0, &raw) != LIBUSB_SUCCESS) {
		return false;
	}
	const std::unique_ptr<libusb_config_descriptor, void (*)(libusb_config_descriptor *)> config(
			raw, libusb_free_config_descriptor);
	for (int index = 0; index < config->bNumInterfaces; ++index) {
		const libusb_interface &interface = config->interface[index];
		for (int setting = 0; setting < interface.num_altsetting; ++setting) {
			const libusb_interface_descriptor &descriptor = interface.altsetting[setting];
			Endpoints found;
			for (int end = 0; end < descriptor.bNumEndpoints; ++end) {
				const libusb_endpoint_descriptor &endpoint = descriptor.endpoint[end];
				if ((endpoint.bmAttributes & 3U) != LIBUSB_TRANSFER_TYPE_BULK) {
					continue;
				}
				const bool is_in = (endpoint.bEndpointAddress & 0x80U) != 0;
				uint8_t &address = is_in ? found.in : found.out;
				if (address == 0) {
					address = endpoint.bEndpointAddress;
					const auto size = uint16_t(endpoint.wMaxPacketSize & 0x7FFU);
					found.packet_size = is_in ? std::max<uint16_t>(size, 8) : found.packet_size;
				}
			}
			if (found.in != 0 && found.out != 0) {
				found.interface = descriptor.bInterfaceNumber;
				found.setting = descriptor.bAlternateSetting;
				r_endpoints = found;
				return true;
			}
		}
	}
	return false;
}

bool Port::claim(libusb_device *p_device, PortFault &r_fault) {
	libusb_device_descriptor descriptor{};
	libusb_get_device_descriptor(p_device, &descriptor);
	_release = descriptor.bcdDevice;
	if (descriptor.iSerialNumber != 0) {
		unsigned char text[64] = {};
		const int size =
				libusb_get_string_descriptor_ascii(_handle.get(), descriptor.iSerialNumber, text, sizeof(text));
		// What a device says of itself goes to logs and screens.
		for (int at = 0; at < size; ++at) {
			_serial += text[at] > 0x20 && text[at] < 0x7F ? char(text[at]) : '?';
		}
	}
	if (!find_endpoints(p_device, _ends)) {
		r_fault = fault_of(LIBUSB_ERROR_NOT_FOUND, p_device, _known);
		return false;
	}
	libusb_set_auto_detach_kernel_driver(_handle.get(), 1);
	int error = libusb_claim_interface(_handle.get(), _ends.interface);
	_is_claimed = error == LIBUSB_SUCCESS;
	if (_is_claimed && _ends.setting != 0) {
		error = libusb_set_interface_alt_setting(_handle.get(), _ends.interface, _ends.setting);
	}
	if (error != LIBUSB_SUCCESS) {
		r_fault = fault_of(error, p_device, _known);
	}
	return error == LIBUSB_SUCCESS;
}

uint16_t Port::chip_port() const {
	return ftdi_has_ports(_release) ? uint16_t(_ends.interface + 1) : uint16_t(0);
}

bool Port::set_up_chip(PortFault &r_fault) {
	if (!has_baud()) {
		return true;
	}
	const uint16_t port = chip_port();
	const bool done = control(ftdi::RESET, ftdi::RESET_ALL, port) && control(ftdi::LATENCY_TIMER, LATENCY_MS, port) &&
			control(ftdi::DATA_FORMAT, ftdi::FORMAT_8N2, port) && control(ftdi::FLOW_CONTROL, 0, port) &&
			control(ftdi::MODEM_CONTROL, ftdi::DTR_RTS_ON, port);
	if (!done) {
		r_fault = { std::string(_known.name) + ": its serial chip does not answer; plug it in again", true };
		return false;
	}
	unsigned char status[2] = {};
	libusb_control_transfer(
			_handle.get(), ftdi::IN, ftdi::MODEM_STATUS, 0, port, status, sizeof(status), CONTROL_LIMIT_MS);
	return true;
}

bool Port::control(uint8_t p_request, uint16_t p_value, uint16_t p_index) {
	const int done = libusb_control_transfer(
			_handle.get(), ftdi::OUT, p_request, p_value, p_index, nullptr, 0, CONTROL_LIMIT_MS);
	if (done == LIBUSB_ERROR_NO_DEVICE) {
		_gone = true;
	}
	return done >= 0;
}

bool Port::prepare_transfers() {
	// A read ends at packets only: anything else could overflow.
	const std::size_t packets = std::max<std::size_t>(READ_SIZE / _ends.packet_size, 1);
	_reads.resize(READS);
	_writes.resize(WRITES);
	for (std::vector<Transfer> *list : { &_reads, &_writes }) {
		const bool reads = list == &_reads;
		for (Transfer &transfer : *list) {
			transfer.port = this;
			transfer.buffer.resize(reads ? packets * _ends.packet_size : WRITE_SIZE);
			transfer.transfer.reset(libusb_alloc_transfer(0));
			if (transfer.transfer == nullptr) {
				return false;
			}
			libusb_fill_bulk_transfer(transfer.transfer.get(), _handle.get(), reads ? _ends.in : _ends.out,
					transfer.buffer.data(), int(transfer.buffer.size()), reads ? on_read : on_write, &transfer,
					reads ? 0 : WRITE_LIMIT_MS);
		}
	}
	return true;
}

bool Port::start() {
	bool any = false;
	for (Transfer &transfer : _reads) {
		any = submit(transfer) || any;
	}
	return any;
}

bool Port::send(const uint8_t *p_bytes, std::size_t p_size) {
	std::size_t sent = 0;
	for (Transfer &transfer : _writes) {
		if (sent == p_size || _gone || _is_stopping) {
			break;
		}
		if (transfer.is_flying) {
			continue;
		}
		const std::size_t size = std::min(p_size - sent, WRITE_SIZE);
		std::memcpy(transfer.buffer.data(), p_bytes + sent, size);
		transfer.transfer->length = int(size);
		if (!submit(transfer)) {
			break;
		}
		sent += size;
	}
	_statistics.bytes_out += sent;
	_statistics.failed_writes += sent < p_size ? 1U : 0U;
	return sent == p_size;
}

void Port::set_baud(uint32_t p_baud) {
	if (!has_baud() || _gone) {
		return;
	}
	const FtdiDivisor divisor = ftdi_divisor(p_baud, _release, chip_port());
	control(ftdi::BAUD_RATE, divisor.value, divisor.index);
	// What came in at the old speed is noise.
	control(ftdi::RESET, ftdi::PURGE_IN, chip_port());
}

void Port::stop() {
	_is_stopping = true;
	for (std::vector<Transfer> *list : { &_reads, &_writes }) {
		for (Transfer &transfer : *list) {
			if (transfer.is_flying) {
				libusb_cancel_transfer(transfer.transfer.get());
			}
		}
	}
}

void Port::look_after() {
	if (_is_stopping || _gone || _is_dead) {
		return;
	}
	if (_is_halted) {
		_is_halted = false;
		libusb_clear_halt(_handle.get(), _ends.in);
	}
	for (Transfer &transfer : _reads) {
		if (!transfer.is_flying) {
			submit(transfer);
		}
	}
}

bool Port::submit(Transfer &p_transfer) {
	const int error = libusb_submit_transfer(p_transfer.transfer.get());
	if (error == LIBUSB_SUCCESS) {
		p_transfer.is_flying = true;
		++_in_flight;
	} else if (error == LIBUSB_ERROR_NO_DEVICE) {
		_gone = true;
	}
	return error == LIBUSB_SUCCESS;
}

void LIBUSB_CALL Port::on_read(libusb_transfer *p_transfer) {
	auto *transfer = static_cast<Transfer *>(p_transfer->user_data);
	transfer->port->read_done(*transfer);
}

void LIBUSB_CALL Port::on_write(libusb_transfer *p_transfer) {
	auto *transfer = static_cast<Transfer *>(p_transfer->user_data);
	transfer->port->write_done(*transfer);
}

void Port::read_done(Transfer &p_transfer) {
	p_transfer.is_flying = false;
	--_in_flight;
	const libusb_transfer &transfer = *p_transfer.transfer;
	const auto size = std::size_t(std::max(transfer.actual_length, 0));
	if (size > 0) {
		const uint64_t now = clocks::now_usec();
		_statistics.bytes_in += size;
		if (has_baud()) {
			ftdi_strip(transfer.buffer, size, _ends.packet_size, _statistics.ftdi,
					[this, now](const uint8_t *p_bytes, std::size_t p_size) {
						_listener.take_bytes(p_bytes, p_size, now);
					});
		} else {
			_listener.take_bytes(transfer.buffer, size, now);
		}
	}
	switch (transfer.status) {
		case LIBUSB_TRANSFER_COMPLETED:
		case LIBUSB_TRANSFER_TIMED_OUT:
			_failures = 0;
			break;
		case LIBUSB_TRANSFER_CANCELLED:
			return;
		case LIBUSB_TRANSFER_NO_DEVICE:
			_gone = true;
			return;
		case LIBUSB_TRANSFER_STALL:
			++_statistics.halts;
			_is_halted = true; // Ended by look_after: that takes a request of its own.
			_is_dead = ++_failures > MAX_FAILURES || _is_dead;
			return;
		default:
			++_statistics.failed_reads;
			// Begun again by look_after: a device that is going away fails thousands of times a second.
			_is_dead = ++_failures > MAX_FAILURES || _is_dead;
			return;
	}
	if (!_is_stopping && !_gone && !_is_dead) {
		submit(p_transfer);
	}
}

void Port::write_done(Transfer &p_transfer) {
	p_transfer.is_flying = false;
	--_in_flight;
	if (p_transfer.transfer->status == LIBUSB_TRANSFER_NO_DEVICE) {
		_gone = true;
	} else if (p_transfer.transfer->status != LIBUSB_TRANSFER_COMPLETED && !_is_stopping) {
		++_statistics.failed_writes;
	}
}

} // namespace usb
