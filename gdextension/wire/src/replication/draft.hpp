// SPDX-License-Identifier: MIT
#pragma once

#include "replication/client_record.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace wire {

/// Added to the urgency of what the receiver believes something plainly wrong of.
constexpr float MAX_URGENCY = 1000.0f;

/// One datagram in the making.
struct Draft {
	Datagram &out;
	SentDatagram &entry;
	Baseline usual;
	std::size_t room; ///< Bytes that it may have in all.
	uint8_t flags = 0;
};

/// What is to be sent to a client in the datagrams at hand, by its index in the world.
class WaitingList {
public:
	bool is_empty() const { return _waiting.empty(); }
	std::size_t size() const { return _waiting.size(); }
	void clear() { _waiting.clear(); }
	void add(float p_urgency, std::size_t p_index) { _waiting.push_back({ p_urgency, uint16_t(p_index) }); }

	/// Puts the most urgent last.
	void sort() { std::sort(_waiting.begin(), _waiting.end(), is_less_urgent); }
	/// The last one.
	std::size_t last() const { return _waiting.back().index; }
	void remove_last() { _waiting.pop_back(); }

	/// Takes some of the most urgent out, in no order.
	void take(std::size_t p_count, std::vector<uint16_t> &r_taken) {
		const auto begin = _waiting.end() - std::ptrdiff_t(p_count);
		std::nth_element(_waiting.begin(), begin, _waiting.end(), is_less_urgent);
		r_taken.clear();
		for (auto one = begin; one != _waiting.end(); ++one) {
			r_taken.push_back(one->index);
		}
		_waiting.erase(begin, _waiting.end());
	}

private:
	struct Candidate {
		float urgency;
		uint16_t index;
	};

	static bool is_less_urgent(const Candidate &p_a, const Candidate &p_b) { return p_a.urgency < p_b.urgency; }

	std::vector<Candidate> _waiting;
};

} // namespace wire
