// SPDX-License-Identifier: MIT
#pragma once

#include "body.hpp"

#include <quaternion.hpp>

#include <algorithm>
#include <cmath>

namespace heading {

/// The magnetic field at a sensor, against the one that it had after its calibration: the first
/// REFERENCE_S that it says something. As long as strength and dip are the same, so is its north.
class MagneticField {
public:
	/// How long the reference is measured, s.
	static constexpr double REFERENCE_S = 2.0;
	/// Time constant of what is said, s.
	static constexpr double MEAN_S = 1.0;
	/// How far strength (as a part) and dip (rad) may be off.
	static constexpr double STRENGTH = 0.1;
	static constexpr double DIP = degrees(5.0);

	/// Takes the field in the world's axes as the sensor sees it, Y up, and the step, s.
	void add(const kinematics::Vec3 &p_field, double p_step) {
		const double strength = p_field.length();
		if (!p_field.is_finite() || strength < 1e-6) {
			return;
		}
		if (_passed < REFERENCE_S) {
			_passed += p_step;
			_sum = _sum + p_field;
			_strengths += strength;
			_count++;
			return;
		}
		const double part = std::min(p_step / MEAN_S, 1.0);
		if (!_is_known) {
			_mean = p_field;
			_strength = strength;
			_is_known = true;
		}
		_mean = _mean + (p_field - _mean) * float(part);
		_strength += part * (strength - _strength);
	}

	/// Whether there is a reference, and something to hold against it.
	bool is_known() const { return _is_known; }
	/// Whether strength and dip are those of the reference.
	bool is_good() const { return _is_known && std::abs(strength() - 1.0) < STRENGTH && std::abs(dip()) < DIP; }
	/// Strength, in reference strengths.
	double strength() const { return _is_known ? _strength * _count / _strengths : 1.0; }
	/// How much steeper it is than the reference, rad.
	double dip() const { return _is_known ? _dip_of(_mean) - _dip_of(_sum) : 0.0; }
	/// By how much its north is turned against the reference, rad about the vertical.
	double turned() const {
		const double angle = std::atan2(double(_mean.x), double(_mean.z)) - std::atan2(double(_sum.x), double(_sum.z));
		return _is_known ? std::remainder(angle, 2.0 * PI) : 0.0;
	}

private:
	static double _dip_of(const kinematics::Vec3 &p_field) {
		return std::atan2(-double(p_field.y), std::hypot(double(p_field.x), double(p_field.z)));
	}

	kinematics::Vec3 _sum;
	kinematics::Vec3 _mean;
	double _strengths = 0.0;
	double _strength = 0.0;
	double _passed = 0.0;
	int _count = 0;
	bool _is_known = false;
};

} // namespace heading
