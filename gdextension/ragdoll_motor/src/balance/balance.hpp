// SPDX-License-Identifier: MIT
#pragma once

#include "balance/foothold.hpp"
#include "balance/knock.hpp"
#include "balance/loose_ground.hpp"
#include "balance/recovery.hpp"
#include "base/archive.hpp"
#include "body/leg.hpp"
#include "body/rig.hpp"

#include <vector>

namespace ragdoll {

/// Parameters of a body that stands on its own feet.
///
/// The numbers were found by `bench ground` on the repository's three clips, 56 foreign ones and pushes
/// from four sides, one at a time; where a range is given, it held there.
struct BalanceSettings {
	/// Greatest horizontal force from outside as a share of the weight. Nothing pulls upwards. 0 to 0.1:
	/// people stand as well, they drift less with more.
	float residual = 0.06f;
	/// Greatest torque from outside at the hips, N m: of somebody whose feet move (600 to 800; with 300
	/// runners fall), and of somebody who has stood for some time and is to give way (230 to 270).
	float torque = 800.0f;
	float standing_torque = 240.0f;
	/// While feet move, what holds the hips is no stronger than a spring and a damper are at the beginning of a step, N
	/// m, N m/rad, N m s/rad: what answers a foot's impact within the same step fights it. Medians of 11 walks and 10
	/// runs of foreign clips: without 469 and 795 N m, 0.82 and 5.2 deg off; with these 357 and 681, 0.92 and 5.3; with
	/// 3000 and 300 they are 279 and 598, but 1.6 and 7.3 deg off; with 12,000 and 600 373 and 701, 0.86 and 5.2.
	float hold_torque = 50.0f;
	float hold_stiffness = 6000.0f;
	float hold_damping = 600.0f;
	/// And of somebody who stands at ease: so much (N m), and so much more as the hips lean from where the motion has
	/// them, N m/rad. Two joints that hold the same hips, legs and world, pull against each other, with 27 N m as
	/// stiff as they are; so legs carry and 7 N m are left. With 12,000 who is hit by a ball comes back after 0.8
	/// instead of 0.6 s.
	float quiet_torque = 4.0f;
	float quiet_stiffness = 30000.0f;
	/// Greatest torque from outside of somebody who is knocked (see Knock), N m: he is left to his feet.
	float knocked_torque = 80.0f;
	/// What the torque of legs and trunk is multiplied by while the feet move: they have to swing limbs
	/// whose inertia is scaled, and to catch a runner's weight (1.5 to 3).
	float bearing = 2.0f;
	/// How eagerly the pose of somebody who has stood for some time is corrected: with 1 a stiff body shakes
	/// over stiff ankles (4.6 deg/s; 0.003 with 0.4).
	float standing_eagerness = 0.4f;
	/// The joints above the legs of somebody who has stood for some time swing with this frequency, Hz, see
	/// ease_limbs(). A ball of 5 kg at 10 m/s turns the trunk by 11 to 14 deg with 1.3, by 9 to 12 with 1.5 (back
	/// within 2 deg after 0.5 to 0.6 s), by 6 to 9 with 2.
	float ease_frequency = 1.5f;
	/// The part of the torque that may brake a body that swings back; gravity and inertia take the rest
	/// (0.25 to 1; without it the body swings to and fro over its feet).
	float braking = 0.5f;
	/// How fast the centre of mass is brought back to where the motion has it, 1/s.
	float follow = 2.0f;
	/// How slowly that force changes, s: at once, a stiff body over stiff ankles shakes.
	float smooth_s = 0.3f;
	/// How far feet may slide from where the motion has them before the motion's position gives in, m.
	float slack = 0.08f;
	/// How fast a person who walks comes back to where the motion is, m/s, how much faster for each metre
	/// that the tether is longer than the slack, 1/s, and how fast at most (with 0.5 runners fell). With 0.04, 0.5
	/// and 0.25 a body that walks up a slope of 5 deg loses 3 to 8 % of its way, with these 2 to 5 %; with 0.15
	/// walks on level ground are off by 1.03 instead of 0.74 deg (median of 14).
	float walk_back = 0.1f;
	float walk_back_faster = 1.0f;
	float walk_back_most = 0.4f;
	/// A foot of the motion that moves faster than this swings, until it is slower than half of it, m/s.
	float swing_speed = 0.6f;
	/// How fast a foot in the air is put elsewhere than the motion has it, m/s.
	float foot_speed = 1.5f;
	/// How feet find the ground.
	FootholdSettings foothold;
	/// How fast the body follows its feet up and down, m/s.
	float rise_speed = 1.0f;
	/// A foot in the air is raised by how much lower the hips are than legs and motion mean them to be, up to the
	/// first number, m: who lands from a stride sinks, and would trip over that foot; of who walks, only beyond the
	/// second one. Without, 24 runs of foreign clips are off by 4.6 deg and 1.07 m from their wearers (mean of the
	/// errors, median of the greatest distances), with these by 3.8 and 0.34; with 0.15 3 of them fall. With no slack
	/// for walkers, 11 walks are off by 1.13 instead of 0.89 deg (median).
	float sunk_most = 0.1f;
	float sunk_slack = 0.02f;
	/// The motion runs while both feet are faster than this, m/s, and for so long after, s. With 1.5 one runner gets
	/// 3.9 m away, with 1 who walks fast counts as well.
	float run_speed = 1.2f;
	float run_s = 0.6f;
	/// A leg that stands is to be no longer than it is by more than this, m, 0 for no limit: joints bring a leg that a
	/// landing has bent back so fast that the body is thrown up, and lands harder. For motions that are made for the
	/// body: with 0.01 walkers (`bench walker`) do not hop, but 22 recorded walks and runs are off by 3.7 instead of
	/// 2.7 deg (median), as runners take off by it.
	float leg_push = 0.0f;
	/// How legs behave over loose things.
	LooseGroundSettings loose;
	/// Somebody who stands takes a step from this distance of the capture point on, m: somewhat more than
	/// what the length of a foot can hold.
	float step_from = 0.22f;
	/// Feet that swing anyway are put towards the capture point from this distance on, m, by this part of
	/// what is beyond it (from 0.1 m on, the legs of runners are off by 5 degrees more).
	float swing_from = 0.6f;
	float swing_gain = 0.5f;
	/// How fast the body goes after a foot that was put elsewhere, m/s.
	float follow_step = 1.0f;
	/// Nobody takes a step of their own sooner after a foot of the motion swung, s.
	float stand_s = 0.3f;
	/// A foot that was put further than this from where the motion has it comes back by a step, m.
	float close_from = 0.03f;
	/// How long a step takes, s, and how high the foot is lifted, m.
	float step_s = 0.3f;
	float step_height = 0.07f;
	/// Longest step, m.
	float longest_step = 0.45f;
};

/// What the balance of a body knows at the beginning of a step.
struct BalanceInput {
	const RigState *state = nullptr;
	const Ground *ground = nullptr; ///< Null for none: feet are where the motion has them.
	/// How the motion's frame moves in this step with what carries the person, a seat or a platform: a point
	/// p of the world is at turn p + shift (m) at its end.
	Quat turn;
	Vec3 shift;
	float gravity = 9.81f; ///< m/s^2
	bool is_limp = false; ///< Nothing drives the body.
	float delta_s = 0.0f;
};

/// Keeps a body on its own feet whose position is known.
///
/// The feet carry it; from outside comes only a small horizontal force, and a torque that keeps the hips
/// upright. How far a body is out of balance is told by the capture point (Pratt, Carff, Drakunov, Goswami
/// 2006, "Capture point: a step toward humanoid push recovery", eq. 7: x + v sqrt(h / g)), relative to that
/// of the motion. Feet that swing anyway are put down towards it, as in SIMBICON (Yin, Loken, van de Panne
/// 2007, section 3.2); from a distance on a standing person takes steps. Where the world holds a body back,
/// or a push has moved it, the position of the motion gives in, and comes back as the person walks. Feet follow
/// the ground under them.
class Balance {
public:
	Balance() = default;
	Balance(const Rig &p_rig, const std::vector<ContactPoint> &p_contacts);

