// SPDX-License-Identifier: MIT
#pragma once

#include "quaternion.hpp"

#include <cstdint>
#include <limits>
#include <vector>

/// What is worked out of a level ahead of time: its mesh, its light, what can be seen from where.
/// Godot's frame (right-handed, Y up), metres.
namespace level {

using kinematics::Vec3;

/// A triangle seen from the side from which a, b, c run clockwise, as the engine has it.
struct Triangle {
	Vec3 a;
	Vec3 b;
	Vec3 c;
	/// Towards the side from which it is seen; not of unit length, zero where it has no area.
	Vec3 normal() const { return (c - a).cross(b - a); }
};

/// Where a ray ends.
struct Hit {
	static constexpr uint32_t NOTHING = std::numeric_limits<uint32_t>::max();

	/// Number of the triangle in the order in which they were given, or NOTHING.
	uint32_t triangle = NOTHING;
	/// Distance from the beginning, in lengths of the direction.
	float distance = 0.0f;
	/// Whether it was met from behind.
	bool is_back = false;
};

/// Triangles, and which of them a ray meets: a hierarchy of bounding volumes, divided where the
/// surface area heuristic says (Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies",
/// 2007). Rays may be traced by several threads at once.
class RayScene {
public:
	/// Replaces all triangles. Those without area or with numbers that are not finite are never met.
	void build(const std::vector<Triangle> &p_triangles);
	/// The nearest triangle from a point in a direction, up to a distance (in lengths of the direction).
	Hit closest(const Vec3 &p_from, const Vec3 &p_way, float p_farthest) const;
	/// Whether anything lies between two points.
	bool is_blocked(const Vec3 &p_from, const Vec3 &p_to) const;

private:
	struct Box {
		Vec3 low{ 1e30f, 1e30f, 1e30f };
		Vec3 high{ -1e30f, -1e30f, -1e30f };
		void include(const Vec3 &p_point);
		void include(const Box &p_other);
		float area() const;
	};
	struct Node {
		Box box;
		/// A leaf: its first triangle; else the number of its first child, the second follows.
		uint32_t first = 0;
		/// Triangles of a leaf; 0 for a node with two children.
		uint32_t count = 0;
	};
	/// A triangle as rays want it.
	struct Prepared {
		Vec3 corner;
		Vec3 to_b;
		Vec3 to_c;
		uint32_t number = 0;
	};
	struct Split {
		int axis = -1;
		int bin = 0;
		float cost = std::numeric_limits<float>::max();
	};
	struct Ray;

	Split find_split(uint32_t p_first, uint32_t p_count, const Box &p_centres) const;
	void divide(uint32_t p_node, uint32_t p_first, uint32_t p_count);
	uint32_t partition(uint32_t p_first, uint32_t p_count, const Box &p_centres, const Split &p_split);
	template <bool t_any>
	bool trace(Ray &p_ray, Hit &r_hit) const;

	std::vector<Node> _nodes;
	std::vector<Prepared> _triangles;
	/// Only while it is built.
	std::vector<Box> _boxes;
	std::vector<uint32_t> _order;
};

} // namespace level
