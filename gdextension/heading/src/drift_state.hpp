// SPDX-License-Identifier: MIT
#pragma once

#include "body.hpp"

#include <array>
#include <cstddef>

namespace heading {

/// What is observed of headings: a joint (by the mount below it), the body in the room, planted feet.
constexpr int ROOM = 0;
constexpr int LEFT_PLANT = MOUNTS;
constexpr int EDGES = LEFT_PLANT + 2;
/// Ways that somebody faces again and again.
constexpr int FRONTS = 8;

/// An angle that is observed: the drift of a mount less that of another (-1: the room), plus an
/// angle of an edge: the one at which it is held now, or the one that it has on the whole.
struct Angle {
	int mount = 0;
	int other = -1;
	int edge = 0;
	bool is_habit = false;
	/// Which front, for a habit of the body in the room.
	int front = 0;
};

/// How a joint's acceleration, as both of its sensors tell it, depends on what is not known: the drift
/// of the one less that of the other, and where the joint is from both sensors.
struct Pull {
	int mount = 0;
	int other = 0;
	/// By how much what is seen grows with the difference of drifts, m/s² per rad, and with the three
	/// coordinates of each lever (of the other mount, of the mount), 1/s².
	double turn = 0.0;
	std::array<double, 6> levers{};
};

/// A linear filter of all that is not known about headings (Kalman 1960): of each mount the drift
/// that it has and the rate at which it grows; of each edge the angle at which it is held now, and
/// the one that it has on the whole; of each joint how far its levers are off. Angles in rad, times in s.
class DriftState {
public:
	DriftState() { reset(); }

	/// As right after a calibration: no drift, nothing known of postures.
	void reset();
	/// Goes on by so many seconds.
	void predict(double p_step);

	/// The drift of a mount, rad, and its rate, rad/s.
	double drift(int p_mount) const { return _x[std::size_t(p_mount)]; }
	double rate(int p_mount) const { return _x[std::size_t(MOUNTS) + std::size_t(p_mount)]; }
	/// How far a coordinate (0 to 5, as in Pull) of a joint's levers is off, m.
	double lever(int p_mount, int p_coordinate) const { return _x[std::size_t(_lever(p_mount, p_coordinate))]; }
	/// The standard deviation of the rate, rad/s.
	double rate_deviation(int p_mount) const { return _deviation(MOUNTS + p_mount); }

	/// What an observation would be, and the variance of that.
	double expected(const Angle &p_angle) const;
	double variance(const Angle &p_angle) const;
	/// Takes an observation, rad, with its variance.
	void observe(const Angle &p_angle, double p_seen, double p_variance);
	/// The angle of an edge is another one now: whatever it was, it becomes what is seen, rad.
	void begin(const Angle &p_angle, double p_seen, double p_variance);
	/// Takes an observation of a mount's drift alone, rad, with its variance.
	void observe_drift(int p_mount, double p_seen, double p_variance);
	/// Takes by how much a pull is more than expected, m/s², with its variance; not if that is strange.
	void observe(const Pull &p_pull, double p_off, double p_variance);
	/// Nothing has drifted as of now, but what drifts goes on, and levers are where they are.
	void restart();

private:
	static constexpr int HELD = 2 * MOUNTS;
	static constexpr int HABITS = HELD + EDGES;
	static constexpr int LEVERS = HABITS + MOUNTS + FRONTS - 1;
	static constexpr int SIZE = LEVERS + 6 * MOUNTS;
	using Column = std::array<double, SIZE>;
	/// A row of an observation: which states, and with which sign.
	struct Term {
		int state = 0;
		double factor = 0.0;
	};
	struct Row {
		std::array<Term, 8> terms{};
		int count = 0;

		void add(int p_state, double p_factor) { terms[std::size_t(count++)] = { p_state, p_factor }; }
	};

	static int _lever(int p_mount, int p_coordinate) { return LEVERS + 6 * p_mount + p_coordinate; }
	static int _state(const Angle &p_angle);
	static Row _row(const Angle &p_angle);
	double _deviation(int p_state) const;
	double _dot(const Row &p_row, const Column &p_column) const;
	Column _times(const Row &p_row) const;
	void _take(const Row &p_row, double p_seen, double p_variance);
	void _isolate(int p_state, double p_variance);

	Column _x{};
	std::array<Column, SIZE> _p{};
};

} // namespace heading
