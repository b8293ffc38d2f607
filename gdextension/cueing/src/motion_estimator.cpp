// SPDX-License-Identifier: MIT
#include "motion_estimator.hpp"

#include "parabola.hpp"

#include <algorithm>
#include <cmath>

namespace cueing {

namespace {

/// More than a second of states at 60 a second.
constexpr std::size_t ROOM = 80;
constexpr std::size_t FEWEST = 4;
/// States that came so much later are no continuation, s.
constexpr double GAP = 0.5;
/// Nothing on the ground moves so much farther than it was going, m, or turns so far from one state to the next, rad.
constexpr double JUMP = 1.5;
constexpr double TURN = 1.0;

double difference(const Triple &p_a, const Triple &p_b) {
	return std::hypot(p_a[0] - p_b[0], p_a[1] - p_b[1], p_a[2] - p_b[2]);
}

Triple to_triple(const kinematics::Vec3 &p_vector) {
	return { p_vector.x, p_vector.y, p_vector.z };
}

kinematics::Vec3 to_vec(const Triple &p_triple) {
	return { float(p_triple[0]), float(p_triple[1]), float(p_triple[2]) };
}

/// 1 in the middle of a window, 0 with a slope of 0 at its ends (tricube).
double weight(double p_from_middle, double p_half_window) {
	const double part = std::fabs(p_from_middle) / p_half_window;
	const double rest = part < 1.0 ? 1.0 - part * part * part : 0.0;
	return rest * rest * rest;
}

} // namespace

bool SeatState::is_finite() const {
	bool all = std::isfinite(time) && orientation.is_finite() && orientation.dot(orientation) > 0.5f;
	for (int axis = 0; axis < 3; axis++) {
		all = all && std::isfinite(position[axis]) && (!has_velocity || std::isfinite(velocity[axis]));
	}
	return all;
}

void MotionEstimator::clear() {
	_states.clear();
}

bool MotionEstimator::follows(const SeatState &p_state) const {
	const SeatState &last = _states.back();
	const double seconds = p_state.time - last.time;
	if (seconds > GAP) {
		return false;
	}
	Triple expected = last.position;
	for (int axis = 0; axis < 3; axis++) {
		if (p_state.has_velocity) {
			expected[axis] += p_state.velocity[axis] * seconds;
		} else if (_states.size() > 1) {
			const SeatState &before = _states[_states.size() - 2];
			expected[axis] += (last.position[axis] - before.position[axis]) * seconds / (last.time - before.time);
		}
	}
	return difference(p_state.position, expected) < JUMP &&
			kinematics::angle_between(last.orientation, p_state.orientation) < TURN;
}

bool MotionEstimator::add(const SeatState &p_state) {
	if (!p_state.is_finite() || (!_states.empty() && p_state.time <= _states.back().time)) {
		return true;
	}
	const bool goes_on = _states.empty() || follows(p_state);
	if (!goes_on) {
		_states.clear();
	}
	_states.push_back(p_state);
	if (_states.size() > ROOM) {
		_states.pop_front();
	}
	return goes_on;
}

double MotionEstimator::window_at(double p_time) const {
	std::array<double, ROOM> distances{};
	for (std::size_t i = 0; i < _states.size(); i++) {
		distances[i] = std::fabs(_states[i].time - p_time);
	}
	// The farthest that is needed must have some weight.
	auto *const needed = distances.begin() + FEWEST - 1;
	std::nth_element(distances.begin(), needed, distances.begin() + _states.size());
	return std::max(half_window, *needed * 1.25);
}

bool MotionEstimator::estimate(double p_time, SeatMotion &r_motion) const {
	if (_states.size() < FEWEST) {
		return false;
	}
	const double moment = std::clamp(p_time, _states.front().time, _states.back().time);
	const double window = window_at(moment);
	const auto nearest =
			std::min_element(_states.begin(), _states.end(), [moment](const SeatState &p_a, const SeatState &p_b) {
				return std::fabs(p_a.time - moment) < std::fabs(p_b.time - moment);
			});
	Parabola path;
	Parabola turn;
	for (const SeatState &state : _states) {
		const double time = state.time - moment;
		const double counts = weight(time, window);
		if (counts <= 0.0) {
			continue;
		}
		// From the nearest state, so that numbers are small.
		path.add(time, counts,
				{ state.position[0] - nearest->position[0], state.position[1] - nearest->position[1],
						state.position[2] - nearest->position[2] });
		if (state.has_velocity) {
			path.add_rate(time, counts * window * window, state.velocity);
		}
		turn.add(time, counts, to_triple(kinematics::log(nearest->orientation.inverse() * state.orientation)));
	}
	Triple curve{};
	Triple angles{};
	Triple unused{};
	SeatMotion motion;
	if (!path.solve(motion.position, motion.velocity, curve) || !turn.solve(angles, motion.felt.rates, unused)) {
		return false;
	}
	motion.orientation = (nearest->orientation * kinematics::exp(to_vec(angles))).normalized();
	for (int axis = 0; axis < 3; axis++) {
		motion.position[axis] += nearest->position[axis];
		motion.acceleration[axis] = 2.0 * curve[axis];
	}
	Triple supported = motion.acceleration;
	supported[1] += GRAVITY;
	motion.felt.specific_force = to_triple(motion.orientation.inverse().rotate(to_vec(supported)));
	r_motion = motion;
	return true;
}

} // namespace cueing