	/// Begins a step: bends the motion's pose at its beginning and end to what the body can do.
	void advance(const Rig &p_rig, const BalanceInput &p_input, Pose &r_now, Pose &r_next);
	/// The body has been put into the motion's pose.
	void clear();
	/// The motion went elsewhere at once where the body cannot follow: the tether takes it all, m.
	void shift(const Vec3 &p_by) { _offset = _offset + p_by; }

	/// The force on the hips in this step, world axes, N.
	const Vec3 &get_force() const { return _force; }
	/// The most that the force may be, N.
	float get_force_limit() const { return _force_limit; }
	/// What a joint's torque is multiplied by.
	/// @param p_bears whether the limb is one of the legs or of the trunk
	float get_strength(bool p_bears) const { return _recovery.get_strength() * (p_bears ? _bearing : 1.0f); }
	/// Whether it falls, and how far it has got up.
	const Recovery &get_recovery() const { return _recovery; }
	/// Greatest torque at the hips in this step, N m.
	float get_torque() const { return _torque; }
	/// How much at ease somebody stands, 0 to 1: the limbs above the legs give way then.
	float get_ease() const { return _ease; }
	/// What corrections of the pose are multiplied by.
	float get_eagerness() const { return _eagerness; }
	/// How fast that torque can brake the whole body as it turns about its feet, rad/s^2.
	float get_deceleration() const { return _deceleration; }
	/// From where the motion has the hips to the position that the body holds instead, m: the tether.
	const Vec3 &get_offset() const { return _offset; }
	/// Distance of the body's capture point from the motion's, horizontal, m.
	const Vec3 &get_capture_error() const { return _capture; }
	/// Whether a step is being taken that the motion does not have.
	bool is_stepping() const;

