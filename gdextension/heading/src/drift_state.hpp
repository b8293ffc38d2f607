// SPDX-License-Identifier: MIT
#pragma once

#include "body.hpp"

#include <array>
#include <cstddef>
#include <initializer_list>

namespace heading {

/// What is observed of headings: a joint (by the mount below it), the body in the room, planted feet.
constexpr int ROOM = 0;
constexpr int LEFT_PLANT = MOUNTS;
constexpr int RIGHT_PLANT = MOUNTS + 1;
constexpr int EDGES = MOUNTS + 2;
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

/// A linear filter of all that is not known about headings (Kalman 1960): of each mount the drift
/// that it has and the rate at which it grows; of each edge the angle at which it is held now, and
/// the one that it has on the whole. Angles in rad, times in s.
class DriftState {
public:
	/// Standard deviations of what is believed, rad and s.
	struct Belief {
		/// Of the rates of a drift when nothing has been seen, rad/s.
		double rate = degrees(4.5) / 60.0;
		/// By how much a rate changes in a second, rad/s.
		double rate_change = degrees(1.0) / 60.0 / 17.0;
		/// Of a heading right after a calibration, rad.
		double calibrated = degrees(0.3);
		/// Of an angle that nobody has seen yet.
		double any = degrees(60.0);
		/// By how much the angle of a joint that is held, of the body in the room, of a foot that
		/// stands, and habits wander in a second.
		double held = degrees(0.03);
		double room = degrees(0.05);
		double plant = degrees(0.03);
		double habit = degrees(0.03);
	};

	DriftState() { reset(); }

	/// As right after a calibration: no drift, nothing known of postures.
	void reset();
	/// Goes on by so many seconds.
	void predict(double p_step);

	/// The drift of a mount, rad, and its rate, rad/s.
	double drift(int p_mount) const { return _x[std::size_t(p_mount)]; }
	double rate(int p_mount) const { return _x[std::size_t(MOUNTS) + std::size_t(p_mount)]; }
	/// Their standard deviations.
	double drift_deviation(int p_mount) const { return _deviation(p_mount); }
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
	/// Nothing has drifted as of now, but what drifts goes on.
	void restart();

private:
	static constexpr int HELD = 2 * MOUNTS;
	static constexpr int HABITS = HELD + EDGES;
	static constexpr int SIZE = HABITS + MOUNTS + FRONTS - 1;
	using Column = std::array<double, SIZE>;
	/// A row of an observation: which states, and with which sign.
	struct Term {
		int state = 0;
		double factor = 0.0;
	};
	struct Row {
		std::array<Term, 3> terms{};
		int count = 0;
	};

	static int _state(const Angle &p_angle);
	static Row _row(const Angle &p_angle);
	double _deviation(int p_state) const;
	double _dot(const Row &p_row, const Column &p_column) const;
	Column _times(const Row &p_row) const;
	void _take(const Row &p_row, double p_seen, double p_variance);
	void _isolate(int p_state, double p_variance);

	Belief _belief;
	Column _x{};
	std::array<Column, SIZE> _p{};
};

} // namespace heading
