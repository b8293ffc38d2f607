// SPDX-License-Identifier: MIT
#pragma once

#include "coding/person_codec.hpp"
#include "replication/body_codec.hpp"
#include "replication/client_record.hpp"
#include "replication/datagram.hpp"
#include "replication/field_codec.hpp"

#include <memory>
#include <unordered_map>
#include <vector>

namespace wire {

/// An entity's fields at a tick, as they were received.
struct FieldUpdate {
	uint32_t tick = 0;
	uint16_t id = 0;
	const EntityType *type = nullptr;
	const uint32_t *values = nullptr; ///< As whole numbers, as many as the type has fields.
};

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
	const std::vector<FieldUpdate> &fields() const { return _field_updates; }
	/// The last datagram's mark, or null.
	const Mark *mark() const { return _has_mark ? &_last_mark : nullptr; }
	/// The newest command that the server has applied, of which a datagram has said so; -1 if none has.
	int command_ack() const { return _command_ack; }
	/// Where in a datagram the MOTION_ACK_BYTES bytes of SnapshotEncoder::set_motion_ack() are, or null: a
	/// thread that needs them at once finds them here. It may be a datagram that decode() would not take.
	static const uint8_t *find_motion_ack(const uint8_t *p_bytes, std::size_t p_size);
	/// Tick of the last datagram that was fine.
	uint32_t tick() const { return _last_tick; }
	int tick_rate() const { return _rate; }
	const Skeleton &shape() const { return _skeleton; }

	/// What the entity table says. Once there is an entity, datagrams with people, bodies or fields of others are
	/// broken. An entity that was removed is still read for a while, but nothing of it is reported.
	EntityTypes &types() { return _types; }
	/// False if the type is not defined or has another number of fields.
	bool add_entity(uint16_t p_id, uint8_t p_type, const float *p_values, std::size_t p_count);
	void remove_entity(uint16_t p_id);
	bool has_entity(uint16_t p_id) const;
	/// The version of the entity table that we have: acknowledgements say it.
	void set_table_version(uint32_t p_version);
	/// An entity's type, and its newest fields; null if there is none.
	const EntityType *type_of(uint16_t p_id) const;
	const uint32_t *newest_fields(uint16_t p_id) const;
	const uint32_t *spawn_fields(uint16_t p_id) const;
	/// Counts how often an id was added: another number is another entity.
	uint32_t generation_of(uint16_t p_id) const;

	/// Forgets people who are not in a list.
	void keep_people(const std::vector<uint16_t> &p_people);
	/// Whether a mark is wanted in every datagram.
	void want_marks(bool p_wanted) { _wants_marks = p_wanted; }
	/// An acknowledgement, with room for a viewpoint.
	using Ack = std::array<uint8_t, ClientRecord::ACK_BYTES + ClientRecord::VIEWPOINT_BYTES>;
	/// Writes an acknowledgement of what has come; 0 bytes if nothing has, or nothing new. The viewpoint is said when
	/// it has moved by VIEWPOINT_STEP_M, and once a second.
	std::size_t write_ack(const Vec3 &p_viewpoint, Ack &r_bytes);
	static constexpr float VIEWPOINT_STEP_M = 0.25f;
	/// Datagrams since the last acknowledgement. It speaks of no more than ClientRecord::ACKED_BEFORE.
	int unacknowledged() const { return _unacknowledged; }
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
	// What the entity table says of an id.
	struct Known {
		const EntityType *type;
		FieldHistory history;
		std::vector<uint32_t> newest;
		uint32_t newest_tick = NEVER;
		uint32_t generation = 0;
		bool is_removed = false;
		uint32_t removed_tick = NEVER;
	};
	// One datagram being read.
	struct Reader {
		const uint8_t *bytes = nullptr;
		std::size_t size = 0;
		std::size_t at = 0;
		uint32_t tick = 0;
		int command_ack = -1;
		Baseline usual;
		int people = 0;
		uint8_t flags = 0;
		uint8_t number = 0;
		bool is_key = false;
		bool follows_gap = false; // Its number says nothing about those before.
		const uint8_t *mark = nullptr;
		const uint8_t *command_bytes = nullptr;
		const uint8_t *motion_ack = nullptr;
	};

	Outcome _read_header(Reader &r_reader);
	static bool _read_begin(Reader &r_reader);
	static bool _find_extras(Reader &r_reader);
	bool _read_extras(Reader &r_reader);
	Outcome _read_people(Reader &r_reader);
	Outcome _read_fields(Reader &r_reader);
	Outcome _read_entity(
			RangeDecoder &p_decoder, FieldCodec &r_codec, const Reader &p_reader, Known &p_known, int p_age);
	Known *_find_known(uint16_t p_id) const;
	bool _may_be_sent(uint16_t p_id) const { return _known.empty() || _find_known(p_id) != nullptr; }
	bool _is_gone(uint16_t p_id) const;
	void _keep_fields(uint32_t p_tick);
	void _sweep_removed();
	void _forget_snapshots();
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
	EntityTypes _types;
	std::unordered_map<uint16_t, std::unique_ptr<Known>> _known;
	std::vector<uint16_t> _field_scratch; // Ids; their fields are in _field_values.
	std::vector<uint32_t> _field_values;
	std::vector<FieldUpdate> _field_updates;
	uint32_t _table_version = 0;
	uint32_t _generations = 0;
	int _command_ack = -1;
	Vec3 _sent_viewpoint;
	uint32_t _viewpoint_tick = NEVER;
	int _unacknowledged = 0;
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
