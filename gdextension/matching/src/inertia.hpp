// SPDX-License-Identifier: MIT
#pragma once

#include "pose.hpp"

namespace matching {

/// How fast a critically damped spring settles: computed once for all that share it in a tick.
struct Damping {
	float rate = 0.0f; ///< 1/s.
	float left = 1.0f; ///< What a tick leaves of an offset that stands still.
	float delta = 0.0f;

	/// Halves about every `p_halflife` s.
	static Damping of(float p_halflife, float p_delta) {
		const float rate = 2.0f * 0.69314718f / p_halflife;
		return { rate, std::exp(-rate * p_delta), p_delta };
	}
};

/// An offset that goes to zero as a critically damped spring does, with the speed that it had.
struct Decay {
	Vec3 offset;
	Vec3 velocity;

	void advance(const Damping &p_damping) {
		const Vec3 push = velocity + offset * p_damping.rate;
		offset = (offset + push * p_damping.delta) * p_damping.left;
		velocity = (velocity - push * (p_damping.rate * p_damping.delta)) * p_damping.left;
	}
};

/// Lets a body go from one motion to another without a jump: keeps the difference and lets it decay
/// (Bollo 2018: inertialization).
class Inertia {
public:
	void reset();
	/// Notes that from now on another motion is played: `p_new` is its pose now, `p_next` a tick later.
	void change(const Pose &p_new, const Pose &p_next, float p_delta);
	/// Puts what is left of the differences on a pose.
	void apply(float p_delta, Pose &r_pose);

private:
	static constexpr float HALFLIFE_S = 0.085f;

	std::array<Decay, LIMBS> _limbs{};
	std::array<Decay, 3> _places{}; ///< Hips and ankles.
	Pose _last;
	Pose _before;
	bool _is_known = false;
};

} // namespace matching
