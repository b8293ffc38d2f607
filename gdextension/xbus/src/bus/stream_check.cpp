// SPDX-License-Identifier: MIT
#include "bus/stream_check.hpp"

#include <algorithm>

namespace xbus {

namespace {

/// Data bytes that a device's message can have.
struct Lengths {
	Message message;
	uint16_t least;
	uint16_t most;
};

constexpr Lengths LENGTHS[] = {
	{ Message::DEVICE_ID, 4, 8 },
	{ Message::INIT_BUS_RESULTS, 0, 4 * MAX_DEVICES },
	{ Message::SET_PERIOD_ACK, 0, 2 },
	{ Message::SET_BUS_ID_ACK, 0, 1 },
	{ Message::BUS_POWER_ACK, 0, 2 },
	{ Message::DATA_LENGTH, 2, 2 },
	{ Message::CONFIGURATION, Configuration::HEAD, Configuration::MAX_BYTES },
	{ Message::RESTORE_FACTORY_DEFAULTS_ACK, 0, 0 },
	{ Message::GO_TO_MEASUREMENT_ACK, 0, 0 },
	{ Message::FIRMWARE_REVISION, 3, 11 },
	{ Message::DISABLE_BLUETOOTH_ACK, 0, 8 },
	{ Message::OPERATING_MODE_ACK, 0, 2 },
	{ Message::SET_BAUD_RATE_ACK, 0, 1 },
	{ Message::SET_SYNC_MODE_ACK, 0, 4 },
	{ Message::PRODUCT_CODE, 1, 32 },
	{ Message::HARDWARE_VERSION, 2, 8 },
	{ Message::GO_TO_CONFIG_ACK, 0, 0 },
	{ Message::MT_DATA, 1, MAX_DATA },
	{ Message::REQ_DATA_ACK, 0, MAX_DATA },
	{ Message::MT_DATA2, 3, MAX_DATA },
	{ Message::WAKE_UP, 0, 0 },
	{ Message::RESET_ACK, 0, 0 },
	{ Message::ERROR, 1, 2 },
	{ Message::WARNING, 1, 16 },
	{ Message::MASTER_INDICATION, 0, 32 },
	{ Message::XSB_DATA, 0, MAX_DATA },
	{ Message::KEEP_ALIVE_ACK, 0, 2 },
	{ Message::XM_ERROR_MODE_ACK, 0, 4 },
	{ Message::BUFFER_SIZE_ACK, 0, 2 },
	{ Message::BATTERY_LEVEL, 0, 2 },
	{ Message::RESET_ORIENTATION_ACK, 0, 2 },
	{ Message::SCAN_CHANNELS_ACK, 0, 64 },
	{ Message::ENABLE_MASTER_ACK, 0, 2 },
	{ Message::DISABLE_MASTER_ACK, 0, 2 },
	{ Message::RADIO_CHANNEL_ACK, 0, 2 },
	{ Message::WIRELESS_CONFIG_ACK, 0, 64 },
	{ Message::SET_OUTPUT_CONFIGURATION_ACK, 0, 4 * 64 },
	{ Message::ACCEPT_MTW_ACK, 0, 4 },
	{ Message::REJECT_MTW_ACK, 0, 4 },
	{ Message::START_RECORDING_ACK, 0, 2 },
	{ Message::STOP_RECORDING_ACK, 0, 2 },
	{ Message::SET_OUTPUT_MODE_ACK, 0, 2 },
	{ Message::SET_OUTPUT_SETTINGS_ACK, 0, 4 },
	{ Message::SET_OUTPUT_SKIP_FACTOR_ACK, 0, 2 },
	{ Message::SET_ERROR_MODE_ACK, 0, 2 },
	{ Message::SET_OBJECT_ALIGNMENT_ACK, 0, 36 },
};

struct LengthTable {
	std::array<uint16_t, 256> least{};
	std::array<uint16_t, 256> most{};

