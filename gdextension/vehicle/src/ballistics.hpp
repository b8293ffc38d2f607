// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace vehicle {

/// A vector of doubles: a shell's way is kilometres long and told to millimetres.
struct Vec3d {
	double x = 0.0;
	double y = 0.0;
	double z = 0.0;

	Vec3d operator+(const Vec3d &p_other) const { return { x + p_other.x, y + p_other.y, z + p_other.z }; }
	Vec3d operator*(double p_factor) const { return { x * p_factor, y * p_factor, z * p_factor }; }
	double length() const { return std::sqrt(x * x + y * y + z * z); }
	bool is_finite() const { return std::isfinite(x) && std::isfinite(y) && std::isfinite(z); }
};

/// How air brakes a shell. The ICAO standard atmosphere at sea level: 1.225 kg/m^3, sound at 340.3 m/s.
struct Drag {
	enum class Law {
		QUADRATIC, ///< A drag coefficient that does not change: dv/ds = -k v.
		G7, ///< That of the G7 standard projectile by Mach number, over the ballistic coefficient.
	};

	Law law = Law::QUADRATIC;
	/// QUADRATIC: k = rho Cd A / 2 m, 1/m. G7: the ballistic coefficient, kg/m^2 (703.07 of them are 1 lb/in^2).
	double coefficient = 0.0;

	/// From a drag coefficient, a calibre (m) and a mass (kg).
	static Drag from_shape(double p_drag_coefficient, double p_calibre, double p_mass);
	/// From a ballistic coefficient for G7 as published, lb/in^2.
	static Drag from_g7(double p_pounds_per_square_inch);
	bool is_valid() const;
	/// Deceleration over speed at a speed (m/s), 1/s.
	double rate(double p_speed) const;
};

/// Drag coefficient of the G7 standard projectile at a Mach number.
double g7_drag(double p_mach);

/// A shell in flight: a point mass with gravity and drag.
class ShellFlight {
public:
	/// Longest step that is integrated at once, s.
	static constexpr double MAX_STEP = 1.0 / 120.0;
	/// Fastest shell that is believed, m/s.
	static constexpr double MAX_SPEED = 5000.0;

	/// Fires it. Returns false and stays as it is where something is not finite or makes no sense.
	bool launch(const Vec3d &p_position, const Vec3d &p_velocity, const Drag &p_drag, double p_gravity = 9.81);
	/// Flies on for a time, s; what is not finite, negative or more than a minute is refused.
	bool advance(double p_delta);
	const Vec3d &position() const { return _position; }
	const Vec3d &velocity() const { return _velocity; }
	double speed() const { return _velocity.length(); }
	/// Since it was fired, s.
	double age() const { return _age; }

private:
	Vec3d _acceleration(const Vec3d &p_velocity) const;

	Vec3d _position;
	Vec3d _velocity;
	Drag _drag;
	double _gravity = 9.81;
	double _age = 0.0;
};

} // namespace vehicle
