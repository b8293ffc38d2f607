// SPDX-License-Identifier: MIT
#pragma once

#include "coding/person_codec.hpp"
#include "replication/client_record.hpp"
#include "replication/interest.hpp"

namespace wire {

/// Sends each client what it needs to know of the world: what has moved, by how much its own prediction
/// would be wrong, as far as its share of the network goes (thesis section 7.2).
///
/// Usage, once a tick: world().begin(), put_person(), put_body(), end(); then encode() for each client.
class SnapshotEncoder {
public:
	/// How wrong a client's prediction of a body may be, m, before an update is sent (DIS, IEEE 1278, calls it
	/// the threshold of dead reckoning). An angle counts as the distance that a point moves this far from the middle.
	static constexpr float TOLERANCE_M = 0.01f;
	static constexpr float LEVER_M = 0.25f;
	/// Marks that a client gets in a second that does not ask for more.
	static constexpr int MARKS_PER_SECOND = 1;

	SnapshotEncoder(const Skeleton &p_skeleton, double p_max_error_deg, int p_tick_rate);

	WorldHistory &world() { return _history; }
	Interest &interest() { return _visibility; }
	/// Takes a client in, anew if it is known. The rate is at most the tick rate; 0 asks for that.
	void add_client(int p_client, int p_snapshots_per_second, double p_bits_per_second);
	void remove_client(int p_client) { _clients.erase(p_client); }
	/// The record of a client, or null.
	ClientRecord *client(int p_client);

	/// Notes which sample moved a person in this tick, and when it was where; for a while it is sent along.
	void set_mark(const Mark &p_mark);
	/// Writes what a client gets in this tick into as many datagrams as it returns; 0 where it gets none.
	std::size_t encode(int p_client, int64_t p_now_usec, std::array<Datagram, MAX_DATAGRAMS> &r_datagrams);

private:
	struct Candidate {
		float urgency;
		uint16_t index;
	};
	struct EncodedPerson {
		std::array<uint8_t, PersonCodec::MAX_BYTES + 16> bytes{}; // With who it is, and against what.
		std::size_t size = 0;
		uint32_t tick = NEVER;
		Baseline base;
		bool is_usual = false;
	};
	// One datagram in the making.
	struct Draft {
		Datagram &out;
		SentDatagram &entry;
		Baseline usual;
		std::size_t room; // Bytes that it may have in all.
	};
	// Distinct baselines that a person's clients have in one tick, at most; more are encoded again.
	static constexpr std::size_t MAX_ENCODINGS = 6;

	void _collect_people(ClientRecord &p_client, bool p_jolts_only);
	void _collect_bodies(ClientRecord &p_client, bool p_jolts_only);
	float _body_error(const ClientRecord::BodyDelivery &p_delivery, const WorldHistory::Body &p_body) const;
	Baseline _baseline_of(const Delivery &p_delivery, bool p_has_before) const;
	Baseline _usual_baseline(const ClientRecord &p_client) const;
	void _write_header(ClientRecord &p_client, Draft &p_draft, int64_t p_now_usec);
	bool _write_mark(ClientRecord &p_client, Draft &p_draft, int64_t p_now_usec);
	void _write_people(ClientRecord &p_client, Draft &p_draft, std::size_t p_room);
	void _write_bodies(ClientRecord &p_client, Draft &p_draft);
	std::size_t _choose_bodies(std::size_t p_room);
	const EncodedPerson &_encode_person(std::size_t p_index, const Baseline &p_base, bool p_is_usual);

	PersonCodec _codec;
	WorldHistory _history;
	Interest _visibility;
	std::unordered_map<int, std::unique_ptr<ClientRecord>> _clients;
	std::vector<Mark> _marks;
	std::vector<uint32_t> _mark_ticks;
	std::vector<std::array<EncodedPerson, MAX_ENCODINGS>> _encoded_people;
	std::vector<std::size_t> _next_encoded;
	// Who is to be sent in the datagrams at hand, the most urgent last.
	std::vector<Candidate> _people_waiting;
	std::vector<Candidate> _bodies_waiting;
	std::vector<uint16_t> _chosen;
	float _bytes_per_body = 9.0f;
};

} // namespace wire
