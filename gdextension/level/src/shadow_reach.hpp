// SPDX-License-Identifier: MIT
#pragma once

#include "ray_scene.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace level {

/// The meshes that throw a level's shadows, one for each square of the ground, and which of them are
/// needed: those whose shadow can fall on what is drawn, or on people and props beside it.
///
/// What is drawn and what throws is divided into cubes. Seen from the light, a cube can shade those that lie
/// behind it: which these are is found once for a direction of the light, so that each look costs microseconds.
class ShadowReach {
public:
	/// Points x with normal . x <= distance are inside.
	struct Bound {
		Vec3 normal;
		float distance = 0.0f;
	};

	/// Edges of the cubes and of the squares, m, and of so few triangles a square is part of another. Before
	/// the first part.
	float cube_m = 2.5f;
	float square_m = 24.0f;
	std::size_t few = 300;
	/// How far beside and above what is drawn something may stand on which shadows fall, m.
	float beside_m = 0.5f;
	float above_m = 2.5f;

	/// Adds a part: what is drawn of it, and the triangles that throw its shadow, three corners each. What is
	/// within a house throws its shadow on what is within only, by meshes of its own.
	void add_part(const std::vector<Vec3> &p_points, const std::vector<int32_t> &p_indices,
			const std::vector<Vec3> &p_shadow, bool p_is_within = false);
	/// Makes the meshes that throw the shadows of all parts.
	void gather();
	/// Says where the light comes from: a vector towards it.
	void set_light(const Vec3 &p_way);
	/// A byte for each caster: 1 if it is needed where the parts with a byte other than 0 in p_seen are
	/// drawn, as far as they are inside of all bounds. All are needed while there is no light.
	std::vector<uint8_t> look(const std::vector<uint8_t> &p_seen, const std::vector<Bound> &p_bounds) const;
	/// A byte for each box between two corners: 1 if some of it is inside of all bounds.
	static std::vector<uint8_t> inside(
			const std::vector<std::array<Vec3, 2>> &p_boxes, const std::vector<Bound> &p_bounds);
	int caster_count() const { return int(_casters.size()); }
	/// The triangles of such a mesh, three corners each.
	const std::vector<Vec3> &caster(int p_number) const { return _casters[p_number].corners; }

private:
	/// Of the part or mesh with a number.
	struct Cube {
		Vec3 low{ 1e30f, 1e30f, 1e30f };
		Vec3 high{ -1e30f, -1e30f, -1e30f };
		int number = 0;
		bool is_within = false;
		void include(const Vec3 &p_point);
	};
	using Key = std::array<int, 3>;
	struct Square {
		std::vector<Vec3> corners;
		std::map<Key, Cube> cubes;
		bool is_within = false;
	};
	using Triangle = std::array<Vec3, 3>;
	/// A cube as the light sees it: across, up, and towards the light.
	struct Outline {
		std::array<float, 3> low;
		std::array<float, 3> high;
	};

	static Outline outline_of(const Cube &p_cube, const std::array<Vec3, 3> &p_axes);
	Cube with_room(const Cube &p_cube) const;
	static bool is_inside(const Vec3 &p_low, const Vec3 &p_high, const std::vector<Bound> &p_bounds);

	Key key_of(const Triangle &p_triangle) const;
	void add_throwing(Square &r_square, const Triangle &p_triangle, int p_depth) const;

	std::vector<Cube> _cubes;
	int _parts = 0;
	/// By x, z and whether it is within.
	std::map<Key, Square> _squares;
	std::vector<Square> _casters;
	/// Of each cube a bit for each caster, in words: those that can shade it.
	std::size_t _words = 0;
	std::vector<uint64_t> _shading;
};

} // namespace level
