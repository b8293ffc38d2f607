// SPDX-License-Identifier: MIT
#pragma once

#include "ray_scene.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace level {

/// Which of the meshes that throw a level's shadows are needed: those whose shadow can fall on what is
/// drawn, or on people and props beside it.
///
/// Parts are divided into cubes. Seen from the light, a cube can shade those that lie behind it: which
/// these are is found once for a direction of the light, so that each look costs microseconds.
class ShadowReach {
public:
	/// Points x with normal . x <= distance are inside.
	struct Bound {
		Vec3 normal;
		float distance = 0.0f;
	};

	/// Edge of the cubes, m. Before the first part.
	float cube_m = 4.0f;
	/// How far beside and above what is drawn something may stand on which shadows fall, m.
	float beside_m = 0.5f;
	float above_m = 2.5f;

	/// Adds a part, whose shadow the caster of this number throws; none does if it is negative.
	void add_part(const std::vector<Vec3> &p_points, const std::vector<int32_t> &p_indices, int p_caster);
	/// Says where the light comes from: a vector towards it.
	void set_light(const Vec3 &p_way);
	/// A byte for each caster: 1 if it is needed where the parts with a byte other than 0 in p_seen are
	/// drawn, as far as they are inside of all bounds. All are needed while there is no light.
	std::vector<uint8_t> look(const std::vector<uint8_t> &p_seen, const std::vector<Bound> &p_bounds) const;
	int caster_count() const { return _casters; }

private:
	struct Cube {
		Vec3 low{ 1e30f, 1e30f, 1e30f };
		Vec3 high{ -1e30f, -1e30f, -1e30f };
		int part = 0;
		int caster = -1;
	};
	/// A cube as the light sees it: across, up, and towards the light.
	struct Outline {
		std::array<float, 3> low;
		std::array<float, 3> high;
	};

	static Outline outline_of(const Cube &p_cube, const std::array<Vec3, 3> &p_axes);
	Cube with_room(const Cube &p_cube) const;
	static bool is_inside(const Cube &p_cube, const std::vector<Bound> &p_bounds);

	std::vector<Cube> _cubes;
	int _parts = 0;
	int _casters = 0;
	/// Of each cube a bit for each caster, in words: those that can shade it.
	std::size_t _words = 0;
	std::vector<uint64_t> _shading;
};

} // namespace level
