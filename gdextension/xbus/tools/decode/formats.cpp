// SPDX-License-Identifier: MIT
#include "formats.hpp"

#include "bus/bytes.hpp"
#include "device/full_mt_data.hpp"

using namespace xbus;

FormatBook::FormatBook(const FormatOptions &p_options) {
	if (!p_options.mode) {
		return;
	}
	DataFormat format;
	format.source = "options";
	format.is_master = p_options.is_master;
	format.tracker = { *p_options.mode, p_options.settings };
	for (std::size_t i = 0; p_options.is_master && i < p_options.devices; i++) {
		format.trackers.add(format.tracker);
	}
	_formats.push_back(format);
}

int FormatBook::add(const DataFormat &p_format) {
	_formats.push_back(p_format);
	return int(_formats.size()) - 1;
}

int FormatBook::pick(std::size_t p_size) const {
	for (std::size_t i = _formats.size(); i > 0; i--) {
		if (_formats[i - 1].size() == p_size) {
			return int(i) - 1;
		}
	}
	return -1;
}

void FormatBook::note(const Frame &p_frame) {
	switch (p_frame.message) {
		case Message::CONFIGURATION:
			_note_configuration(p_frame);
			break;
		case Message::INIT_BUS_RESULTS:
			_trackers = p_frame.size / 4;
			break;
		case Message::SET_OUTPUT_MODE:
		case Message::SET_OUTPUT_MODE_ACK:
			if (p_frame.size == 2) {
				_set[p_frame.bus_id].mode = read_u16(p_frame.data);
				_is_set[p_frame.bus_id] = true;
				_combine();
			}
			break;
		case Message::SET_OUTPUT_SETTINGS:
		case Message::SET_OUTPUT_SETTINGS_ACK:
			if (p_frame.size == 4) {
				_set[p_frame.bus_id].settings = read_u32(p_frame.data);
				_combine();
			}
			break;
		default:
			break;
	}
}

void FormatBook::_note_configuration(const Frame &p_frame) {
	Configuration configuration;
	if (configuration.parse(p_frame.data, p_frame.size) != ConfigurationFault::NONE ||
			configuration.device_count == 0) {
		return;
	}
	DataFormat format;
	format.source = "Configuration";
	format.is_master =
			device_kind(configuration.master_id) == DeviceKind::XBUS_MASTER || configuration.device_count > 1;
	format.tracker = configuration.devices[0].format;
	for (std::size_t i = 0; i < configuration.device_count; i++) {
		format.trackers.add(configuration.devices[i].format);
		_set[i + 1] = configuration.devices[i].format;
		_is_set[i + 1] = format.is_master;
	}
	_trackers = format.is_master ? configuration.device_count : 0;
	_formats.push_back(format);
}

void FormatBook::_combine() {
	DataFormat format;
	format.source = "SetOutputMode";
	std::size_t count = 0;
	while (count < MAX_DEVICES && _is_set[count + 1] && (_trackers == 0 || count < _trackers)) {
		format.trackers.add(_set[count + 1]);
		count++;
	}
	if (count > 0) {
		format.is_master = true;
		_formats.push_back(format);
	}
	if (_is_set[MASTER]) {
		format.is_master = false;
		format.tracker = _set[MASTER];
		_formats.push_back(format);
	}
}

bool decode_frame(const DataFormat &p_format, const Frame &p_frame, std::vector<FullSample> &r_samples) {
	r_samples.resize(p_format.is_master ? p_format.trackers.count() : 1);
	const bool good = p_format.is_master ? decode_data(p_format.trackers, p_frame.data, p_frame.size, r_samples.data())
										 : decode_data(p_format.tracker, p_frame.data, p_frame.size, r_samples[0]);
	if (!p_format.is_master) {
		r_samples[0].bus_id = p_frame.bus_id;
	}
	r_samples.resize(good ? r_samples.size() : 0);
	return good;
}
