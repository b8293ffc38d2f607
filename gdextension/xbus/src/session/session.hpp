// SPDX-License-Identifier: MIT
#pragma once

#include "bus/framer.hpp"
#include "bus/requests.hpp"
#include "session/line_budget.hpp"
#include "session/suit_frame.hpp"
#include "session/suit_stream.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace xbus {

enum class Severity : uint8_t {
	INFO,
	WARNING,
	ERROR
};

/// Where a session is.
enum class SessionState : uint8_t {
	SEARCHING, ///< Nobody has answered yet.
	CONFIGURING,
	MEASURING,
	SILENT, ///< Was measuring, and says nothing any more.
	UNSUPPORTED, ///< Answered, and is a device that can't be used.
	STOPPED,
};

/// The state in plain words.
const char *state_text(SessionState p_state);

/// What a session is to reach.
struct SessionOptions {
	/// Samples per second of all trackers; less where the line does not carry it.
	double rate_hz = 100.0;
	/// Whether the line has a speed that must be found.
	bool has_baud = false;
};

/// What is known of a tracker.
struct TrackerReport {
	uint32_t device_id = 0;
	uint8_t bus_id = 0;
	DeviceStatistics samples;
	TrackerFlow flow;
};

/// What is known of a master, for people.
struct SessionReport {
	SessionState state = SessionState::SEARCHING;
	uint32_t device_id = 0;
	DeviceKind kind = DeviceKind::UNKNOWN;
	/// Speed of the line, bit/s; 0 where it has none.
	uint32_t baud = 0;
	/// Samples per second that were asked for.
	double rate_hz = 0.0;
	/// 0 to 1, negative where it is not known.
	double battery = -1.0;
	FramerStatistics framer;
	StreamStatistics stream;
	/// Error messages of the device.
	uint64_t errors = 0;
	/// How often it was brought up anew.
	uint64_t restarts = 0;
	/// Part of the samples that was lost in the last seconds, 0 to 1.
	double lost_share = 0.0;
	/// What is wrong now, or an empty text.
	std::string problem;
	std::vector<TrackerReport> trackers;
};

/// The world around a session.
class SessionHost {
public:
	virtual ~SessionHost() = default;
	/// Sends bytes to the device; false if they cannot be sent now.
	virtual bool send(const uint8_t *p_bytes, std::size_t p_size) = 0;
	/// Sets the line's speed, bit/s, soon.
	virtual void set_baud(uint32_t p_baud) = 0;
	virtual void take_frame(const SuitFrame &p_frame) = 0;
	/// Something that people should know.
	virtual void say(Severity p_severity, const char *p_text) = 0;
};

/// Brings a master with its trackers, or a tracker that stands alone, to measuring and keeps it there
/// (docs/suits.md, "Bringing a suit up"). No I/O, no clock: bytes and the time, µs, are handed in.
///
/// It works from any state of the device: powered up just now, waiting, measuring since before we came. What
/// does not answer is asked again; what falls silent or starts anew is brought up anew, for as long as the
/// session is open. Nothing is allocated while the device measures.
class Session {
public:
	/// The speed that a slower master is set to where its line does not carry the samples, bit/s.
	static constexpr uint32_t FAST_BAUD = 460800;

	Session(const SessionOptions &p_options, SessionHost &p_host);

	/// Begins.
	void open(uint64_t p_now_usec);
	/// Bytes of the bus, cut anywhere.
	void take_bytes(const uint8_t *p_bytes, std::size_t p_size, uint64_t p_now_usec);
	/// What time brings: asks again, notices silence. Call it every few milliseconds.
	void advance(uint64_t p_now_usec);
	/// Lets the device stop measuring.
	void stop(uint64_t p_now_usec);
	bool is_stopped() const { return _step == Step::STOPPED || _step == Step::UNSUPPORTED; }

	SessionState state() const;
	/// Writes what is known; allocates.
	void report(uint64_t p_now_usec, SessionReport &r_report) const;

private:
	enum class Step : uint8_t {
		PAUSE,
		GO_TO_CONFIG,
		DEVICE_ID,
		INIT_BUS,
		BUS_POWER,
		CONFIGURATION,
		SET_BAUD,
		REBOOT,
		OUTPUT_MODE,
		OUTPUT_SETTINGS,
		PERIOD,
		SKIP_FACTOR,
		DATA_LENGTH,
		OUTPUT_CONFIGURATION,
		BATTERY,
		MEASURE,
		MEASURING,
		STOP,
		STOPPED,
		UNSUPPORTED,
	};
	/// How long an answer is waited for, and how often it is asked for.
	struct Patience {
		uint64_t limit_usec;
		int tries;
		/// Whether it goes on without an answer.
		bool is_optional;
	};

