// SPDX-License-Identifier: MIT
#include "session/session.hpp"

#include "bus/bytes.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace xbus {

namespace {

/// Speeds at which a master may be found, the likeliest first, bit/s.
constexpr std::array<uint32_t, 7> BAUDS = { 460800, 115200, 921600, 230400, 57600, 38400, 19200 };
/// The likeliest speeds are given more time: a converter or a radio link may hold answers up for long.
constexpr std::size_t LIKELY_BAUDS = 2;
constexpr int LIKELY_TRIES = 5;
constexpr uint8_t FAST_BAUD_CODE = 0x00;
/// A master that is reset is back after about 750 ms.
constexpr uint64_t REBOOT_USEC = 1000000;
constexpr uint64_t PAUSE_USEC = 500000;
/// A message whose rest does not come within this time hides what comes behind it.
constexpr uint64_t REST_USEC = 50000;
constexpr uint64_t BATTERY_USEC = 30000000;
/// Bus errors in a row until the log asks to look at the cables.
constexpr int MAX_BUS_FAILURES = 3;
/// Error codes of the device that ask for something else than asking again.
constexpr uint8_t ERROR_NO_BUS = 0x01;
constexpr uint8_t ERROR_BUS_NOT_READY = 0x02;

bool is_data(Message p_message) {
	return p_message == Message::MT_DATA || p_message == Message::MT_DATA2;
}

} // namespace

Session::Session(const SessionOptions &p_options, SessionHost &p_host) :
		_options(p_options), _host(p_host), _log(p_host), _choice(p_options.rate_hz, p_options.has_baud) {}

void Session::open(uint64_t p_now_usec) {
	_now_usec = p_now_usec;
	if (_options.has_baud) {
		_baud = BAUDS[_baud_at];
		_host.set_baud(_baud);
	}
	pause(0);
}

void Session::take_bytes(const uint8_t *p_bytes, std::size_t p_size, uint64_t p_now_usec) {
	_now_usec = std::max(_now_usec, p_now_usec);
	_bytes_usec = _now_usec;
	_framer.feed(p_bytes, p_size, [this](const Frame &p_frame) { return judge(p_frame); });
}

void Session::stop(uint64_t p_now_usec) {
	_now_usec = std::max(_now_usec, p_now_usec);
	if (is_stopped() || _step == SetupStep::STOP) {
		return;
	}
	// Somebody who never answered has nothing to stop.
	go_to(_has_answered ? SetupStep::STOP : SetupStep::STOPPED);
}

SessionState Session::state() const {
	switch (_step) {
		case SetupStep::PAUSE:
		case SetupStep::GO_TO_CONFIG:
			return _is_silent ? SessionState::SILENT
							  : (_has_answered ? SessionState::CONFIGURING : SessionState::SEARCHING);
		case SetupStep::MEASURING:
			return SessionState::MEASURING;
		case SetupStep::UNSUPPORTED:
			return SessionState::UNSUPPORTED;
		case SetupStep::STOPPED:
			return SessionState::STOPPED;
		default:
			return SessionState::CONFIGURING;
	}
}

void Session::advance(uint64_t p_now_usec) {
	_now_usec = std::max(_now_usec, p_now_usec);
	// A message whose rest does not come hides what comes behind it.
	if (_framer.pending() > 0 && _now_usec - _bytes_usec > REST_USEC) {
		_framer.give_up([this](const Frame &p_frame) { return judge(p_frame); });
	}
	if (_step == SetupStep::MEASURING) {
		look_after_stream();
		return;
	}
	if (is_stopped() || !_exchange.is_due(_now_usec)) {
		return;
	}
	if (_step == SetupStep::PAUSE) {
		go_to(SetupStep::GO_TO_CONFIG);
	} else if (_step == SetupStep::REBOOT) {
		_baud = FAST_BAUD;
		_host.set_baud(_baud);
		pause(0);
	} else if (_exchange.tries() < tries()) {
		_exchange.repeat(_step, _now_usec);
		send(_exchange.request());
	} else {
		fail_step();
	}
}

