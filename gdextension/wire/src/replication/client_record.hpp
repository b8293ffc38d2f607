// SPDX-License-Identifier: MIT
#pragma once

#include "replication/world_history.hpp"
#include "updates.hpp"

namespace wire {

/// Urgency at which what is out of sight is sent after all.
constexpr float HIDDEN_URGENCY = 0.75f;

/// What a client is known to have of one person or body.
struct Delivery {
	uint32_t generation = 0;
	uint32_t acked = NEVER; ///< Tick of the newest state that it has for sure.
	uint32_t before = NEVER; ///< Tick of the one before that.
	uint32_t sent = NEVER; ///< Tick of the newest state that was sent.
	float urgency = 0.0f; ///< Grows until it is sent (priority accumulator: Fiedler 2015).
	bool is_lost = false; ///< What was sent last got lost.

	/// Notes that a state has arrived.
	void arrived(uint32_t p_tick);
	/// What the state of a tick can be coded against.
	/// @param p_has_before whether against the state before, too
	Baseline find_baseline(uint32_t p_tick, bool p_has_before) const;
};

/// What a client is known to have of an entity's fields.
struct FieldDelivery {
	uint32_t generation = 0;
	uint32_t acked = NEVER; ///< Tick of the newest state that it has for sure.
	uint32_t first_unacked = NEVER; ///< Tick from which on states were sent since, perhaps.
	uint32_t sent = NEVER; ///< Tick of the newest state that was sent.
	float urgency = 0.0f;
	bool is_lost = false;
	bool is_pending = false; ///< It is among those of which something may have to be sent.

	void arrived(uint32_t p_tick);
	void was_sent(uint32_t p_tick);
};

/// What was sent to a client in one datagram.
struct SentDatagram {
	uint32_t tick = NEVER;
	uint8_t number = 0;
	bool is_open = false; ///< Neither acknowledged nor given up.
	uint8_t people_count = 0;
	uint16_t body_count = 0;
	uint16_t field_count = 0;
	bool has_command_ack = false;
	uint16_t command_ack = 0;
	std::array<uint16_t, MAX_PEOPLE> people{}; ///< Indices in WorldHistory.
	std::array<uint16_t, MAX_BODIES> bodies{};
	std::array<uint16_t, MAX_FIELD_ENTITIES> fields{}; ///< Indices in EntityTable.
};

/// Statistics of a client since it came.
struct ClientStats {
	uint64_t datagrams = 0;
	uint64_t bytes = 0; ///< With headers of UDP, IP and ENet.
	uint64_t acked = 0;
	uint64_t lost = 0;
	float round_trip_ticks = 0.0f; ///< From sending to the acknowledgement, smoothed; 0: not known yet.
};

/// Everything that the server keeps of one client.
class ClientRecord {
public:
	/// Acknowledgements: message, flags, newest number, those before it as bits, version of the entity table; then
	/// perhaps where the client looks from.
	static constexpr std::size_t ACK_BYTES = 1 + 1 + 1 + 4 + 2;
	static constexpr std::size_t VIEWPOINT_BYTES = 12;
	/// Datagrams before the newest that an acknowledgement speaks of.
	static constexpr uint32_t ACKED_BEFORE = 32;
	/// Flags of an acknowledgement: the client lacks a baseline, all has to be sent anew; it wants a mark in
	/// every datagram; a viewpoint follows.
	static constexpr uint8_t WANTS_ALL = 1;
	static constexpr uint8_t WANTS_MARKS = 2;
	static constexpr uint8_t HAS_VIEWPOINT = 4;

	ClientRecord(int p_rate, double p_bytes_per_tick) : rate(p_rate), bytes_per_tick(p_bytes_per_tick) {}

	/// Snapshots per second.
	const int rate;
	double bytes_per_tick;
	double allowance = double(MAX_BYTES);
	/// Where the client looks from, if it has sent that.
	Vec3 viewpoint;
	bool has_viewpoint = false;
	int own_person = -1; ///< Id of the body that is the client's own.
	uint32_t last_tick = NEVER; ///< When a snapshot was due last.
	uint32_t sent_tick = NEVER; ///< Of the last datagram.
	uint32_t mark_tick = NEVER; ///< Of the last mark.
	std::size_t marked = 0; ///< Index of the person that the last mark was about.
	std::size_t key_in = 0; ///< Datagrams until the whole tick is sent again.
	uint32_t heard_tick = NEVER; ///< When it acknowledged something last.
	bool wants_marks = false; ///< A mark in every datagram.
	bool is_recorder = false; ///< It gets everything, and loses nothing.
	uint32_t table_version = 0; ///< Of the entity table, as far as the client has it.
	bool has_command = false;
	uint16_t command = 0; ///< The newest command that was applied.
	bool is_command_acked = true; ///< The client knows that.
	std::array<uint8_t, MOTION_ACK_BYTES> motion_ack{};
	bool owes_motion_ack = false; ///< It has not been sent yet.
	ClientStats stats;

	struct BodyDelivery : Delivery {
		BodyUpdate believed; ///< What was sent last.
	};
	std::vector<Delivery> people;
	std::vector<BodyDelivery> bodies;
	std::vector<FieldDelivery> fields;
	/// Indices of the entities of whose fields something may have to be sent.
	std::vector<uint16_t> pending_fields;
	uint64_t changes_read = 0; ///< Of EntityTable's.
	bool reads_all_fields = true; ///< Any entity may have to be sent.

	/// Makes records for as many people and bodies, and voids those about others than are there now.
	void follow(const WorldHistory &p_world);
	/// A new datagram's entry.
	SentDatagram &begin_datagram(uint32_t p_tick);
	/// Takes an acknowledgement; false if it is none.
	bool take_ack(const uint8_t *p_bytes, std::size_t p_size, uint32_t p_now, uint32_t p_newest_version = 0);
	/// Counts a datagram as arrived that a recorder keeps.
	void keep_datagram(SentDatagram &p_entry) { _note_arrival(p_entry, p_entry.tick); }
	/// What the client has of an entity's fields.
	FieldDelivery &field_delivery(std::size_t p_index, uint32_t p_generation);
	/// Notes that something of an entity's fields may have to be sent.
	void mark_fields(std::size_t p_index, uint32_t p_generation);
	bool knows(uint32_t p_table_version) const { return is_recorder || p_table_version <= table_version; }
	/// Gives up datagrams that should have been acknowledged long ago: nothing newer may come to say so.
	void expire(uint32_t p_now, int p_tick_rate);
	/// Takes back the datagram that was begun last: nothing went into it.
	void cancel_datagram();

private:
	static constexpr std::size_t KEPT = 128;

	void _take_viewpoint(const uint8_t *p_bytes);
	void _note_arrival(SentDatagram &p_entry, uint32_t p_now);
	void _note_loss(SentDatagram &p_entry);
	void _forget_all();

	std::array<SentDatagram, KEPT> _log{};
	uint8_t _next_number = 0;
	uint8_t _oldest_open = 0; // No datagram before this one is open.
};

} // namespace wire
