// SPDX-License-Identifier: MIT
#include "session/output_choice.hpp"

#include "bus/data_item.hpp"

#include <algorithm>
#include <array>

namespace xbus {

namespace {

/// Error codes of a device that cannot send so often.
constexpr uint8_t ERROR_PERIOD = 0x03;
constexpr uint8_t ERROR_PERIOD_TOO_SHORT = 0x18;
constexpr uint8_t ERROR_TIMER_OVERFLOW = 0x1E;
constexpr uint8_t ERROR_BUFFER_FULL = 0x23;

} // namespace

OutputChoice::Fit OutputChoice::choose(
		uint32_t p_baud, const KnownDevice &p_device, bool p_may_be_raised, double &r_rate_hz) {
	const int trackers = p_device.tracker_count;
	std::size_t demand = _demand;
	while (demand + 1 < DEMANDS.size() && !fits(p_baud, DEMANDS[demand].block, trackers, _wanted_hz)) {
		++demand;
	}
	const Demand &chosen = DEMANDS[demand];
	r_rate_hz = rate_that_fits(p_baud, chosen.block, trackers, _wanted_hz);
	if (r_rate_hz < _wanted_hz && p_baud < FAST_BAUD && p_may_be_raised) {
		return Fit::LINE_TOO_SLOW;
	}
	_outputs.mode = chosen.mode;
	_outputs.settings = chosen.settings | (p_device.is_master() ? 0U : SETTINGS_COUNTER);
	_outputs.period = std::max(period_of(r_rate_hz), _outputs.period);
	return r_rate_hz < _wanted_hz ? Fit::FEWER_SAMPLES : Fit::AS_WANTED;
}

OutputChoice::Lowered OutputChoice::lower(uint8_t p_code, bool p_is_about_period) {
	if (_demand + 1 < DEMANDS.size() && !(p_is_about_period && p_code == ERROR_PERIOD)) {
		++_demand;
		return Lowered::CONTENT;
	}
	const bool is_too_fast = p_code == ERROR_PERIOD || p_code == ERROR_PERIOD_TOO_SHORT ||
			p_code == ERROR_TIMER_OVERFLOW || p_code == ERROR_BUFFER_FULL;
	if (is_too_fast && _outputs.period > 0 && _outputs.period <= MAX_PERIOD / 2) {
		_outputs.period = uint16_t(_outputs.period * 2);
		return Lowered::RATE;
	}
	return Lowered::NOTHING;
}

MasterFormat OutputChoice::master_format(int p_trackers) const {
	MasterFormat format;
	for (int tracker = 0; tracker < p_trackers; ++tracker) {
		format.add(tracker_format());
	}
	return format;
}

std::size_t OutputChoice::sample_size(const KnownDevice &p_device) const {
	return p_device.is_master() ? master_format(p_device.tracker_count).size() : tracker_format().size();
}

Request OutputChoice::mtdata2_request() const {
	constexpr uint16_t ALWAYS = 0xFFFF;
	const auto rate = uint16_t(std::clamp(_wanted_hz + 0.5, 1.0, 400.0));
	const std::array<OutputRequest, 7> outputs = { {
			{ item::PACKET_COUNTER, ALWAYS },
			{ item::SAMPLE_TIME_FINE, ALWAYS },
			{ item::QUATERNION, rate },
			{ item::RATE_OF_TURN, rate },
			{ item::ACCELERATION, rate },
			// No magnetometer measures faster.
			{ item::MAGNETIC_FIELD, std::min<uint16_t>(rate, 100) },
			{ item::STATUS_WORD, ALWAYS },
	} };
	return host::set_output_configuration(outputs.data(), outputs.size());
}

} // namespace xbus
