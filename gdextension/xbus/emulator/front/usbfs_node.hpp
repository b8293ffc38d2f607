// SPDX-License-Identifier: MIT
#pragma once

#include "cable/usb_port.hpp"
#include "front/device_node.hpp"
#include "front/interface_claims.hpp"

#include <mutex>

namespace emulator {

/// What every node and the main thread share: the lock over all devices, and a way to wake the main thread if there
/// is something to do sooner than it thought, to be called under the lock. umockdev calls in a thread of its own.
struct Shared {
	std::mutex mutex;
	std::function<void()> wake_early;
	std::function<Usec()> now;
};

/// A device's node below /dev/bus/usb: answers the ioctls of the kernel's usbfs.
class UsbfsNode {
public:
	/// `p_index`: where it is plugged in, from 1. `p_driver`: the kernel's driver that takes it first.
	UsbfsNode(Shared &p_shared, UsbPort &p_port, Testbed &p_testbed, int p_index, std::string p_driver,
			UsbPort::Log p_log);
	~UsbfsNode();
	UsbfsNode(const UsbfsNode &) = delete;
	UsbfsNode &operator=(const UsbfsNode &) = delete;

	/// The device comes or goes, with all that the system says about it. Not under the lock.
	void plug(bool p_in);
	/// Hands what the port has completed to those who wait for it. Under the lock.
	void collect();

private:
	/// A transfer whose memory is in the program.
	struct Transfer {
		UMockdevIoctlClient *client = nullptr;
		UMockdevIoctlData *urb = nullptr;
		UMockdevIoctlData *buffer = nullptr;
		/// Where the data begin in the buffer: control transfers have the request before.
		std::size_t offset = 0;
		/// What came. The program's buffer is looked at no sooner than it fetches the transfer: most of it would
		/// be carried to and fro for nothing.
		std::vector<uint8_t> bytes;
	};
	/// A program that has the node open.
	struct Opened {
		std::deque<Transfer> finished;
		/// Waits in REAPURB until something is finished.
		bool is_waiting = false;
	};
	/// Result of an ioctl: 0 or more, or a negative errno. LATER: it is answered by somebody else.
	using Result = InterfaceClaims::Result;
	static constexpr Result LATER = -100000;

	static gboolean _on_ioctl(UMockdevIoctlBase *p_base, UMockdevIoctlClient *p_client, gpointer p_self);
	/// The program has closed the node, or has ended.
	static void _on_gone(gpointer p_self, GObject *p_client);

	Result _dispatch(UMockdevIoctlClient *p_client, unsigned p_request);
	Result _dispatch_interface(UMockdevIoctlClient *p_client, unsigned p_request);
	Result _submit(UMockdevIoctlClient *p_client);
	Result _discard(UMockdevIoctlClient *p_client);
	Result _reap(UMockdevIoctlClient *p_client, bool p_waits);
	Result _control(UMockdevIoctlClient *p_client);
	/// Makes a transfer of what the program has submitted; null where it makes no sense.
	std::unique_ptr<Urb> _make_urb(UMockdevIoctlClient *p_client, Transfer &r_transfer);
	void _hand_over(Transfer p_transfer);
	static void _fill_buffer(const Transfer &p_transfer);
	void _close(UMockdevIoctlClient *p_client);
	void _update_gate();
	static void _free(Transfer &r_transfer);

	Shared &_shared;
	UsbPort &_port;
	Testbed &_testbed;
	int _index;
	std::string _driver;
	UsbPort::Log _log;
	InterfaceClaims _claims;
	std::unique_ptr<DeviceNode> _node;
	UMockdevIoctlBase *_handler = nullptr;
	std::map<UMockdevIoctlClient *, Opened> _opened;
	std::map<uint64_t, Transfer> _transfers;
	uint64_t _last_id = 0;
};

} // namespace emulator
