// SPDX-License-Identifier: MIT
#pragma once

#include "ray_scene.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace level {

/// A rotation and a translation: columns of the basis, then the origin.
struct Place {
	std::array<Vec3, 3> basis{ Vec3{ 1.0f, 0.0f, 0.0f }, Vec3{ 0.0f, 1.0f, 0.0f }, Vec3{ 0.0f, 0.0f, 1.0f } };
	Vec3 origin;

	Vec3 turn(const Vec3 &p_vector) const {
		return basis[0] * p_vector.x + basis[1] * p_vector.y + basis[2] * p_vector.z;
	}
	Vec3 point(const Vec3 &p_point) const { return turn(p_point) + origin; }
};

/// A rectangle in a face, from its lower left corner, m.
struct Opening {
	float x = 0.0f;
	float y = 0.0f;
	float width = 0.0f;
	float height = 0.0f;
};

/// What a surface is made of.
struct Style {
	/// Number of the layer of the texture.
	int layer = 0;
	/// Number of the tint.
	int tint = 0;
};

/// Faces of a box.
enum FaceOfBox : uint32_t {
	FACE_LEFT = 1,
	FACE_RIGHT = 2,
	FACE_BOTTOM = 4,
	FACE_TOP = 8,
	FACE_BACK = 16,
	FACE_FRONT = 32,
};

/// A solid box.
struct SolidBox {
	Place place;
	/// Edge lengths, m.
	Vec3 size;
};

/// Collects the faces of building blocks: one vertex format for everything that a level is built of,
/// so that one material and few meshes show all. Light lives in the vertices: faces are divided.
class BlockMesh {
public:
	/// Longest edge of a part of a face, and next to openings, m.
	static constexpr float FINEST_M = 1.25f;
	static constexpr float NEAR_OPENING_M = 0.4f;
	/// Most vertices of a mesh.
	static constexpr std::size_t MAX_VERTICES = 2'000'000;

	/// Where the block being built stands.
	void set_place(const Place &p_place) { _place = p_place; }
	/// Moves the pictures, in edges of a picture, so that neighbours differ.
	void set_uv_shift(float p_u, float p_v) { _uv_shift = { p_u, p_v }; }
	/// Edges of the layers' pictures, m.
	void set_layer_edges(const std::vector<float> &p_edges) { _edges = p_edges; }
	/// How much sand settles on what is built from now on, 0 to 1, and where the ground is, m.
	void set_dust(float p_amount, float p_ground_y);
	/// Longest edge of a part of a face from now on, m.
	void set_finest(float p_finest) { _finest = p_finest; }

	/// A rectangle seen from the side to which p_right x p_up points.
	void face(const Vec3 &p_corner, const Vec3 &p_right, const Vec3 &p_up, float p_width, float p_height,
			const Style &p_style, const std::vector<Opening> &p_holes = {});
	/// A quadrilateral; its corners run clockwise as it is seen.
	void quad(const std::array<Vec3, 4> &p_corners, const Style &p_style);
	/// A triangle; its corners run clockwise as it is seen.
	void triangle(const Vec3 &p_a, const Vec3 &p_b, const Vec3 &p_c, const Style &p_style);
	/// A box between two corners, without the sides that are never seen (bits of FaceOfBox).
	void box(const Vec3 &p_from, const Vec3 &p_to, const Style &p_style, uint32_t p_without = 0);
	/// A cylinder or cone.
	void rod(const Vec3 &p_from, const Vec3 &p_to, float p_radius, float p_end_radius, const Style &p_style,
			int p_sides, bool p_has_ends);
	/// A surface of triangles with own normals, such as rocks and models.
	void surface(const std::vector<Vec3> &p_points, const std::vector<Vec3> &p_normals,
			const std::vector<std::array<float, 2>> &p_uvs, const std::vector<int32_t> &p_indices,
			const Style &p_style);
	/// A solid box between two corners.
	void solid(const Vec3 &p_from, const Vec3 &p_to);

	const std::vector<Vec3> &points() const { return _points; }
	const std::vector<Vec3> &normals() const { return _normals; }
	const std::vector<Vec3> &tangents() const { return _tangents; }
	const std::vector<std::array<float, 2>> &uvs() const { return _uvs; }
	const std::vector<std::array<float, 2>> &styles() const { return _styles; }
	const std::vector<float> &dust() const { return _dust; }
	const std::vector<int32_t> &indices() const { return _indices; }
	const std::vector<SolidBox> &solids() const { return _solids; }
	/// Triangles that throw the shadow of all faces, three corners each, in the order of the indices: shadows
	/// need no light, so these are not divided.
	const std::vector<Vec3> &shadow() const { return _shadow; }

private:
	float edge_of(int p_layer) const;
	float dust_at(const Vec3 &p_point, const Vec3 &p_normal) const;
	int32_t add(const Vec3 &p_point, const Vec3 &p_normal, const Vec3 &p_tangent, float p_u, float p_v,
			const Style &p_style);
	std::vector<float> cuts(float p_length, const std::vector<Opening> &p_holes, bool p_across) const;
	void add_shadow(const Vec3 &p_a, const Vec3 &p_b, const Vec3 &p_c);
	void add_shadow(const Vec3 &p_corner, const Vec3 &p_right, const Vec3 &p_up, float p_width, float p_height,
			const std::vector<Opening> &p_holes);
	void copy_shadow(std::size_t p_first_index);
	void cap(const Vec3 &p_middle, const Vec3 &p_way, const Vec3 &p_side, float p_radius, const Style &p_style,
			int p_sides);

	Place _place;
	std::array<float, 2> _uv_shift{};
	std::vector<float> _edges;
	float _dust_amount = 1.0f;
	float _ground_y = 0.0f;
	float _finest = FINEST_M;

	std::vector<Vec3> _points;
	std::vector<Vec3> _normals;
	std::vector<Vec3> _tangents;
	std::vector<std::array<float, 2>> _uvs;
	std::vector<std::array<float, 2>> _styles;
	std::vector<float> _dust;
	std::vector<int32_t> _indices;
	std::vector<SolidBox> _solids;
	std::vector<Vec3> _shadow;
};

} // namespace level
