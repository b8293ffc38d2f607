// SPDX-License-Identifier: MIT
#pragma once

#include "bus/requests.hpp"
#include "bus/stream_check.hpp"
#include "session/known_device.hpp"
#include "session/line_budget.hpp"

#include <cstddef>
#include <cstdint>

namespace xbus {

/// Chooses what trackers are asked to send: as much as the line carries and the device bears.
class OutputChoice {
public:
	/// How what was chosen fits the line.
	enum class Fit : uint8_t {
		AS_WANTED,
		FEWER_SAMPLES,
		/// Nothing was chosen: the line is to be made faster first.
		LINE_TOO_SLOW,
	};
	/// What was taken away from the demands.
	enum class Lowered : uint8_t {
		CONTENT,
		RATE,
		/// Nothing: they are the least already.
		NOTHING,
	};

	/// Samples per second that are wanted, and whether the line is serial. Such a line damages bytes now and
	/// then, and an eight-bit checksum lets one damaged message in 255 through: of orientations alone nearly
	/// all of those are found (docs/xbus.md), of rates and accelerations not.
	OutputChoice(double p_rate_hz, bool p_is_serial) :
			_wanted_hz(p_rate_hz), _demand(p_is_serial ? DEMANDS.size() - 1 : 0) {}

	/// Chooses for a line's speed, bit/s (0: of any speed), and says how many samples per second it carries.
	Fit choose(uint32_t p_baud, const KnownDevice &p_device, bool p_may_be_raised, double &r_rate_hz);
	/// Asks for less the next time, after a device's error code; `p_is_about_period`: to a period.
	Lowered lower(uint8_t p_code, bool p_is_about_period);

	const Outputs &outputs() const { return _outputs; }
	double wanted_hz() const { return _wanted_hz; }
	/// Samples per second that a device sends.
	double rate_hz(const KnownDevice &p_device) const {
		return p_device.speaks_mtdata2() ? _wanted_hz : _outputs.rate_hz();
	}
	OutputFormat tracker_format() const { return { _outputs.mode, _outputs.settings }; }
	MasterFormat master_format(int p_trackers) const;
	/// Bytes of a message of samples.
	std::size_t sample_size(const KnownDevice &p_device) const;
	/// What a tracker of the newer kind is asked for.
	Request mtdata2_request() const;

private:
	double _wanted_hz;
	/// Which of DEMANDS is the most that is asked for.
	std::size_t _demand;
	Outputs _outputs;
};

} // namespace xbus
