// SPDX-License-Identifier: MIT
// Sessions with emulated suits: from any state to measuring, and back there after whatever happens.
#include "bus/bytes.hpp"
#include "bus/encoder.hpp"
#include "suit_rig.hpp"

#include "check.hpp"

namespace test_session {

namespace {

using xbus::SessionState;

std::vector<std::string> with(std::initializer_list<std::string> p_more) {
	std::vector<std::string> options = { "--sensors=15", "--seed=3" };
	options.insert(options.end(), p_more);
	return options;
}

/// A master with two trackers that follows the protocol in its own way.
class OddMaster final : public xbus::SessionHost {
public:
	/// How late it answers, µs; whether it answers for its trackers; whether it says that it measures.
	uint64_t delay_usec = 0;
	bool answers_for_trackers = false;
	bool is_mute_at_start = false;
	uint64_t frames = 0;
	/// What it was asked.
	std::vector<xbus::Message> asked;

	bool send(const uint8_t *p_bytes, std::size_t p_size) override {
		_asked.feed(p_bytes, p_size, [this](const xbus::Frame &p_frame) { answer(p_frame); });
		return true;
	}
	void set_baud(uint32_t) override {}
	void take_frame(const xbus::SuitFrame &) override { ++frames; }
	void say(xbus::Severity, const char *) override {}

	void run(double p_seconds) {
		xbus::Session session(xbus::SessionOptions(), *this);
		session.open(_now);
		for (const uint64_t end = _now + uint64_t(p_seconds * 1e6); _now < end; _now += 1000) {
			if (_measures && _now % 10000 == 0) {
				measure();
			}
			while (!_answers.empty() && _answers.front().first <= _now) {
				const std::vector<uint8_t> bytes = _answers.front().second;
				_answers.erase(_answers.begin());
				session.take_bytes(bytes.data(), bytes.size(), _now);
			}
			session.advance(_now);
		}
		session.stop(_now);
	}

private:
	void say_later(uint8_t p_bus_id, xbus::Message p_message, const std::vector<uint8_t> &p_data, uint64_t p_delay) {
		std::vector<uint8_t> bytes(p_data.size() + 7);
		bytes.resize(xbus::write_frame(p_bus_id, p_message, p_data.data(), p_data.size(), bytes.data()));
		_answers.emplace_back(_now + p_delay, bytes);
	}

	void answer(const xbus::Frame &p_frame) {
		using xbus::Message;
		std::vector<uint8_t> data;
		asked.push_back(p_frame.message);
		_measures = p_frame.message == Message::GO_TO_MEASUREMENT;
		if (p_frame.message == Message::REQ_DEVICE_ID) {
			data = { 0x00, 0x10, 0x00, 0x01 };
		} else if (p_frame.message == Message::INIT_BUS) {
			data = { 0x00, 0x30, 0x00, 0x01, 0x00, 0x30, 0x00, 0x02 };
		} else if (p_frame.message == Message::REQ_CONFIGURATION || p_frame.message == Message::REQ_DATA_LENGTH ||
				p_frame.message == Message::REQ_BATTERY_LEVEL || (_measures && is_mute_at_start)) {
			return;
		}
		const uint8_t bus_id = answers_for_trackers ? xbus::MASTER : p_frame.bus_id;
		say_later(bus_id, Message(uint8_t(p_frame.message) + 1), data, delay_usec);
	}

	void measure() {
		std::vector<uint8_t> data = { uint8_t(_counter >> 8U), uint8_t(_counter) };
		++_counter;
		for (int tracker = 0; tracker < 2; ++tracker) {
			data.resize(data.size() + 36);
			data.insert(data.end(), { 0x3F, 0x80, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0 });
		}
		say_later(xbus::MASTER, xbus::Message::MT_DATA, data, 0);
	}

