// SPDX-License-Identifier: MIT
#pragma once

#include "angle_mean.hpp"
#include "drift_state.hpp"
#include "joint_motion.hpp"
#include "magnetic_field.hpp"

#include <quaternion.hpp>

#include <array>

namespace heading {

/// Finds how far the heading of each worn sensor has drifted since its calibration, from how its
/// wearer moves. Time in s of any clock, angles in rad.
///
/// A limb's measured rotation is yaw(d) r: r is the true one, d the drift. Its turn about the
/// vertical (swing and twist) hence is d plus that of the limb. Drift grows evenly and slowly for
/// minutes; people turn their joints quickly, to and fro, about a posture that they hold or come
/// back to, and take another one at once. So means over BLOCK_S of the turn of each limb against
/// its neighbour, of the body in the room, and of feet that stand still, are postures that stay
/// where they are (or change by a leap) plus a drift that does not: DriftState tells them apart.
///
/// Where accelerations are known, joints that move tell the difference of both neighbours' drifts
/// however anybody stands or sits: JointMotion.
class DriftEstimator {
public:
	/// Samples that are looked at, s.
	static constexpr double SAMPLE_S = 0.05;
	/// Span of a mean, s.
	static constexpr double BLOCK_S = 2.0;
	/// Span of a habit's mean, in blocks.
	static constexpr int WINDOW_BLOCKS = 8;
	/// Fastest correction, rad/s.
	static constexpr double FASTEST = degrees(0.5);

	/// The limbs' rotations from the reset pose as their sensors say, where they are known.
	struct Sample {
		double time = 0.0;
		std::array<bool, MOUNTS> present{};
		std::array<kinematics::Quat, MOUNTS> rotations{};
		/// The magnetic field in the world's axes, turned like the rotations; zero if not known.
		std::array<kinematics::Vec3, MOUNTS> fields{};
		/// Accelerations with gravity in the world's axes, turned like the rotations, m/s²; zero if not known.
		std::array<kinematics::Vec3, MOUNTS> accelerations{};
	};

	/// As right after a calibration, nothing known of joints.
	void reset();
	/// Says where the joint above a mount is.
	void set_levers(int p_mount, const Levers &p_levers) { _motion.set_levers(p_mount, p_levers); }
	/// Whether all of a sample of such a time, s, is looked at: of those that come sooner than SAMPLE_S
	/// after the last only accelerations are.
	bool wants(double p_time) const;
	/// Takes a sample.
	void add(const Sample &p_sample);

	/// What is to be taken off the heading of a mount now, rad: it moves smoothly.
	double correction(int p_mount) const { return _corrections[std::size_t(p_mount)]; }
	/// The drift that is believed, rad, its rate, rad/s, and their standard deviations.
	const DriftState &state() const { return _state; }
	/// How much of the belief is corrected, 0 to 1: none where there seems to be no drift at all.
	double trust() const { return _trust; }
	/// The magnetic field at a mount.
	const MagneticField &field(int p_mount) const { return _fields[std::size_t(p_mount)]; }
	/// The drifts of all mounts are known now, rad: they are taken off at once.
	void restart(const std::array<double, MOUNTS> &p_drifts);

private:
	/// What is known of an edge.
	struct Edge {
		/// Of the block, and of the window.
		AngleMean block;
		AngleMean window;
		/// Of the means of its blocks in the window.
		AngleMean blocks;
		/// How far means of blocks are off while the angle is held, and those of windows, rad².
		double held_variance = 0.0;
		double habit_variance = 0.0;
		/// How much a window's is that of the one before, rad²; and that one, rad.
		double habit_persistence = 0.0;
		double last_off = 0.0;
		/// Blocks since the angle is held; windows that have been seen.
		int held = 0;
		int windows = 0;
		/// The mean of the last block while the angle is held, and its change, rad.
		double last = 0.0;
		/// The mean of the block before, which counts once the next one is still too, rad.
		double waiting = 0.0;
		int still = 0;
		double change = 0.0;
		int strange = 0;
		bool is_still = true;
	};

	void _collect(const Sample &p_sample);
	void _add_foot(int p_edge, int p_foot, const Sample &p_sample, double p_step);
	void _end_block(double p_step);
	void _end_window();
	void _take_held(int p_edge, double p_seen);
	void _take_habit(int p_edge);
	void _take_front();
	Angle _angle(int p_edge) const;
	void _take_fields();
	void _take_motion();
	void _correct(double p_step);
	void _doubt();
	int _above(int p_mount) const;
	int _root() const;

	DriftState _state;
	std::array<Edge, EDGES> _edges{};
	/// The block in which somebody faced each way last; 0: never.
	std::array<int, FRONTS> _fronts{};
	double _front_variance = 0.0;
	/// The way that is faced now, and for how many blocks.
	int _front = -1;
	int _faced = 0;
	std::array<MagneticField, MOUNTS> _fields{};
	JointMotion _motion;
	/// Whether accelerations have told anything.
	bool _moved = false;
	/// What was known to be drifted at the last restart, and what is taken off now, rad.
	std::array<double, MOUNTS> _known{};
	std::array<double, MOUNTS> _corrections{};
	/// How much of what is believed is corrected, 0 to 1.
	double _trust = 0.0;
	std::array<bool, MOUNTS> _worn{};
	Sample _last;
	bool _has_last = false;
	double _block_begin = 0.0;
	int _block_samples = 0;
	int _window_samples = 0;
	int _blocks = 0;
};

} // namespace heading
