// SPDX-License-Identifier: MIT
#pragma once

#include "network_table.hpp"

#include <algorithm>

namespace transport {

/// So many at once of each network, and so many more a second.
class TryLimiter {
public:
	using Network = std::array<uint8_t, 16>;

	TryLimiter(double p_burst, double p_per_second) : _burst(p_burst), _per_second(p_per_second) {}

	/// Whether a try is left.
	bool has(const Network &p_network, int64_t p_now_usec) { return of(p_network, p_now_usec).left >= 1.0; }

	/// Takes a try, if one is left.
	bool take(const Network &p_network, int64_t p_now_usec) {
		Tries &tries = of(p_network, p_now_usec);
		if (tries.left < 1.0) {
			return false;
		}
		tries.left -= 1.0;
		return true;
	}

	/// The last one was none.
	void give_back(const Network &p_network) {
		Tries *tries = _tries.find(p_network);
		if (tries != nullptr) {
			tries->left = std::min(tries->left + 1.0, _burst);
		}
	}

private:
	struct Tries {
		double left = 0.0;
		int64_t seen_usec = 0;
	};

	Tries &of(const Network &p_network, int64_t p_now_usec) {
		// Who has all tries back is as one who is not known.
		const auto is_idle = [this, p_now_usec](
									 const Tries &p_tries) { return left_at(p_tries, p_now_usec) >= _burst; };
		Tries &tries = _tries.find_or_add(p_network, Tries{ _burst, p_now_usec }, is_idle);
		tries.left = left_at(tries, p_now_usec);
		tries.seen_usec = p_now_usec;
		return tries;
	}

	double left_at(const Tries &p_tries, int64_t p_now_usec) const {
		return std::min(p_tries.left + double(p_now_usec - p_tries.seen_usec) / 1e6 * _per_second, _burst);
	}

	double _burst;
	double _per_second;
	NetworkTable<Tries> _tries;
};

} // namespace transport
