// SPDX-License-Identifier: MIT
#pragma once

#include "body.hpp"

#include <quaternion.hpp>

#include <array>
#include <vector>

namespace heading {

/// Where a joint is from the sensors on both of its sides, m, in the axes of the reset pose.
struct Levers {
	kinematics::Vec3 above;
	kinematics::Vec3 own;
};

/// How joints are accelerated, as the sensors on both of their sides tell it: in the world as each of
/// them sees it, so that the level parts are turned against each other as both headings are (Kok, Hol
/// and Schön 2014; Weygers and Kok 2020).
///
/// A joint is at p + R l, p being its sensor and l the lever: its acceleration is that of the sensor
/// plus the second derivative of R l. All is weighed by a bump w(t) of SPAN_S, and partial integration
/// moves both derivatives to w, which is smooth: rates of turn are not needed, and nothing that is
/// measured is differentiated.
class JointMotion {
public:
	/// Length of a bump, s. Two of them run at a time, half a length apart.
	static constexpr double SPAN_S = 1.2;

	/// A moment: time in s, rotations from the reset pose, and accelerations with gravity in the world as
	/// each sensor sees it, m/s², zero where they are not known.
	struct Moment {
		double time = 0.0;
		const std::array<bool, MOUNTS> &present;
		const std::array<kinematics::Quat, MOUNTS> &rotations;
		const std::array<kinematics::Vec3, MOUNTS> &accelerations;
	};
	/// What a bump says of a side of a joint: the acceleration of its sensor, m/s², and by how much that of
	/// the joint grows with each coordinate of the lever, 1/s².
	struct Side {
		kinematics::Vec3 sensor;
		std::array<kinematics::Vec3, 3> levers;

		/// That of the joint, m/s².
		kinematics::Vec3 joint(const kinematics::Vec3 &p_lever) const {
			return sensor + levers[0] * p_lever.x + levers[1] * p_lever.y + levers[2] * p_lever.z;
		}
	};
	/// And of a joint: the mount below it, both sides, and the variance of each direction, (m/s²)².
	struct Sight {
		int mount = 0;
		Side above;
		Side own;
		double variance = 0.0;
	};

	/// Says where the joint above a mount is.
	void set_levers(int p_mount, const Levers &p_levers);
	const Levers &levers(int p_mount) const { return _levers[std::size_t(p_mount)]; }
	/// Begins anew, joints stay where they are.
	void clear();
	/// Takes a moment.
	void add(const Moment &p_moment);
	/// What has been seen of joints that moved since this was asked last.
	std::vector<Sight> take();

private:
	/// What a bump has gathered of a mount, and its axes when it began.
	struct Sum {
		Side side;
		std::array<kinematics::Vec3, 3> begin;
		bool is_whole = false;
	};
	struct Bump {
		double begin = 0.0;
		bool runs = false;
		std::array<Sum, MOUNTS> sums;
	};

	static void _begin(Bump &r_bump, const Moment &p_moment);
	static void _gather(Bump &r_bump, const Moment &p_moment, double p_step);
	void _end(Bump &r_bump);
	void _look(int p_mount, const Side &p_above, const Side &p_own);

	std::array<Levers, MOUNTS> _levers{};
	std::array<bool, MOUNTS> _known{};
	std::array<Bump, 2> _bumps;
	/// What each acceleration is off all the time, m/s²: nobody is accelerated the same way for long.
	std::array<kinematics::Vec3, MOUNTS> _biases{};
	std::vector<Sight> _sights;
	double _last = 0.0;
	bool _has_last = false;
};

} // namespace heading
