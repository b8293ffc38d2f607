// SPDX-License-Identifier: MIT
#include "suit/stand_alone.hpp"

#include "bus/bytes.hpp"
#include "device/items.hpp"
#include "suit/master.hpp"

#include <algorithm>

namespace emulator {
namespace {

using xbus::Frame;
using xbus::Message;

/// Fastest rate of any item, Hz.
constexpr int FASTEST = 400;
constexpr unsigned ON_REQUEST = 0xFFFF;

} // namespace

StandAlone::StandAlone(Tracker p_tracker, MotionStream p_stream, uint64_t p_seed) :
		XbusDevice(std::move(p_stream), p_seed), _tracker(p_tracker) {
	_device_id = _tracker.device_id;
}

void StandAlone::set_items(std::vector<Item> p_items) {
	_items = std::move(p_items);
}

int StandAlone::_rate() const {
	int rate = 0;
	for (const Item &item : _items) {
		rate = item.rate == ALWAYS ? rate : std::max(rate, int(item.rate));
	}
	return std::clamp(rate == 0 ? 100 : rate, 1, FASTEST);
}

int64_t StandAlone::sample_ticks() const {
	if (!_items.empty()) {
		return TICKS / _rate();
	}
	return int64_t(_period) * int64_t(_skip == ON_REQUEST ? 1 : _skip + 1);
}

Data StandAlone::sample(double p_motion_s, uint16_t p_counter) {
	const Reading reading = _tracker.read(_stream, p_motion_s, motion_runs(), _random);
	Data data;
	if (_items.empty()) {
		data.resize(Tracker::LONGEST);
		data.resize(_tracker.write_data(reading, false, p_counter, data.data()));
		data.resize(std::size_t(std::max(int(data.size()) + _tracker.length_fault, 0)));
		return data;
	}
	const int rate = _rate();
	xbus::FullSample sample = sample_of(reading, xbus::Axes::EAST_NORTH_UP, p_counter, p_motion_s);
	for (const Item &item : _items) {
		const int every = item.rate == ALWAYS ? 1 : std::max(rate / std::max(int(item.rate), 1), 1);
		if (p_counter % every != 0) {
			continue;
		}
		const xbus::Axes axes = xbus::Item{ item.identifier }.axes();
		if (axes != sample.axes && xbus::item_type(item.identifier).has_axes()) {
			sample = sample_of(reading, axes, p_counter, p_motion_s);
		}
		append_item(data, item.identifier, sample);
	}
	return data;
}

Data StandAlone::configuration() const {
	return configuration_of(_device_id, _period, _skip, { _tracker }, false);
}

uint8_t StandAlone::start_measuring(uint8_t & /*r_bus_id*/) {
	_only_on_request = _items.empty() && _skip == ON_REQUEST;
	return 0;
}

bool StandAlone::is_allowed_while_measuring(const Frame &p_frame) const {
	return p_frame.message == Message::REQ_DATA;
}

XbusDevice::Answer StandAlone::handle(const Frame &p_frame, Usec p_now) {
	Data data;
	switch (p_frame.message) {
		case Message::REQ_DEVICE_ID:
		case Message::INIT_BUS:
			append_u32(data, _device_id);
			break;
		case Message::REQ_CONFIGURATION:
			data = configuration();
			break;
		case Message::REQ_DATA_LENGTH:
			append_u16(data, unsigned(_tracker.data_size(false)));
			break;
		case Message::REQ_FIRMWARE_REVISION:
			data = { 1, 12, 73 };
			break;
		case Message::REQ_HARDWARE_VERSION:
			data = { 2, 1 };
			break;
		case Message::REQ_PRODUCT_CODE:
			data = product_code("MTI-30-2A5G4");
			break;
		case Message::REQ_DATA:
			if (state() == State::MEASUREMENT && _only_on_request) {
				reply(xbus::MASTER, sample_message(), sample(motion_time(p_now), 0), p_now);
			}
			return Answer::DONE;
		case Message::RESTORE_FACTORY_DEFAULTS:
			_items.clear();
			_skip = 0;
			_period = 1152;
			break;
		case Message::SET_BAUD_RATE:
			return change_baud(p_frame, p_now) ? Answer::DONE : Answer::UNKNOWN;
		case Message::SET_OUTPUT_CONFIGURATION:
			return _choose_items(p_frame, p_now);
		default:
			return _handle_value(p_frame, p_now);
	}
	reply(p_frame.bus_id, xbus::acknowledgement(p_frame.message), data, p_now);
	return Answer::DONE;
}

XbusDevice::Answer StandAlone::_handle_value(const Frame &p_frame, Usec p_now) {
	bool is_done = false;
	unsigned mode = _tracker.mode;
	switch (p_frame.message) {
		case Message::SET_OUTPUT_MODE:
			is_done = exchange(p_frame, mode, 2, p_now);
			_tracker.mode = uint16_t(mode);
			_items.clear();
			break;
		case Message::SET_OUTPUT_SETTINGS:
			is_done = exchange(p_frame, _tracker.settings, 4, p_now);
			break;
		case Message::SET_OUTPUT_SKIP_FACTOR:
			is_done = exchange(p_frame, _skip, 2, p_now);
			break;
		case Message::SET_PERIOD:
			if (p_frame.size == 2 && xbus::read_u16(p_frame.data) < 225) {
				reply_error(ERROR_PERIOD, p_now);
				return Answer::DONE;
			}
			is_done = exchange(p_frame, _period, 2, p_now);
			break;
		case Message::LOCATION_ID:
			is_done = exchange(p_frame, _location, 2, p_now);
			break;
		case Message::SET_ERROR_MODE:
			is_done = exchange(p_frame, _error_mode, 2, p_now);
			break;
		default:
			break;
	}
	return is_done ? Answer::DONE : Answer::UNKNOWN;
}

XbusDevice::Answer StandAlone::_choose_items(const Frame &p_frame, Usec p_now) {
	if (p_frame.size % 4 != 0) {
		return Answer::UNKNOWN;
	}
	if (p_frame.size > 0) {
		_items.clear();
		_items.reserve(p_frame.size / 4);
		for (std::size_t at = 0; at < p_frame.size; at += 4) {
			const Item item = { xbus::read_u16(p_frame.data + at), xbus::read_u16(p_frame.data + at + 2) };
			if (offers_item(item.identifier) && item.rate > 0) {
				_items.push_back(
						{ item.identifier, std::min(item.rate, item.rate == ALWAYS ? ALWAYS : uint16_t(FASTEST)) });
			}
		}
	}
	Data data;
	data.reserve(_items.size() * 4);
	for (const Item &item : _items) {
		append_u16(data, item.identifier);
		append_u16(data, item.rate);
	}
	reply(xbus::MASTER, Message::SET_OUTPUT_CONFIGURATION_ACK, data, p_now);
	return Answer::DONE;
}

} // namespace emulator
