// SPDX-License-Identifier: MIT
#pragma once

#include <block_mesh.hpp>

#include <vector>

namespace boxes {

using level::BlockMesh;
using level::Triangle;
using level::Vec3;

/// The triangles of a mesh.
inline std::vector<Triangle> triangles(const BlockMesh &p_mesh) {
	std::vector<Triangle> result;
	for (std::size_t index = 0; index < p_mesh.indices().size(); index += 3) {
		result.push_back({ p_mesh.points()[p_mesh.indices()[index]], p_mesh.points()[p_mesh.indices()[index + 1]],
				p_mesh.points()[p_mesh.indices()[index + 2]] });
	}
	return result;
}

/// A colour for each triangle of a mesh.
inline std::vector<Vec3> colours(const BlockMesh &p_mesh, const Vec3 &p_colour) {
	return std::vector<Vec3>(p_mesh.indices().size() / 3, p_colour);
}

/// A ground of 40 m and a room on it with a floor of its own, 6 x 3 x 6 m with walls of 0.3 m, which has a door to +Z
/// if asked for.
inline BlockMesh room(bool p_has_door) {
	BlockMesh mesh;
	mesh.set_finest(1.0f);
	mesh.box({ -20.0f, -1.0f, -20.0f }, { 20.0f, 0.0f, 20.0f }, {});
	mesh.box({ -3.0f, 0.0f, -3.0f }, { 3.0f, 0.05f, 3.0f }, {});
	mesh.box({ -3.3f, 0.0f, -3.3f }, { -3.0f, 3.0f, 3.3f }, {});
	mesh.box({ 3.0f, 0.0f, -3.3f }, { 3.3f, 3.0f, 3.3f }, {});
	mesh.box({ -3.3f, 0.0f, -3.3f }, { 3.3f, 3.0f, -3.0f }, {});
	mesh.box({ -3.3f, 3.0f, -3.3f }, { 3.3f, 3.3f, 3.3f }, {});
	const float edge = p_has_door ? 0.6f : 0.0f;
	mesh.box({ -3.3f, 0.0f, 3.0f }, { -edge, 3.0f, 3.3f }, {});
	mesh.box({ edge, 0.0f, 3.0f }, { 3.3f, 3.0f, 3.3f }, {});
	return mesh;
}

} // namespace boxes
