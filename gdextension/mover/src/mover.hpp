// SPDX-License-Identifier: MIT
#pragma once

#include "mover_state.hpp"

namespace mover {

/// What a walker can do. Human: a sprinter reaches 10 m/s, who wears boots and a rifle 5; 0.35 m is the seat of a
/// chair.
struct Ability {
	/// Highest speed ahead, of each stance, m/s; its share sideways and backwards, and the most there, m/s.
	std::array<float, STANCES> speed{ 5.5f, 1.6f, 0.6f };
	float speed_back = 0.5f;
	float most_back = 1.6f;
	/// On the ground, to get faster and to brake, and in the air, m/s^2: more, and the body would not come after.
	float acceleration = 3.5f;
	float braking = 4.0f;
	float air_acceleration = 2.0f;
	/// How fast the body turns to where it is to face, rad/s.
	float turn_rate = 9.0f;
	/// What is stepped onto in walking, and how far feet are held to the ground that sinks, m.
	float step = 0.35f;
	float snap = 0.25f;
	/// How fast the body gets up and down steps and slopes, m/s, and how far it may be behind its feet, m.
	float climb = 1.6f;
	float most_lift = 0.25f;
	/// Upwards speed of a jump, m/s: 0.46 m high.
	float jump = 3.0f;
	/// What is climbed by hands, m.
	float vault = 1.2f;
	float ladder_speed = 0.9f;
	float gravity = 9.81f;
};

/// Moves a walker by one tick: a pure function of the state, the wish and the surroundings. Nothing is kept, so that a
/// tick can be made again from any state, and server and client agree to the bit. A cylinder, as the round foot of a
/// capsule finds no floor on the edge of a step.
class Mover {
public:
	explicit Mover(const Surroundings &p_surroundings) : _surroundings(p_surroundings) {}
	/// What it can do.
	Ability ability;

	/// Goes on by a tick of so many seconds. A wish that is none (NaN) counts as standing still.
	void tick(State &r_state, const Wish &p_wish, float p_delta) const;
	/// What is left of a level wish, m/s, where something holds the body back.
	static Vec3 held(const State &p_state, const Vec3 &p_wish);

private:
	void _ride(State &r_state, float p_delta) const;
	void _choose_stance(State &r_state, Stance p_wanted) const;
	Vec3 _wished_velocity(const State &p_state, const Wish &p_wish) const;
	void _walk(State &r_state, const Vec3 &p_wish, float p_delta) const;
	void _fly(State &r_state, float p_delta) const;
	bool _finds_floor(const State &p_state, Sweep &r_below) const;
	bool _step_up(State &r_state, const Vec3 &p_motion) const;
	void _slide(State &r_state, const Vec3 &p_motion, float p_delta) const;
	bool _begin_vault(State &r_state, float p_reach) const;
	void _vault(State &r_state, float p_delta) const;
	bool _takes_ladder(State &r_state, const Vec3 &p_wish, const Sweep &p_sweep) const;
	void _climb(State &r_state, const Vec3 &p_wish, float p_delta) const;
	void _stand_on(State &r_state, const Sweep &p_floor) const;

	const Surroundings &_surroundings;
};

} // namespace mover
