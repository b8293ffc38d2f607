// SPDX-License-Identifier: MIT
#pragma once

#include "balance/balance.hpp"
#include "body/energy_guard.hpp"
#include "control/feed_forward.hpp"
#include "control/world_drive.hpp"
#include "gait/foot_lock.hpp"
#include "gait/path_filter.hpp"
#include "joint/controller.hpp"
#include "joint/torque_meter.hpp"
#include "motion/tracking_meter.hpp"
#include "root/carrier.hpp"
#include "root/root_drive.hpp"
#include "root/tether.hpp"
#include "world/obstacles.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace ragdoll {

/// What the simulation gets for a step.
struct StepCommands {
	std::vector<LimbCommand> limbs;
	RootCommand root;
	Vec3 root_turn; ///< Turning rate of the root, limb's axes, rad/s.
	Vec3 trunk_turn; ///< The same of the limb that SELF_RIGHTING keeps upright.
	bool is_root_held = false; ///< The root is held at a pose instead of pulled.
	std::vector<Quat> orientations; ///< Of limbs that are held at a pose, at the step's end.
	std::vector<Vec3> joints; ///< Their joints, m.
	std::vector<LimbPush> pushes; ///< What feed-forward and world-space controls add to the limbs.
	/// Flags of GuardAction. Where there are any, or after a teleport, `must_put` is set and the state
	/// that was handed in has been mended and has to be given back to the simulation.
	std::uint32_t guarded = GUARD_NOTHING;
	bool must_put = false;
};

/// Everything that drives one ragdoll, without any engine: takes samples, and once a tick turns the
/// state of the bodies into commands. A tick allocates nothing.
class Driver {
public:
	/// Strength to which a body sinks when its stream has stalled: it holds its pose but gives way.
	static constexpr float STALLED_STRENGTH = 0.3f;
	/// Age of the newest sample (s) from which it sinks.
	static constexpr double LET_GO_AFTER = 0.25;
	/// A pause of the motion (s) after which the body is put into the new pose instead of being flung
	/// there; the beginning counts as one.
	static constexpr double PUT_AFTER = 1.0;
	/// For how long a body that comes is put into the motion's pose, until that is in motion, s; in the modes
	/// in which feet carry it or say where it is.
	static constexpr float ARRIVAL_S = 0.06f;
	/// GROUNDED: nobody is at ease whose fastest limb the motion turns faster than this, rad/s.
	static constexpr float EASE_BELOW = 0.5f;
	/// How long it takes to sink, and to come back, s.
	static constexpr float LET_GO_S = 0.25f;
	/// While a body gets up its root is lifted by so much for each radian that its limbs are off, m: a
	/// leg that lies askew could not pass under it.
	static constexpr float GETTING_UP_LIFT = 0.6f;
	/// Who does not come free is lifted further, from this on (s), by so much more a second, and so many times as
	/// far at most: until what lies on him falls off. Only where the travel is found.
	static constexpr float STUCK_S = 1.0f;
	static constexpr float LIFTS_MORE = 2.0f;
	static constexpr float MAX_LIFT = 3.0f;
	/// It has got up when its limbs are off by less than this, rad, for so long, s: legs that swing pass
	/// through the pose without being there.
	static constexpr float UPRIGHT = 0.02f;
	static constexpr float UPRIGHT_S = 0.2f;

	/// INERTIAL, CONTACTS, LOWEST_FOOT: how far the body may be held back from where the feet carry it
	/// (m) before the estimate gives in: a person who walks against a wall walks on the spot.
	static constexpr float SLACK = 0.05f;
	/// The same modes: how far the target may be above or below the body, and across, m. Nobody is lifted
	/// faster than he rises himself, and who lies on something that no ray sees stays there.
	static constexpr float FURTHEST_UP = 0.2f;
	static constexpr float FURTHEST_ACROSS = 0.12f;
	/// Modes that find the travel: by how much of themselves corrections fall where the motion is nothing
	/// but noise.
	static constexpr float CALMED = 0.75f;

	/// A root that becomes held is fetched with this speed (m/s and rad/s), not within a tick: that
	/// would fling the limbs.
	static constexpr float FETCH_SPEED = 3.0f;
	static constexpr float FETCH_TURN = 6.0f;
	/// It is there when it is off by less than this, m and rad.
	static constexpr float FETCHED = 0.02f;

	Driver(Rig p_rig, const std::vector<int> &p_groups, std::size_t p_group_count,
			const std::vector<ContactPoint> &p_contacts);
	Driver(const Driver &) = delete;
	Driver &operator=(const Driver &) = delete;

