// SPDX-License-Identifier: MIT
#pragma once

#include "footing.hpp"
#include "inertia.hpp"
#include "player.hpp"

#include <limits>
#include <memory>

namespace matching {

/// What a walker is to be shown doing in a tick. In the world, m and s.
struct Wish {
	Vec3 position; ///< Of the mover, on the ground.
	Vec3 velocity;
	float heading = 0.0f; ///< rad about +Y, 0 faces +Z.
	Vec3 wished_velocity;
	float wished_heading = 0.0f;
	Stance stance = STAND;
	bool is_grounded = true;
	/// Height of the ground under each foot; NaN: as high as the mover.
	std::array<float, 2> ground{ std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::quiet_NaN() };

	/// Whether somebody can be there and move so.
	bool is_sound() const {
		// Comparisons that NaN fails, too.
		return position.length() < 1e6f && velocity.length() < 1e3f && wished_velocity.length() < 1e3f &&
				std::fabs(heading) < 1e3f && std::fabs(wished_heading) < 1e3f;
	}
};

/// Turns what a mover does into the pose of a person: motion of a set that fits best, changed to fit wholly. The same
/// set, body and wishes give the same bits; a copy goes on as the original would.
class MotionMatcher {
public:
	void set_motion_set(std::shared_ptr<const MotionSet> p_set);
	/// Goes on by another set, from the pose at hand: nothing jumps.
	void change_motion_set(std::shared_ptr<const MotionSet> p_set);
	void set_body(const Body &p_body) { _body = p_body; }
	const Body &body() const { return _body; }
	/// Stands at a place from now on.
	void reset(const Vec3 &p_position, float p_heading);
	/// A tick. A wish that is not sound, or no set, changes nothing.
	void advance(float p_delta, const Wish &p_wish);
	/// In the world, m.
	const Pose &pose() const { return _pose; }
	/// A point that is so far from an ankle in the foot's axes in the reset pose, in the world, m.
	Vec3 sole_point(std::size_t p_side, const Vec3 &p_from_ankle) const {
		return ankle_of(_body, _pose, p_side) + _pose.limbs[foot_of(p_side)].rotate(p_from_ankle);
	}
	bool is_planted(std::size_t p_side) const { return _footing.is_planted(p_side); }
	/// Searches since the last reset.
	int searches() const { return _searches; }
	/// The clip that is played, or an empty text.
	const char *clip_name() const;

private:
	/// Follows a value smoothly.
	struct Follow {
		Vec3 value;
		void go(const Vec3 &p_to, float p_delta, float p_halflife) {
			value = value + (p_to - value) * (1.0f - std::exp2(-p_delta / p_halflife));
		}
	};
	/// How a clip is changed to go where the mover goes.
	struct Warp {
		float stride = 1.0f;
		float turn = 0.0f; ///< rad.
		float hips_turn = 0.0f; ///< rad.
	};

	Way _predict(const Wish &p_wish) const;
	bool _is_search_due(float p_delta, const Wish &p_wish);
	void _choose_gait(float p_speed);
	float _rate(const Wish &p_wish) const;
	Warp _warp(const Wish &p_wish, const Player::Sample &p_sample) const;
	Pose _changed(const Player::Sample &p_sample, const Warp &p_warp) const;
	void _lean(float p_delta, const Wish &p_wish, Pose &r_pose);
	void _breathe(float p_delta, Pose &r_pose);
	Pose _made(const Wish &p_wish, const Pose &p_from, Stance p_stance) const;
	void _put_on_feet(float p_delta, const Wish &p_wish, const Player::Sample &p_sample, Pose &r_pose);
	float _most_drop() const;
	void _lower_hips(float p_delta, const std::array<Vec3, 2> &p_ankles, Pose &r_pose);
	void _keep_above_ground(const Wish &p_wish, Pose &r_pose) const;
	void _advance_stances(float p_delta, const Wish &p_wish);
	Pose _in_world(const Pose &p_pose) const;

	std::shared_ptr<const MotionSet> _set;
	Body _body = Body::of(1.0115f);
	Player _player;
	Inertia _inertia;
	Footing _footing;
	Pose _pose;
	Vec3 _origin; ///< Where the frame of the pose is, on the ground.
	float _heading = 0.0f;
	Vec3 _before; ///< The mover's velocity a tick ago.
	Vec3 _searched_velocity; ///< What was wished when it was last searched.
	float _searched_heading = 0.0f;
	Stance _searched_stance = STAND;
	bool _runs = false;
	float _until_search = 0.0f;
	float _blocked_s = 0.0f; ///< For how long the mover has not moved though it wanted to.
	float _time = 0.0f;
	float _travelled = 0.0f;
	float _drop = 0.0f; ///< How far the hips are lowered for the legs to reach, m.
	float _landing = 0.0f; ///< How far the knees give way after a jump, m, and how fast.
	float _landing_speed = 0.0f;
	Follow _acceleration;
	Follow _head; ///< x: how far the head is turned ahead, rad.
	Stance _made_stance = PRONE; ///< Which made pose is shown, by _made_share.
	float _made_share = 0.0f;
	float _crouch_share = 0.0f;
	float _air_share = 0.0f;
	bool _was_grounded = true;
	int _searches = 0;
	bool _enters = false; ///< Another set is entered in the next tick, from these features in the last one.
	Features _entering{};
};

} // namespace matching
