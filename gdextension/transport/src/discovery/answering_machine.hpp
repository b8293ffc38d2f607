// SPDX-License-Identifier: MIT
#pragma once

#include "../relay/relay_counts.hpp"
#include "../relay/relay_sink.hpp"
#include "../sealing/fair_share.hpp"
#include "discovery_messages.hpp"

namespace transport {

/// A server's answer to clients that look for servers: always the same bytes behind the question's nonce. It keeps
/// nothing of whoever asks, and answers so many a second only.
class AnsweringMachine {
public:
	/// Answers of one network, and of all.
	static constexpr double PER_S = 50.0;
	static constexpr double ALL_PER_S = 1000.0;

	explicit AnsweringMachine(RelayCounts &r_counts) : _counts(r_counts), _asked(PER_S), _all_asked(ALL_PER_S) {}

	/// What it says; nothing: it is silent. False if that is too long.
	bool set_body(const View &p_body) {
		if (p_body.size > discovery::MAX_BODY) {
			return false;
		}
		_body.assign(p_body.data, p_body.data + p_body.size);
		return true;
	}

	/// Whether a datagram is meant for it, by its first byte.
	static bool is_asked(const View &p_bytes) { return p_bytes.data[0] == discovery::QUESTION; }

	/// Somebody asks.
	void take(const Endpoint &p_from, const View &p_bytes, int64_t p_now_usec, RelaySink &r_sink) {
		discovery::Nonce nonce;
		if (!discovery::read_question(p_bytes, nonce)) {
			_counts.stray++;
			return;
		}
		_counts.questions++;
		if (_body.empty() || !_asked.admit(network_of(p_from), p_now_usec) || !_all_asked.admit({}, p_now_usec)) {
			return;
		}
		_counts.answers++;
		r_sink.to_outer(p_from, discovery::make_answer(nonce, _body));
	}

private:
	RelayCounts &_counts;
	FairShare _asked;
	FairShare _all_asked;
	Bytes _body;
};

} // namespace transport
