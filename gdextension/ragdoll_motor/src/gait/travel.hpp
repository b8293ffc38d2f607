// SPDX-License-Identifier: MIT
#pragma once

#include "base/archive.hpp"
#include "body/contact_point.hpp"
#include "world/ground.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace ragdoll {

/// What an estimator of travel gets each tick.
struct GaitInput {
	float delta_s = 0.0f;
	const std::vector<Vec3> *points = nullptr; ///< Contact points from the root's joint, world axes, m.
	Vec3 centre; ///< The centre of mass from the root's joint, world axes, m.
	const Ground *ground = nullptr;
	Vec3 gravity{ 0.0f, -9.81f, 0.0f }; ///< What pulls at the body, m/s^2.
	/// Turning rate of each limb, world axes, rad/s: what is round rolls where it touches. Null: unknown.
	const std::vector<Vec3> *turns = nullptr;
	/// Where the simulated body has the contact points, m. Null: nothing is known of it.
	const std::vector<Vec3> *shown = nullptr;
};

/// Finds where a person's root is from its pose and the ground: for suits that know orientations only
/// (thesis section 8.4).
class Travel {
public:
	/// Points further above the ground than this (m), were the body as low as it can be, do not touch.
	static constexpr float REACH = 0.12f;
	static constexpr float STEP = Ground::STEP;
	/// What is further above the body's own limb than this (m) does not carry it: a table over somebody who
	/// crawls, or a crate on the back. Only feet step up.
	static constexpr float SUNK = 0.05f;
	/// A point that has moved less than this (m) is on the same ground for LOOK_AGAIN_S seconds.
	static constexpr float SAME_PLACE = 0.015f;
	static constexpr float LOOK_AGAIN_S = 0.1f;
	static constexpr float NOWHERE = -1e9f;

	explicit Travel(std::vector<ContactPoint> p_points);
	Travel(const Travel &) = delete;
	Travel &operator=(const Travel &) = delete;
	virtual ~Travel() = default;

	/// Begins anew with the root's joint somewhere, m.
	void reset(const Vec3 &p_root);
	/// Takes the next pose. Input that is not finite is left out.
	void step(const GaitInput &p_input);
	/// The world has moved the body: everything moves along, m.
	virtual void shift(const Vec3 &p_offset);

	/// Where the root's joint is, m.
	const Vec3 &get_root() const { return _root; }
	/// Whether nothing touches the ground.
	bool is_flying() const { return _flying; }
	/// How surely each point stands still on the ground, 0 to 1.
	const std::vector<float> &get_weights() const { return _weights; }
	/// Whether a point is held where it stands, and where that is, m.
	virtual bool is_anchored(std::size_t p_point) const { return _weights[p_point] > 0.0f; }
	const Vec3 &get_anchor(std::size_t p_point) const { return _anchors[p_point]; }
	/// Height of a point when it stands on the ground that was found under it last, m; NaN without.
	float get_standing_height(std::size_t p_point) const {
		return _levels[p_point].footing.height + _contacts[p_point].radius;
	}
	/// How far the ground under a point, as it was found last, moves something at p_at (m) in a time, m.
	Vec3 get_carry(std::size_t p_point, const Vec3 &p_at, float p_delta_s) const;
	/// Where the root will be when the points will be elsewhere, as long as those that stand go on to.
	Vec3 ahead(const std::vector<Vec3> &p_points, float p_delta_s) const;

	/// Whether the estimator itself finds what carries the person; who rides on a platform is moved otherwise.
	virtual bool knows_what_carries() const { return true; }

	virtual void save(ArchiveWriter &p_archive) const;
	virtual bool restore(ArchiveReader &p_archive);

protected:
	virtual void begin(const GaitInput &p_input) = 0;
	virtual void advance(const GaitInput &p_input) = 0;

	/// Height of the body's reference over each point, were that on the ground, m: what the ground's
	/// height, the point's radius and its height under the reference come to; NOWHERE for points that
	/// are far from any ground. Returns the highest.
	/// @param p_points the points from the reference, world axes, m
	/// @param p_reference where the reference is about to be, m
	float find_heights(const GaitInput &p_input, const std::vector<Vec3> &p_points, const Vec3 &p_reference,
			std::vector<float> &r_heights);

	/// What was found under the points counts no more.
	void forget_ground() { std::fill(_levels.begin(), _levels.end(), Level()); }

	std::vector<ContactPoint> _contacts;
	std::vector<float> _weights;
	std::vector<Vec3> _anchors; // Where the points stand, m.
	std::vector<Vec3> _last; // The points of the tick before.
	float _floor = 0.0f; // Height of the ground that carries the body, m.
	Vec3 _root;
	Vec3 _velocity;
	bool _flying = false;
	bool _begun = false;

private:
	/// What was found under a point.
	struct Level {
		Vec3 at;
		Footing footing;
		float age_s = 1e9f;
	};

	Footing find_footing(const GaitInput &p_input, std::size_t p_point, const Vec3 &p_at) const;
	float look(const GaitInput &p_input, std::size_t p_point, const Vec3 &p_at);

	std::vector<Level> _levels;
};

} // namespace ragdoll
