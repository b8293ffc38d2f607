// SPDX-License-Identifier: MIT
#pragma once

#include "bus/bytes.hpp"
#include "bus/encoder.hpp"
#include "bus/framer.hpp"
#include "suit/suit.hpp"

#include <utility>

/// A host in simulated time: a suit without any system, and what it answers.
class BenchHost {
public:
	struct Message {
		uint8_t bus_id = 0;
		xbus::Message message = xbus::Message::ERROR;
		std::vector<uint8_t> data;
	};

	explicit BenchHost(const std::vector<std::string> &p_options, bool p_is_plugged = true) :
			suit(
					parse(p_options), emulator::MotionStream::still(16), [this]() { return now; },
					[this](emulator::Usec, std::size_t, const std::string &p_text) { log.push_back(p_text); }) {
		suit.begin(now);
		if (p_is_plugged) {
			port().plug(true, now);
		}
	}

	static emulator::SuitOptions parse(const std::vector<std::string> &p_options) {
		emulator::SuitOptions options;
		options.parse(p_options);
		return options;
	}

	emulator::SuitDevice &device() { return suit.devices().front(); }
	emulator::UsbPort &port() { return *device().port; }
	bool is_ftdi() { return device().ftdi != nullptr; }

	/// A vendor's request; the result's size or error, and what came.
	int control(uint8_t p_type, uint8_t p_request, uint16_t p_value, uint16_t p_index = 0, uint16_t p_length = 0) {
		auto urb = std::make_unique<emulator::Urb>();
		urb->type = emulator::Urb::Type::CONTROL;
		urb->setup = { p_type, p_request, p_value, p_index, p_length };
		port().submit(std::move(urb), now);
		const std::unique_ptr<emulator::Urb> done = port().take_completed();
		answer.assign(done->data.begin(), done->data.begin() + std::ptrdiff_t(done->done));
		return done->status != 0 ? done->status : int(done->done);
	}

	void send(uint8_t p_bus_id, xbus::Message p_message, const std::vector<uint8_t> &p_data = {}) {
		auto urb = std::make_unique<emulator::Urb>();
		urb->endpoint = is_ftdi() ? emulator::FtdiChip::OUT : emulator::NativeChip::OUT;
		urb->data.resize(p_data.size() + 7);
		urb->data.resize(xbus::write_frame(p_bus_id, p_message, p_data.data(), p_data.size(), urb->data.data()));
		port().submit(std::move(urb), now);
		port().take_completed();
	}

	/// Reads for so long; every packet's bytes go through a framer.
	void read(emulator::Usec p_time) {
		const emulator::Usec end = now + p_time;
		while (now < end) {
			while (waiting < 4) {
				auto urb = std::make_unique<emulator::Urb>();
				urb->id = ++waiting + 100;
				urb->endpoint = is_ftdi() ? emulator::FtdiChip::IN : emulator::NativeChip::IN;
				urb->data.resize(512);
				port().submit(std::move(urb), now);
			}
			now = std::min(end, std::max(port().next_event(), now + 1));
			port().advance(now);
			collect();
		}
	}

	/// What answers a message, with these data; the last one of several.
	Message ask(uint8_t p_bus_id, xbus::Message p_message, const std::vector<uint8_t> &p_data = {}) {
		received.clear();
		send(p_bus_id, p_message, p_data);
		read(200000);
		// A message that was cut short would be waited for.
		framer.finish([this](const xbus::Frame &p_frame) { take(p_frame); });
		for (const Message &one : received) {
			if (one.message == xbus::acknowledgement(p_message) || one.message == xbus::Message::ERROR) {
				return one;
			}
		}
		return {};
	}

	/// From power-up to measuring.
	void bring_up() {
		if (is_ftdi()) {
			control(0x40, 9, 1);
			control(0x40, 3, 0x4006);
		}
		ask(xbus::MASTER, xbus::Message::GO_TO_CONFIG);
		ask(xbus::MASTER, xbus::Message::INIT_BUS);
		ask(xbus::MASTER, xbus::Message::GO_TO_MEASUREMENT);
		received.clear();
	}

	emulator::Usec now = emulator::SECOND;
	std::vector<std::string> log;
	emulator::Suit suit;
	std::vector<Message> received;
	std::vector<std::vector<uint8_t>> packets;
	std::vector<int> statuses;
	std::vector<uint8_t> answer;
	xbus::Framer framer;
	std::size_t waiting = 0;

private:
	void take(const xbus::Frame &p_frame) {
		received.push_back({ p_frame.bus_id, p_frame.message, { p_frame.data, p_frame.data + p_frame.size } });
	}

	void collect() {
		while (const std::unique_ptr<emulator::Urb> done = port().take_completed()) {
			waiting--;
			statuses.push_back(done->status);
			done->data.resize(done->done);
			packets.push_back(done->data);
			const std::size_t packet = std::size_t(is_ftdi() && device().chip->description().speed == 480 ? 512 : 64);
			for (std::size_t at = 0; at < done->data.size(); at += packet) {
				const std::size_t head = is_ftdi() ? 2 : 0;
				const std::size_t size = std::min(packet, done->data.size() - at);
				framer.feed(done->data.data() + at + head, size - std::min(head, size),
						[this](const xbus::Frame &p_frame) { take(p_frame); });
			}
		}
	}
};