	/// A device whose answers take so long is asked for several things at once, and for no more than is needed, µs.
	static constexpr uint64_t SLOW_USEC = 250000;

	static Patience patience(Step p_step);
	int tries(Step p_step) const;
	static Request output_configuration(double p_rate_hz);
	void go_to(Step p_step);
	void ask(const Request &p_request);
	void send_request();
	Request request_for(Step p_step) const;
	OutputFormat tracker_format() const { return { _outputs.mode, _outputs.settings }; }
	MasterFormat master_format() const;
	std::size_t expected_size() const;
	double rate_hz() const { return speaks_mtdata2() ? _options.rate_hz : _outputs.rate_hz(); }
	Step step_after(Step p_step) const;
	Step after_trackers(Step p_step);
	void start_over(const char *p_why);
	void fail_step();
	bool pass_over();
	void next_baud();
	void pause(uint64_t p_usec);

	bool judge(const Frame &p_frame);
	void take(const Frame &p_frame);
	bool is_answering(uint8_t p_bus_id) const;
	void take_answer(const Frame &p_frame);
	void take_device_id(const Frame &p_frame);
	void take_bus(const Frame &p_frame);
	void take_data_length(const Frame &p_frame);
	void take_error(const Frame &p_frame);
	void take_setup_error(uint8_t p_code);
	void take_data();
	void note_refusals();
	void wake_up();
	void choose_outputs();
	void begin_measuring();
	void look_after_stream();
	bool lower_demands(uint8_t p_code);
	void log(Severity p_severity, const char *p_format, ...) __attribute__((format(printf, 3, 4)));
	/// A kind that is not known is tried as both, in turn.
	bool is_master() const {
		return _kind == DeviceKind::XBUS_MASTER || (_kind == DeviceKind::UNKNOWN && _is_unknown_master);
	}
	static bool is_sent_ahead(Step p_step);
	void send_ahead();
	void await_answer();
	void note_delay();
	void note_damage();
	/// How long the present step's answer is waited for, µs.
	uint64_t limit_usec() const;
	bool speaks_mtdata2() const;
	uint8_t bus_id_of(int p_tracker) const { return is_master() ? uint8_t(p_tracker + 1) : MASTER; }

	const SessionOptions _options;
	SessionHost &_host;
	Framer _framer;
	StreamCheck _check;
	SuitStream _stream;
	SuitFrame _frame;

	Step _step = Step::PAUSE;
	Request _request;
	bool _waits = false;
	int _tries = 0;
	uint64_t _now_usec = 0;
	uint64_t _deadline_usec = 0;
	/// When the present request was first sent, and how long answers have taken at most, µs.
	uint64_t _asked_usec = 0;
	uint64_t _delay_usec = 0;
	/// Requests that were sent before their turn: their answers are on the way.
	int _ahead = 0;

	DeviceKind _kind = DeviceKind::UNKNOWN;
	uint32_t _device_id = 0;
	std::array<uint32_t, MAX_TRACKERS> _tracker_ids{};
	int _tracker_count = 0;
	int _tracker = 0;
	int _bus_failures = 0;
	bool _has_powered = false;
	bool _is_unknown_master = false;

	std::size_t _baud_at = 0;
	uint32_t _baud = 0;
	bool _has_raised_baud = false;
	Outputs _outputs;
	int _demands = 0;
	double _battery = -1.0;
	uint64_t _battery_usec = 0;

	uint64_t _heard_usec = 0;
	/// Samples of a wrong length when it began to measure, and when that was reported last.
	uint64_t _refused = 0;
	uint64_t _reported_refused = 0;
	uint64_t _bytes_usec = 0;
	/// Of the span over which damage on the line is judged: when it began, what had come and was lost by then.
	uint64_t _judged_usec = 0;
	uint64_t _judged_received = 0;
	uint64_t _judged_lost = 0;
	uint64_t _judged_bad_bytes = 0;
	double _lost_share = 0.0;
	bool _is_silent = false;
	bool _has_answered = false;
	uint64_t _errors = 0;
	uint64_t _restarts = 0;
	/// Restarts without a sample in between.
	unsigned _in_vain = 0;
	std::array<char, 240> _problem{};
};

} // namespace xbus
