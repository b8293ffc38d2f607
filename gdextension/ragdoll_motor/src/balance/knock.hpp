// SPDX-License-Identifier: MIT
#pragma once

#include "base/archive.hpp"
#include "base/vectors.hpp"

namespace ragdoll {

/// Parameters of knocks.
struct KnockSettings {
	float speed = 1.3f; ///< By how much the whole body is moved within some steps, m/s.
	float duration_s = 0.8f; ///< How long somebody counts as knocked, s.
};

/// Notices blows and collisions: the body is moved at once, as the motion is not.
class Knock {
public:
	/// Notes the horizontal velocity of the centre of mass, and how far it is off the motion's, m/s.
	void advance(const Vec3 &p_velocity, const Vec3 &p_error, float p_delta_s);
	/// The same while nobody counts as knocked: who falls, or gets up.
	void rest(const Vec3 &p_velocity, const Vec3 &p_error);
	void clear() { rest({}, {}); }

	bool is_knocked() const { return _left_s > 0.0f; }

	void save(ArchiveWriter &p_archive) const;
	bool restore(ArchiveReader &p_archive);

	KnockSettings settings;

private:
	Vec3 _usual_velocity; // As they were some steps ago, m/s.
	Vec3 _usual_error;
	float _left_s = 0.0f; // How much longer somebody counts as knocked.
};

} // namespace ragdoll
