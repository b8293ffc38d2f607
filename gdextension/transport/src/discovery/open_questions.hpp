// SPDX-License-Identifier: MIT
#pragma once

#include "../relay/endpoint.hpp"
#include "discovery_messages.hpp"

#include <map>

namespace transport {

/// The questions of a client that may still be answered. What answers none of them is dropped: forged answers that
/// do not know a nonce, those from another port than was asked, and, where one address was asked, from another one.
class OpenQuestions {
public:
	/// How long an answer is awaited.
	static constexpr int64_t OPEN_USEC = 3000000;
	static constexpr size_t MAX = 4096;

	/// A question has left. p_to_one: it went to one address, not to all of a network.
	void note(const discovery::Nonce &p_nonce, const Endpoint &p_to, bool p_to_one, int64_t p_now_usec) {
		forget(p_now_usec);
		if (_questions.size() < MAX) {
			_questions[p_nonce] = { p_to, p_to_one, p_now_usec };
		}
	}

	/// The time since the question that an answer is to, us; negative if it is to none.
	int64_t take(const View &p_bytes, const Endpoint &p_from, int64_t p_arrival_usec) const {
		discovery::Nonce nonce;
		if (!discovery::read_answer(p_bytes, nonce)) {
			return -1;
		}
		const auto found = _questions.find(nonce);
		if (found == _questions.end() || found->second.to.port != p_from.port) {
			return -1;
		}
		const Question &question = found->second;
		if (question.to_one && question.to.address != p_from.address) {
			return -1;
		}
		const int64_t delay_usec = p_arrival_usec - question.asked_usec;
		return delay_usec <= OPEN_USEC && delay_usec >= 0 ? delay_usec : -1;
	}

	size_t size() const { return _questions.size(); }

private:
	struct Question {
		Endpoint to;
		bool to_one = true;
		int64_t asked_usec = 0;
	};

	void forget(int64_t p_now_usec) {
		for (auto one = _questions.begin(); one != _questions.end();) {
			const int64_t age_usec = p_now_usec - one->second.asked_usec;
			// A clock that was set back makes no question last.
			one = age_usec > OPEN_USEC || age_usec < 0 ? _questions.erase(one) : std::next(one);
		}
	}

	std::map<discovery::Nonce, Question> _questions;
};

} // namespace transport
