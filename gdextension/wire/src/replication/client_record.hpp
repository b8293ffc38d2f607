// SPDX-License-Identifier: MIT
#pragma once

#include "replication/world_history.hpp"
#include "updates.hpp"

namespace wire {

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
};

/// What was sent to a client in one datagram.
struct SentDatagram {
	uint32_t tick = NEVER;
	uint8_t number = 0;
	bool is_open = false; ///< Neither acknowledged nor given up.
	uint8_t people_count = 0;
	uint16_t body_count = 0;
	std::array<uint16_t, MAX_PEOPLE> people{}; ///< Indices in WorldHistory.
	std::array<uint16_t, MAX_BODIES> bodies{};
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
	/// Acknowledgements: kind, flags, newest number, the 64 before it as bits, where the client looks from.
	static constexpr std::size_t ACK_BYTES = 1 + 1 + 1 + 8 + 12;
	/// Flags of an acknowledgement: the client lacks a baseline, all has to be sent anew; it wants a mark in
	/// every datagram.
	static constexpr uint8_t WANTS_ALL = 1;
	static constexpr uint8_t WANTS_MARKS = 2;

	ClientRecord(int p_rate, double p_bytes_per_tick) : rate(p_rate), bytes_per_tick(p_bytes_per_tick) {}

	/// Snapshots per second.
	const int rate;
	const double bytes_per_tick;
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
	ClientStats stats;

	struct BodyDelivery : Delivery {
		BodyUpdate believed; ///< What was sent last.
	};
	std::vector<Delivery> people;
	std::vector<BodyDelivery> bodies;

	/// Makes records for as many people and bodies, and voids those about others than are there now.
	void follow(const WorldHistory &p_world);
	/// A new datagram's entry.
	SentDatagram &begin_datagram(uint32_t p_tick);
	/// Takes an acknowledgement; false if it is none.
	bool take_ack(const uint8_t *p_bytes, std::size_t p_size, uint32_t p_now);
	/// Takes back the datagram that was begun last: nothing went into it.
	void cancel_datagram();

private:
	static constexpr std::size_t KEPT = 128;

	void _note_arrival(SentDatagram &p_entry, uint32_t p_now);
	void _note_loss(SentDatagram &p_entry);
	void _forget_all();

	std::array<SentDatagram, KEPT> _log{};
	uint8_t _next_number = 0;
};

} // namespace wire
