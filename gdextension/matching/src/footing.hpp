// SPDX-License-Identifier: MIT
#pragma once

#include "body.hpp"

namespace matching {

/// Where the motion would have a foot, in the world.
struct FootGoal {
	Vec3 ball; ///< m.
	Quat foot; ///< Rotation of the foot from the reset pose.
	float ground = 0.0f; ///< Height of the ground there, m.
	bool stands = false; ///< Whether the motion has it on the ground.
};

/// Keeps feet that stand where they stand, and lets them step to where the motion has them: the balls of the feet are
/// what stands, so that heels rise as the motion says.
class Footing {
public:
	/// What the feet are to do now.
	struct Goals {
		std::array<FootGoal, 2> feet{};
		std::array<Vec3, 2> hip_joints{}; ///< Where the legs begin, in the world, m.
		float leg = 1.0f; ///< How far from there an ankle can be, m.
		Vec3 ball; ///< From the ankle, in the foot's axes in the reset pose, m.
		Vec3 heel; ///< From the ball, in the foot's axes in the reset pose, m.
		Vec3 velocity; ///< Of the person, m/s.
		bool is_walking = false; ///< Whether the motion steps by itself.
		bool is_grounded = true;
	};

	/// Puts both feet where the motion has them.
	void reset() { *this = Footing(); }
	/// Changes the goals to where the feet are.
	void advance(float p_delta, float p_size, Goals &r_goals);
	bool is_planted(std::size_t p_side) const { return _feet[p_side].is_planted; }

private:
	struct Foot {
		bool is_known = false;
		bool is_planted = false;
		bool is_forced = false; ///< Steps because it stood too far off.
		Vec3 place; ///< Of the ball that stands, m.
		float turn = 0.0f; ///< How far it has turned from the goal while standing, rad.
		float heading = 0.0f;
		Vec3 offset; ///< From the goal, when it was lifted.
		float time = 0.0f;
		float length = 0.0f; ///< Of the step, s.
		float height = 0.0f; ///< Above the ground, m.
		Vec3 last; ///< Where the ball was, m.
	};

	static void _clear(float p_delta, const Goals &p_goals, Foot &r_foot, FootGoal &r_goal);
	void _lift(const FootGoal &p_goal, bool p_is_forced, Foot &r_foot) const;
	bool _is_out_of_reach(const Goals &p_goals, std::size_t p_side) const;
	bool _must_step(const Goals &p_goals, std::size_t p_side, float p_size) const;
	void _swing(const Goals &p_goals, float p_delta, float p_size, std::size_t p_side, FootGoal &r_goal);

	std::array<Foot, 2> _feet{};
};

} // namespace matching