void Session::report(uint64_t p_now_usec, SessionReport &r_report) const {
	r_report.state = state();
	r_report.device_id = _device.id;
	r_report.kind = _device.kind;
	r_report.baud = _baud;
	r_report.rate_hz = _choice.rate_hz(_device);
	r_report.battery = _battery;
	r_report.framer = _framer.statistics();
	r_report.stream = _measurement.statistics();
	r_report.errors = _errors;
	r_report.restarts = _restarts;
	r_report.lost_share = _measurement.lost_share();
	r_report.problem = _log.problem();
	r_report.trackers.resize(std::size_t(_device.tracker_count));
	for (int tracker = 0; tracker < _device.tracker_count; ++tracker) {
		TrackerReport &report = r_report.trackers[std::size_t(tracker)];
		report.device_id = _device.tracker_ids[std::size_t(tracker)];
		report.bus_id = _device.bus_id_of(tracker);
		report.samples = _measurement.device(report.bus_id);
		report.flow = _measurement.flow(tracker, p_now_usec);
	}
}

void Session::go_to(SetupStep p_step) {
	_step = p_step;
	_exchange.end();
	// A slow device is not asked for what is merely good to know.
	const bool is_needed = p_step == SetupStep::SKIP_FACTOR || !patience(p_step).is_optional;
	if (_exchange.is_slow() && !is_needed && pass_over()) {
		return;
	}
	switch (p_step) {
		case SetupStep::STOPPED:
		case SetupStep::UNSUPPORTED:
		case SetupStep::PAUSE:
			return;
		case SetupStep::REBOOT:
			send(host::reset());
			_exchange.pause_until(_now_usec + REBOOT_USEC);
			return;
		case SetupStep::MEASURING:
			begin_measuring();
			return;
		default:
			ask(request_for(p_step));
	}
}

Request Session::request_for(SetupStep p_step) const {
	const uint8_t bus_id = _device.bus_id_of(_tracker);
	switch (p_step) {
		case SetupStep::DEVICE_ID:
			return host::request_device_id();
		case SetupStep::INIT_BUS:
			return host::init_bus();
		case SetupStep::BUS_POWER:
			return host::set_bus_power(true);
		case SetupStep::CONFIGURATION:
			return host::request_configuration();
		case SetupStep::SET_BAUD:
			return host::set_baud_rate(FAST_BAUD_CODE);
		case SetupStep::OUTPUT_MODE:
			return host::set_output_mode(_choice.outputs().mode, bus_id);
		case SetupStep::OUTPUT_SETTINGS:
			return host::set_output_settings(_choice.outputs().settings, bus_id);
		case SetupStep::PERIOD:
			return host::set_period(_choice.outputs().period);
		case SetupStep::SKIP_FACTOR:
			return host::set_skip_factor(0, MASTER);
		case SetupStep::DATA_LENGTH:
			return host::request_data_length();
		case SetupStep::OUTPUT_CONFIGURATION:
			return _choice.mtdata2_request();
		case SetupStep::BATTERY:
			return host::request_battery_level();
		case SetupStep::MEASURE:
			return host::go_to_measurement();
		default:
			return host::go_to_config();
	}
}

void Session::ask(const Request &p_request) {
	if (!_exchange.begin(p_request, _step, _now_usec)) {
		return; // It was sent before.
	}
	send(p_request);
	if (_exchange.is_slow() && _step == SetupStep::OUTPUT_MODE) {
		send_ahead();
	}
}

/// Sends all requests of the trackers' set-up at once, so that their answers are waited for once.
void Session::send_ahead() {
	const SetupStep step = _step;
	const int tracker = _tracker;
	const int count = 2 * _device.tracker_count - _tracker;
	for (int i = 0; i < count; ++i) {
		_step = step_after_tracker();
		send(request_for(_step));
	}
	_exchange.note_sent_ahead(count);
	_step = step;
	_tracker = tracker;
}

int Session::tries() const {
	const bool is_likely = _step == SetupStep::GO_TO_CONFIG && (!_options.has_baud || _baud_at < LIKELY_BAUDS);
	return is_likely ? LIKELY_TRIES : patience(_step).tries;
}

/// Goes on without an answer, where that is possible.
bool Session::pass_over() {
	if (_step == SetupStep::CONFIGURATION || _step == SetupStep::SET_BAUD) {
		choose_outputs();
	} else if (patience(_step).is_optional) {
		go_on();
	} else {
		return false;
	}
	return true;
}

