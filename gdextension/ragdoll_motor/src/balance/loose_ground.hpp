// SPDX-License-Identifier: MIT
#pragma once

#include "base/archive.hpp"
#include "base/vectors.hpp"

namespace ragdoll {

/// Parameters of legs over loose things. Found by `bench ground --scene=crates`, one at a time.
struct LooseGroundSettings {
	/// A body that is lower than its legs mean to carry it, by more than the slack and at most by so much (m), is
	/// followed by them at once and lifted again so fast, m/s: they would throw it up. Without, 5 fewer of 88 walks
	/// come far enough through crates. On firm ground it holds up who climbs stairs (42 instead of 90 % come through
	/// those of the town).
	float sag_slack = 0.05f;
	float sag_most = 0.2f;
	float sag_back = 0.6f;
	/// A leg is to be no longer than it is by more than this, m. Joints go 50 times as far in a second
	/// (Controller's gain) as far as their torque lasts, which is for 6 g: a crate that slipped under a foot threw
	/// people up with 4 m/s, 1 m high. Of 152 walks of 23 gaits, hips come more than 0.3 m too high in 114 without, in
	/// 40 with 0.02, in 22 with 0.015; too short of the way or fallen are 25 and 28, 16 and 18, 23 and 23.
	float push = 0.02f;
	/// For so long after a foot was over something loose, s: feet come down beside crates as well (0.4 does as well).
	float memory_s = 1.0f;
};

/// What the legs of a body know of ground that gives way: crates, not the world.
class LooseGround {
public:
	void clear() { *this = LooseGround(); }
	/// @param p_is_loose whether a foot is over something that gives way
	/// @param p_lower how much lower the body is than its legs mean to carry it, m
	void advance(const LooseGroundSettings &p_settings, bool p_is_loose, float p_lower, float p_delta_s);

	/// How much lower than meant the legs carry the body, m; 0 or below.
	float get_sag() const { return _sag; }
	/// How far a foot is drawn to its hip so that the leg throws nobody up, m.
	/// @param p_is where the ankle is from the hip, m
	/// @param p_meant and where it is to be, m
	Vec3 find_give(const LooseGroundSettings &p_settings, const Vec3 &p_is, const Vec3 &p_meant) const;

	void save(ArchiveWriter &p_archive) const;
	bool restore(ArchiveReader &p_archive);

private:
	float _sag = 0.0f; // m
	float _since_s = 1e9f; // Since a foot was over something loose.
};

} // namespace ragdoll
