// SPDX-License-Identifier: MIT
#pragma once

#include "replication/draft.hpp"
#include "replication/interest.hpp"

#include <vector>

namespace wire {

/// Chooses which rigid bodies a client gets in its datagrams of a tick, and writes them: those of which its own
/// prediction would be wrong.
class BodiesWriter {
public:
	/// How wrong a client's prediction of a body may be, m, before an update is sent (DIS, IEEE 1278, calls it
	/// the threshold of dead reckoning). An angle counts as the distance that a point moves this far from the middle.
	static constexpr float TOLERANCE_M = 0.01f;
	static constexpr float LEVER_M = 0.25f;
	/// Bytes that the worst body takes.
	static constexpr std::size_t WORST_BODY = 96;

	/// Keeps references.
	BodiesWriter(const WorldHistory &p_history, const Interest &p_interest) :
			_history(p_history), _interest(p_interest) {}

	/// Begins a client's tick.
	/// @param p_jolts_only only those that were moved at once
	void collect(ClientRecord &p_client, bool p_jolts_only);
	bool is_waiting() const { return !_waiting.is_empty(); }
	/// About how many bytes all that wait take.
	double expected_bytes() const { return double(_bytes_each) * double(_waiting.size()); }
	/// Writes the most urgent, as long as the datagram has no more than p_room bytes.
	void write(ClientRecord &p_client, Draft &p_draft, std::size_t p_room);

private:
	float find_error(const ClientRecord::BodyDelivery &p_delivery, const WorldHistory::Body &p_body) const;
	std::size_t choose(std::size_t p_room);

	const WorldHistory &_history;
	const Interest &_interest;
	WaitingList _waiting;
	std::vector<uint16_t> _chosen;
	float _bytes_each = 9.0f;
};

} // namespace wire