/// Asks for as much as the line carries; a slow line is made faster once, else the rate goes down.
void Session::choose_outputs() {
	_tracker = 0;
	_exchange.note_sent_ahead(0);
	if (_device.speaks_mtdata2()) {
		go_to(SetupStep::OUTPUT_CONFIGURATION);
		return;
	}
	double rate_hz = 0.0;
	const bool may_be_raised = !_has_raised_baud && _step != SetupStep::SET_BAUD;
	switch (_choice.choose(_baud, _device, may_be_raised, rate_hz)) {
		case OutputChoice::Fit::LINE_TOO_SLOW:
			_has_raised_baud = true;
			_log.log(Severity::INFO, "%u bit/s are too slow for %d trackers at %.0f Hz: setting it to %u", _baud,
					_device.tracker_count, _options.rate_hz, FAST_BAUD);
			go_to(SetupStep::SET_BAUD);
			return;
		case OutputChoice::Fit::FEWER_SAMPLES:
			_log.log(Severity::WARNING, "%u bit/s carry %d trackers at %.0f Hz, not at %.0f", _baud,
					_device.tracker_count, rate_hz, _options.rate_hz);
			break;
		case OutputChoice::Fit::AS_WANTED:
			break;
	}
	go_to(SetupStep::OUTPUT_MODE);
}

/// The same step for the next tracker, and the next step after the last one.
SetupStep Session::step_after_tracker() {
	if (++_tracker < _device.tracker_count) {
		return _step;
	}
	_tracker = 0;
	return step_after(_step, _device);
}

void Session::begin_measuring() {
	_log.clear();
	_is_silent = false;
	_battery_usec = _now_usec;
	_measurement.begin(_device, _choice, _now_usec);
	// A false length must not hold back what comes behind it.
	_framer.set_longest(std::max<std::size_t>(_measurement.data_size(), Configuration::MAX_BYTES));
	_log.log(Severity::INFO, "%s %08X measures: %d tracker%s at %.0f Hz", device_kind_name(_device.kind), _device.id,
			_device.tracker_count, _device.tracker_count == 1 ? "" : "s", _choice.rate_hz(_device));
}

/// Begins once more after so many microseconds; with 0 as soon as a speed that was set is in force.
void Session::pause(uint64_t p_usec) {
	_step = SetupStep::PAUSE;
	_exchange.end();
	_exchange.pause_until(_now_usec + p_usec);
}

void Session::start_over(const char *p_why) {
	_log.log(Severity::WARNING, "%s: bringing it up anew", p_why);
	++_restarts;
	if (_device.kind == DeviceKind::UNKNOWN && _in_vain % 2 == 0) {
		_device.is_unknown_master = !_device.is_unknown_master;
		++_in_vain;
		pause(0);
		return;
	}
	// What does not help the first time may take its time.
	pause(PAUSE_USEC << std::min(_in_vain, 4U));
	++_in_vain;
}

void Session::fail_step() {
	if (_step == SetupStep::STOP) {
		go_to(SetupStep::STOPPED);
	} else if (_step == SetupStep::GO_TO_CONFIG) {
		next_baud();
	} else if (!pass_over()) {
		const char *name = message_name(_exchange.request().message());
		char why[80];
		snprintf(why, sizeof(why), "no answer to %s", name != nullptr ? name : "a message");
		start_over(why);
	}
}

void Session::next_baud() {
	const bool hears = _has_answered || _framer.statistics().frames > 0;
	if (_options.has_baud && !(hears && _bytes_usec + PAUSE_USEC > _now_usec && !_is_silent)) {
		_baud_at = (_baud_at + 1) % BAUDS.size();
		_baud = BAUDS[_baud_at];
		_host.set_baud(_baud);
		if (_baud_at != 0) {
			pause(0);
			return;
		}
	}
	if (!_log.has_problem()) {
		_log.log(Severity::WARNING, "does not answer%s: is the suit switched on and in reach?",
				_options.has_baud ? " at any speed" : "");
	}
	pause(PAUSE_USEC);
}

bool Session::judge(const Frame &p_frame) {
	switch (_measurement.judge(p_frame, _framer.statistics().is_noisy())) {
		case StreamCheck::Verdict::REFUSED:
			return false;
		case StreamCheck::Verdict::DATA:
			take_data();
			return true;
		default:
			take(p_frame);
			return true;
	}
}

