// SPDX-License-Identifier: MIT
#pragma once

#include "vectors.hpp"

namespace ragdoll {

/// What a person can stand on. The world answers; the estimators ask only for points that may touch.
class Ground {
public:
	Ground() = default;
	Ground(const Ground &) = default;
	Ground &operator=(const Ground &) = default;
	virtual ~Ground() = default;

	/// Height (m, Y up) of the ground under or just above a point in the world; NaN where there is none.
	virtual float height(const Vec3 &p_at) const = 0;
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
