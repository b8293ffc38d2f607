// SPDX-License-Identifier: MIT
#include "usb/libusb_device.hpp"

#include "clock/clock.hpp"
#include "clock/thread_priority.hpp"

#include <algorithm>

namespace usb {

namespace {

/// The thread looks about itself at least so often, µs: no answer of a device is waited for more exactly.
constexpr long WAIT_USEC = 5000;
constexpr uint64_t PUBLISH_USEC = 100000;
/// Between two looks for devices where the system does not report them.
constexpr uint64_t POLL_USEC = 1000000;
/// Between two attempts to open a device that refused.
constexpr uint64_t RETRY_USEC = 2000000;
/// A device that does not stop measuring in time is left as it is.
constexpr uint64_t STOP_USEC = 1500000;
constexpr std::size_t MAX_MESSAGES = 256;
/// Devices that have left and whose last samples may still be fetched.
constexpr std::size_t MAX_LEFT = 8;

void free_context(libusb_context *p_context) {
	if (p_context != nullptr) {
		libusb_exit(p_context);
	}
}

const char *advice(DeviceLink p_kind) {
	switch (p_kind) {
		case DeviceLink::AWINDA:
			return " is recognised, but can't be used: Awinda's radio protocol and the filter that makes "
				   "orientations of its trackers' data are not public. Let MVN run on the machine with the station and "
				   "send its motion here (network streamer, UDP port 9763; here --source=mvn)";
		case DeviceLink::BODY_PACK:
			return " is recognised, but speaks no public protocol. Let MVN send its motion here (network streamer, UDP "
				   "port 9763; here --source=mvn)";
		default:
			return "";
	}
}

} // namespace

LibusbHub::LibusbHub(const xbus::SessionOptions &p_options, HubListener *p_listener) :
		_options(p_options), _listener(p_listener), _context(nullptr, free_context) {}

LibusbHub::~LibusbHub() {
	stop();
}

std::string LibusbHub::start() {
	stop();
	libusb_context *context = nullptr;
	const int error = libusb_init(&context);
	if (error != LIBUSB_SUCCESS) {
		return std::string("USB can't be used: ") + libusb_strerror(error);
	}
	_context.reset(context);
	const int events = LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED | LIBUSB_HOTPLUG_EVENT_DEVICE_LEFT;
	_has_hotplug = libusb_has_capability(LIBUSB_CAP_HAS_HOTPLUG) != 0 &&
			libusb_hotplug_register_callback(context, events, LIBUSB_HOTPLUG_ENUMERATE, LIBUSB_HOTPLUG_MATCH_ANY,
					LIBUSB_HOTPLUG_MATCH_ANY, LIBUSB_HOTPLUG_MATCH_ANY, on_hotplug, this, &_hotplug) == LIBUSB_SUCCESS;
	_stops = false;
	_thread = std::thread(&LibusbHub::run, this);
	return "";
}

void LibusbHub::stop() {
	if (!_thread.joinable()) {
		return;
	}
	_stops = true;
	libusb_interrupt_event_handler(_context.get());
	_thread.join();
	if (_has_hotplug) {
		libusb_hotplug_deregister_callback(_context.get(), _hotplug);
	}
	for (const Change &change : _changes) {
		libusb_unref_device(change.device);
	}
	_changes.clear();
	_context.reset();
	const std::lock_guard<std::mutex> lock(_mutex);
	_reports.clear();
	_queues.clear();
}

std::vector<DeviceReport> LibusbHub::report() const {
	const std::lock_guard<std::mutex> lock(_mutex);
	return _reports;
}

std::vector<HubMessage> LibusbHub::take_messages() {
	const std::lock_guard<std::mutex> lock(_mutex);
	std::vector<HubMessage> messages;
	messages.swap(_messages);
	return messages;
}

bool LibusbHub::take_frame(int p_device, xbus::SuitFrame &r_frame) {
	std::shared_ptr<FrameRing> ring;
	{
		const std::lock_guard<std::mutex> lock(_mutex);
		for (const Queue &queue : _queues) {
			if (queue.device == p_device) {
				ring = queue.ring;
			}
		}
	}
	const xbus::SuitFrame *frame = ring != nullptr ? ring->front() : nullptr;
	if (frame == nullptr) {
		return false;
	}
	r_frame = *frame;
	ring->drop();
	return true;
}

int LIBUSB_CALL LibusbHub::on_hotplug(
		libusb_context * /*p_context*/, libusb_device *p_device, libusb_hotplug_event p_event, void *p_self) {
	// Nothing may be opened within the event.
	static_cast<LibusbHub *>(p_self)->_changes.push_back(
			{ libusb_ref_device(p_device), p_event == LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED });
	return 0;
}

void LibusbHub::run() {
	say(xbus::Severity::INFO, clocks::priority_text(clocks::prefer_this_thread()));
	while (!_stops) {
		timeval wait{ 0, WAIT_USEC };
		libusb_handle_events_timeout_completed(_context.get(), &wait, nullptr);
		look_for_changes();
		const uint64_t now = clocks::now_usec();
		for (const std::unique_ptr<Device> &device : _devices) {
			advance(*device, now);
		}
		const auto gone = std::remove_if(_devices.begin(), _devices.end(), [](const std::unique_ptr<Device> &p_device) {
			return p_device->is_leaving && (p_device->port == nullptr || p_device->port->is_idle());
		});
		_devices.erase(gone, _devices.end());
		publish();
	}
	close_all();
}

void LibusbHub::look_for_changes() {
	std::vector<Change> changes;
	changes.swap(_changes);
	for (const Change &change : changes) {
		if (change.has_come) {
			add(change.device);
		} else {
			remove(change.device);
		}
		libusb_unref_device(change.device);
	}
	const uint64_t now = clocks::now_usec();
	if (!_has_hotplug && (_polled_usec == 0 || now - _polled_usec > POLL_USEC)) {
		_polled_usec = now;
		poll_devices();
	}
}

void LibusbHub::poll_devices() {
	libusb_device **list = nullptr;
	const ssize_t count = libusb_get_device_list(_context.get(), &list);
	for (const std::unique_ptr<Device> &device : _devices) {
		if (count >= 0 && std::find(list, list + count, device->device) == list + count) {
			remove(device->device);
		}
	}
	for (ssize_t at = 0; at < count; ++at) {
		add(list[at]);
	}
	if (count >= 0) {
		libusb_free_device_list(list, 1);
	}
}

void LibusbHub::add(libusb_device *p_device) {
	libusb_device_descriptor descriptor{};
	if (libusb_get_device_descriptor(p_device, &descriptor) != LIBUSB_SUCCESS) {
		return;
	}
	const KnownDevice known = identify(descriptor.idVendor, descriptor.idProduct);
	const bool is_there = std::any_of(_devices.begin(), _devices.end(),
			[p_device](const std::unique_ptr<Device> &p_other) { return p_other->device == p_device; });
	if (known.kind == DeviceLink::OTHER || is_there) {
		return;
	}
	auto device = std::make_unique<Device>(*this, p_device);
	char address[16];
	snprintf(address, sizeof(address), "%03d/%03d", libusb_get_bus_number(p_device),
			libusb_get_device_address(p_device));
	device->report.number = _next_number++;
	device->report.known = known;
	device->report.address = address;
	if (known.kind == DeviceLink::AWINDA || known.kind == DeviceLink::BODY_PACK) {
		device->report.fault = device->name() + advice(known.kind);
		say(xbus::Severity::WARNING, device->report.fault);
	} else {
		say(xbus::Severity::INFO, device->name() + " was plugged in");
		const std::lock_guard<std::mutex> lock(_mutex);
		_queues.push_back({ device->report.number, device->frames });
	}
	_devices.push_back(std::move(device));
	_published_usec = 0;
}

void LibusbHub::remove(libusb_device *p_device) {
	for (const std::unique_ptr<Device> &device : _devices) {
		if (device->device == p_device && device->port != nullptr) {
			device->port->set_gone();
		} else if (device->device == p_device) {
			device->is_leaving = true;
			say(xbus::Severity::INFO, device->name() + " was unplugged");
		}
	}
}

void LibusbHub::advance(Device &p_device, uint64_t p_now_usec) {
	if (p_device.is_leaving) {
		return;
	}
	const DeviceLink kind = p_device.report.known.kind;
	if (p_device.port == nullptr) {
		if (kind != DeviceLink::AWINDA && kind != DeviceLink::BODY_PACK && p_now_usec >= p_device.retry_usec) {
			open(p_device, p_now_usec);
		}
		return;
	}
	if (p_device.port->is_gone()) {
		say(xbus::Severity::WARNING, p_device.name() + " was unplugged");
		p_device.port->stop();
		p_device.is_leaving = true;
		_published_usec = 0;
		return;
	}
	if (p_device.port->is_dead()) {
		give_up(p_device, p_now_usec);
		return;
	}
	if (p_device.wanted_baud != 0) {
		const uint32_t baud = p_device.wanted_baud;
		p_device.wanted_baud = 0;
		p_device.port->set_baud(baud);
	}
	p_device.port->look_after();
	p_device.session->advance(p_now_usec);
}

/// Closes a device that can't be read any more, and opens it anew a little later.
void LibusbHub::give_up(Device &p_device, uint64_t p_now_usec) {
	if (p_device.report.fault.empty()) {
		p_device.report.fault =
				p_device.name() + " can't be read any more: trying anew; if it stays so, plug it in again";
		say(xbus::Severity::WARNING, p_device.report.fault);
		p_device.port->stop();
	}
	if (p_device.port->is_idle()) {
		p_device.port.reset();
		p_device.session.reset();
		p_device.report.is_open = false;
		p_device.report.session = {};
		p_device.retry_usec = p_now_usec + RETRY_USEC;
	}
}

void LibusbHub::open(Device &p_device, uint64_t p_now_usec) {
	PortFault fault;
	std::unique_ptr<Port> port = Port::open(p_device.device, p_device.report.known, p_device, fault);
	if (port == nullptr) {
		if (fault.text != p_device.report.fault) {
			say(xbus::Severity::ERROR, fault.text);
		}
		p_device.report.fault = fault.text;
		p_device.retry_usec = fault.may_pass ? p_now_usec + RETRY_USEC : UINT64_MAX;
		return;
	}
	p_device.port = std::move(port);
	p_device.report.fault.clear();
	p_device.report.serial = p_device.port->serial();
	p_device.report.is_open = true;
	xbus::SessionOptions options = _options;
	options.has_baud = p_device.port->has_baud();
	p_device.session = std::make_unique<xbus::Session>(options, p_device);
	if (_listener != nullptr) {
		_listener->device_opened(p_device.report);
	}
	p_device.session->open(p_now_usec);
	if (p_device.wanted_baud != 0) {
		p_device.port->set_baud(p_device.wanted_baud);
		p_device.wanted_baud = 0;
	}
	p_device.port->start();
}

void LibusbHub::publish() {
	const uint64_t now = clocks::now_usec();
	if (_published_usec != 0 && now - _published_usec < PUBLISH_USEC) {
		return;
	}
	_published_usec = now;
	std::vector<DeviceReport> reports;
	reports.reserve(_devices.size());
	for (const std::unique_ptr<Device> &device : _devices) {
		if (device->port != nullptr) {
			device->report.port = device->port->statistics();
			device->session->report(now, device->report.session);
		}
		if (!device->is_leaving) {
			reports.push_back(device->report);
		}
	}
	const std::lock_guard<std::mutex> lock(_mutex);
	_reports.swap(reports);
	// What a device said before it left may still be fetched, but not for ever.
	const auto has_left = [this](const Queue &p_queue) {
		return std::none_of(_reports.begin(), _reports.end(),
				[&p_queue](const DeviceReport &p_report) { return p_report.number == p_queue.device; });
	};
	while (_queues.size() > _reports.size() + MAX_LEFT) {
		const auto oldest = std::find_if(_queues.begin(), _queues.end(), has_left);
		if (oldest == _queues.end()) {
			break;
		}
		_queues.erase(oldest);
	}
}

void LibusbHub::say(xbus::Severity p_severity, const std::string &p_text) {
	const std::lock_guard<std::mutex> lock(_mutex);
	if (_messages.size() < MAX_MESSAGES) {
		_messages.push_back({ p_severity, p_text });
	}
}

void LibusbHub::close_all() {
	const uint64_t begin = clocks::now_usec();
	for (const std::unique_ptr<Device> &device : _devices) {
		if (device->session != nullptr && !device->is_leaving) {
			device->session->stop(begin);
		}
	}
	bool works = true;
	while (works && clocks::now_usec() - begin < STOP_USEC) {
		timeval wait{ 0, WAIT_USEC };
		libusb_handle_events_timeout_completed(_context.get(), &wait, nullptr);
		works = false;
		for (const std::unique_ptr<Device> &device : _devices) {
			if (device->session != nullptr && !device->is_leaving && !device->port->is_gone()) {
				device->session->advance(clocks::now_usec());
				works = works || !device->session->is_stopped();
			}
		}
	}
	for (const std::unique_ptr<Device> &device : _devices) {
		if (device->port != nullptr) {
			device->port->stop();
		}
	}
	for (works = true; works && clocks::now_usec() - begin < 2 * STOP_USEC;) {
		timeval wait{ 0, WAIT_USEC };
		libusb_handle_events_timeout_completed(_context.get(), &wait, nullptr);
		works = std::any_of(_devices.begin(), _devices.end(), [](const std::unique_ptr<Device> &p_device) {
			return p_device->port != nullptr && !p_device->port->is_idle();
		});
	}
	_devices.clear();
}

} // namespace usb
