// SPDX-License-Identifier: MIT
#include "status_bytes.hpp"

#include "bus/framer.hpp"

#include <array>
#include <cstddef>

using namespace xbus;

namespace {

/// The second status byte of a line without faults: its transmitter is empty, or not.
bool is_line_status(uint8_t p_byte) {
	return (p_byte & ~0x60U) == 0;
}

/// Bytes of the messages in a stream.
std::size_t bytes_of_messages(const std::vector<uint8_t> &p_bytes) {
	Framer framer;
	framer.feed(p_bytes.data(), p_bytes.size(), [](const Frame &) { return true; });
	framer.finish([](const Frame &) { return true; });
	return p_bytes.size() - std::size_t(framer.statistics().skipped_bytes);
}

/// The stream without the pairs that begin with this modem status.
std::vector<uint8_t> without(const std::vector<uint8_t> &p_bytes, uint8_t p_modem) {
	std::vector<uint8_t> rest;
	rest.reserve(p_bytes.size());
	for (std::size_t at = 0; at < p_bytes.size(); ++at) {
		if (p_bytes[at] == p_modem && at + 1 < p_bytes.size() && is_line_status(p_bytes[at + 1])) {
			++at;
			continue;
		}
		rest.push_back(p_bytes[at]);
	}
	return rest;
}

} // namespace

bool strip_status_bytes(std::vector<uint8_t> &r_bytes) {
	// A packet has 64 or 512 bytes at most: there are at least so many pairs.
	constexpr std::size_t MAX_PACKET = 512;
	std::array<std::size_t, 256> counts{};
	for (std::size_t at = 0; at + 1 < r_bytes.size(); ++at) {
		// The low bits of the first say how fast the chip's USB is.
		const unsigned speed = r_bytes[at] & 0x0FU;
		counts[r_bytes[at]] += (speed == 1 || speed == 2) && is_line_status(r_bytes[at + 1]) ? 1U : 0U;
	}
	std::size_t best = bytes_of_messages(r_bytes);
	std::vector<uint8_t> found;
	for (std::size_t modem = 0; modem < counts.size(); ++modem) {
		if (counts[modem] < 2 || counts[modem] * MAX_PACKET < r_bytes.size()) {
			continue;
		}
		std::vector<uint8_t> rest = without(r_bytes, uint8_t(modem));
		const std::size_t bytes = bytes_of_messages(rest);
		if (bytes > best + r_bytes.size() / 10) {
			best = bytes;
			found = std::move(rest);
		}
	}
	if (found.empty()) {
		return false;
	}
	r_bytes = std::move(found);
	return true;
}
