// SPDX-License-Identifier: MIT
#include "front/usbfs_node.hpp"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <utility>

#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>

namespace emulator {

namespace {

/// The structure that the program passed; null where its memory cannot be read.
template <class T>
T *argument_of(UMockdevIoctlClient *p_client) {
	UMockdevIoctlData *argument = umockdev_ioctl_client_get_arg(p_client);
	UMockdevIoctlData *data = umockdev_ioctl_data_resolve(argument, 0, sizeof(T), nullptr);
	return data == nullptr ? nullptr : reinterpret_cast<T *>(data->data);
}

} // namespace

UsbfsNode::UsbfsNode(
		Shared &p_shared, UsbPort &p_port, Testbed &p_testbed, int p_index, std::string p_driver, UsbPort::Log p_log) :
		_shared(p_shared),
		_port(p_port),
		_testbed(p_testbed),
		_index(p_index),
		_driver(std::move(p_driver)),
		_log(std::move(p_log)),
		_claims(p_port, _driver, _log,
				[this](unsigned p_interface, bool p_is_bound) { _node->set_driver(p_interface, p_is_bound); }),
		_handler(umockdev_ioctl_base_new()) {
	g_signal_connect(_handler, "handle-ioctl", G_CALLBACK(_on_ioctl), this);
}

UsbfsNode::~UsbfsNode() {
	_node.reset();
	const std::lock_guard lock(_shared.mutex);
	for (const auto &[client, opened] : _opened) {
		g_object_weak_unref(G_OBJECT(client), _on_gone, this);
	}
	g_signal_handlers_disconnect_by_data(_handler, this);
	g_object_unref(_handler);
}

void UsbfsNode::plug(bool p_in) {
	if (p_in == _port.is_plugged()) {
		return;
	}
	if (!p_in) {
		{
			const std::lock_guard lock(_shared.mutex);
			_port.plug(false, _shared.now());
			collect();
			_claims.forget_all();
			_log("unplugged");
		}
		_node->leave();
		return;
	}
	auto node = std::make_unique<DeviceNode>(_testbed, _port.description(), _index, _driver, _handler);
	{
		const std::lock_guard lock(_shared.mutex);
		std::swap(_node, node);
		_claims.begin();
		_port.plug(true, _shared.now());
		_log("plugged");
		_shared.wake_early();
	}
	_node->announce();
}

gboolean UsbfsNode::_on_ioctl(UMockdevIoctlBase * /*p_base*/, UMockdevIoctlClient *p_client, gpointer p_self) {
	auto *self = static_cast<UsbfsNode *>(p_self);
	Result result = LATER;
	{
		const std::lock_guard lock(self->_shared.mutex);
		if (self->_opened.count(p_client) == 0) {
			self->_opened[p_client] = {};
			// umockdev says nothing when a program goes: it only lets go of the object.
			g_object_weak_ref(G_OBJECT(p_client), _on_gone, self);
		}
		result = self->_dispatch(p_client, unsigned(umockdev_ioctl_client_get_request(p_client)));
		self->collect();
		self->_shared.wake_early();
	}
	if (result != LATER) {
		umockdev_ioctl_client_complete(p_client, result < 0 ? -1 : result, result < 0 ? int(-result) : 0);
	}
	return TRUE;
}

void UsbfsNode::_on_gone(gpointer p_self, GObject *p_client) {
	auto *self = static_cast<UsbfsNode *>(p_self);
	const std::lock_guard lock(self->_shared.mutex);
	self->_close(reinterpret_cast<UMockdevIoctlClient *>(p_client));
}

UsbfsNode::Result UsbfsNode::_dispatch(UMockdevIoctlClient *p_client, unsigned p_request) {
	switch (p_request) {
		case USBDEVFS_REAPURB:
		case USBDEVFS_REAPURBNDELAY:
			return _reap(p_client, p_request == USBDEVFS_REAPURB);
		default:
			break;
	}
	if (!_port.is_plugged()) {
		return -ENODEV;
	}
	switch (p_request) {
		case USBDEVFS_SUBMITURB:
			return _submit(p_client);
		case USBDEVFS_DISCARDURB:
			return _discard(p_client);
		case USBDEVFS_CONTROL:
			return _control(p_client);
		case USBDEVFS_GET_CAPABILITIES: {
			auto *capabilities = argument_of<uint32_t>(p_client);
			if (capabilities == nullptr) {
				return -EFAULT;
			}
			*capabilities =
					USBDEVFS_CAP_ZERO_PACKET | USBDEVFS_CAP_NO_PACKET_SIZE_LIM | USBDEVFS_CAP_REAP_AFTER_DISCONNECT;
			return 0;
		}
		case USBDEVFS_RESET:
			_log("reset");
			_port.discard_all(-ENOENT);
			return 0;
		case USBDEVFS_GET_SPEED:
			return _port.description().speed == 480 ? 3 : 2;
		default:
			return _dispatch_interface(p_client, p_request);
	}
}

UsbfsNode::Result UsbfsNode::_dispatch_interface(UMockdevIoctlClient *p_client, unsigned p_request) {
	switch (p_request) {
		case USBDEVFS_GETDRIVER: {
			auto *asked = argument_of<usbdevfs_getdriver>(p_client);
			return asked == nullptr ? -EFAULT : _claims.tell_driver(*asked);
		}
		case USBDEVFS_IOCTL: {
			const auto *asked = argument_of<usbdevfs_ioctl>(p_client);
			return asked == nullptr ? -EFAULT : _claims.ask_driver(*asked);
		}
		case USBDEVFS_DISCONNECT_CLAIM: {
			const auto *asked = argument_of<usbdevfs_disconnect_claim>(p_client);
			return asked == nullptr ? -EFAULT : _claims.disconnect_and_claim(p_client, *asked);
		}
		default:
			break;
	}
	const auto *number = argument_of<unsigned>(p_client);
	if (number == nullptr) {
		return p_request == USBDEVFS_CONNECTINFO ? -ENOTTY : -EFAULT;
	}
	switch (p_request) {
		case USBDEVFS_CLAIMINTERFACE:
			return _claims.claim(p_client, *number);
		case USBDEVFS_RELEASEINTERFACE:
			return _claims.release(p_client, *number);
		case USBDEVFS_CLEAR_HALT:
		case USBDEVFS_RESETEP:
			_log("clear halt " + std::to_string(*number));
			_port.clear_halt(uint8_t(*number));
			return 0;
		case USBDEVFS_SETINTERFACE:
		case USBDEVFS_SETCONFIGURATION:
			return 0;
		default:
			return -ENOTTY;
	}
}

void UsbfsNode::_free(Transfer &r_transfer) {
	g_clear_object(&r_transfer.buffer);
	g_clear_object(&r_transfer.urb);
}

void UsbfsNode::_close(UMockdevIoctlClient *p_client) {
	const auto opened = _opened.find(p_client);
	if (opened == _opened.end()) {
		return;
	}
	_log("close");
	for (Transfer &transfer : opened->second.finished) {
		_free(transfer);
	}
	_opened.erase(opened);
	_claims.forget(p_client);
	for (auto it = _transfers.begin(); it != _transfers.end();) {
		if (it->second.client == p_client) {
			_port.discard(it->first, -ENOENT);
			_free(it->second);
			it = _transfers.erase(it);
		} else {
			++it;
		}
	}
	collect();
}

void UsbfsNode::_update_gate() {
	if (_node == nullptr) {
		return;
	}
	const auto has_finished = [](const auto &p_pair) { return !p_pair.second.finished.empty(); };
	_node->set_ready(std::any_of(_opened.begin(), _opened.end(), has_finished));
}

void UsbfsNode::collect() {
	while (std::unique_ptr<Urb> done = _port.take_completed()) {
		const auto found = _transfers.find(done->id);
		if (found == _transfers.end()) {
			continue; // Its program has gone.
		}
		Transfer transfer = std::move(found->second);
		_transfers.erase(found);
		auto *urb = reinterpret_cast<usbdevfs_urb *>(transfer.urb->data);
		urb->status = done->status;
		urb->actual_length = int(done->done);
		if ((done->endpoint & 0x80U) != 0) {
			transfer.bytes = std::move(done->data);
			transfer.bytes.resize(done->done);
		}
		_hand_over(std::move(transfer));
	}
	_update_gate();
}

void UsbfsNode::_hand_over(Transfer p_transfer) {
	UMockdevIoctlClient *client = p_transfer.client;
	Opened &opened = _opened[client];
	opened.finished.push_back(std::move(p_transfer));
	if (opened.is_waiting) {
		opened.is_waiting = false;
		_reap(client, false);
		umockdev_ioctl_client_complete(client, 0, 0);
	}
}

void UsbfsNode::_fill_buffer(const Transfer &p_transfer) {
	if (p_transfer.bytes.empty()) {
		return;
	}
	UMockdevIoctlData *buffer = p_transfer.buffer;
	if (buffer == nullptr) {
		buffer = umockdev_ioctl_data_resolve(
				p_transfer.urb, offsetof(usbdevfs_urb, buffer), p_transfer.bytes.size(), nullptr);
	}
	if (buffer != nullptr) {
		const std::size_t room = std::size_t(buffer->data_len) - p_transfer.offset;
		std::memcpy(buffer->data + p_transfer.offset, p_transfer.bytes.data(), std::min(p_transfer.bytes.size(), room));
	}
}

std::unique_ptr<Urb> UsbfsNode::_make_urb(UMockdevIoctlClient *p_client, Transfer &r_transfer) {
	constexpr int MAX = 4194304;
	constexpr int REQUEST = 8;
	UMockdevIoctlData *argument = umockdev_ioctl_client_get_arg(p_client);
	r_transfer.client = p_client;
	r_transfer.urb = umockdev_ioctl_data_resolve(argument, 0, sizeof(usbdevfs_urb), nullptr);
	if (r_transfer.urb == nullptr) {
		return nullptr;
	}
	const auto *raw = reinterpret_cast<usbdevfs_urb *>(r_transfer.urb->data);
	const int head = raw->type == USBDEVFS_URB_TYPE_CONTROL ? REQUEST : 0;
	if (raw->buffer_length < head || raw->buffer_length > MAX) {
		return nullptr;
	}
	auto urb = std::make_unique<Urb>();
	urb->id = ++_last_id;
	urb->type = Urb::Type(raw->type & 3U);
	urb->endpoint = raw->endpoint;
	r_transfer.offset = std::size_t(head);
	if (raw->buffer_length == 0) {
		return urb;
	}
	if (head == 0 && (raw->endpoint & 0x80U) != 0) {
		urb->data.resize(std::size_t(raw->buffer_length));
		return urb;
	}
	r_transfer.buffer = umockdev_ioctl_data_resolve(
			r_transfer.urb, offsetof(usbdevfs_urb, buffer), std::size_t(raw->buffer_length), nullptr);
	if (r_transfer.buffer == nullptr) {
		return nullptr;
	}
	const uint8_t *bytes = r_transfer.buffer->data;
	urb->data.assign(bytes + head, bytes + raw->buffer_length);
	if (head == REQUEST) {
		urb->setup = UsbSetup::parse(bytes);
		urb->endpoint = urb->setup.is_in() ? 0x80 : 0x00;
	}
	return urb->setup.length > urb->data.size() ? nullptr : std::move(urb);
}

UsbfsNode::Result UsbfsNode::_submit(UMockdevIoctlClient *p_client) {
	Transfer transfer;
	std::unique_ptr<Urb> urb = _make_urb(p_client, transfer);
	if (urb == nullptr) {
		return -EINVAL;
	}
	g_object_ref(transfer.urb);
	if (transfer.buffer != nullptr) {
		g_object_ref(transfer.buffer);
	}
	const uint64_t id = urb->id;
	_transfers[id] = transfer;
	const int result = _port.submit(std::move(urb), _shared.now());
	if (result != 0) {
		_free(transfer);
		_transfers.erase(id);
	}
	return result;
}

UsbfsNode::Result UsbfsNode::_discard(UMockdevIoctlClient *p_client) {
	gulong address = 0;
	std::memcpy(&address, umockdev_ioctl_client_get_arg(p_client)->data, sizeof(address));
	for (const auto &[id, transfer] : _transfers) {
		if (transfer.client == p_client && transfer.urb->client_addr == address) {
			return _port.discard(id, -ENOENT) ? 0 : -EINVAL;
		}
	}
	return -EINVAL;
}

UsbfsNode::Result UsbfsNode::_reap(UMockdevIoctlClient *p_client, bool p_waits) {
	Opened &opened = _opened[p_client];
	if (opened.finished.empty()) {
		if (!_port.is_plugged()) {
			return -ENODEV;
		}
		opened.is_waiting = p_waits;
		return p_waits ? LATER : -EAGAIN;
	}
	Transfer transfer = std::move(opened.finished.front());
	opened.finished.pop_front();
	_fill_buffer(transfer);
	UMockdevIoctlData *argument = umockdev_ioctl_client_get_arg(p_client);
	UMockdevIoctlData *pointer = umockdev_ioctl_data_resolve(argument, 0, sizeof(void *), nullptr);
	if (pointer != nullptr) {
		umockdev_ioctl_data_set_ptr(pointer, 0, transfer.urb);
	}
	_free(transfer);
	_update_gate();
	return pointer == nullptr ? -EFAULT : 0;
}

UsbfsNode::Result UsbfsNode::_control(UMockdevIoctlClient *p_client) {
	UMockdevIoctlData *argument = umockdev_ioctl_client_get_arg(p_client);
	UMockdevIoctlData *data = umockdev_ioctl_data_resolve(argument, 0, sizeof(usbdevfs_ctrltransfer), nullptr);
	if (data == nullptr) {
		return -EFAULT;
	}
	const auto *raw = reinterpret_cast<usbdevfs_ctrltransfer *>(data->data);
	UMockdevIoctlData *buffer =
			umockdev_ioctl_data_resolve(data, offsetof(usbdevfs_ctrltransfer, data), raw->wLength, nullptr);
	auto urb = std::make_unique<Urb>();
	urb->type = Urb::Type::CONTROL;
	urb->setup = { raw->bRequestType, raw->bRequest, raw->wValue, raw->wIndex, raw->wLength };
	if (buffer != nullptr) {
		urb->data.assign(buffer->data, buffer->data + raw->wLength);
	}
	const bool is_in = urb->setup.is_in();
	collect();
	if (const int result = _port.submit(std::move(urb), _shared.now()); result != 0) {
		return result;
	}
	const std::unique_ptr<Urb> done = _port.take_completed();
	if (done->status == 0 && is_in && buffer != nullptr) {
		std::memcpy(buffer->data, done->data.data(), std::min(done->done, std::size_t(buffer->data_len)));
	}
	return done->status != 0 ? done->status : Result(done->done);
}

} // namespace emulator
