// SPDX-License-Identifier: MIT
#pragma once

#include "balance/balance.hpp"
#include "body/energy_guard.hpp"
#include "clearance/self_clearance.hpp"
#include "control/limb_pushes.hpp"
#include "gait/root_travel.hpp"
#include "joint/controller.hpp"
#include "joint/torque_meter.hpp"
#include "motion/stream_watch.hpp"
#include "motion/tracking_meter.hpp"
#include "root/arrival.hpp"
#include "root/carried_frame.hpp"
#include "root/getting_up.hpp"
#include "root/held_root.hpp"
#include "root/landing.hpp"
#include "root/residual_meter.hpp"
#include "root/root_drive.hpp"
#include "root/surface_guard.hpp"
#include "root/tether.hpp"
#include "world/obstacles.hpp"

#include <cstdint>
#include <vector>

namespace ragdoll {

/// What the simulation gets for a step.
struct StepCommands {
	std::vector<LimbCommand> limbs;
	RootCommand root;
	Vec3 root_turn; ///< Turning rate of the root, limb's axes, rad/s.
	bool is_root_held = false; ///< The root is held at a pose instead of pulled.
	std::vector<Quat> orientations; ///< Of limbs that are held at a pose, at the step's end.
	std::vector<Vec3> joints; ///< Their joints, m.
	std::vector<LimbPush> pushes; ///< What feed-forward and world-space controls add to the limbs.
	/// Flags of GuardAction. Where there are any, or after a teleport, `must_put` is set and the state
	/// that was handed in has been mended and has to be given back to the simulation.
	std::uint32_t guarded = GUARD_NOTHING;
	bool must_put = false;
};

/// Drives one ragdoll, without any engine: takes samples of a motion, and once a tick turns the state of the bodies
/// into commands. It conducts; each part of the work has a class of its own. A tick allocates nothing.
///
/// How to use it: push() each sample as it comes. Before each step of the simulation, read the bodies' state and
/// call step(); give the commands to the simulation (and the state, where `must_put` says so); let it step. Read
/// the state again and call measure() to know how well the body follows.
class Driver {
public:
	/// From this age of the newest sample on (s) a body sinks: it holds its pose, but with so much of its strength
	/// only, so that it gives way.
	static constexpr double LET_GO_AFTER = 0.25;
	static constexpr float STALLED_STRENGTH = 0.3f;
	/// How long it takes to sink, and to come back, s.
	static constexpr float LET_GO_S = 0.25f;
	/// Modes that find the travel: corrections are lowered by this part where the motion is nothing but noise.
	static constexpr float CALMED = 0.75f;
	/// A jump that is shorter than this (m) cannot go through anything: nothing is looked for in its way.
	static constexpr float SHORT_JUMP = 0.05f;

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
	/// What keeps the motion's limbs out of its own body.
	SelfClearance &get_clearance() { return _clearance; }
	const SelfClearance &get_clearance() const { return _clearance; }
	TrackingMeter &get_meter() { return _meter; }
	const TrackingMeter &get_meter() const { return _meter; }
	const TorqueMeter &get_torques() const { return _torques; }
	/// What came from outside on the hips.
	const ResidualMeter &get_residual() const { return _residual; }

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
	void set_frame(const Quat &p_orientation, const Vec3 &p_origin) { _frame.set(p_orientation, p_origin); }
	const Quat &get_frame_orientation() const { return _frame.get_orientation(); }
	const Vec3 &get_frame_origin() const { return _frame.get_origin(); }
	/// Forgets all samples. The next motion may have another clock; the body is put into its pose.
	void clear_motion();
	/// Notes what the joint to the world gave in the last step.
	void note_hold(const Residual &p_hold) { _residual.note(p_hold); }
	/// Forgets what has been measured.
	void clear_measures() {
		_meter.clear();
		_residual.clear();
	}
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
	const std::vector<float> &get_saturations() const { return _torques.get_saturations(); }
	/// The estimator of the root's travel of a mode, or null where the mode has none.
	const Travel *get_travel() const { return _travel.find(root_mode); }
	/// What keeps a GROUNDED body on its feet.
	Balance &get_balance() { return _balance; }
	const Balance &get_balance() const { return _balance; }
	/// From where the motion has the root to the position that is held instead, m: what is in the way holds
	/// it back.
	Vec3 get_tether() const { return root_mode == RootMode::GROUNDED ? _balance.get_offset() : _tether.get_now(); }
	/// The target of the root at the end of the last step, m; who gets up is lifted to it.
	Vec3 get_root_target() const { return _next.root + _getting_up.get_lift(); }

