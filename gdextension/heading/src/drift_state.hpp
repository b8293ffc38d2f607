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

/// A linear filter of all that is not known about headings (Kalman 1960): of each mount the drift
/// that it has and the rate at which it grows, of each edge the angle at which its posture holds it.
/// Angles in rad, times in s.
class DriftState {
public:
	/// Standard deviations of what is believed, rad and s.
	struct Belief {
		/// Of the rates of a drift when nothing has been seen, rad/s.
		double rate = degrees(4.0) / 60.0;
		/// By how much a rate changes in a second, rad/s.
		double rate_change = degrees(1.0) / 60.0 / 17.0;
		/// Of a heading right after a calibration, rad.
		double calibrated = degrees(0.3);
		/// By how much the posture of a joint, the body in the room, a planted foot wander in a
		/// second, rad.
		double joint = degrees(0.14);
		double room = degrees(0.14);
		double plant = degrees(0.04);
	};

	DriftState() { reset(); }

	/// As right after a calibration: no drift, nothing known of postures.
	void reset();
	/// Goes on by so many seconds.
	void predict(double p_step);

	/// The drift of a mount, rad, and its rate, rad/s.
	double drift(int p_mount) const { return _x[std::size_t(p_mount)]; }
	double rate(int p_mount) const { return _x[std::size_t(MOUNTS + p_mount)]; }
	/// Their standard deviations.
	double drift_deviation(int p_mount) const { return _deviation(p_mount); }
	double rate_deviation(int p_mount) const { return _deviation(MOUNTS + p_mount); }

	/// What an observation would be, and the variance of that. An observation is of the drift of a
	/// mount less that of another (-1: the room), plus the posture of an edge (-1: none).
	double expected(int p_mount, int p_other, int p_edge) const;
	double variance(int p_mount, int p_other, int p_edge) const;
	/// Takes an observation, rad, with its variance.
	void observe(int p_mount, int p_other, int p_edge, double p_angle, double p_variance);
	/// The posture of an edge has changed to nobody knows what.
	void forget_posture(int p_edge);
	/// The drift of a mount is known, rad; its rate stays.
	void set_drift(int p_mount, double p_drift, double p_deviation);

private:
	static constexpr int SIZE = 2 * MOUNTS + EDGES;
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

	static Row _row(int p_mount, int p_other, int p_edge);
	double _deviation(int p_state) const;
	double _dot(const Row &p_row, const Column &p_column) const;
	Column _times(const Row &p_row) const;
	void _isolate(int p_state, double p_variance);

	Belief _belief;
	Column _x{};
	std::array<Column, SIZE> _p{};
};

} // namespace heading
