// SPDX-License-Identifier: MIT
#pragma once

#include "coding/person_codec.hpp"
#include "replication/body_codec.hpp"
#include "replication/client_record.hpp"
#include "replication/datagram.hpp"

#include <memory>
#include <unordered_map>
#include <vector>

namespace wire {

/// Reads a SnapshotEncoder's datagrams: each by itself, whatever came or did not come before it, as long
/// as the states it is coded against are known. Takes any bytes; what is wrong changes nothing.
class SnapshotDecoder {
public:
	/// What became of a datagram.
	enum class Outcome {
		OK,
		BROKEN, ///< Nothing that an encoder writes.
		STALE, ///< Too old, or known already.
		LACKS_BASELINE, ///< Coded against states that are not known: the next acknowledgement says so.
		NOT_BEGUN, ///< The first one with a whole tick has not come yet.
	};
	/// People and bodies that are kept at most.
	static constexpr std::size_t MAX_ENTITIES = 8192;
	/// So many whole ticks from long ago, and none of late between, mean that the newest one was wrong: all
	/// is forgotten then.
	static constexpr int MAX_STRAYS = 10;

	SnapshotDecoder(const Skeleton &p_skeleton, double p_max_error_deg);

	Outcome decode(const uint8_t *p_bytes, std::size_t p_size);
	/// What the last datagram said; valid until the next.
	const std::vector<PersonUpdate> &people() const { return _person_updates; }
	const std::vector<BodyUpdate> &bodies() const { return _body_updates; }
	/// The last datagram's mark, or null.
	const Mark *mark() const { return _has_mark ? &_last_mark : nullptr; }
	/// Tick of the last datagram that was fine.
	uint32_t tick() const { return _last_tick; }
	int tick_rate() const { return _rate; }
	const Skeleton &shape() const { return _skeleton; }

	/// Forgets people who are not in a list.
	void keep_people(const std::vector<uint16_t> &p_people);
	/// Whether a mark is wanted in every datagram.
	void want_marks(bool p_wanted) { _wants_marks = p_wanted; }
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

	Outcome _read_header(Reader &r_reader, int &r_people);
	Outcome _read_people(Reader &r_reader, int p_count);
	Outcome _read_bodies(Reader &r_reader);
	bool _is_known(uint8_t p_number, uint32_t p_tick) const;
	bool _is_astray(const Reader &p_reader);
	void _note(uint8_t p_number);
	void _keep(uint32_t p_tick);

	Skeleton _skeleton;
	PersonLattice _lattice;
	PersonCodec _codec;
	std::unordered_map<uint16_t, std::unique_ptr<History<PersonState>>> _people_known;
	std::unordered_map<uint16_t, std::unique_ptr<History<BodyState>>> _bodies_known;
	std::vector<PersonScratch> _person_scratch;
	std::vector<BodyScratch> _body_scratch;
	std::vector<PersonUpdate> _person_updates;
	std::vector<BodyUpdate> _body_updates;
	Mark _last_mark;
	bool _has_mark = false;
	int _rate = 0;
	int _read_rate = 0;
	uint32_t _last_tick = NEVER;
	uint32_t _newest_tick = NEVER;
	uint8_t _newest_number = 0;
	uint64_t _earlier_numbers = 0;
	bool _has_numbers = false;
	bool _owes_ack = false;
	bool _wants_all = false;
	bool _wants_marks = false;
	int _strays = 0;
	uint32_t _stray_tick = NEVER; // Of the last of them.
};

} // namespace wire
