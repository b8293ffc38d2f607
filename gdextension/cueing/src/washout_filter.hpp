// SPDX-License-Identifier: MIT
#pragma once

#include <array>

/// Motion cues for a platform under a seat: classical washout (Reid and Nahon 1985, Nahon and Reid 1990), limits,
/// ramps, datagrams. Frames are Godot's: +X right, +Y up, -Z ahead; metres, radians, seconds. Of an attitude, x is
/// pitch (nose up), y yaw (to the left) and z roll (right side up).
namespace cueing {

using Triple = std::array<double, 3>;

/// What a body at rest is carried with, m/s^2.
constexpr double GRAVITY = 9.81;

/// What a seat's occupant feels.
struct Motion {
	/// Acceleration less gravity, in the vehicle's frame, m/s^2: (0, 9.81, 0) at rest on level ground.
	Triple specific_force{ 0.0, GRAVITY, 0.0 };
	/// In the vehicle's frame, rad/s.
	Triple rates{};
	bool is_finite() const;
};

/// Where a platform stands, from neutral.
struct Pose {
	/// m.
	Triple position{};
	/// Pitch, yaw and roll, rad.
	Triple attitude{};
};

/// The high-pass filter of a direction: scale s^3 / ((s^2 + 2 damping frequency s + frequency^2) (s + third_pole)).
struct TranslationParameters {
	/// Part of the vehicle's specific force that the platform gives.
	double scale = 0.5;
	/// Greatest specific force before scaling, m/s^2.
	double limit = 10.0;
	/// rad/s.
	double frequency = 2.5;
	double damping = 1.0;
	/// rad/s.
	double third_pole = 0.25;
};

/// Tilt coordination: gravity stands in for forces that last.
struct TiltParameters {
	/// Of the second-order low-pass, rad/s.
	double frequency = 2.5;
	double damping = 1.0;
	/// rad/s; above some 3 deg/s people feel that they are being turned.
	double max_rate = 0.0523598776;
	/// rad.
	double max_angle = 0.349;
};

/// The high-pass of rotation, from rates to angles: of order 1 scale / (s + frequency), of order 2
/// scale s / (s^2 + 2 damping frequency s + frequency^2).
struct RotationParameters {
	double scale = 0.5;
	/// Greatest rate before scaling, rad/s.
	double limit = 1.0;
	/// rad/s.
	double frequency = 1.0;
	double damping = 1.0;
	int order = 2;
};

struct WashoutParameters {
	/// Ahead, back and to the sides.
	TranslationParameters horizontal;
	/// Up and down.
	TranslationParameters vertical;
	TiltParameters tilt;
	RotationParameters rotation;
};

/// The filter without limits of a platform. All channels are linear but for the limits of input and of tilt. Inputs
/// are taken to change evenly between steps: a jump of the input counts as a jump half a step earlier.
class WashoutFilter {
public:
	WashoutParameters parameters;

	/// Neutral, as if nothing had ever happened.
	void reset();
	/// Advances by p_seconds, to when the motion is p_motion. The first step after a reset takes the motion to have
	/// been the same before.
	void step(const Motion &p_motion, double p_seconds);
	const Pose &pose() const { return _pose; }
	/// Of the platform, m/s.
	const Triple &velocity() const { return _velocity; }
	/// Of the platform, m/s^2.
	const Triple &acceleration() const { return _acceleration; }
	/// Pitch and roll by tilt coordination alone (y is 0), rad.
	const Triple &tilt() const { return _tilt; }

private:
	/// What the channels of one axis remember.
	struct Axis {
		Triple translation{};
		std::array<double, 2> low_pass{};
		std::array<double, 2> rotation{};
	};

	void advance(const Triple &p_force, const Triple &p_rates, double p_seconds);
	void advance_tilt(double p_seconds);
	const TranslationParameters &translation(int p_axis) const;

	std::array<Axis, 3> _axes{};
	Triple _force{};
	Triple _rates{};
	Triple _tilt{};
	Triple _velocity{};
	Triple _acceleration{};
	Pose _pose;
	bool _has_begun = false;
};

} // namespace cueing
