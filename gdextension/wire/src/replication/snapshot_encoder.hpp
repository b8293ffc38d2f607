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
	/// Sets how many bytes the way to a client adds to each datagram: they count as sent.
	void set_datagram_overhead(std::size_t p_bytes) { _datagram_overhead = p_bytes; }
	/// Takes a client in, anew if it is known. The rate is at most the tick rate; 0 asks for that.
	void add_client(int p_client, int p_snapshots_per_second, double p_bits_per_second);
	/// Changes a client's share of the network; who is not here and recorders have none.
	void set_bandwidth(int p_client, double p_bits_per_second);
	/// Takes a client in that gets all of every tick, and loses nothing: a recording on the server itself.
	void add_recorder(int p_client);
	void remove_client(int p_client) { _clients.erase(p_client); }
	/// Forgets an entity: its fields, body and person, whichever it has.
	void remove_entity(uint16_t p_entity);
	/// Notes which of a client's commands was applied last.
	void set_command_ack(int p_client, uint16_t p_number);
	/// Sends MOTION_ACK_BYTES bytes along with the next snapshot; false if they are not so many.
	bool set_motion_ack(int p_client, const uint8_t *p_bytes, std::size_t p_size);
	/// The record of a client, or null.
	double bytes_per_tick(double p_bits_per_second) const;
	ClientRecord *client(int p_client);

	/// Notes which sample moved a person in this tick, and when it was where; for a while it is sent along.
	void set_mark(const Mark &p_mark);
	/// Appends what a client gets in this tick; returns how many datagrams that is, 0 where it gets none.
	std::size_t encode(int p_client, int64_t p_now_usec, DatagramList &r_datagrams);

private:
	// Added where the receiver believes something that is plainly wrong.
	static constexpr float MAX_URGENCY = 1000.0f;
	// Bytes that the worst body takes.
	static constexpr std::size_t WORST_BODY = 96;

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
		uint8_t flags = 0;
	};
	// Distinct baselines that a person's clients have in one tick, at most; more are encoded again.
	static constexpr std::size_t MAX_ENCODINGS = 6;

	void _collect_people(ClientRecord &p_client, bool p_jolts_only);
	void _collect_bodies(ClientRecord &p_client, bool p_jolts_only);
	float _body_error(const ClientRecord::BodyDelivery &p_delivery, const WorldHistory::Body &p_body) const;
	Baseline _baseline_of(const Delivery &p_delivery, bool p_has_before) const;
	Baseline _person_baseline(const Delivery &p_delivery, const WorldHistory::Person &p_person) const;
	Baseline _usual_baseline(const ClientRecord &p_client) const;
	void _write_header(ClientRecord &p_client, Draft &p_draft, int64_t p_now_usec);
	bool _write_mark(ClientRecord &p_client, Draft &p_draft, int64_t p_now_usec);
	void _write_people(ClientRecord &p_client, Draft &p_draft, std::size_t p_room);
	void _write_acks(ClientRecord &p_client, Draft &p_draft);
	void _finish(Draft &p_draft);
	bool _write_datagram(ClientRecord &p_client, Datagram &r_out, std::size_t p_room, int64_t p_now_usec);
	bool _is_due(const ClientRecord &p_client) const;
	void _write_bodies(ClientRecord &p_client, Draft &p_draft, std::size_t p_room);
	std::size_t _choose_bodies(std::size_t p_room);
	// What an entity's fields are coded against.
	struct FieldBase {
		const uint32_t *values;
		int age; // Ticks; 0: the client's newest that is older than FieldHistory::MAX_AGE; -1: as it was spawned.
	};
	void _read_changes(ClientRecord &p_client) const;
	void _collect_fields(ClientRecord &p_client);
	bool _needs_fields(ClientRecord &p_client, std::size_t p_index) const;
	FieldBase _field_base(const FieldDelivery &p_delivery, const EntityTable::Entity &p_entity) const;
	void _choose_fields(std::size_t p_room);
	void _write_fields(ClientRecord &p_client, Draft &p_draft);
	const EncodedPerson &_encode_person(std::size_t p_index, const Baseline &p_base, bool p_is_usual);

	PersonCodec _codec;
	WorldHistory _history;
	std::size_t _datagram_overhead = TRANSPORT_BYTES;
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
	std::vector<Candidate> _fields_waiting;
	float _bytes_per_body = 9.0f;
	float _bytes_per_fields = 4.0f;
};

} // namespace wire
