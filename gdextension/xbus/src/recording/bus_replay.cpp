// SPDX-License-Identifier: MIT
#include "recording/bus_replay.hpp"

#include "bus/bytes.hpp"
#include "bus/configuration.hpp"

#include <algorithm>
#include <map>

namespace recording {

using namespace xbus;

BusReplay::BusReplay() {
	_tracker_ids.reserve(MAX_TRACKERS);
}

void BusReplay::take_out(const uint8_t *p_bytes, std::size_t p_size) {
	_out.feed(p_bytes, p_size, [this](const Frame &p_frame) {
		note_request(p_frame);
		return true;
	});
}

void BusReplay::note_request(const Frame &p_frame) {
	switch (p_frame.message) {
		case Message::SET_OUTPUT_MODE:
			if (p_frame.size == 2) {
				_formats[p_frame.bus_id].mode = read_u16(p_frame.data);
				_is_stale = true;
			}
			break;
		case Message::SET_OUTPUT_SETTINGS:
			if (p_frame.size == 4) {
				_formats[p_frame.bus_id].settings = read_u32(p_frame.data);
				_is_stale = true;
			}
			break;
		case Message::SET_PERIOD:
			if (p_frame.size == 2) {
				_period = read_u16(p_frame.data);
				_is_stale = true;
			}
			break;
		default:
			break;
	}
}

StreamCheck::Verdict BusReplay::take_frame(const Frame &p_frame) {
	const bool is_data = p_frame.message == Message::MT_DATA || p_frame.message == Message::MT_DATA2;
	if (is_data && _is_stale) {
		expect();
	}
	const StreamCheck::Verdict verdict = _check.take(p_frame, _framer.statistics().is_noisy());
	if (verdict == StreamCheck::Verdict::CONTROL) {
		_undecoded += is_data ? 1U : 0U;
		note_answer(p_frame);
	}
	return verdict;
}

void BusReplay::note_answer(const Frame &p_frame) {
	switch (p_frame.message) {
		case Message::DEVICE_ID:
			if (p_frame.size == 4) {
				_device_id = read_u32(p_frame.data);
				_is_stale = true;
			}
			break;
		case Message::INIT_BUS_RESULTS:
			if (p_frame.size % 4 == 0 && p_frame.size / 4 <= std::size_t(MAX_TRACKERS)) {
				_tracker_ids.clear();
				for (std::size_t at = 0; at < p_frame.size; at += 4) {
					_tracker_ids.push_back(read_u32(p_frame.data + at));
				}
				_is_stale = true;
			}
			break;
		case Message::CONFIGURATION:
			note_configuration(p_frame);
			break;
		case Message::GO_TO_MEASUREMENT_ACK:
			_is_stale = true;
			break;
		default:
			break;
	}
}

void BusReplay::note_configuration(const Frame &p_frame) {
	Configuration configuration;
	if (configuration.parse(p_frame.data, p_frame.size) != ConfigurationFault::NONE) {
		return;
	}
	_device_id = configuration.master_id;
	_period = configuration.period;
	const bool has_trackers = is_master() && configuration.device_count <= std::size_t(MAX_TRACKERS);
	if (!has_trackers && configuration.device_count > 0) {
		_formats[MASTER] = configuration.devices[0].format;
	}
	if (has_trackers) {
		_tracker_ids.clear();
		for (std::size_t at = 0; at < configuration.device_count; ++at) {
			_formats[at + 1] = configuration.devices[at].format;
			_tracker_ids.push_back(configuration.devices[at].device_id);
		}
	}
	_is_stale = true;
}

/// Before the first sample after anything has changed.
void BusReplay::expect() {
	_is_stale = false;
	_check.restart();
	_stream.restart(rate_hz() > 0.0 ? rate_hz() : 100.0);
	if (is_master()) {
		MasterFormat format;
		for (std::size_t at = 0; at < _tracker_ids.size(); ++at) {
			format.add(_formats[at + 1]);
		}
		_check.expect_devices(_tracker_ids.size());
		if (format.count() > 0 && format.count() == _tracker_ids.size()) {
			_check.expect_master(format);
		}
	} else if (_formats[MASTER].mode != 0) {
		_check.expect_tracker(_formats[MASTER]);
	}
	// Longer ones are not waited for. A configuration may come again.
	_framer.set_longest(std::max(_check.data_size(), Configuration::MAX_BYTES));
}

bool BusReplay::is_master() const {
	return device_kind(_device_id) == DeviceKind::XBUS_MASTER;
}

double BusReplay::rate_hz() const {
	return _period > 0 ? 115200.0 / _period : 0.0;
}

const DeviceStatistics &BusReplay::tracker(int p_tracker) const {
	return _check.device(is_master() ? uint8_t(p_tracker + 1) : MASTER);
}

std::vector<uint8_t> bus_bytes(Reader &r_reader, int p_stream, bool p_with_requests) {
	Record record;
	if (p_stream < 0) {
		std::map<int, uint64_t> sizes;
		for (r_reader.rewind(); r_reader.next(record);) {
			sizes[record.stream] += record.kind == Kind::BUS_IN ? record.size : 0;
		}
		for (const auto &[stream, size] : sizes) {
			p_stream = p_stream < 0 || size > sizes[p_stream] ? stream : p_stream;
		}
	}
	std::vector<uint8_t> bytes;
	std::vector<uint8_t> requests;
	Framer framer;
	for (r_reader.rewind(); r_reader.next(record);) {
		if (record.stream != p_stream) {
			continue;
		}
		if (record.kind == Kind::BUS_OUT && p_with_requests) {
			requests.insert(requests.end(), record.payload, record.payload + record.size);
		} else if (record.kind == Kind::BUS_IN) {
			framer.feed(record.payload, record.size, [](const Frame &) { return true; });
			bytes.insert(bytes.end(), record.payload, record.payload + record.size);
		}
		if (framer.pending() == 0) {
			bytes.insert(bytes.end(), requests.begin(), requests.end());
			requests.clear();
		}
	}
	r_reader.rewind();
	return bytes;
}

} // namespace recording
