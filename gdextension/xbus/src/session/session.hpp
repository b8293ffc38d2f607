// SPDX-License-Identifier: MIT
#pragma once

#include "bus/framer.hpp"
#include "session/device_setup.hpp"
#include "session/measurement.hpp"
#include "session/session_log.hpp"
#include "session/session_report.hpp"

#include <cstddef>
#include <cstdint>

namespace xbus {

/// What a session is to reach.
struct SessionOptions {
	/// Samples per second of all trackers; less where the line does not carry it.
	double rate_hz = 100.0;
	/// Whether the line has a speed that must be found.
	bool has_baud = false;
};

/// Brings a master with its trackers, or a tracker that stands alone, to measuring and keeps it there
/// (docs/suits.md, "Bringing a suit up"). No I/O, no clock: bytes and the time, µs, are handed in.
///
/// It works from any state of the device: powered up just now, waiting, measuring since before we came. What
/// does not answer is asked again; what falls silent or starts anew is brought up anew, for as long as the
/// session is open. Nothing is allocated while the device measures.
///
/// It conducts: DeviceSetup brings the device up, Measurement judges what comes.
class Session {
public:
	/// The speed that a slower master is set to where its line does not carry the samples, bit/s.
	static constexpr uint32_t FAST_BAUD = xbus::FAST_BAUD;

	Session(const SessionOptions &p_options, SessionHost &p_host);

	/// Begins.
	void open(uint64_t p_now_usec);
	/// Bytes of the bus, cut anywhere.
	void take_bytes(const uint8_t *p_bytes, std::size_t p_size, uint64_t p_now_usec);
	/// What time brings: asks again, notices silence. Call it every few milliseconds.
	void advance(uint64_t p_now_usec);
	/// Lets the device stop measuring.
	void stop(uint64_t p_now_usec);
	bool is_stopped() const { return _setup.is_over(); }

	SessionState state() const { return _setup.state(); }
	/// Writes what is known; allocates.
	void report(uint64_t p_now_usec, SessionReport &r_report) const;

private:
	bool judge(const Frame &p_frame);
	void take(const Frame &p_frame);
	void take_data();
	void begin_measuring();
	void look_after_stream();
	void report_damage();

	SessionHost &_host;
	SessionLog _log;
	Framer _framer;
	DeviceSetup _setup;
	Measurement _measurement;

	uint64_t _now_usec = 0;
	/// When the last bytes came.
	uint64_t _bytes_usec = 0;
	double _battery = -1.0;
	uint64_t _battery_usec = 0;
	uint64_t _errors = 0;
};

} // namespace xbus
