// SPDX-License-Identifier: MIT
#pragma once

#include "../coding/person_codec.hpp"
#include "body_codec.hpp"
#include "client_record.hpp"
#include "datagram.hpp"

#include <memory>
#include <unordered_map>
#include <vector>

namespace wire {

/// Reads a SnapshotEncoder's datagrams: each by itself, whatever came or did not come before it, as long
/// as the states it is told against are known. Takes any bytes; what is wrong changes nothing.
class SnapshotDecoder {
public:
	/// What became of a datagram.
	enum class Outcome {
		OK,
		BROKEN, ///< Nothing that an encoder writes.
		STALE, ///< Too old, or known already.
		LACKS_BASELINE, ///< Told against states that are not known: the next acknowledgement says so.
		NOT_BEGUN, ///< The first one with a whole tick has not come yet.
	};
	/// People and bodies that are kept at most.
	static constexpr std::size_t MAX_ENTITIES = 8192;
	/// So many whole ticks from long ago, and none of late between, mean that the newest one was wrong: all
	/// is forgotten then.
	static constexpr int MAX_STRAYS = 10;

	SnapshotDecoder(const Skeleton &p_skeleton, double p_max_error_deg);

	Outcome decode(const uint8_t *p_bytes, std::size_t p_size);
	/// What the last datagram told; valid until the next.
	const std::vector<PersonUpdate> &people() const { return person_updates; }
	const std::vector<BodyUpdate> &bodies() const { return body_updates; }
	/// The last datagram's mark, or null.
	const Mark *mark() const { return has_mark ? &last_mark : nullptr; }
	/// Tick of the last datagram that was fine.
	uint32_t tick() const { return last_tick; }
	int tick_rate() const { return rate; }
	const Skeleton &shape() const { return skeleton; }

	/// Forgets people who are not in a list.
	void keep_people(const std::vector<uint16_t> &p_people);
	/// Whether a mark is wanted in every datagram.
	void want_marks(bool p_wanted) { wants_marks = p_wanted; }
	/// Writes an acknowledgement of what has come; false if nothing has, or nothing new.
	bool write_ack(const Vec3 &p_viewpoint, std::array<uint8_t, ClientRecord::ACK_BYTES> &r_bytes);
	/// Forgets everything: another server, or the same one anew.
	void clear();

private:
	struct PersonScratch {
		uint16_t id = 0;
		PersonState state;
	};
	struct BodyScratch {
		uint16_t id = 0;
		BodyState state;
	};
	// One datagram being read.
	struct Reader {
		const uint8_t *bytes;
		std::size_t size;
		std::size_t at;
		uint32_t tick;
		Baseline usual;
		bool follows_gap = false; // Its number says nothing about those before.
	};

	Outcome read_header(Reader &r_reader, int &r_people);
	Outcome read_people(Reader &r_reader, int p_count);
	Outcome read_bodies(Reader &r_reader);
	bool is_known(uint8_t p_number, uint32_t p_tick) const;
	bool is_astray(const Reader &p_reader);
	void note(uint8_t p_number);
	void keep(uint32_t p_tick);

	Skeleton skeleton;
	PersonLattice lattice;
	PersonCodec codec;
	std::unordered_map<uint16_t, std::unique_ptr<Trail<PersonState>>> people_known;
	std::unordered_map<uint16_t, std::unique_ptr<Trail<BodyState>>> bodies_known;
	std::vector<PersonScratch> person_scratch;
	std::vector<BodyScratch> body_scratch;
	std::vector<PersonUpdate> person_updates;
	std::vector<BodyUpdate> body_updates;
	Mark last_mark;
	bool has_mark = false;
	int rate = 0;
	int read_rate = 0;
	uint32_t last_tick = NEVER;
	uint32_t newest_tick = NEVER;
	uint8_t newest_number = 0;
	uint64_t earlier_numbers = 0;
	bool has_numbers = false;
	bool owes_ack = false;
	bool wants_all = false;
	bool wants_marks = false;
	int strays = 0;
	uint32_t stray_tick = NEVER; // Of the last of them.
};

} // namespace wire
