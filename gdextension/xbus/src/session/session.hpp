// SPDX-License-Identifier: MIT
#pragma once

#include "bus/framer.hpp"
#include "session/exchange.hpp"
#include "session/known_device.hpp"
#include "session/measurement.hpp"
#include "session/output_choice.hpp"
#include "session/session_log.hpp"
#include "session/session_report.hpp"
#include "session/setup_step.hpp"

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
/// It conducts: SetupStep says what comes after what, Exchange asks and waits, OutputChoice says what is asked
/// for, Measurement judges what comes.
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
	bool is_stopped() const { return _step == SetupStep::STOPPED || _step == SetupStep::UNSUPPORTED; }

	SessionState state() const;
	/// Writes what is known; allocates.
	void report(uint64_t p_now_usec, SessionReport &r_report) const;

private:
	// The steps.
	void go_to(SetupStep p_step);
	void go_on() { go_to(step_after(_step, _device)); }
	SetupStep step_after_tracker();
	Request request_for(SetupStep p_step) const;
	void ask(const Request &p_request);
	void send(const Request &p_request) { _host.send(p_request.bytes.data(), p_request.size); }
	void send_ahead();
	int tries() const;
	bool pass_over();
	void choose_outputs();
	void begin_measuring();
	void pause(uint64_t p_usec);
	void start_over(const char *p_why);
	void fail_step();
	void next_baud();

	// What the device says.
	bool judge(const Frame &p_frame);
	void take(const Frame &p_frame);
	bool is_answering(uint8_t p_bus_id) const;
	void take_answer(const Frame &p_frame);
	void take_device_id(const Frame &p_frame);
	void take_bus(const Frame &p_frame);
	void take_data_length(const Frame &p_frame);
	void take_error(const Frame &p_frame);
	void take_setup_error(uint8_t p_code);
	bool lower_demands(uint8_t p_code);
	void take_data();
	void wake_up();
	void look_after_stream();
	void report_damage();

	const SessionOptions _options;
	SessionHost &_host;
	SessionLog _log;
	Framer _framer;
	KnownDevice _device;
	OutputChoice _choice;
	Exchange _exchange;
	Measurement _measurement;

	SetupStep _step = SetupStep::PAUSE;
	uint64_t _now_usec = 0;
	/// When the last bytes came.
	uint64_t _bytes_usec = 0;
	/// The tracker that is being set up.
	int _tracker = 0;
	int _bus_failures = 0;
	bool _has_powered = false;
	bool _has_answered = false;
	bool _is_silent = false;

	std::size_t _baud_at = 0;
	uint32_t _baud = 0;
	bool _has_raised_baud = false;
	double _battery = -1.0;
	uint64_t _battery_usec = 0;

	uint64_t _errors = 0;
	uint64_t _restarts = 0;
	/// Restarts without a sample in between.
	unsigned _in_vain = 0;
};

} // namespace xbus
