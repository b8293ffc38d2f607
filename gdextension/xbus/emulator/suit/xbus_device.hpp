// SPDX-License-Identifier: MIT
#pragma once

#include "bus/encoder.hpp"
#include "bus/framer.hpp"
#include "bus/message.hpp"
#include "cable/serial_line.hpp"
#include "suit/tracker.hpp"

#include <deque>
#include <functional>
#include <initializer_list>
#include <map>

namespace emulator {

/// Of the clock of samples, in a second.
constexpr int64_t TICKS = 115200;
constexpr uint8_t ERROR_PERIOD = 0x03;

/// Bytes of a message's data.
using Data = std::vector<uint8_t>;

void append_u16(Data &r_data, unsigned p_value);
void append_u32(Data &r_data, uint32_t p_value);

/// What a device does wrong on purpose.
struct DeviceFaults {
	/// Answers nothing any more.
	bool is_mute = false;
	/// Sends no samples any more.
	bool is_frozen = false;
	/// Messages that are answered with an error of this code.
	std::map<uint8_t, uint8_t> errors;
	/// It takes notice of what it is told so much later.
	Usec answer_delay = 0;
	/// An Error message of this code after every so many samples.
	int error_every = 0;
	uint8_t error_code = 0x29;
};

/// What a device stands for on the bus, whether a master or a tracker that stands alone: states, sample
/// clock, answers.
class XbusDevice : public SerialDevice {
public:
	using Log = std::function<void(Usec, const std::string &)>;
	enum class State : uint8_t {
		OFF,
		WAKE_UP,
		CONFIG,
		MEASUREMENT,
		REBOOT
	};

	XbusDevice(MotionStream p_stream, uint64_t p_seed);

	void power(bool p_on, Usec p_now) override;
	void receive(const uint8_t *p_bytes, std::size_t p_size, Usec p_now) override;
	void advance(Usec p_now) override;
	Usec next_event() const override;
	uint32_t baud() const override { return _baud; }

	State state() const { return _state; }
	uint32_t device_id() const { return _device_id; }
	uint64_t samples() const { return _samples; }
	void set_log(Log p_log) { _log = std::move(p_log); }
	/// Called whenever it begins to measure.
	void set_on_measuring(std::function<void(Usec)> p_call) { _on_measuring = std::move(p_call); }
	void set_baud(uint32_t p_baud) { _baud = _next_baud = p_baud; }
	/// The counter of the first sample, to see it go round.
	void set_first_counter(uint16_t p_counter) { _counter = p_counter; }
	/// The wearer does what the motion has after so many seconds, and goes on from that time on or stands still.
	void set_motion(double p_seconds, bool p_runs, Usec p_since);
	/// Where in the motion the wearer is, s.
	double motion_time(Usec p_now) const {
		return _motion_s + (_motion_runs && p_now > _motion_since ? double(p_now - _motion_since) * 1e-6 : 0.0);
	}
	/// Whether it goes on.
	bool motion_runs() const { return _motion_runs; }
	/// Sends an Error message by itself.
	void send_error(uint8_t p_code, Usec p_now);

	DeviceFaults faults;

protected:
	/// What the message was answered with.
	enum class Answer : uint8_t {
		DONE,
		UNKNOWN
	};

	/// A message in Config, or one that measuring allows. UNKNOWN: it is answered with error 04.
	virtual Answer handle(const xbus::Frame &p_frame, Usec p_now) = 0;
	virtual bool is_allowed_while_measuring(const xbus::Frame &p_frame) const = 0;
	/// 0, or the error that keeps it from measuring. `r_bus_id`: of whom, 0 for the device itself.
	virtual uint8_t start_measuring(uint8_t &r_bus_id) = 0;
	/// The data of the sample's message.
	virtual Data sample(double p_motion_s, uint16_t p_counter) = 0;
	virtual xbus::Message sample_message() const = 0;
	/// Nobody has acknowledged WakeUp: whether it measures by itself now.
	virtual bool measures_by_itself() const = 0;
	virtual Data configuration() const = 0;
	/// Forgets what does not survive a reset.
	virtual void restart() = 0;
	/// How often it measures, in units of 1/115200 s.
	virtual int64_t sample_ticks() const = 0;

	/// Sends a message; `p_delay`: how long the device works for it.
	void reply(uint8_t p_bus_id, xbus::Message p_message, const Data &p_data, Usec p_now, Usec p_delay = 200);
	void reply_error(uint8_t p_code, Usec p_now, uint8_t p_bus_id = 0);
	/// Takes a value of 8, 16 or 32 bits, or answers with it where there are no data; false if neither fits.
	bool exchange(const xbus::Frame &p_frame, unsigned &r_value, std::size_t p_bytes, Usec p_now);
	bool change_baud(const xbus::Frame &p_frame, Usec p_now);
	void go_to(State p_state) { _state = p_state; }
	bool is_overflowing() const;

	MotionStream _stream;
	Random _random;
	uint32_t _device_id = 0;
	/// Sends nothing while measuring but what it is asked for (ReqData).
	bool _only_on_request = false;
	/// Stops where its buffer overflows, instead of leaving out samples.
	bool _stops_on_overflow = false;
	/// 0 ignore, 1 count, 2 count and send, 3 send and go to Config.
	unsigned _error_mode = 2;

private:
	void _read(const uint8_t *p_bytes, std::size_t p_size, Usec p_now);
	void _take(const xbus::Frame &p_frame, Usec p_now);
	Usec _next_own() const;
	void _take_common(const xbus::Frame &p_frame, Usec p_now);
	void _go_to_config(Usec p_now);
	void _go_to_measurement(Usec p_now, bool p_is_asked);
	void _sample(Usec p_now);
	void _log_state(Usec p_now, const std::string &p_text) const;

	xbus::Framer _framer;
	Log _log;
	std::function<void(Usec)> _on_measuring;
	State _state = State::OFF;
	uint32_t _baud = 460800;
	uint32_t _next_baud = 460800;
	double _motion_s = 0.0;
	Usec _motion_since = 0;
	bool _motion_runs = true;
	/// End of WakeUp, or of the reboot.
	Usec _deadline = NEVER;
	Usec _measuring_since = 0;
	int64_t _sample_number = 0;
	Usec _last_received = 0;
	uint16_t _counter = 0;
	uint64_t _samples = 0;
	/// What it is to take notice of later.
	std::deque<Chunk> _heard;
};

} // namespace emulator
