// SPDX-License-Identifier: MIT
#include "part_surfaces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace level {

PartSurfaces::PartSurfaces(const std::vector<Triangle> &p_triangles, const std::vector<int32_t> &p_part_of, int p_parts,
		float p_cluster_m) :
		_triangles(&p_triangles), _clusters_of(p_parts) {
	std::vector<std::map<std::array<int, 3>, std::vector<uint32_t>>> cubes(p_parts);
	for (std::size_t index = 0; index < p_triangles.size(); index++) {
		const Triangle &triangle = p_triangles[index];
		const int32_t part = p_part_of[index];
		if (part < 0 || part >= p_parts || !(triangle.normal().length() > 0.0f)) {
			continue;
		}
		const Vec3 middle = (triangle.a + triangle.b + triangle.c) * (1.0f / (3.0f * p_cluster_m));
		const std::array<int, 3> cube{ int(std::floor(middle.x)), int(std::floor(middle.y)),
			int(std::floor(middle.z)) };
		cubes[part][cube].push_back(uint32_t(index));
	}
	for (int part = 0; part < p_parts; part++) {
		for (auto &cube : cubes[part]) {
			_clusters_of[part].push_back(_clusters.size());
			_clusters.push_back({ part, std::move(cube.second) });
		}
	}
}

Vec3 PartSurfaces::choose_point(const Cluster &p_cluster, VisibilityDice &r_dice, Vec3 &r_normal) const {
	const auto number = std::size_t(r_dice.next() * float(p_cluster.triangles.size()));
	const Triangle &triangle = (*_triangles)[p_cluster.triangles[std::min(number, p_cluster.triangles.size() - 1)]];
	float u = r_dice.next();
	float v = r_dice.next();
	if (u + v > 1.0f) {
		u = 1.0f - u;
		v = 1.0f - v;
	}
	r_normal = triangle.normal();
	return triangle.a + (triangle.b - triangle.a) * u + (triangle.c - triangle.a) * v;
}

} // namespace level
