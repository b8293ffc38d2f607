// SPDX-License-Identifier: MIT
#include "session/exchange.hpp"

#include <algorithm>

namespace xbus {

namespace {

constexpr uint64_t MAX_DELAY_USEC = 1000000;
constexpr uint64_t SOON_USEC = 100000;

} // namespace

bool Exchange::begin(const Request &p_request, SetupStep p_step, uint64_t p_now_usec) {
	_request = p_request;
	_tries = 0;
	_asked_usec = p_now_usec;
	if (!is_of_trackers(p_step)) {
		_ahead = 0; // Whatever else is asked ends the set-up of the trackers.
	}
	const bool was_sent = _ahead > 0;
	_ahead -= was_sent ? 1 : 0;
	await(p_step, p_now_usec);
	return !was_sent;
}

void Exchange::repeat(SetupStep p_step, uint64_t p_now_usec) {
	_ahead = 0;
	await(p_step, p_now_usec);
}

void Exchange::note_answer(SetupStep p_step, uint64_t p_now_usec) {
	// The first question of all may have been asked before the device was there.
	if (p_step != SetupStep::GO_TO_CONFIG) {
		_delay_usec = std::max(_delay_usec, std::min(p_now_usec - _asked_usec, MAX_DELAY_USEC));
	}
}

void Exchange::hasten(uint64_t p_now_usec) {
	_deadline_usec = std::min(_deadline_usec, p_now_usec + SOON_USEC);
}

void Exchange::await(SetupStep p_step, uint64_t p_now_usec) {
	_waits = true;
	++_tries;
	_deadline_usec = p_now_usec + std::max(patience(p_step).limit_usec, _delay_usec * 2);
}

} // namespace xbus