	xbus::Framer _asked;
	std::vector<std::pair<uint64_t, std::vector<uint8_t>>> _answers;
	uint64_t _now = 1000000;
	uint16_t _counter = 0;
	bool _measures = false;
};

} // namespace

TEST(a_master_with_ways_of_its_own_is_brought_up) {
	for (const uint64_t delay : { 0U, 100000U, 300000U, 400000U, 500000U, 600000U, 700000U }) {
		OddMaster master;
		master.delay_usec = delay;
		master.run(8.0);
		CHECK(master.frames > 200);
	}
	OddMaster speaker;
	speaker.answers_for_trackers = true;
	speaker.run(6.0);
	CHECK(speaker.frames > 200);
	OddMaster quiet;
	quiet.is_mute_at_start = true;
	quiet.run(6.0);
	CHECK(quiet.frames > 100);
}

TEST(a_slow_master_is_told_at_once_to_stop_whenever_that_is) {
	for (int tenths = 10; tenths < 60; ++tenths) {
		OddMaster master;
		master.delay_usec = 400000;
		master.run(tenths / 10.0);
		CHECK(master.asked.back() == xbus::Message::GO_TO_CONFIG);
	}
}

TEST(a_whole_suit_that_answers_late_is_up_soon) {
	for (const char *kind : { "ftdi", "ftdi-fast", "native", "mti", "mti-ftdi" }) {
		for (const char *delay : { "300", "400", "500", "600", "700" }) {
			SuitRig rig({ std::string("--devices=") + kind, "--sensors=17", std::string("--answer-delay=") + delay });
			CHECK(rig.fault.empty());
			CHECK(rig.measures_within(5.0));
			rig.run(2.0);
			CHECK(rig.frames > 150);
		}
	}
}

TEST(a_master_of_an_unknown_kind_is_brought_up) {
	for (const char *id : { "00800001", "00900001", "00F00001", "00000001" }) {
		for (const char *kind : { "ftdi", "native" }) {
			SuitRig rig(with({ std::string("--devices=") + kind, std::string("--master-id=") + id }));
			CHECK(rig.fault.empty());
			CHECK(rig.measures_within(5.0));
			rig.run(2.0);
			CHECK(rig.frames > 150);
			CHECK(rig.report().trackers.size() == 15);
		}
	}
}

TEST(a_line_that_loses_samples_is_told_of) {
	SuitRig rig(with({ "--devices=ftdi", "--corrupt=0.0003" }));
	CHECK(rig.measures_within(5.0));
	rig.run(20.0);
	CHECK(rig.report().lost_share > 0.01);
	CHECK(rig.report().problem.find("% of its samples are lost, for the line damages bytes") != std::string::npos);
	(void)rig.command("corrupt 0");
	rig.run(11.0);
	CHECK(rig.report().lost_share < 0.01);
	CHECK(rig.report().problem.empty());
}

TEST(a_suit_is_brought_up_as_xsens_own_host_does_it) {
	SuitRig rig(with({ "--devices=ftdi" }));
	CHECK(rig.fault.empty());
	CHECK(rig.measures_within(3.0));
	const xbus::SessionReport report = rig.report();
	CHECK(report.kind == xbus::DeviceKind::XBUS_MASTER);
	CHECK(report.trackers.size() == 15);
	CHECK(report.baud == 460800);
	CHECK(report.battery > 0.8 && report.battery <= 1.0);
	rig.run(2.0);
	CHECK(rig.frames > 190);
	CHECK(rig.last.tracker_count == 15);
	for (int tracker = 0; tracker < 15; ++tracker) {
		CHECK(rig.last.trackers[std::size_t(tracker)].has_orientation);
	}
	// Each step once, in the order of the table in docs/suits.md.
	CHECK(rig.logged("InitBus") == 1);
	CHECK(rig.logged("ReqConfiguration") == 1);
	CHECK(rig.logged("SetOutputMode") == 15);
	CHECK(rig.logged("SetOutputSettings") == 15);
	CHECK(rig.logged("SetPeriod") == 1);
	CHECK(rig.logged("GoToMeasurement") == 1);
	CHECK(rig.report().problem.empty());
}

TEST(every_kind_of_device_comes_up_with_as_much_as_its_line_bears) {
	for (const char *kind : { "ftdi", "ftdi-fast", "native", "mti", "mti-ftdi" }) {
		SuitRig rig(with({ std::string("--devices=") + kind }));
		CHECK(rig.measures_within(4.0));
		rig.run(1.5);
		CHECK(rig.frames > 140);
		CHECK(rig.last.trackers[0].has_orientation);
		// Nothing is in the way of rates and accelerations where there is no serial line.
		if (std::string(kind) == "native") {
			CHECK(rig.last.trackers[14].has_rate && rig.last.trackers[14].has_acceleration);
		}
	}
}

TEST(an_hour_passes_without_a_loss) {
	SuitRig rig(with({ "--devices=ftdi", "--first-counter=65000" }));
	CHECK(rig.measures_within(3.0));
	// What came before the line's speed was set is noise.
	const uint64_t noise = rig.report().framer.skipped_bytes;
	uint64_t expected = 0;
	uint64_t gaps = 0;
	rig.on_frame = [&](const xbus::SuitFrame &p_frame) {
		gaps += expected != 0 && p_frame.counter != expected ? 1U : 0U;
		expected = p_frame.counter + 1;
	};
	rig.run(3600.0);
	CHECK(rig.frames > 359900);
	CHECK(gaps == 0);
	const xbus::SessionReport report = rig.report();
	CHECK(report.framer.skipped_bytes == noise);
	CHECK(report.restarts == 0);
	for (const xbus::TrackerReport &tracker : report.trackers) {
		CHECK(tracker.samples.lost == 0);
		CHECK_NEAR(tracker.flow.rate_hz, 100.0, 1.0);
	}
}

TEST(sample_times_have_no_jitter_of_the_bus) {
	SuitRig rig(with({ "--devices=ftdi" }));
	CHECK(rig.measures_within(3.0));
	rig.run(1.0);
	uint64_t before = 0;
	double worst = 0.0;
	rig.on_frame = [&](const xbus::SuitFrame &p_frame) {
		if (before != 0) {
			worst = std::max(worst, std::abs(double(p_frame.time_usec - before) - 10000.0));
		}
		before = p_frame.time_usec;
		CHECK(p_frame.time_usec <= p_frame.arrival_usec);
	};
	rig.run(10.0);
	CHECK(worst < 50.0);
}

TEST(a_slow_line_is_made_faster_and_one_that_stays_slow_gets_a_lower_rate) {
	SuitRig fast(with({ "--devices=ftdi", "--baud=115200" }));
	CHECK(fast.measures_within(5.0));
	CHECK(fast.report().baud == 460800);
	CHECK_NEAR(fast.report().rate_hz, 100.0, 0.1);
	SuitRig slow(with({ "--devices=ftdi", "--baud=115200", "--errors=18:20" }));
	CHECK(slow.measures_within(8.0));
	CHECK(slow.report().baud == 115200);
	CHECK(slow.report().rate_hz >= 20.0 && slow.report().rate_hz <= 50.0);
	CHECK(slow.has_said("115200 bit/s carry 15 trackers at"));
	slow.frames = 0;
	slow.run(4.0);
	CHECK(double(slow.frames) > 3.9 * slow.report().rate_hz);
}

TEST(errors_are_reported_and_what_can_be_done_about_them_is_done) {
	SuitRig unpowered(with({ "--devices=ftdi", "--bus-power=off" }));
	CHECK(unpowered.measures_within(6.0));
	CHECK(unpowered.logged("BusPower") >= 1);
	// Every message that is refused once and for all: it measures with less, or says why not.
	for (const char *refused : { "02:10", "0c:04", "0a:04", "88:04", "d0:21", "d2:21", "04:03", "10:1d" }) {
		SuitRig rig(with({ "--devices=ftdi", std::string("--errors=") + refused }));
		const bool measures = rig.measures_within(20.0);
		CHECK(measures || rig.has_said("error"));
		CHECK(measures || !rig.report().problem.empty());
	}
	// Those without which it can measure do not stop it.
	for (const char *refused : { "0c:04", "0a:04", "88:04" }) {
		SuitRig rig(with({ "--devices=ftdi", std::string("--errors=") + refused }));
		CHECK(rig.measures_within(4.0));
	}
	SuitRig noisy(with({ "--devices=ftdi", "--error-every=50" }));
	CHECK(noisy.measures_within(4.0));
	noisy.run(5.0);
	CHECK(noisy.report().errors >= 8);
	CHECK(noisy.report().restarts == 0);
	CHECK(noisy.said.size() < 8); // The same is said once.
}

TEST(a_damaged_line_does_not_keep_it_from_measuring) {
	SuitRig rig(with({ "--devices=ftdi", "--corrupt=0.001", "--drop=0.0005" }));
	CHECK(rig.measures_within(20.0));
	rig.frames = 0;
	rig.run(20.0);
	// 0.9985 to the power of 247 bytes: two thirds of the frames are whole.
	CHECK(rig.frames > 1150);
	CHECK(rig.report().framer.skipped_bytes > 0);
	for (const xbus::TrackerReport &tracker : rig.report().trackers) {
		CHECK(tracker.samples.lost > 100);
	}
}

TEST(a_configuration_that_never_comes_is_done_without) {
	for (const char *seed : { "1", "2", "3", "4", "5", "6" }) {
		SuitRig rig({ "--sensors=15", "--devices=ftdi", "--drop=0.002", std::string("--seed=") + seed });
		CHECK(rig.measures_within(15.0));
		CHECK(rig.logged("SetOutputMode 0000") == 0);
		CHECK(rig.logged("SetPeriod 0000") == 0);
	}
}

TEST(a_dead_tracker_does_not_slow_the_others_down) {
	SuitRig rig(with({ "--devices=ftdi", "--dead=2" }));
	rig.run(12.0);
	CHECK(rig.has_said("tracker 2"));
	CHECK(!rig.has_said("bears no more"));
}

TEST(a_suit_that_is_switched_on_off_and_on_again_comes_back) {
	SuitRig rig(with({ "--devices=ftdi" }));
	CHECK(rig.measures_within(3.0));
	rig.suit->devices()[0].device->power(false, rig.now);
	rig.run(3.0);
	CHECK(rig.session->state() == SessionState::SILENT);
	CHECK(rig.has_said("has fallen silent"));
	rig.suit->devices()[0].device->power(true, rig.now);
	CHECK(rig.measures_within(12.0));
	rig.frames = 0;
	rig.run(1.0);
	CHECK(rig.frames > 90);
}

TEST(a_suit_that_freezes_is_brought_up_anew) {
	SuitRig rig(with({ "--devices=ftdi" }));
	CHECK(rig.measures_within(3.0));
	CHECK(rig.command("freeze").empty());
	rig.run(3.0);
	CHECK(rig.session->state() != SessionState::MEASURING || rig.report().restarts > 0);
	CHECK(rig.command("thaw").empty());
	rig.run(10.0);
	CHECK(rig.session->state() == SessionState::MEASURING);
}

TEST(a_device_that_does_not_answer_is_reported_and_found_later) {
	SuitRig rig(with({ "--devices=ftdi", "--mute" }));
	CHECK(!rig.measures_within(6.0));
	CHECK(rig.has_said("does not answer at any speed"));
	CHECK(rig.said.size() == 1);
	CHECK(rig.command("speak").empty());
	CHECK(rig.measures_within(12.0));
}

TEST(a_tracker_that_lies_about_its_length_is_reported) {
	SuitRig rig(with({ "--devices=ftdi", "--lie=3:5" }));
	rig.run(6.0);
	CHECK(rig.has_said("sends samples of another length"));
	CHECK(!rig.has_said("silent"));
	CHECK(rig.frames == 0);
	CHECK(rig.report().framer.refused_frames > 0);
	CHECK(rig.said.size() < 20);
}

TEST(awinda_is_recognised_and_honestly_answered) {
	SuitRig rig(with({ "--devices=awinda" }));
	rig.run(3.0);
	CHECK(rig.session->state() == SessionState::UNSUPPORTED);
	CHECK(rig.has_said("MVN"));
}

TEST(a_stop_leaves_the_suit_at_rest) {
	SuitRig rig(with({ "--devices=ftdi" }));
	CHECK(rig.measures_within(3.0));
	rig.session->stop(uint64_t(rig.now));
	rig.run(1.0);
	CHECK(rig.session->is_stopped());
	CHECK(rig.suit->devices()[0].device->state() == emulator::XbusDevice::State::CONFIG);
}

} // namespace test_session
