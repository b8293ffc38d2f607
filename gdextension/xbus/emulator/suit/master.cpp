// SPDX-License-Identifier: MIT
#include "suit/master.hpp"

#include "bus/bytes.hpp"
#include "bus/configuration.hpp"
#include "device/replies.hpp"

#include <algorithm>

namespace emulator {
namespace {

using xbus::Frame;
using xbus::Message;

constexpr uint8_t ERROR_NO_BUS = 0x01;
constexpr uint8_t ERROR_BUS_NOT_READY = 0x02;
constexpr uint8_t ERROR_NO_ANSWER = 0x1D;
constexpr uint8_t ERROR_PARAMETER = 0x21;
constexpr unsigned MIN_PERIOD = 225;
constexpr unsigned MAX_PERIOD = 11520;

} // namespace

Data configuration_of(uint32_t p_device_id, unsigned p_period, unsigned p_skip, const std::vector<Tracker> &p_trackers,
		bool p_is_behind_master) {
	xbus::Configuration configuration;
	configuration.master_id = p_device_id;
	configuration.period = uint16_t(p_period);
	configuration.skip_factor = uint16_t(p_skip);
	configuration.date = { '2', '0', '0', '7', '0', '3', '1', '5' };
	configuration.time = { '1', '2', '3', '0', '0', '0', '0', '0' };
	configuration.device_count = p_trackers.size();
	std::transform(p_trackers.begin(), p_trackers.end(), configuration.devices.begin(),
			[p_is_behind_master](const Tracker &p_tracker) {
				xbus::DeviceConfiguration device;
				device.device_id = p_tracker.device_id;
				device.data_length = uint16_t(p_tracker.data_size(p_is_behind_master));
				device.format = { p_tracker.mode, p_tracker.settings };
				device.scenario = p_tracker.filter_scenario;
				device.firmware = { 2, 4, 6 };
				device.filter = { 1, 2, 0 };
				return device;
			});
	Data data(xbus::Configuration::MAX_BYTES);
	data.resize(configuration.write(data.data()));
	return data;
}

Data product_code(const char *p_text) {
	const std::array<uint8_t, 20> code = xbus::device::product_code(p_text);
	return { code.begin(), code.end() };
}

Master::Master(uint32_t p_device_id, std::vector<Tracker> p_trackers, MotionStream p_stream, uint64_t p_seed) :
		XbusDevice(std::move(p_stream), p_seed), _trackers(std::move(p_trackers)) {
	_device_id = p_device_id;
}

void Master::restart() {
	_is_initialised = false;
}

bool Master::is_allowed_while_measuring(const Frame &p_frame) const {
	return p_frame.bus_id == xbus::MASTER && p_frame.message == Message::REQ_BATTERY_LEVEL;
}

uint8_t Master::start_measuring(uint8_t &r_bus_id) {
	if (_bus_power == 0) {
		return ERROR_NO_BUS;
	}
	if (!_is_initialised) {
		return ERROR_BUS_NOT_READY;
	}
	r_bus_id = uint8_t(_dead);
	return _dead != 0 ? ERROR_NO_ANSWER : uint8_t(0);
}

std::size_t Master::_data_size() const {
	std::size_t total = xbus::MasterFormat::HEAD;
	for (const Tracker &tracker : _trackers) {
		total += tracker.data_size(true);
	}
	return total;
}

Data Master::sample(double p_motion_s, uint16_t p_counter) {
	Data data;
	data.reserve(xbus::MasterFormat::HEAD + _trackers.size() * Tracker::LONGEST);
	append_u16(data, p_counter);
	for (const Tracker &tracker : _trackers) {
		const std::size_t at = data.size();
		data.resize(at + Tracker::LONGEST);
		const Reading reading = tracker.read(_stream, p_motion_s, motion_runs(), _random);
		const std::size_t size = tracker.write_data(reading, true, p_counter, data.data() + at);
		data.resize(std::size_t(std::max<ptrdiff_t>(ptrdiff_t(at + size) + tracker.length_fault, ptrdiff_t(at))));
	}
	return data;
}

Data Master::configuration() const {
	return configuration_of(_device_id, _period, 0, _trackers, true);
}

XbusDevice::Answer Master::handle(const Frame &p_frame, Usec p_now) {
	return p_frame.bus_id == xbus::MASTER ? _handle_own(p_frame, p_now) : _handle_tracker(p_frame, p_now);
}

XbusDevice::Answer Master::_init_bus(Usec p_now) {
	if (_bus_power == 0) {
		reply_error(ERROR_NO_BUS, p_now);
		return Answer::DONE;
	}
	Data data;
	data.reserve(4 * _trackers.size());
	for (const Tracker &tracker : _trackers) {
		append_u32(data, tracker.device_id);
	}
	_is_initialised = true;
	const Usec search = 20000 + Usec(_trackers.size()) * 5000;
	reply(xbus::MASTER, Message::INIT_BUS_RESULTS, data, p_now, search);
	return Answer::DONE;
}

XbusDevice::Answer Master::_set_period(const Frame &p_frame, Usec p_now) {
	if (p_frame.size == 2) {
		const unsigned period = xbus::read_u16(p_frame.data);
		if (period < MIN_PERIOD || period > MAX_PERIOD) {
			reply_error(ERROR_PERIOD, p_now);
			return Answer::DONE;
		}
	}
	return exchange(p_frame, _period, 2, p_now) ? Answer::DONE : Answer::UNKNOWN;
}

XbusDevice::Answer Master::_handle_own(const Frame &p_frame, Usec p_now) {
	const Message answer = xbus::acknowledgement(p_frame.message);
	Data data;
	switch (p_frame.message) {
		case Message::REQ_DEVICE_ID:
			append_u32(data, _device_id);
			break;
		case Message::INIT_BUS:
			return _init_bus(p_now);
		case Message::SET_PERIOD:
			return _set_period(p_frame, p_now);
		case Message::REQ_DATA_LENGTH:
			append_u16(data, unsigned(_data_size()));
			break;
		case Message::REQ_CONFIGURATION:
			data = configuration();
			break;
		case Message::REQ_FIRMWARE_REVISION:
			data = { 1, 6, 3 };
			break;
		case Message::REQ_HARDWARE_VERSION:
			data = { 1, 2 };
			break;
		case Message::REQ_PRODUCT_CODE:
			data = product_code("XM-B-3");
			break;
		case Message::XM_POWER_OFF:
			go_to(State::OFF);
			return Answer::DONE;
		case Message::SET_BAUD_RATE:
			return change_baud(p_frame, p_now) ? Answer::DONE : Answer::UNKNOWN;
		case Message::SET_BUS_ID:
		case Message::RESTORE_FACTORY_DEFAULTS:
		case Message::SET_OUTPUT_MODE:
		case Message::SET_OUTPUT_SETTINGS:
			break; // Meant for all trackers: done with them one by one, so only acknowledged.
		default:
			return _handle_value(p_frame, p_now);
	}
	reply(xbus::MASTER, answer, data, p_now);
	return Answer::DONE;
}

XbusDevice::Answer Master::_handle_value(const Frame &p_frame, Usec p_now) {
	bool is_done = false;
	switch (p_frame.message) {
		case Message::BUS_POWER:
			is_done = exchange(p_frame, _bus_power, 2, p_now);
			_is_initialised = _is_initialised && _bus_power != 0;
			break;
		case Message::DISABLE_BLUETOOTH:
			is_done = exchange(p_frame, _bluetooth, 1, p_now);
			break;
		case Message::OPERATING_MODE:
			is_done = exchange(p_frame, _operating_mode, 1, p_now);
			break;
		case Message::SET_SYNC_MODE:
			is_done = exchange(p_frame, _sync_mode, p_frame.size == 2 ? 2 : 1, p_now);
			break;
		case Message::XM_ERROR_MODE:
			is_done = exchange(p_frame, _overflow_mode, 2, p_now);
			_stops_on_overflow = _overflow_mode == 1;
			break;
		case Message::BUFFER_SIZE:
			is_done = exchange(p_frame, _buffer_size, 2, p_now);
			break;
		case Message::SET_ERROR_MODE:
			is_done = exchange(p_frame, _error_mode, 2, p_now);
			break;
		case Message::REQ_BATTERY_LEVEL:
			is_done = p_frame.size == 0 && exchange(p_frame, _battery, 1, p_now);
			break;
		default:
			break;
	}
	return is_done ? Answer::DONE : Answer::UNKNOWN;
}

XbusDevice::Answer Master::_set_mode(const Frame &p_frame, Tracker &r_tracker, Usec p_now) {
	unsigned mode = r_tracker.mode;
	if (p_frame.size == 2 && (xbus::read_u16(p_frame.data) & xbus::output_mode::RAW) != 0 &&
			xbus::read_u16(p_frame.data) != xbus::output_mode::RAW) {
		reply_error(ERROR_PARAMETER, p_now, p_frame.bus_id);
		return Answer::DONE;
	}
	const bool is_done = exchange(p_frame, mode, 2, p_now);
	r_tracker.mode = uint16_t(mode);
	return is_done ? Answer::DONE : Answer::UNKNOWN;
}

XbusDevice::Answer Master::_handle_tracker(const Frame &p_frame, Usec p_now) {
	if (!_is_initialised) {
		reply_error(ERROR_BUS_NOT_READY, p_now);
		return Answer::DONE;
	}
	if (p_frame.bus_id < 1 || p_frame.bus_id > _trackers.size()) {
		reply_error(ERROR_PARAMETER, p_now, p_frame.bus_id);
		return Answer::DONE;
	}
	Tracker &tracker = _trackers[p_frame.bus_id - 1U];
	Data data;
	switch (p_frame.message) {
		case Message::REQ_DEVICE_ID:
			append_u32(data, tracker.device_id);
			break;
		case Message::REQ_DATA_LENGTH:
			append_u16(data, unsigned(tracker.data_size(true)));
			break;
		case Message::REQ_CONFIGURATION:
			data = configuration_of(tracker.device_id, _period, 0, { tracker }, true);
			break;
		case Message::REQ_FIRMWARE_REVISION:
			data = { 2, 4, 6 };
			break;
		case Message::REQ_PRODUCT_CODE:
			data = product_code("MTx-49A53G25-S");
			break;
		case Message::SET_OUTPUT_MODE:
			return _set_mode(p_frame, tracker, p_now);
		case Message::SET_OUTPUT_SETTINGS:
			return exchange(p_frame, tracker.settings, 4, p_now) ? Answer::DONE : Answer::UNKNOWN;
		case Message::SET_OBJECT_ALIGNMENT:
			if (p_frame.size != 36) {
				return Answer::UNKNOWN;
			}
			break;
		case Message::HEADING:
		case Message::LOCATION_ID:
		case Message::INIT_TRACK_MODE:
			break;
		default:
			return Answer::UNKNOWN;
	}
	reply(p_frame.bus_id, xbus::acknowledgement(p_frame.message), data, p_now);
	return Answer::DONE;
}

} // namespace emulator
