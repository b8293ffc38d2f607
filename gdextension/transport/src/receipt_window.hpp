// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>

namespace transport {

/// How much was sent reliably to one end that it has not taken in yet.
///
/// After every PROBE_EVERY bytes the sender puts a probe, a random number, into the stream. Only who
/// has taken in all that lies before can answer it, however it plays with ENet's acknowledgements;
/// the answer is its receipt.
class ReceiptWindow {
public:
	/// What a probe holds; unpredictable.
	using Nonce = std::array<uint8_t, 8>;

	/// Bytes between two probes.
	static constexpr int64_t PROBE_EVERY = 65536;
	/// Bytes without a receipt above which the other end takes nothing in.
	static constexpr int64_t MAX_UNRECEIPTED = 4 << 20;

	/// Counts bytes that are being sent. True if a probe must be sent behind them.
	bool note_sent(int64_t p_bytes, Nonce &r_probe);
	/// Takes a receipt: all up to that probe has arrived. What was never asked for is ignored, so is
	/// what was answered before.
	void take_receipt(const Nonce &p_nonce);
	/// Bytes sent without a receipt.
	int64_t unreceipted() const { return _unreceipted; }
	bool is_exceeded() const { return _unreceipted > MAX_UNRECEIPTED; }

private:
	struct Probe {
		Nonce nonce{};
		int64_t bytes = 0;
	};

	std::deque<Probe> _probes;
	int64_t _unreceipted = 0;
	int64_t _since_probe = 0;
};

} // namespace transport
