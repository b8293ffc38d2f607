// SPDX-License-Identifier: MIT
#include "ballistics.hpp"

#include <algorithm>
#include <array>

namespace vehicle {

namespace {

constexpr double PI = 3.14159265358979;
constexpr double AIR_DENSITY = 1.225;
constexpr double SOUND_SPEED = 340.3;
/// kg/m^2 for one lb/in^2.
constexpr double POUNDS_PER_SQUARE_INCH = 703.07;
constexpr double MAX_DELTA = 60.0;

struct DragPoint {
	double mach;
	double drag;
};

/// The G7 standard drag function, as ballistic programs share it (mcg7.txt of JBM Ballistics), at fewer Mach numbers
/// where it is nearly straight.
constexpr std::array<DragPoint, 53> G7{ {
		{ 0.0, 0.1198 },
		{ 0.1, 0.1196 },
		{ 0.2, 0.1193 },
		{ 0.3, 0.1194 },
		{ 0.4, 0.1193 },
		{ 0.5, 0.1194 },
		{ 0.6, 0.1194 },
		{ 0.65, 0.1197 },
		{ 0.7, 0.1202 },
		{ 0.725, 0.1207 },
		{ 0.75, 0.1215 },
		{ 0.775, 0.1226 },
		{ 0.8, 0.1242 },
		{ 0.825, 0.1266 },
		{ 0.85, 0.1306 },
		{ 0.875, 0.1368 },
		{ 0.9, 0.1464 },
		{ 0.925, 0.1660 },
		{ 0.95, 0.2054 },
		{ 0.975, 0.2993 },
		{ 1.0, 0.3803 },
		{ 1.025, 0.4015 },
		{ 1.05, 0.4043 },
		{ 1.075, 0.4034 },
		{ 1.1, 0.4014 },
		{ 1.125, 0.3987 },
		{ 1.15, 0.3955 },
		{ 1.2, 0.3884 },
		{ 1.25, 0.3810 },
		{ 1.3, 0.3732 },
		{ 1.35, 0.3657 },
		{ 1.4, 0.3580 },
		{ 1.5, 0.3440 },
		{ 1.6, 0.3315 },
		{ 1.7, 0.3209 },
		{ 1.8, 0.3117 },
		{ 1.9, 0.3042 },
		{ 2.0, 0.2980 },
		{ 2.1, 0.2922 },
		{ 2.2, 0.2864 },
		{ 2.3, 0.2807 },
		{ 2.4, 0.2752 },
		{ 2.5, 0.2697 },
		{ 2.6, 0.2643 },
		{ 2.7, 0.2588 },
		{ 2.8, 0.2533 },
		{ 2.9, 0.2479 },
		{ 3.0, 0.2424 },
		{ 3.25, 0.2286 },
		{ 3.5, 0.2154 },
		{ 4.0, 0.1935 },
		{ 4.5, 0.1762 },
		{ 5.0, 0.1618 },
} };

} // namespace

double g7_drag(double p_mach) {
	const auto *const after = std::upper_bound(G7.begin(), G7.end(), p_mach,
			[](double p_value, const DragPoint &p_point) { return p_value < p_point.mach; });
	if (after == G7.begin()) {
		return G7.front().drag;
	}
	if (after == G7.end()) {
		return G7.back().drag;
	}
	const DragPoint &low = *(after - 1);
	return low.drag + (after->drag - low.drag) * (p_mach - low.mach) / (after->mach - low.mach);
}

Drag Drag::from_shape(double p_drag_coefficient, double p_calibre, double p_mass) {
	// A mass of zero gives what is_valid() refuses.
	return { Law::QUADRATIC, AIR_DENSITY * p_drag_coefficient * PI * p_calibre * p_calibre / (8.0 * p_mass) };
}

Drag Drag::from_g7(double p_pounds_per_square_inch) {
	return { Law::G7, p_pounds_per_square_inch * POUNDS_PER_SQUARE_INCH };
}

bool Drag::is_valid() const {
	if (!std::isfinite(coefficient)) {
		return false;
	}
	// At 1 per metre a shell stops within its own dust; a coefficient of 1 kg/m^2 does the same.
	return law == Law::G7 ? coefficient > 1.0 : coefficient >= 0.0 && coefficient < 1.0;
}

double Drag::rate(double p_speed) const {
	if (law == Law::QUADRATIC) {
		return coefficient * p_speed;
	}
	return PI / 8.0 * AIR_DENSITY * p_speed * g7_drag(p_speed / SOUND_SPEED) / coefficient;
}

bool ShellFlight::launch(const Vec3d &p_position, const Vec3d &p_velocity, const Drag &p_drag, double p_gravity) {
	const bool is_finite = p_position.is_finite() && p_velocity.is_finite() && std::isfinite(p_gravity);
	if (!is_finite || !p_drag.is_valid() || p_velocity.length() > MAX_SPEED) {
		return false;
	}
	_position = p_position;
	_velocity = p_velocity;
	_drag = p_drag;
	_gravity = p_gravity;
	_age = 0.0;
	return true;
}

bool ShellFlight::advance(double p_delta) {
	// Written so that NaN fails too.
	if (!(p_delta >= 0.0 && p_delta <= MAX_DELTA)) {
		return false;
	}
	const int steps = std::max(1, int(std::ceil(p_delta / MAX_STEP - 1e-9)));
	const double step = p_delta / steps;
	for (int i = 0; i < steps; i++) {
		// Runge and Kutta's of fourth order: the acceleration depends on the velocity alone.
		const Vec3d v1 = _velocity;
		const Vec3d a1 = _acceleration(v1);
		const Vec3d v2 = v1 + a1 * (0.5 * step);
		const Vec3d a2 = _acceleration(v2);
		const Vec3d v3 = v1 + a2 * (0.5 * step);
		const Vec3d a3 = _acceleration(v3);
		const Vec3d v4 = v1 + a3 * step;
		const Vec3d a4 = _acceleration(v4);
		_position = _position + (v1 + v2 * 2.0 + v3 * 2.0 + v4) * (step / 6.0);
		_velocity = _velocity + (a1 + a2 * 2.0 + a3 * 2.0 + a4) * (step / 6.0);
	}
	_age += p_delta;
	return true;
}

Vec3d ShellFlight::_acceleration(const Vec3d &p_velocity) const {
	Vec3d slowed = p_velocity * -_drag.rate(p_velocity.length());
	slowed.y -= _gravity;
	return slowed;
}

} // namespace vehicle
