// SPDX-License-Identifier: MIT
#pragma once

#include "bus/requests.hpp"
#include "session/setup_step.hpp"

#include <cstdint>

namespace xbus {

/// One question to a device and the wait for its answer: how often it was asked, until when the answer is
/// waited for, and how slow the device is. Sending is the caller's. Times are in µs.
class Exchange {
public:
	/// Asks something in a step. Returns whether it is to be sent: not if it was sent ahead.
	bool begin(const Request &p_request, SetupStep p_step, uint64_t p_now_usec);
	/// Asks the same once more.
	void repeat(SetupStep p_step, uint64_t p_now_usec);
	/// Requests were sent before their turn: so many answers are on the way.
	void note_sent_ahead(int p_count) { _ahead = p_count; }
	/// The answer came, to a step's question.
	void note_answer(SetupStep p_step, uint64_t p_now_usec);
	/// Nothing is waited for.
	void end() { _waits = false; }
	/// Nothing is due before a time.
	void pause_until(uint64_t p_usec) { _deadline_usec = p_usec; }
	/// The time is up soon.
	void hasten(uint64_t p_now_usec);

	const Request &request() const { return _request; }
	/// Whether an answer is waited for.
	bool waits() const { return _waits; }
	int tries() const { return _tries; }
	bool is_due(uint64_t p_now_usec) const { return p_now_usec >= _deadline_usec; }
	/// Whether the device answers so slowly that it is asked for several things at once, and for no more than
	/// is needed.
	bool is_slow() const { return _delay_usec > SLOW_USEC; }

private:
	static constexpr uint64_t SLOW_USEC = 250000;

	void await(SetupStep p_step, uint64_t p_now_usec);

	Request _request;
	bool _waits = false;
	int _tries = 0;
	uint64_t _deadline_usec = 0;
	/// When the present request was first sent, and how long answers have taken at most.
	uint64_t _asked_usec = 0;
	uint64_t _delay_usec = 0;
	int _ahead = 0;
};

} // namespace xbus