	void save(ArchiveWriter &p_archive) const;
	/// Returns false, and is as before, where the archive is not of such a body.
	bool restore(ArchiveReader &p_archive);

private:
	bool read(ArchiveReader &p_archive);
	/// Takes the motion at the beginning and the end of the step to where its frame is. Returns whether the frame
	/// was moved further than anything could carry it.
	bool find_motion(RigState &r_state, double p_time_s, float p_delta_s);
	/// Whether the root's place is known, and something pulls it there.
	bool is_pulled() const { return !finds_travel(root_mode) && !is_free(root_mode); }
	/// Holds the motion's position on the body's side of what is in its way. Returns whether the body is to be
	/// put into the motion's pose.
	/// @param p_begins whether the motion begins, wherever that may be
	/// @param p_jumps whether the motion is elsewhere at once
	/// @param p_goes_on whether it goes on after a short pause, maybe elsewhere
	bool hold_back(const RigState &p_state, bool p_begins, bool p_jumps, bool p_goes_on, float p_delta_s);
	/// Whether a body is brought back to a motion that goes on after a short pause.
	bool can_go_on() const;
	/// From where the motion has the root to where the body that goes on will have it, m.
	Vec3 find_offset() const;
	/// Begins to bring the body back to a motion that goes on.
	void go_on(RigState &r_state);
	/// Brings the body into the motion, as long as it takes.
	/// @param p_may_end whether the motion's velocity is known, or will not come any more
	void arrive(RigState &r_state, bool p_may_end, float p_delta_s);
	void travel(const RigState &p_state, float p_delta_s);
	void balance(const RigState &p_state, float p_delta_s);
	void compute_limbs(const RigState &p_state, float p_delta_s);
	void command_root(const RigState &p_state, float p_delta_s);
	void place_kinematic(const RigState &p_state, float p_delta_s);
	void put_into_pose(RigState &r_state);
	/// Puts the bodies into the pose of the step's beginning, at rest.
	void place(RigState &r_state);
	/// What was known of the bodies' past counts no more.
	void forget();

	Rig _rig;
	std::vector<ContactPoint> _contacts;
	PoseStream _stream;
	StreamWatch _watch;
	CarriedFrame _frame; // In which the motion happens.
	SelfClearance _clearance;
	ActuationTable _table;
	Controller _controller;
	LimbPushes _pushes;
	RootTravel _travel; // Modes that find the travel.
	Balance _balance; // GROUNDED.
	Tether _tether; // HELD, SOFT.
	HeldRoot _held_root; // HELD.
	GettingUp _getting_up;
	EnergyGuard _guard;
	Landing _landing;
	SurfaceGuard _surfaces;
	TrackingMeter _meter;
	TorqueMeter _torques;
	ResidualMeter _residual;
	FlatGround _level_ground;
	StepCommands _commands;
	Pose _now; // The motion at the beginning of the step ...
	Pose _next; // ... and at its end.
	Arrival _arrival;
	Vec3 _steady_offset; // GROUNDED: the tether before the motion stalled, m, ...
	bool _stood = true; // ... and whether the body was on its feet.
	// Kept between steps, so that a step allocates nothing.
	std::vector<Vec3> _joints;
	std::vector<Quat> _measured;
	std::vector<float> _errors;
};

} // namespace ragdoll
