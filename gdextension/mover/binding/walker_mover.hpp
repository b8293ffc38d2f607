// SPDX-License-Identifier: MIT
#pragma once

#include "body_surroundings.hpp"

#include <mover.hpp>

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/vector2.hpp>
#include <godot_cpp/variant/vector3.hpp>

namespace godot {

/// Moves a person who walks by keys or a stick. Documented in doc_classes/WalkerMover.xml.
class WalkerMover : public RefCounted {
	GDCLASS(WalkerMover, RefCounted)

public:
	enum Stance {
		STAND,
		CROUCH,
		PRONE
	};
	enum Mode {
		WALK,
		VAULT,
		LADDER,
		BODY
	};

	void enter(const RID &p_space, const Ref<Resource> &p_world, int64_t p_mask);
	void set_carrier(const RID &p_body, int64_t p_number);
	void set_ladder(const RID &p_body, bool p_is_ladder);
	void set_passable(const RID &p_body, bool p_is_passable);
	void clear_bodies();

	void place(const Vector3 &p_position, double p_heading);
	void follow_body(const Vector3 &p_position, double p_heading);
	Vector3 push(const Vector3 &p_motion);
	void set_hold(const Vector2 &p_hold);
	Vector2 hold_back(const Vector2 &p_wish) const;
	void tick(const Vector2 &p_wish, double p_heading, int64_t p_stance, bool p_jumps, double p_delta);
	PackedByteArray get_state() const;
	bool set_state(const PackedByteArray &p_bytes);
	int64_t get_check() const { return _state.check(); }

	Vector3 get_position() const;
	Vector3 get_velocity() const;
	double get_heading() const { return double(_state.heading); }
	double get_lift() const { return double(_state.lift); }
	int64_t get_stance() const { return int64_t(_state.stance); }
	int64_t get_mode() const { return int64_t(_state.mode); }
	bool is_grounded() const { return _state.is_grounded != 0; }
	int64_t get_carrier() const { return int64_t(_state.carrier); }

protected:
	static void _bind_methods();

private:
	BodySurroundings _surroundings;
	mover::Mover _mover{ _surroundings };
	mover::State _state;
};

} // namespace godot

VARIANT_ENUM_CAST(WalkerMover::Stance);
VARIANT_ENUM_CAST(WalkerMover::Mode);
