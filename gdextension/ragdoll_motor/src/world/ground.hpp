// SPDX-License-Identifier: MIT
#pragma once

#include "base/vectors.hpp"

#include <cstdint>
#include <limits>

namespace ragdoll {

/// What there is under a point.
struct Footing {
	float height = std::numeric_limits<float>::quiet_NaN(); ///< Of the ground, m, Y up; NaN for none.
	bool is_loose = false; ///< A body that can be moved: a crate, not the world.
	Vec3 velocity; ///< Of the pivot, m/s: platforms carry who stands on them.
	Vec3 turning; ///< About the pivot, rad/s.
	Vec3 pivot; ///< m
	std::uint64_t body = 0; ///< Which body it is, if it can move by itself and carries people; 0 otherwise.
	Quat orientation; ///< Of that body.
	Vec3 origin; ///< Of that body, m.

	bool moves() const { return velocity.length() > 0.0f || turning.length() > 0.0f; }
	/// How far the ground at p_at (m) moves in a time, m. Turned, not along the tangent: in half a minute
	/// that would spiral out by centimetres.
	Vec3 carry(const Vec3 &p_at, float p_delta_s) const {
		const Vec3 arm = p_at - pivot;
		return velocity * p_delta_s + exp(turning * p_delta_s).rotate(arm) - arm;
	}
};

/// What a person can stand on. The world answers; the estimators ask only for points that may touch.
class Ground {
public:
	/// Steps that somebody takes are not higher than this, m: as far above a point ground is looked for.
	static constexpr float STEP = 0.35f;

	Ground() = default;
	Ground(const Ground &) = default;
	Ground &operator=(const Ground &) = default;
	virtual ~Ground() = default;

	/// Height (m, Y up) of the ground under or just above a point in the world; NaN where there is none.
	virtual float height(const Vec3 &p_at) const = 0;
	/// The same, and what else is known of it.
	/// @param p_above how far above the point the ground may be, m
	virtual Footing find(const Vec3 &p_at, float /*p_above*/) const {
		Footing found;
		found.height = height(p_at);
		return found;
	}
};

/// Level ground without end.
class FlatGround : public Ground {
public:
	explicit FlatGround(float p_height = 0.0f) : _level(p_height) {}
	float height(const Vec3 & /*p_at*/) const override { return _level; }

private:
	float _level;
};

} // namespace ragdoll
