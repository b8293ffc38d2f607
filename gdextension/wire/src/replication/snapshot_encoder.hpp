// SPDX-License-Identifier: MIT
#pragma once

#include "replication/bodies_writer.hpp"
#include "replication/client_record.hpp"
#include "replication/fields_writer.hpp"
#include "replication/interest.hpp"
#include "replication/people_writer.hpp"

namespace wire {

/// Sends each client what it needs to know of the world: what has moved, by how much its own prediction
/// would be wrong, as far as its share of the network goes (thesis section 7.2).
///
/// Usage, once a tick: world().begin(), put_person(), put_body(), end(); then encode() for each client.
class SnapshotEncoder {
public:
	/// Marks that a client gets in a second that does not ask for more.
	static constexpr int MARKS_PER_SECOND = 1;

	SnapshotEncoder(const Skeleton &p_skeleton, double p_max_error_deg, int p_tick_rate);
	SnapshotEncoder(const SnapshotEncoder &) = delete;
	SnapshotEncoder &operator=(const SnapshotEncoder &) = delete;

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
	void _write_header(ClientRecord &p_client, Draft &p_draft, int64_t p_now_usec);
	bool _write_mark(ClientRecord &p_client, Draft &p_draft, int64_t p_now_usec);
	void _write_acks(ClientRecord &p_client, Draft &p_draft);
	void _finish(Draft &p_draft);
	bool _write_datagram(ClientRecord &p_client, Datagram &r_out, std::size_t p_room, int64_t p_now_usec);
	bool _is_due(const ClientRecord &p_client) const;
	bool _is_waiting() const { return _people.is_waiting() || _bodies.is_waiting() || _fields.is_waiting(); }

	WorldHistory _history;
	std::size_t _datagram_overhead = TRANSPORT_BYTES;
	Interest _visibility;
	std::unordered_map<int, std::unique_ptr<ClientRecord>> _clients;
	std::vector<Mark> _marks;
	std::vector<uint32_t> _mark_ticks;
	PeopleWriter _people;
	BodiesWriter _bodies;
	FieldsWriter _fields;
};

} // namespace wire
