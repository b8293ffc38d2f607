// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

namespace transport {

/// How many replies a client with a password answers, at once and each second: whoever sent one learns from the
/// answer whether he has guessed it.
class AnswerBudget {
public:
	static constexpr double BURST = 6.0;
	static constexpr double PER_S = 0.5;

	/// Takes an answer, if one is left.
	bool take(int64_t p_now_usec) {
		const bool is_first = _taken_usec == INT64_MIN;
		const double since_s = is_first ? 0.0 : double(p_now_usec - _taken_usec) / 1e6;
		_left = is_first ? BURST : std::min(_left + since_s * PER_S, BURST);
		_taken_usec = p_now_usec;
		if (_left < 1.0) {
			return false;
		}
		_left -= 1.0;
		return true;
	}

private:
	double _left = 0.0;
	int64_t _taken_usec = INT64_MIN;
};

} // namespace transport
