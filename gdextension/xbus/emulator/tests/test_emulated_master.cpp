// SPDX-License-Identifier: MIT
// What the emulated devices answer, in simulated time.
#include "bench_host.hpp"
#include "bus/mt_data.hpp"
#include "check.hpp"

namespace test_emulated_master {

using emulator::SECOND;
using xbus::MASTER;
using xbus::Message;

namespace {

bool is_error(const BenchHost::Message &p_answer, uint8_t p_code) {
	return p_answer.message == Message::ERROR && !p_answer.data.empty() && p_answer.data[0] == p_code;
}

std::vector<int> counters(const BenchHost &p_host) {
	std::vector<int> found;
	for (const BenchHost::Message &one : p_host.received) {
		if (one.message == Message::MT_DATA) {
			found.push_back(xbus::read_u16(one.data.data()));
		}
	}
	return found;
}

} // namespace

TEST(a_device_says_that_it_woke_up_and_takes_the_answer) {
	BenchHost host({ "--devices=native", "--sensors=2" });
	host.read(SECOND / 10);
	CHECK(host.received.size() == 1 && host.received[0].message == Message::WAKE_UP);
	host.send(MASTER, Message::WAKE_UP_ACK);
	host.read(1000);
	CHECK(host.device().device->state() == emulator::XbusDevice::State::CONFIG);
}

TEST(a_tracker_alone_measures_by_itself_after_half_a_second) {
	BenchHost host({ "--devices=mti" });
	host.read(SECOND / 2 - 1000);
	CHECK(host.received.size() == 1);
	host.read(SECOND);
	CHECK(host.received[1].message == Message::CONFIGURATION);
	CHECK(host.received[1].data.size() == 118);
	CHECK(host.received[2].message == Message::MT_DATA2);
}

TEST(the_bus_must_be_searched_before_anything_is_asked_of_it) {
	BenchHost host({ "--devices=native", "--sensors=3" });
	host.ask(MASTER, Message::GO_TO_CONFIG);
	CHECK(is_error(host.ask(MASTER, Message::GO_TO_MEASUREMENT), 0x02));
	CHECK(is_error(host.ask(1, Message::SET_OUTPUT_MODE, { 0, 4 }), 0x02));
	const BenchHost::Message found = host.ask(MASTER, Message::INIT_BUS);
	CHECK(found.message == Message::INIT_BUS_RESULTS && found.data.size() == 12);
	CHECK(host.ask(1, Message::SET_OUTPUT_MODE, { 0, 4 }).message == Message::SET_OUTPUT_MODE_ACK);
	CHECK(is_error(host.ask(4, Message::SET_OUTPUT_MODE, { 0, 4 }), 0x21));
	CHECK(host.ask(MASTER, Message::GO_TO_MEASUREMENT).message == Message::GO_TO_MEASUREMENT_ACK);
}

TEST(a_bus_without_power_finds_nobody) {
	BenchHost host({ "--devices=native", "--sensors=3", "--bus-power=off" });
	host.ask(MASTER, Message::GO_TO_CONFIG);
	CHECK(is_error(host.ask(MASTER, Message::INIT_BUS), 0x01));
	CHECK(host.ask(MASTER, Message::BUS_POWER).data == std::vector<uint8_t>({ 0, 0 }));
	CHECK(host.ask(MASTER, Message::BUS_POWER, { 0, 1 }).message == Message::BUS_POWER_ACK);
	CHECK(host.ask(MASTER, Message::INIT_BUS).message == Message::INIT_BUS_RESULTS);
}

TEST(periods_have_limits) {
	BenchHost host({ "--devices=native" });
	host.ask(MASTER, Message::GO_TO_CONFIG);
	CHECK(is_error(host.ask(MASTER, Message::SET_PERIOD, { 0, 224 }), 0x03));
	CHECK(is_error(host.ask(MASTER, Message::SET_PERIOD, { 0x2D, 0x01 }), 0x03));
	CHECK(host.ask(MASTER, Message::SET_PERIOD, { 0x09, 0x00 }).message == Message::SET_PERIOD_ACK);
	CHECK(host.ask(MASTER, Message::SET_PERIOD).data == std::vector<uint8_t>({ 0x09, 0x00 }));
}

TEST(unknown_messages_and_wrong_sizes_are_refused) {
	BenchHost host({ "--devices=native" });
	host.bring_up();
	CHECK(is_error(host.ask(MASTER, Message::SET_PERIOD, { 4, 0x80 }), 0x04)); // It measures.
	host.ask(MASTER, Message::GO_TO_CONFIG);
	CHECK(is_error(host.ask(MASTER, Message(0x5E)), 0x04));
	CHECK(is_error(host.ask(MASTER, Message::SET_PERIOD, { 4 }), 0x04));
	CHECK(is_error(host.ask(1, Message::SET_OUTPUT_MODE, { 0x40, 0x04 }), 0x21));
	CHECK(is_error(host.ask(MASTER, Message::SET_BAUD_RATE, { 0x55 }), 0x20));
}

TEST(samples_come_at_the_period_with_the_counter_in_front) {
	BenchHost host({ "--devices=native", "--sensors=16", "--first-counter=65500" });
	host.bring_up();
	host.read(SECOND);
	const std::vector<int> found = counters(host);
	CHECK(found.size() >= 99 && found.size() <= 101);
	for (std::size_t i = 1; i < found.size(); i++) {
		CHECK(found[i] == (found[i - 1] + 1) % 65536);
	}
	// 16 trackers with calibrated data and quaternions: the extended form.
	CHECK(host.received.back().data.size() == 2 + 16 * 52);
}

TEST(reported_lengths_are_those_that_come) {
	BenchHost host({ "--devices=native", "--sensors=4" });
	host.ask(MASTER, Message::GO_TO_CONFIG);
	host.ask(MASTER, Message::INIT_BUS);
	xbus::OutputFormat format;
	for (const uint16_t mode : { 0x0001, 0x0002, 0x0004, 0x0006, 0x000E, 0x0837, 0x4000 }) {
		for (const uint32_t settings : { 0x000U, 0x104U, 0x208U, 0x3F1U, 0xC10U }) {
			format = { mode, settings };
			host.ask(1, Message::SET_OUTPUT_MODE, { uint8_t(mode >> 8U), uint8_t(mode) });
			host.ask(1, Message::SET_OUTPUT_SETTINGS, { 0, 0, uint8_t(settings >> 8U), uint8_t(settings) });
			const BenchHost::Message length = host.ask(1, Message::REQ_DATA_LENGTH);
			CHECK(xbus::read_u16(length.data.data()) == format.size_behind_master());
		}
	}
	host.ask(MASTER, Message::GO_TO_MEASUREMENT);
	host.read(SECOND / 10);
	CHECK(host.received.back().data.size() == 2 + format.size_behind_master() + 3 * 52);
}

TEST(a_message_is_cut_short_by_the_way_back_to_config) {
	BenchHost host({ "--devices=native", "--sensors=4" });
	host.bring_up();
	host.read(SECOND / 10);
	const uint64_t skipped = host.framer.statistics().skipped_bytes;
	CHECK(host.ask(MASTER, Message::GO_TO_CONFIG).message == Message::GO_TO_CONFIG_ACK);
	CHECK(host.framer.statistics().skipped_bytes > skipped + 50);
}

TEST(a_reset_forgets_the_bus_and_takes_its_time) {
	BenchHost host({ "--devices=native" });
	host.bring_up();
	CHECK(host.ask(MASTER, Message::RESET).message == Message::RESET_ACK);
	host.received.clear();
	host.read(SECOND / 2);
	CHECK(host.received.empty());
	host.read(SECOND / 2);
	CHECK(!host.received.empty() && host.received[0].message == Message::WAKE_UP);
	host.ask(MASTER, Message::GO_TO_CONFIG);
	CHECK(is_error(host.ask(MASTER, Message::GO_TO_MEASUREMENT), 0x02));
}

TEST(faults_are_as_ordered) {
	BenchHost host({ "--devices=native", "--errors=d0:21,04:28", "--sensors=2", "--error-every=10", "--lie=2:5" });
	host.ask(MASTER, Message::GO_TO_CONFIG);
	CHECK(is_error(host.ask(MASTER, Message::SET_PERIOD), 0x28));
	host.ask(MASTER, Message::INIT_BUS);
	CHECK(is_error(host.ask(1, Message::SET_OUTPUT_MODE, { 0, 4 }), 0x21));
	host.ask(MASTER, Message::GO_TO_MEASUREMENT);
	host.received.clear();
	host.read(SECOND);
	std::size_t errors = 0;
	for (const BenchHost::Message &one : host.received) {
		errors += one.message == Message::ERROR ? 1 : 0;
		CHECK(one.message == Message::ERROR || one.data.size() == 2 + 2 * 52 + 5);
	}
	CHECK(errors >= 9 && errors <= 11);
	bool is_known = false;
	host.suit.command("mute", host.now, is_known);
	CHECK(is_known);
	host.ask(MASTER, Message::GO_TO_CONFIG);
	CHECK(host.device().device->state() == emulator::XbusDevice::State::MEASUREMENT);
}

TEST(the_wearer_begins_a_moment_after_the_suit_measures) {
	BenchHost host({ "--devices=two-masters", "--sensors=4" });
	host.read(SECOND);
	emulator::XbusDevice &other = *host.suit.devices().back().device;
	CHECK_NEAR(host.device().device->motion_time(host.now), 0.0, 1e-9);
	host.bring_up();
	CHECK_NEAR(host.device().device->motion_time(host.now), 0.0, 1e-9);
	host.read(2 * SECOND);
	const double time = host.device().device->motion_time(host.now);
	CHECK(time > 0.6 && time < 1.2);
	CHECK_NEAR(other.motion_time(host.now), time, 1e-9);
	bool is_known = false;
	host.suit.command("hold", host.now, is_known);
	host.read(SECOND);
	CHECK_NEAR(other.motion_time(host.now), time, 1e-9);
	host.suit.command("motion 5.5", host.now, is_known);
	CHECK_NEAR(other.motion_time(host.now + SECOND), 6.5, 1e-9);
	BenchHost held({ "--devices=native", "--hold" });
	held.bring_up();
	held.read(SECOND);
	CHECK_NEAR(held.device().device->motion_time(held.now), 0.0, 1e-9);
}

TEST(options_say_what_is_wrong_with_them) {
	for (const char *option : { "--sensors=0", "--sensors=x", "--corrupt=2", "--nonsense", "--instant=1", "word",
				 "--errors=zz:1", "--swap=1", "--bus-power=maybe", "--baud=1e9", "--seed=-1", "--sensors=1.5" }) {
		emulator::SuitOptions options;
		CHECK(!options.parse({ option }).empty());
	}
	for (const char *option : { "--devices=toaster", "--sensors=30", "--limbs=tail", "--lie=40:1" }) {
		CHECK(!BenchHost({ option }, false).suit.error().empty());
	}
	for (const char *kind : { "--devices=two-masters", "--devices=two-native-masters" }) {
		CHECK(BenchHost({ kind, "--sensors=30" }).suit.devices().size() == 2);
	}
}

} // namespace test_emulated_master