void Session::take(const Frame &p_frame) {
	switch (p_frame.message) {
		case Message::WAKE_UP:
			wake_up();
			return;
		case Message::ERROR:
			take_error(p_frame);
			return;
		case Message::BATTERY_LEVEL:
			if (p_frame.bus_id == MASTER && p_frame.size >= 1) {
				_battery = p_frame.data[0] / 255.0;
			}
			break;
		default:
			break;
	}
	if (_step == SetupStep::PAUSE && !_options.has_baud && p_frame.message == Message::GO_TO_CONFIG_ACK) {
		// An answer that was long in transit; with a speed to be found it would be one at another speed.
		_has_answered = true;
		go_to(SetupStep::DEVICE_ID);
	} else if (_exchange.waits() && p_frame.message == _exchange.request().reply() && is_answering(p_frame.bus_id)) {
		_has_answered = true;
		_exchange.note_answer(_step, _now_usec);
		take_answer(p_frame);
	} else if (_step == SetupStep::MEASURE && _exchange.tries() > 1 && is_data(p_frame.message)) {
		// It measures already: the answer was lost.
		go_to(SetupStep::MEASURING);
	}
}

/// Whether the request may be answered by whom this identifier names: who was asked, the master in the name of
/// a tracker, or a tracker that stands alone and calls itself by a number.
bool Session::is_answering(uint8_t p_bus_id) const {
	return p_bus_id == _exchange.request().bus_id() || p_bus_id == MASTER || !_device.is_master();
}

void Session::take_answer(const Frame &p_frame) {
	switch (_step) {
		case SetupStep::STOP:
			go_to(SetupStep::STOPPED);
			return;
		case SetupStep::DEVICE_ID:
			take_device_id(p_frame);
			return;
		case SetupStep::INIT_BUS:
			take_bus(p_frame);
			return;
		case SetupStep::CONFIGURATION:
			choose_outputs();
			return;
		case SetupStep::OUTPUT_MODE:
		case SetupStep::OUTPUT_SETTINGS:
			go_to(step_after_tracker());
			return;
		case SetupStep::DATA_LENGTH:
			take_data_length(p_frame);
			return;
		default:
			go_on();
	}
}

void Session::take_device_id(const Frame &p_frame) {
	if (p_frame.size < 4) {
		return; // Asked again when the time is up.
	}
	_device.id = read_u32(p_frame.data);
	_device.kind = device_kind(_device.id);
	switch (_device.kind) {
		case DeviceKind::AWINDA_STATION:
		case DeviceKind::AWINDA_DONGLE:
		case DeviceKind::BODY_PACK:
		case DeviceKind::MTW2_MTX2:
			_log.log(Severity::WARNING,
					"%08X is %s %s: its protocol and the filter that makes its orientations are not public. Let MVN "
					"run with it and send its motion here (network streamer, UDP port 9763; here --source=mvn)",
					_device.id, _device.kind == DeviceKind::BODY_PACK ? "a" : "an", device_kind_name(_device.kind));
			go_to(SetupStep::UNSUPPORTED);
			return;
		default:
			break;
	}
	_device.tracker_count = _device.is_master() ? 0 : 1;
	_device.tracker_ids[0] = _device.id;
	go_on();
}

void Session::take_bus(const Frame &p_frame) {
	const std::size_t count = p_frame.size / 4;
	if (p_frame.size % 4 != 0 || count > std::size_t(MAX_TRACKERS)) {
		_log.log(Severity::WARNING, "names its trackers in %zu bytes, which is no list of at most %d", p_frame.size,
				MAX_TRACKERS);
		return; // Asked again when the time is up.
	}
	if (count == 0) {
		start_over("finds no tracker on its bus (look at the cables)");
		return;
	}
	for (std::size_t tracker = 0; tracker < count; ++tracker) {
		_device.tracker_ids[tracker] = read_u32(p_frame.data + 4 * tracker);
	}
	_device.tracker_count = int(count);
	_bus_failures = 0;
	go_on();
}

void Session::take_data_length(const Frame &p_frame) {
	const std::size_t expected = _choice.sample_size(_device);
	if (p_frame.size >= 2 && read_u16(p_frame.data) != expected) {
		_log.log(Severity::WARNING, "says that a sample has %u bytes; by its settings it has %zu",
				read_u16(p_frame.data), expected);
	}
	go_on();
}

void Session::take_error(const Frame &p_frame) {
	++_errors;
	const uint8_t code = p_frame.size > 0 ? p_frame.data[0] : uint8_t(0);
	const char *text = error_text(code);
	const unsigned faulty = p_frame.size > 1 ? p_frame.data[1] : 0U;
	char where[24] = "";
	if (faulty >= 1 && faulty <= unsigned(_device.tracker_count) && _device.is_master()) {
		snprintf(where, sizeof(where), ", tracker %u", faulty);
	}
	if (_step != SetupStep::STOP && !is_stopped() && _step != SetupStep::GO_TO_CONFIG) {
		_log.log(Severity::WARNING, "error %02X%s: %s", code, where, text != nullptr ? text : "unknown");
	}
	if (_exchange.waits()) {
		take_setup_error(code);
	}
}

