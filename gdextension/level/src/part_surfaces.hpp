// SPDX-License-Identifier: MIT
#pragma once

#include "ray_scene.hpp"
#include "visibility_dice.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace level {

/// The surfaces of a level's parts, divided into cubes: points on them are chosen by chance, and what is a small
/// share of its part, such as a palm above a wall, gets its own.
class PartSurfaces {
public:
	/// Triangles of a cube of a part.
	struct Cluster {
		int part = 0;
		std::vector<uint32_t> triangles;
	};

	PartSurfaces() = default;
	/// Keeps a reference to the triangles.
	/// @param p_part_of the part of each triangle; -1 for none
	/// @param p_cluster_m edge of the cubes, m
	PartSurfaces(const std::vector<Triangle> &p_triangles, const std::vector<int32_t> &p_part_of, int p_parts,
			float p_cluster_m);

	const std::vector<Cluster> &clusters() const { return _clusters; }
	/// Numbers of the clusters of a part.
	const std::vector<std::size_t> &clusters_of(int p_part) const { return _clusters_of[p_part]; }
	/// A point on a cluster, and the normal there.
	Vec3 choose_point(const Cluster &p_cluster, VisibilityDice &r_dice, Vec3 &r_normal) const;

private:
	const std::vector<Triangle> *_triangles = nullptr;
	std::vector<Cluster> _clusters;
	std::vector<std::vector<std::size_t>> _clusters_of;
};

} // namespace level