	const Rig &get_rig() const { return _rig; }
	PoseStream &get_stream() { return _stream; }
	const PoseStream &get_stream() const { return _stream; }
	ActuationTable &get_table() { return _table; }
	const ActuationTable &get_table() const { return _table; }
	Controller &get_controller() { return _controller; }
	EnergyGuard &get_guard() { return _guard; }
	TrackingMeter &get_meter() { return _meter; }
	const TrackingMeter &get_meter() const { return _meter; }
	const TorqueMeter &get_torques() const { return _torques; }

	RootSettings root_settings;
	RootMode root_mode = RootMode::SOFT;
	/// What there is to stand on, for the modes that find the root's travel; level ground at height 0
	/// where none is given. Must live as long.
	const Ground *ground = nullptr;
	/// What may stand in the way; nothing where none is given. Must live as long.
	const Obstacles *obstacles = nullptr;
	/// The limb that SELF_RIGHTING keeps upright besides the root; -1 for none.
	int righted_limb = -1;
	/// Whether torques are estimated; costs a microsecond or two a tick.
	bool measures_torque = false;

	bool push(double p_time_s, const float *p_orientations, const Vec3 &p_root, const float *p_rates);
	/// Sets the frame that the motion happens in at the end of the next step, in the world: that of a seat that
	/// carries the person. Until it is set again it moves with what the person stands on.
	void set_frame(const Quat &p_orientation, const Vec3 &p_origin);
	const Quat &get_frame_orientation() const { return _frame_next.orientation; }
	const Vec3 &get_frame_origin() const { return _frame_next.origin; }
	/// Forgets all samples. The next motion may have another clock; the body is put into its pose.
	void clear_motion();
	/// The commands for the next step. The stream must not be empty.
	/// @param p_time_s moment of the motion at which the step begins, s
	const StepCommands &step(RigState &r_state, double p_time_s, float p_delta_s);
	/// The state of bodies at rest in the motion's pose.
	void pose_state(double p_time_s, RigState &r_state);
	/// Changes how a limb is controlled within a time, s. Its actuation can still be changed by its group.
	void set_control(std::size_t p_limb, const LimbControl &p_control, float p_blend_s);
	/// Lets the limb that is nearest to a position (m) and those around it give way for a moment, see flinch();
	/// of one group, or of all (-1). Who calls it gives the body the impulse (N s), of which only is known here
	/// how much strength it takes not to be bent further than MAX_BEND. Returns the limb, or -1.
	int hit(const RigState &p_state, const Vec3 &p_impulse, const Vec3 &p_position, int p_group, float p_strength,
			float p_blend_s);
	/// The limbs' orientations, and the centre of the root's body (m), as they are shown: between the motion
	/// at the end of the last step and the simulation, by the limbs' physics blend.
	void blend_shown(const RigState &p_state, std::vector<Quat> &r_orientations, Vec3 &r_root_centre) const;
	/// Notes the bodies' state after a step that ended at a moment of the motion.
	void measure(double p_time_s, const RigState &p_state);
	/// Angle between each limb and the motion at the beginning of the last step, rad.
	const std::vector<float> &find_errors(const RigState &p_state);
	/// How much of each joint's greatest torque the last step needed, 0 to 1 and more. Needs
	/// measures_torque.
	const std::vector<float> &get_saturations() const { return _saturations; }
	/// The estimator of the root's travel of a mode, or null where the mode has none.
	const Travel *get_travel() const { return find_travel(root_mode); }
	/// What keeps a GROUNDED body on its feet.
	Balance &get_balance() { return _balance; }
	const Balance &get_balance() const { return _balance; }
	/// From where the motion has the root to the position that is held instead, m: what is in the way holds
	/// it back.
	Vec3 get_tether() const { return root_mode == RootMode::GROUNDED ? _balance.get_offset() : _tether.get_now(); }
	/// The target of the root at the end of the last step, m; who gets up is lifted to it.
	Vec3 get_root_target() const { return _next.root + _lift; }

	void save(ArchiveWriter &p_archive) const;
	/// Returns false, and is as before, where the archive is not of such a body.
	bool restore(ArchiveReader &p_archive);

private:
	/// Moves the motion's own frame with what carries the person.
	void ride(RigState &r_state, float p_delta_s);
	/// Where the motion's own frame is in the world.
	struct MotionFrame {
		Quat orientation;
		Vec3 origin; ///< m
		bool is_identity = true;

		void apply(Pose &r_pose) const;
		MotionFrame moved(const Ride &p_ride) const;
		void save(ArchiveWriter &p_archive) const;
		bool restore(ArchiveReader &p_archive);
	};

