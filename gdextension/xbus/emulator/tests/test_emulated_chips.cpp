// SPDX-License-Identifier: MIT
// What the emulated USB chips do, in simulated time.
#include "bench_host.hpp"
#include "check.hpp"

#include <cerrno>

namespace test_emulated_chips {

using emulator::FtdiChip;
using emulator::SECOND;
using emulator::Usec;
using xbus::MASTER;
using xbus::Message;

TEST(divisors_are_those_of_the_kernel_s_driver) {
	const std::pair<uint16_t, uint32_t> known[] = { { 0x4138, 9600 }, { 0xC034, 57554 }, { 0x001A, 115385 },
		{ 0x000D, 230769 }, { 0x4006, 461538 }, { 0x8003, 923077 } };
	for (const auto &[divisor, baud] : known) {
		CHECK(FtdiChip::baud_of_divisor(divisor, 0, false) == baud);
	}
	CHECK(FtdiChip::baud_of_divisor(0x0000, 0, false) == 3000000);
	CHECK(FtdiChip::baud_of_divisor(0x0001, 0, false) == 2000000);
	// 12 MHz / 13, as the chips with an H have it.
	CHECK(FtdiChip::baud_of_divisor(0x000D, 0x0200, true) == 923077);
}

TEST(a_chip_that_has_nothing_says_so_once_a_latency_period) {
	BenchHost host({ "--devices=ftdi" });
	host.ask(MASTER, Message::GO_TO_CONFIG);
	host.packets.clear();
	host.read(SECOND);
	CHECK_NEAR(double(host.packets.size()), 62.5, 1.0);
	CHECK(host.packets.back() == std::vector<uint8_t>({ 0x31, 0x60 }));
	CHECK(host.control(0x40, 9, 1) == 0);
	CHECK(host.control(0xC0, 10, 0, 0, 1) == 1 && host.answer[0] == 1);
	host.packets.clear();
	host.read(SECOND);
	CHECK_NEAR(double(host.packets.size()), 1000.0, 2.0);
}

TEST(every_packet_has_two_bytes_of_status) {
	for (const char *kind : { "--devices=ftdi", "--devices=ftdi-fast" }) {
		BenchHost host({ kind, "--sensors=16", "--instant" });
		host.bring_up();
		const uint64_t skipped = host.framer.statistics().skipped_bytes;
		host.read(SECOND);
		CHECK(host.received.size() >= 99);
		CHECK(host.framer.statistics().skipped_bytes == skipped);
	}
}

TEST(bytes_take_their_time_on_the_line) {
	BenchHost host({ "--devices=ftdi", "--sensors=6" });
	host.bring_up();
	host.read(SECOND);
	CHECK(host.device().traces().size() >= 99);
	const Usec expected = (2 + 6 * 52 + 7) * SECOND * 10 / 461538;
	for (const emulator::SampleTrace &trace : host.device().traces()) {
		CHECK_NEAR(double(trace.on_chip - trace.sampled), double(expected), 2.0);
		// The rest of a message waits for the latency timer at most.
		CHECK(trace.handed_over >= trace.on_chip && trace.handed_over - trace.on_chip <= 1001);
	}
}

TEST(a_line_too_slow_for_the_samples_loses_some_and_says_so) {
	BenchHost host({ "--devices=ftdi", "--sensors=15", "--baud=115200" });
	host.control(0x40, 9, 1);
	host.control(0x40, 3, 0x001A);
	host.ask(MASTER, Message::GO_TO_CONFIG);
	host.ask(MASTER, Message::INIT_BUS);
	host.ask(MASTER, Message::GO_TO_MEASUREMENT);
	host.received.clear();
	host.read(10 * SECOND);
	std::size_t errors = 0;
	std::size_t samples = 0;
	for (const BenchHost::Message &one : host.received) {
		errors += one.message == Message::ERROR && one.data[0] == 0x2A ? 1 : 0;
		samples += one.message == Message::MT_DATA ? 1 : 0;
	}
	CHECK(errors > 10);
	CHECK(samples > 100 && samples < 160); // 789 bytes each, 11.5 kB/s.
}

TEST(the_wrong_speed_gives_nothing_but_garbage) {
	BenchHost host({ "--devices=ftdi" });
	host.control(0x40, 3, 0x001A);
	CHECK(host.ask(MASTER, Message::GO_TO_CONFIG).data.empty());
	CHECK(host.device().device->state() != emulator::XbusDevice::State::CONFIG || host.received.empty());
	host.control(0x40, 3, 0x4006);
	CHECK(host.ask(MASTER, Message::GO_TO_CONFIG).message == Message::GO_TO_CONFIG_ACK);
}

TEST(who_does_not_read_loses_bytes_and_is_notified) {
	BenchHost host({ "--devices=ftdi" });
	host.bring_up();
	host.read(SECOND / 10);
	host.port().discard_all(-ENOENT);
	while (host.port().take_completed() != nullptr) {
	}
	host.waiting = 0;
	host.port().advance(host.now);
	for (int i = 0; i < 100; i++) {
		host.now += 10000;
		host.port().advance(host.now);
	}
	host.packets.clear();
	host.read(2000);
	CHECK((host.packets.front()[1] & 0x02U) != 0);
	CHECK((host.packets.back()[1] & 0x02U) == 0);
}

TEST(a_purge_drops_what_the_chip_has) {
	BenchHost host({ "--devices=ftdi" });
	host.now += SECOND / 10;
	host.port().advance(host.now);
	CHECK(host.control(0x40, 0, 1) == 0);
	host.read(SECOND / 10);
	CHECK(host.received.empty()); // No WakeUp: it was purged.
}

TEST(unknown_requests_are_refused) {
	BenchHost ftdi({ "--devices=ftdi" });
	CHECK(ftdi.control(0x40, 0x77, 0) == emulator::USB_STALL);
	CHECK(ftdi.control(0xC0, 0x90, 0, 2, 2) == 2 && ftdi.answer == std::vector<uint8_t>({ 0x8B, 0xD3 }));
	BenchHost native({ "--devices=native" });
	CHECK(native.control(0x40, 0x00, 0) == emulator::USB_STALL);
	// The standard ones are answered by any device: 18 bytes of descriptor, a serial number.
	CHECK(native.control(0x80, 6, 0x0100, 0, 64) == 18);
	CHECK(native.control(0x80, 6, 0x0303, 0, 255) == 18 && native.answer[2] == '0');
}

TEST(a_stall_lasts_until_it_is_cleared) {
	BenchHost host({ "--devices=native" });
	host.bring_up();
	host.read(SECOND / 10);
	host.device().native->halt();
	host.statuses.clear();
	host.now += 1000;
	host.port().advance(host.now);
	host.read(1);
	CHECK(!host.statuses.empty() && host.statuses.front() == -EPIPE);
	CHECK(host.control(0x02, 1, 0, emulator::NativeChip::IN) == 0);
	host.received.clear();
	host.read(SECOND / 10);
	CHECK(!host.received.empty());
}

TEST(a_pulled_cable_ends_every_transfer) {
	BenchHost host({ "--devices=ftdi" });
	host.bring_up();
	host.read(SECOND / 10);
	const std::size_t waiting = host.waiting;
	CHECK(waiting > 0);
	host.port().plug(false, host.now);
	for (std::size_t i = 0; i < waiting; i++) {
		const std::unique_ptr<emulator::Urb> done = host.port().take_completed();
		CHECK(done != nullptr && done->status == -ESHUTDOWN);
	}
	CHECK(host.port().submit(std::make_unique<emulator::Urb>(), host.now) == -ENODEV);
	CHECK(host.port().next_event() == emulator::NEVER);
	host.waiting = 0;
	host.port().plug(true, host.now);
	host.received.clear();
	host.control(0x40, 3, 0x4006);
	host.read(SECOND / 10);
	CHECK(host.ask(MASTER, Message::GO_TO_CONFIG).message == Message::GO_TO_CONFIG_ACK);
}

TEST(bytes_are_corrupted_as_often_as_ordered) {
	BenchHost host({ "--devices=native", "--sensors=16", "--corrupt=0.001" });
	host.bring_up();
	host.read(20 * SECOND);
	// 841 bytes each: 57 % of the messages have a wrong byte.
	CHECK(host.received.size() > 600 && host.received.size() < 1150);
}

} // namespace test_emulated_chips
