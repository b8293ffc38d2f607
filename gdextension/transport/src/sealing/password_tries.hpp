// SPDX-License-Identifier: MIT
#pragma once

#include "try_limiter.hpp"

namespace transport {

/// How often passwords may be tried. A try is charged when it is begun, and given back by success alone,
/// so that nothing that a guesser does refunds one.
///
/// It is charged to its address (IPv6: its /64), to the addresses around it (IPv4: /24, IPv6: /48), and
/// to all. Those of whom no try is open or has failed share a budget of their own with all that are like
/// them: guessers use up that of the others, and keep no newcomer out for long.
class PasswordTries {
public:
	/// What a try has been charged to.
	struct Try {
		bool is_newcomer = false;
	};

	/// Tries that were not given back are forgotten after so long, us.
	static constexpr int64_t REMEMBERED_USEC = 3600 * int64_t(1000000);

	/// Charges a try, if each budget has one left.
	bool take(const Endpoint &p_from, int64_t p_now_usec, Try &r_try) {
		const Network network = network_of(p_from);
		const Network around = around_of(p_from);
		const auto is_forgotten = [p_now_usec](const Record &p_record) {
			return p_record.open <= 0 || p_now_usec - p_record.seen_usec > REMEMBERED_USEC;
		};
		Record &record = _records.find_or_add(network, Record(), is_forgotten);
		if (is_forgotten(record)) {
			record.open = 0;
		}
		r_try.is_newcomer = record.open <= 0;
		TryLimiter &all = r_try.is_newcomer ? _newcomers : _others;
		if (!_of_network.has(network, p_now_usec) || !_around.has(around, p_now_usec) || !all.has({}, p_now_usec)) {
			return false;
		}
		_of_network.take(network, p_now_usec);
		_around.take(around, p_now_usec);
		all.take({}, p_now_usec);
		record.open++;
		record.seen_usec = p_now_usec;
		return true;
	}

	/// It was the right password.
	void give_back(const Endpoint &p_from, const Try &p_try) {
		const Network network = network_of(p_from);
		_of_network.give_back(network);
		_around.give_back(around_of(p_from));
		(p_try.is_newcomer ? _newcomers : _others).give_back({});
		Record *record = _records.find(network);
		if (record != nullptr) {
			record->open--;
		}
	}

private:
	using Network = TryLimiter::Network;

	/// Tries of a network that were not given back.
	struct Record {
		int open = 0;
		int64_t seen_usec = 0;
	};

	/// The addresses around one: whoever has one of them may well have them all.
	static Network around_of(const Endpoint &p_from) {
		Network network = network_of(p_from);
		if (is_v4(network)) {
			network.back() = 0;
		} else {
			std::fill(network.begin() + 6, network.end(), uint8_t(0));
		}
		return network;
	}

	TryLimiter _of_network{ 5.0, 0.5 };
	TryLimiter _around{ 8.0, 1.2 };
	TryLimiter _newcomers{ 16.0, 6.0 };
	TryLimiter _others{ 4.0, 1.5 };
	NetworkTable<Record> _records;
};

} // namespace transport
