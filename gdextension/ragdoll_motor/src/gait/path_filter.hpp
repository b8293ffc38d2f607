// SPDX-License-Identifier: MIT
#pragma once

#include "base/archive.hpp"
#include "base/calm.hpp"
#include "base/vectors.hpp"

namespace ragdoll {

/// Smooths the root's path where noise of the limbs shakes it. It may: a body has momentum, and FootLock holds
/// the standing feet whatever the root does.
class PathFilter {
public:
	/// Each radian of the limbs' noise moves the root by this, m/rad.
	static constexpr float LEVER = 0.7f;
	static constexpr float MEMORY_S = 0.15f;
	/// At most this share of a surprise is left out, so that a body can jump.
	static constexpr float CALMEST = 0.85f;

	void clear() { _begun = false; }
	/// Takes the next position, m.
	/// @param p_noise of the limbs, rad
	void advance(const Vec3 &p_position, float p_noise, float p_span_s);
	/// The world has moved the body, m.
	void shift(const Vec3 &p_offset) { _position = _position + p_offset; }

	const Vec3 &get_position() const { return _position; }
	/// Where it will be, m.
	Vec3 ahead(float p_span_s) const { return _position + _rate * p_span_s; }

	void save(ArchiveWriter &p_archive) const;
	bool restore(ArchiveReader &p_archive);

private:
	Vec3 _position;
	Vec3 _rate; // m/s
	Calm _calm;
	bool _begun = false;
};

} // namespace ragdoll
