// SPDX-License-Identifier: MIT
#pragma once

#include "coding/person_codec.hpp"
#include "replication/draft.hpp"
#include "replication/interest.hpp"

#include <array>
#include <vector>

namespace wire {

/// Chooses which people a client gets in its datagrams of a tick, and writes them. What several clients get alike is
/// encoded once.
class PeopleWriter {
public:
	/// Keeps references to all but the skeleton.
	PeopleWriter(const WorldHistory &p_history, const Interest &p_interest, const Skeleton &p_skeleton,
			double p_resolution) :
			_history(p_history), _interest(p_interest), _codec(p_skeleton, p_resolution) {}

	/// Begins a client's tick.
	/// @param p_jolts_only only those who were moved at once
	void collect(ClientRecord &p_client, bool p_jolts_only);
	bool is_waiting() const { return !_waiting.is_empty(); }
	/// What most people of the next datagram are coded against.
	Baseline find_usual(const ClientRecord &p_client) const;
	/// Writes the most urgent; those after the first in no more than a part of the datagram, bytes.
	void write(ClientRecord &p_client, Draft &p_draft, std::size_t p_room);

private:
	struct Encoded {
		std::array<uint8_t, PersonCodec::MAX_BYTES + 16> bytes{}; // With who it is, and against what.
		std::size_t size = 0;
		uint32_t tick = NEVER;
		Baseline base;
		bool is_usual = false;
	};
	// Distinct baselines that a person's clients have in one tick, at most; more are encoded again.
	static constexpr std::size_t MAX_ENCODINGS = 6;

	Baseline find_baseline(const Delivery &p_delivery, const WorldHistory::Person &p_person) const;
	const Encoded &encode(std::size_t p_index, const Baseline &p_base, bool p_is_usual);

	const WorldHistory &_history;
	const Interest &_interest;
	PersonCodec _codec;
	std::vector<std::array<Encoded, MAX_ENCODINGS>> _encoded;
	std::vector<std::size_t> _next_encoded;
	WaitingList _waiting;
};

} // namespace wire
