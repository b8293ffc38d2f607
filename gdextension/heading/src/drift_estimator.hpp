// SPDX-License-Identifier: MIT
#pragma once

#include "drift_state.hpp"

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
class DriftEstimator {
public:
	/// Samples that are looked at, s.
	static constexpr double SAMPLE_S = 0.05;
	/// Span of a mean, s.
	static constexpr double BLOCK_S = 2.0;
	/// Fastest correction, rad/s.
	static constexpr double FASTEST = degrees(0.5);

	/// The limbs' rotations from the reset pose as their sensors say, where they are known.
	struct Sample {
		double time = 0.0;
		std::array<bool, MOUNTS> present{};
		std::array<kinematics::Quat, MOUNTS> rotations{};
	};

	/// As right after a calibration.
	void reset();
	/// Takes a sample; those that come sooner than SAMPLE_S after the last are left out.
	void add(const Sample &p_sample);

	/// What is to be taken off the heading of a mount now, rad: it moves smoothly.
	double correction(int p_mount) const { return _corrections[std::size_t(p_mount)]; }
	/// The drift that is believed, rad, its rate, rad/s, and their standard deviations.
	const DriftState &state() const { return _state; }
	/// The drift of a mount is known, rad: it is taken off at once.
	void set_drift(int p_mount, double p_drift);

private:
	/// A mean of angles that grows.
	struct Mean {
		double cosines = 0.0;
		double sines = 0.0;
		double weights = 0.0;
		int count = 0;
	};
	/// What is known of an edge.
	struct Edge {
		Mean mean;
		double variance = degrees(4.0) * degrees(4.0);
		int strange = 0;
		bool is_still = true;
	};

	void _collect(const Sample &p_sample);
	void _add_foot(int p_edge, int p_foot, const Sample &p_sample, double p_step);
	void _end_block(double p_step);
	void _take(int p_edge);
	void _correct(double p_step);
	int _above(int p_mount) const;

	DriftState _state;
	std::array<Edge, EDGES> _edges{};
	std::array<double, MOUNTS> _corrections{};
	std::array<bool, MOUNTS> _worn{};
	Sample _last;
	bool _has_last = false;
	double _block_begin = 0.0;
	int _block_samples = 0;
};

} // namespace heading
