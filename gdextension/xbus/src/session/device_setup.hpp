// SPDX-License-Identifier: MIT
#pragma once

#include "bus/framer.hpp"
#include "session/exchange.hpp"
#include "session/known_device.hpp"
#include "session/line_speed.hpp"
#include "session/output_choice.hpp"
#include "session/session_log.hpp"
#include "session/session_report.hpp"
#include "session/setup_step.hpp"

#include <cstdint>

namespace xbus {

/// The conversation that brings a device to measuring, and begins anew where that fails (docs/suits.md,
/// "Bringing a suit up"). SetupStep says what comes after what, Exchange asks and waits, OutputChoice says what
/// is asked for. Times are in µs; nothing is allocated.
class DeviceSetup {
public:
	/// Samples per second that are wanted, and whether the line has a speed that must be found.
	DeviceSetup(double p_rate_hz, bool p_is_serial, SessionHost &p_host, SessionLog &p_log);

	/// Begins.
	void open(uint64_t p_now_usec);
	/// What time brings: asks again, or begins anew. `p_hears`: whether messages come at the line's present speed.
	void advance(uint64_t p_now_usec, bool p_hears);
	/// Takes a message that holds no samples of the kind that was asked for.
	void take(const Frame &p_frame, uint64_t p_now_usec);
	/// Samples have come. Returns whether the device is measuring for us.
	bool note_sample(uint64_t p_now_usec);
	/// The device measured and sends nothing of use any more.
	void begin_anew(const char *p_why, uint64_t p_now_usec);
	/// Lets the device stop measuring.
	void stop(uint64_t p_now_usec);

	bool is_measuring() const { return _step == SetupStep::MEASURING; }
	/// Whether nothing more will be asked.
	bool is_over() const { return _step == SetupStep::STOPPED || _step == SetupStep::UNSUPPORTED; }
	SessionState state() const;
	const KnownDevice &device() const { return _device; }
	const OutputChoice &choice() const { return _choice; }
	/// Speed of the line, bit/s; 0 where it has none.
	uint32_t baud() const { return _speed.baud(); }
	/// How often the device was brought up anew.
	uint64_t restarts() const { return _restarts; }

private:
	// What is asked.
	void go_to(SetupStep p_step);
	void go_on() { go_to(step_after(_step, _device)); }
	SetupStep step_after_tracker();
	void ask(const Request &p_request);
	void send(const Request &p_request) { _host.send(p_request.bytes.data(), p_request.size); }
	void send_ahead();
	int tries() const;
	bool pass_over();
	void choose_outputs();
	void pause(uint64_t p_usec);
	void start_over(const char *p_why);
	void fail_step(bool p_hears);
	void next_baud(bool p_hears);

	// What the device says.
	bool is_answering(uint8_t p_bus_id) const;
	void take_answer(const Frame &p_frame);
	void take_device_id(const Frame &p_frame);
	void take_bus(const Frame &p_frame);
	void take_data_length(const Frame &p_frame);
	void take_error(const Frame &p_frame);
	void take_setup_error(uint8_t p_code);
	bool lower_demands(uint8_t p_code);
	void wake_up();

	SessionHost &_host;
	SessionLog &_log;
	KnownDevice _device;
	LineSpeed _speed;
	OutputChoice _choice;
	Exchange _exchange;

	SetupStep _step = SetupStep::PAUSE;
	uint64_t _now_usec = 0;
	/// The tracker that is being set up.
	int _tracker = 0;
	int _bus_failures = 0;
	bool _has_powered = false;
	bool _has_answered = false;
	bool _is_silent = false;
	bool _has_raised_baud = false;
	uint64_t _restarts = 0;
	/// Restarts without a sample in between.
	unsigned _in_vain = 0;
};

} // namespace xbus
