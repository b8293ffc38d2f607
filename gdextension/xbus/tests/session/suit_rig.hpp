// SPDX-License-Identifier: MIT
#pragma once

#include "session/session.hpp"
#include "suit/suit.hpp"
#include "usb/ftdi_protocol.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

/// A session on one end and an emulated suit with its USB chip on the other, in a time of their own.
class SuitRig final : public xbus::SessionHost {
public:
	explicit SuitRig(const std::vector<std::string> &p_options, double p_rate_hz = 100.0) {
		emulator::SuitOptions options;
		fault = options.parse(p_options);
		const auto limbs = std::size_t(std::max(options.sensors, 1));
		suit = std::make_unique<emulator::Suit>(
				options, emulator::MotionStream::still(limbs), [this] { return now; },
				[this](emulator::Usec, std::size_t, const std::string &p_text) { log.push_back(p_text); });
		fault += suit->error();
		emulator::SuitDevice &device = suit->devices()[0];
		device.chip->plug(true, now);
		suit->begin(now);
		xbus::SessionOptions session_options;
		session_options.rate_hz = p_rate_hz;
		session_options.has_baud = device.ftdi != nullptr;
		if (device.ftdi != nullptr) {
			control(usb::ftdi::LATENCY_TIMER, 1);
			control(usb::ftdi::DATA_FORMAT, usb::ftdi::FORMAT_8N2);
			control(usb::ftdi::MODEM_CONTROL, usb::ftdi::DTR_RTS_ON);
		}
		session = std::make_unique<xbus::Session>(session_options, *this);
		session->open(uint64_t(now));
	}

	/// Lets so many seconds pass.
	void run(double p_seconds) {
		const emulator::Usec end = now + emulator::Usec(p_seconds * 1e6);
		while (now < end) {
			now += STEP_USEC;
			suit->advance(now);
			read();
			set_waiting_baud();
			session->advance(uint64_t(now));
		}
	}

	/// Lets time pass until it measures; whether it does within so many seconds.
	bool measures_within(double p_seconds) {
		for (int step = 0; step < int(p_seconds * 100.0); ++step) {
			if (session->state() == xbus::SessionState::MEASURING) {
				return true;
			}
			run(0.01);
		}
		return false;
	}

	std::string command(const std::string &p_line) {
		bool is_known = false;
		return suit->command(p_line, now, is_known);
	}

	xbus::SessionReport report() const {
		xbus::SessionReport result;
		session->report(uint64_t(now), result);
		return result;
	}

	/// Whether something with these words was said, or is the trouble now.
	bool has_said(const std::string &p_words) const {
		return std::any_of(said.begin(), said.end(),
				[&](const std::string &p_text) { return p_text.find(p_words) != std::string::npos; });
	}

	/// How often the suit noted something with these words.
	int logged(const std::string &p_words) const {
		return int(std::count_if(log.begin(), log.end(),
				[&](const std::string &p_text) { return p_text.find(p_words) != std::string::npos; }));
	}

	bool send(const uint8_t *p_bytes, std::size_t p_size) override {
		emulator::SuitDevice &device = suit->devices()[0];
		const uint8_t out = device.ftdi != nullptr ? emulator::FtdiChip::OUT : emulator::NativeChip::OUT;
		return device.chip->write(out, p_bytes, p_size, now) == int(p_size);
	}
	void set_baud(uint32_t p_baud) override { waiting_baud = p_baud; }
	void take_frame(const xbus::SuitFrame &p_frame) override {
		++frames;
		last = p_frame;
		if (on_frame) {
			on_frame(p_frame);
		}
	}
	void say(xbus::Severity, const char *p_text) override { said.emplace_back(p_text); }

	static constexpr emulator::Usec STEP_USEC = 1000;
	emulator::Usec now = 1000000;
	std::unique_ptr<emulator::Suit> suit;
	std::unique_ptr<xbus::Session> session;
	std::string fault;
	std::vector<std::string> log;
	std::vector<std::string> said;
	std::function<void(const xbus::SuitFrame &)> on_frame;
	/// Around every call into the session, for who counts what it does.
	std::function<void(bool)> around;
	xbus::SuitFrame last;
	uint64_t frames = 0;
	uint32_t waiting_baud = 0;
	usb::FtdiStatistics strip;

private:
	void control(uint8_t p_request, uint16_t p_value, uint16_t p_index = 0) {
		emulator::UsbSetup setup;
		setup.type = usb::ftdi::OUT;
		setup.request = p_request;
		setup.value = p_value;
		setup.index = p_index;
		suit->devices()[0].chip->control(setup, nullptr, now);
	}

	void set_waiting_baud() {
		if (waiting_baud != 0) {
			const usb::FtdiDivisor divisor = usb::ftdi_divisor(waiting_baud, 0x0600, 0);
			control(usb::ftdi::BAUD_RATE, divisor.value, divisor.index);
			control(usb::ftdi::RESET, usb::ftdi::PURGE_IN);
			waiting_baud = 0;
		}
	}

	void read() {
		emulator::SuitDevice &device = suit->devices()[0];
		const uint8_t in = device.ftdi != nullptr ? emulator::FtdiChip::IN : emulator::NativeChip::IN;
		std::array<uint8_t, 512> packet{};
		emulator::Usec ready = 0;
		for (int count = 0; count < 64; ++count) {
			const int size = device.chip->read_packet(in, packet.data(), now, ready);
			if (size < 0) {
				return;
			}
			if (device.ftdi == nullptr) {
				take(packet.data(), std::size_t(size));
			} else {
				usb::ftdi_strip(packet.data(), std::size_t(size), 64, strip,
						[this](const uint8_t *p_bytes, std::size_t p_size) { take(p_bytes, p_size); });
				if (size <= int(usb::ftdi::STATUS_SIZE)) {
					return;
				}
			}
		}
	}

	void take(const uint8_t *p_bytes, std::size_t p_size) {
		if (around) {
			around(true);
		}
		session->take_bytes(p_bytes, p_size, uint64_t(now));
		if (around) {
			around(false);
		}
	}
};
