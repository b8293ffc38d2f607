// SPDX-License-Identifier: MIT
#pragma once

#include "base/archive.hpp"

namespace ragdoll {

/// Finds out from the pose alone when a body leaves the ground.
///
/// The ground can push a body up but not pull it down: whoever stands on his lowest point and yet sinks
/// faster than he would fall does not stand on it. So from wherever the pose slows down faster than
/// gravity a ballistic path is followed beside the pose; once the lowest point is clearly above the ground
/// by that path, the body flies. A pose that comes back to the path before was only quick.
class Takeoff {
public:
	/// Their source is a sweep over the motion files of `bench gait --cases=clips` (47 of 9 conventions on level
	/// floors): what finds most flights with less than one a minute invented. With a speed of 0.5 and a clearance
	/// of 0.015, 40 instead of 46 % were found.
	struct Settings {
		float speed = 0.25f; ///< Upward speed below which nobody takes off, m/s.
		float jump = 0.8f; ///< Upward speed from which it does not matter whether the lowest points slide, m/s.
		float slide = 0.7f; ///< Below it (m/s) they still stand: a runner's feet do not, once he flies.
		float clearance = 0.005f; ///< Height above the ground from which the body flies for certain, m.
	};

	Settings settings;

	void clear() { _is_watching = false; }
	/// Takes the next pose of a body that stands so far. Returns whether it has taken off.
	/// @param p_height of the centre of mass over the lowest point, m
	/// @param p_rise how fast that grows, smoothed, m/s
	/// @param p_slide how fast the lowest points move over the ground, m/s
	bool advance(float p_height, float p_rise, float p_slide, float p_gravity, float p_delta_s);
	/// How much higher than the pose has it the body is, m; 0 when it does not watch.
	float get_gap() const { return _is_watching ? _gap : 0.0f; }
	/// How fast it rises by the ballistic path, m/s.
	float get_speed() const { return _speed; }

	void save(ArchiveWriter &p_archive) const;
	bool restore(ArchiveReader &p_archive);

private:
	bool _is_watching = false;
	float _path = 0.0f; // Height of the centre over the ground by the ballistic path, m.
	float _speed = 0.0f; // m/s
	float _gap = 0.0f; // m
	float _first = 0.0f; // Speed of the path at its beginning, m/s.
	float _last = 0.0f; // Height of the pose before, m.
};

} // namespace ragdoll