	bool read(ArchiveReader &p_archive);
	/// Of the limbs and contact points: whose state an archive is.
	std::uint64_t fingerprint() const;
	Travel *find_travel(RootMode p_mode) const;
	void travel(const RigState &p_state, float p_delta_s);
	void balance(const RigState &p_state, float p_delta_s);
	/// Holds the motion's position on the body's side of what is in its way. Returns whether the body is to be
	/// put into the motion's pose.
	/// @param p_begins whether the motion begins, wherever that may be
	/// @param p_jumps whether the motion is elsewhere at once
	bool hold_back(const RigState &p_state, bool p_begins, bool p_jumps, float p_delta_s);
	/// Moves the motion's root at the step's beginning and end, m.
	void shift_root(const Vec3 &p_now, const Vec3 &p_next);
	/// Whether the body cannot be put into the motion's pose, as something is between.
	bool is_walled_off(const RigState &p_state) const;
	/// Whether hips that are held have to be pulled instead, as something is in their way.
	bool is_obstructed(const RigState &p_state, float p_delta_s);
	void find_points(const Pose &p_pose, std::vector<Vec3> &r_points);
	void find_shown(const RigState &p_state);
	void shift_travel(Travel &r_estimator, const Vec3 &p_offset);
	/// Brings the estimate to where the body is held back or pushed to.
	/// @param p_off how far the body is from where it should be, m
	void give_in(Travel &r_estimator, const Vec3 &p_off);
	/// Keeps the estimate near the body.
	void stay_near(Travel &r_estimator, const RigState &p_state);
	/// Lets the estimator take the pose.
	void estimate(Travel &r_estimator, const RigState &p_state, float p_delta_s);
	bool has_come_back(double p_time_s);
	void hold_root(const RigState &p_state, float p_delta_s);
	void compute_limbs(const RigState &p_state, float p_delta_s);
	void put_into_pose(RigState &r_state);
	/// Puts the bodies into the pose of the step's beginning, at rest.
	void place(RigState &r_state);
	/// Gives bodies that have been put into the motion's pose its velocities too.
	void set_in_motion(RigState &r_state, float p_delta_s);
	float lift_while_getting_up(const RigState &p_state, float p_delta_s);
	void let_go_when_stalled(double p_time_s);
	void command_root(const RigState &p_state, float p_delta_s);
	void note_torques(const RigState &p_state, float p_delta_s);
	/// GROUNDED: lets the limbs above the legs of somebody who stands at ease give way.
	void ease_limbs(const RigState &p_state, float p_delta_s);
	void push_limbs(const RigState &p_state, float p_delta_s);

	Rig _rig;
	PoseStream _stream;
	ActuationTable _table;
	Controller _controller;
	WorldDrive _world;
	FeedForward _feed_forward;
	EnergyGuard _guard;
	TrackingMeter _meter;
	TorqueMeter _torques;
	StepCommands _commands;
	Pose _now;
	Pose _next;
	MotionFrame _frame_now;
	MotionFrame _frame_next;
	MotionFrame _frame_base; // Where it truly is, not where it was expected to be.
	bool _is_frame_set = true; // By whoever drives, since the last step.
	Carrier _carrier;
	std::vector<Vec3> _joints;
	std::vector<Vec3> _joints_next;
	std::vector<Quat> _measured;
	std::vector<float> _errors;
	std::vector<float> _saturations;
	std::array<std::unique_ptr<Travel>, 3> _travels; // LOWEST_FOOT, CONTACTS, INERTIAL.
	std::vector<ContactPoint> _contacts;
	std::vector<Vec3> _points_now;
	std::vector<Vec3> _points_next;
	std::vector<Vec3> _points_shown;
	std::vector<Vec3> _turns; // Rates of the limbs, world axes, rad/s.
	FootLock _foot_lock;
	Balance _balance; // GROUNDED.
	PathFilter _path; // Of the root, where it is found.
	Vec3 _next_root; // Where the step before was to bring the root, m.
	FlatGround _level_ground;
	RootMode _travelled = RootMode::SOFT; // The mode of the step before.
	static constexpr double NEVER = -1e30;
	float _arrival_s = 0.0f; // How much longer the body is put into the motion's pose.
	double _alive = NEVER; // When the motion was last not stalled, s.
	bool _has_resumed = false; // The motion was stalled in the step before.
	Quat _frame_turn; // How the motion's frame moves in this step.
	Vec3 _frame_shift; // m
	bool _was_limp = false;
	bool _is_getting_up = false;
	float _gets_up_s = 0.0f; // For how long.
	Tether _tether; // HELD, SOFT.
	float _obstructed_s = 0.0f; // HELD: how much longer the root is pulled instead.
	float _upright_s = 0.0f; // For how long its limbs have been where they belong.
	Vec3 _lift; // Of the root while the body gets up, m.
	bool _was_held = false;
	bool _is_fetched = false; // The root is moving to where it will be held.
};

} // namespace ragdoll