	constexpr LengthTable() {
		for (std::size_t i = 0; i < 256; i++) {
			least[i] = 1;
		}
		for (const Lengths &lengths : LENGTHS) {
			least[uint8_t(lengths.message)] = lengths.least;
			most[uint8_t(lengths.message)] = lengths.most;
		}
	}
};

constexpr LengthTable TABLE;

} // namespace

bool is_device_message(const Frame &p_frame) {
	const auto message = uint8_t(p_frame.message);
	return p_frame.size >= TABLE.least[message] && p_frame.size <= TABLE.most[message] &&
			(p_frame.bus_id == MASTER || (p_frame.bus_id != BROADCAST && p_frame.bus_id <= MAX_DEVICES));
}

uint32_t message_shape(const Frame &p_frame) {
	// FNV-1a.
	uint32_t hash = 2166136261U;
	visit_items(p_frame.data, p_frame.size, [&](const Item &p_item) {
		hash = (hash ^ p_item.id) * 16777619U;
		hash = (hash ^ p_item.size) * 16777619U;
	});
	return hash;
}

void StreamCheck::reset() {
	_has_master = false;
	_has_tracker = false;
	_device_count = 0;
	_devices = {};
	_master_counter = {};
	_sample_count = 0;
	_shape_count = 0;
	_statistics = {};
}

void StreamCheck::restart() {
	_master_counter.forget();
	for (Device &device : _devices) {
		device.counter.forget();
	}
}

void StreamCheck::expect_master(const MasterFormat &p_format) {
	_master = p_format;
	_has_master = true;
	_has_tracker = false;
	expect_devices(p_format.count());
}

void StreamCheck::expect_tracker(const OutputFormat &p_format, uint32_t p_counter_step) {
	_tracker = p_format;
	_has_master = false;
	_has_tracker = true;
	_devices[0].counter.set_step(p_counter_step);
}

std::size_t StreamCheck::data_size() const {
	return _has_master ? _master.size() : (_has_tracker ? _tracker.size() : 0);
}

bool StreamCheck::_is_bus_id(uint8_t p_bus_id) const {
	return p_bus_id == MASTER || _device_count == 0 || p_bus_id <= _device_count;
}

StreamCheck::Verdict StreamCheck::_refuse(uint64_t &r_reason) {
	r_reason++;
	return Verdict::REFUSED;
}

StreamCheck::Verdict StreamCheck::take(const Frame &p_frame, bool p_noisy) {
	if (!is_device_message(p_frame) || !_is_bus_id(p_frame.bus_id)) {
		return _refuse(_statistics.impossible);
	}
	if (p_frame.message == Message::MT_DATA) {
		return _take_mt_data(p_frame);
	}
	if (p_frame.message == Message::MT_DATA2) {
		return _take_mt_data2(p_frame, p_noisy);
	}
	_statistics.control++;
	return Verdict::CONTROL;
}

StreamCheck::Verdict StreamCheck::_take_mt_data(const Frame &p_frame) {
	if (_has_master) {
		if (p_frame.bus_id != MASTER || !_master.decode(p_frame.data, p_frame.size, _samples.data())) {
			return _refuse(_statistics.wrong_sizes);
		}
		return _take_master();
	}
	if (_has_tracker) {
		if (!_tracker.decode(p_frame.data, p_frame.size, _samples[0])) {
			return _refuse(_statistics.wrong_sizes);
		}
		_samples[0].bus_id = p_frame.bus_id;
		return _take_sample(_samples[0]);
	}
	_statistics.control++;
	return Verdict::CONTROL;
}

StreamCheck::Verdict StreamCheck::_take_master() {
	bool implausible = false;
	for (std::size_t i = 0; i < _master.count(); i++) {
		Device &device = _devices[i + 1];
		const SampleJudge::Verdict verdict = device.judge.judge(_samples[i]);
		device.statistics.implausible += verdict == SampleJudge::Verdict::PLAUSIBLE ? 0U : 1U;
		implausible = implausible || verdict == SampleJudge::Verdict::IMPLAUSIBLE;
		_samples[i].present = verdict == SampleJudge::Verdict::SICK ? 0 : _samples[i].present;
	}
	if (implausible) {
		return _refuse(_statistics.implausible);
	}
	uint32_t lost = 0;
	const uint16_t counter = uint16_t(_samples[0].counter);
	const CounterTrack::Step step = _master_counter.see(counter, 16, lost);
	note_step(step, lost, _devices[0].statistics);
	for (std::size_t i = 0; i < _master.count(); i++) {
		note_step(step, lost, _devices[i + 1].statistics);
		// What a sick device sends is not received.
		_devices[i + 1].statistics.received -= _samples[i].present == 0 ? 1U : 0U;
	}
	_sample_count = _master.count();
	_statistics.data++;
	return Verdict::DATA;
}

StreamCheck::Verdict StreamCheck::_take_mt_data2(const Frame &p_frame, bool p_noisy) {
	Sample &sample = _samples[0];
	const ItemReport report = decode_mt_data2(p_frame.data, p_frame.size, sample);
	const bool odd = !report.is_clean() && !_is_known_shape(p_frame);
	if (!report.whole || (odd && p_noisy)) {
		return _refuse(_statistics.wrong_sizes);
	}
	_statistics.unknown_items += report.unknown + report.misfits;
	sample.bus_id = p_frame.bus_id;
	return _take_sample(sample);
}

bool StreamCheck::_is_known_shape(const Frame &p_frame) {
	const uint32_t shape = message_shape(p_frame);
	const auto *end = _shapes.begin() + std::min(_shape_count, SHAPES);
	if (std::find(_shapes.cbegin(), end, shape) != end) {
		return true;
	}
	_shapes[_shape_count % SHAPES] = shape;
	_shape_count++;
	return false;
}

StreamCheck::Verdict StreamCheck::_take_sample(Sample &r_sample) {
	Device &device = _devices[_index(r_sample.bus_id)];
	const SampleJudge::Verdict verdict = device.judge.judge(r_sample);
	if (verdict != SampleJudge::Verdict::PLAUSIBLE) {
		device.statistics.implausible++;
	}
	if (verdict == SampleJudge::Verdict::IMPLAUSIBLE) {
		return _refuse(_statistics.implausible);
	}
	if (verdict == SampleJudge::Verdict::SICK) {
		r_sample.present = 0;
	} else if (r_sample.has(Field::COUNTER)) {
		device.counter.see(r_sample.counter, r_sample.counter_bits, device.statistics);
	} else {
		device.statistics.received++;
	}
	_sample_count = 1;
	_statistics.data++;
	return Verdict::DATA;
}

} // namespace xbus