	void save(ArchiveWriter &p_archive) const;
	bool restore(ArchiveReader &p_archive);

	BalanceSettings settings;

private:
	struct Foot {
		Leg limbs;
		Vec3 ball; // From the ankle, in the foot's frame, m.
		Vec3 wanted; // Where the motion has the ankle, m.
		Vec3 shown; // Where the body has it, m.
		Vec3 offset; // How far it is put from where the motion has it at the body's place, horizontal, m.
		Foothold hold; // What it stands on, and how much higher it is put.
		bool swings = false;
		float step_s = -1.0f; // Since a step of its own began; below 0 for none.
		float lift = 0.0f; // m
		Vec3 give; // How far it is drawn to the hip over loose things, m.
		bool is_new = false; // It was put where the body is to go.

		bool is_up() const { return swings || step_s >= 0.0f; }

		/// Calls with each field that is saved. One by one: what lies between them is not the same every
		/// time, and whose legs these are is not for an archive to say.
		template <class FootType, class Call>
		static void for_each_saved(FootType &r_foot, const Call &p_call) {
			p_call(r_foot.offset);
			p_call(r_foot.swings);
			p_call(r_foot.is_new);
			p_call(r_foot.step_s);
		}
	};

	/// Where the ball of a foot is from its ankle, in the foot's frame, m.
	Vec3 find_ball(int p_foot) const;
	void carry(const Quat &p_turn);
	void find_error(const Rig &p_rig, const BalanceInput &p_input, const Pose &p_now, const Pose &p_next);
	void move_offset(const BalanceInput &p_input);
	void begin_steps();
	void move_foot(const BalanceInput &p_input, const Pose &p_now, Foot &r_foot);
	/// How fast the motion moves a limb's joint, what carries the person aside, m/s.
	Vec3 find_velocity(const BalanceInput &p_input, std::size_t p_limb) const;
	/// How many feet the motion moves faster than p_speed, m/s.
	std::size_t count_moving(const BalanceInput &p_input, float p_speed) const;
	/// @param p_velocity of the motion's foot, level, m/s
	void follow_ground(const BalanceInput &p_input, const Pose &p_now, const Vec3 &p_velocity, Foot &r_foot);
	/// Nothing holds or moves it: it was put somewhere, or lies.
	void rest();
	/// Sees how far the body has sunk on its legs, and whether over loose things.
	void find_sunk(const BalanceInput &p_input, const Pose &p_now);
	/// How far a foot is put from where the motion has it, seen from the body, m.
	Vec3 find_away(const Foot &p_foot) const;
	/// Lets a leg push no more than it may.
	void give_way(const Rig &p_rig, const RigState &p_state, Foot &r_foot) const;
	void find_deceleration(const Rig &p_rig);
	void stay(const Rig &p_rig, const BalanceInput &p_input, Pose &r_now, Pose &r_next);
	void push(const Rig &p_rig, const BalanceInput &p_input);
	void bend(const Rig &p_rig, Pose &r_pose, std::vector<Vec3> &r_joints);
	float sole_height(const Pose &p_pose, const Foot &p_foot) const;

	std::vector<ContactPoint> _contacts;
	std::vector<Foot> _feet;
	Recovery _recovery;
	float _height = 0.0f; // Of the centre of mass over the lowest limb, m.
	float _wanted_height = 0.0f; // The same of the motion, m.
	float _speed = 0.0f; // Of the centre of mass, m/s.
	std::vector<Vec3> _joints_now;
	std::vector<Vec3> _joints_next;
	Vec3 _offset; // m
	LooseGround _loose;
	float _sunk = 0.0f; // How much lower the hips are than feet in the air may take them to be, m.
	float _ran_s = 1e9f; // Since the motion ran.
	Vec3 _error; // Of the centre of mass, horizontal, m.
	Vec3 _velocity_error; // m/s
	Vec3 _capture; // m
	float _lean = 0.0f; // Of the hips, from where the motion has them, rad, ...
	float _spin = 0.0f; // ... and their angular velocity from that of the motion, rad/s.
	Vec3 _force; // N
	float _force_limit = 0.0f; // N
	float _torque = 0.0f; // N m
	float _bearing = 1.0f;
	float _eagerness = 1.0f;
	float _ease = 0.0f; // How much at ease somebody stands, 0 to 1.
	float _deceleration = 0.0f; // rad/s^2
	Vec3 _velocity; // Of the centre of mass, horizontal, m/s.
	Knock _knock;
	float _stood_s = 0.0f; // Since a foot of the motion swung.
	float _calm_s = 0.0f; // Since any foot was in the air.
	bool _begun = false;
};

} // namespace ragdoll