void Session::take_setup_error(uint8_t p_code) {
	if (_step == SetupStep::INIT_BUS && p_code == ERROR_NO_BUS && !_has_powered) {
		_has_powered = true;
		go_to(SetupStep::BUS_POWER);
	} else if (_step == SetupStep::INIT_BUS) {
		if (++_bus_failures < MAX_BUS_FAILURES) {
			start_over("its bus failed");
		} else {
			_bus_failures = 0;
			start_over("its bus fails again and again (look at the cables)");
		}
	} else if (p_code == ERROR_BUS_NOT_READY && _device.is_master()) {
		go_to(SetupStep::INIT_BUS);
	} else if (_step == SetupStep::PERIOD || _step == SetupStep::MEASURE || _step == SetupStep::OUTPUT_MODE ||
			_step == SetupStep::OUTPUT_SETTINGS) {
		if (lower_demands(p_code)) {
			choose_outputs();
		} else {
			start_over("refuses its settings");
		}
	} else if (!pass_over()) {
		// Asked again when the time is up.
		_exchange.hasten(_now_usec);
	}
}

/// Asks for less the next time; false if that is the least already.
bool Session::lower_demands(uint8_t p_code) {
	switch (_choice.lower(p_code, _step == SetupStep::PERIOD)) {
		case OutputChoice::Lowered::RATE:
			_log.log(Severity::WARNING, "bears no more than %.0f Hz", _choice.outputs().rate_hz());
			return true;
		case OutputChoice::Lowered::CONTENT:
			return true;
		default:
			return false;
	}
}

void Session::take_data() {
	if (_step == SetupStep::MEASURE && _exchange.tries() > 1) {
		go_to(SetupStep::MEASURING); // The answer was lost.
	}
	if (_step != SetupStep::MEASURING) {
		return;
	}
	_in_vain = 0;
	const SuitFrame &frame = _measurement.take(_now_usec);
	if (_device.kind == DeviceKind::XBUS_MASTER || frame.tracker_count <= _device.tracker_count) {
		_host.take_frame(frame);
	}
}

void Session::wake_up() {
	// After a change of speed it is answered at the new one, when that is set.
	if (_step == SetupStep::STOP || _step == SetupStep::REBOOT || is_stopped()) {
		return;
	}
	send(host::wake_up_ack());
	if (_step == SetupStep::MEASURING) {
		++_restarts;
		_log.log(Severity::WARNING, "was switched on anew: bringing it up");
	}
	_has_answered = true;
	_has_powered = false;
	go_to(SetupStep::DEVICE_ID);
}

void Session::look_after_stream() {
	if (_measurement.refuses_many()) {
		_log.log(Severity::WARNING,
				"sends samples of another length than its settings make (%zu bytes): they are counted and dropped",
				_choice.sample_size(_device));
	}
	report_damage();
	if (_measurement.is_silent(_now_usec, _choice.rate_hz(_device))) {
		_is_silent = true;
		start_over(_measurement.has_refused_all() ? "sends nothing that can be used" : "has fallen silent");
		return;
	}
	if (_battery >= 0.0 && _now_usec > _battery_usec + BATTERY_USEC) {
		_battery_usec = _now_usec;
		send(host::request_battery_level());
	}
}

/// Tells of a line that damages bytes, by the part of the samples that is lost.
void Session::report_damage() {
	switch (_measurement.find_damage(_device, _framer.statistics().skipped_bytes, _now_usec)) {
		case StreamHealth::Finding::LINE_DAMAGES:
			_log.log(Severity::WARNING,
					"%.0f %% of its samples are lost, for the line damages bytes: look at plug and cable",
					100.0 * _measurement.lost_share());
			break;
		case StreamHealth::Finding::SAMPLES_LOST:
			_log.log(Severity::WARNING,
					"%.0f %% of its samples are lost: is this machine too busy, or a radio link too weak?",
					100.0 * _measurement.lost_share());
			break;
		case StreamHealth::Finding::WELL_AGAIN:
			_log.clear();
			break;
		case StreamHealth::Finding::NOTHING:
			break;
	}
}

} // namespace xbus
