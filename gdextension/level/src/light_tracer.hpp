// SPDX-License-Identifier: MIT
#pragma once

#include "ray_scene.hpp"

#include <array>
#include <atomic>
#include <cstdint>
#include <vector>

namespace level {

/// Sources of light that are baked apart, each for a strength of 1.
enum LightSet {
	LIGHT_SKY,
	LIGHT_MORNING,
	LIGHT_NOON,
	LIGHT_EVENING,
	LIGHT_LAMPS,
	LIGHT_SETS,
};
constexpr int SUNS = 3;

/// Light of each source, linear RGB.
using Light = std::array<Vec3, LIGHT_SETS>;

/// A lamp that shines to all sides, or in a cone.
struct Lamp {
	Vec3 position;
	/// Colour times strength: light on a surface 1 m away that faces it.
	Vec3 colour;
	/// It has faded to nothing here, m.
	float range = 10.0f;
	/// Direction and cosine of half the angle of its cone; -1 for all sides.
	Vec3 way{ 0.0f, -1.0f, 0.0f };
	float cone = -1.0f;
};

/// Light that falls on surfaces but for what comes straight from the sun, which is drawn with its
/// shadows each frame: that of the sky, what surfaces throw back of sky and suns (gathering with
/// cosine-weighted rays, several bounces), and lamps with their shadows.
class LightTracer {
public:
	/// Rays from each place.
	int rays = 64;
	/// How often light is thrown back.
	int bounces = 3;
	/// How far rays go, m.
	float farthest = 120.0f;
	/// Threads that work.
	int threads = 2;
	/// Towards the sun in the morning, at noon, in the evening; of unit length.
	std::array<Vec3, SUNS> suns{};
	/// What the ground far below the horizon throws back of the sky.
	Vec3 far_ground{ 0.5f, 0.42f, 0.31f };
	std::vector<Lamp> lamps;

	/// Adds surfaces. p_albedo has a linear colour for each triangle. Returns the number of its first vertex.
	std::size_t add(const std::vector<Vec3> &p_points, const std::vector<Vec3> &p_normals,
			const std::vector<int32_t> &p_indices, const std::vector<Vec3> &p_albedo);
	/// Works it out for all vertices.
	void bake();
	/// Light at a vertex.
	const Light &light(std::size_t p_vertex) const { return _light[_place_of[p_vertex]]; }
	std::size_t vertex_count() const { return _place_of.size(); }
	/// Light that comes from above and from below at a point in the air, after bake(). False where the
	/// point is inside something.
	bool gather_at(const Vec3 &p_point, Light &r_above, Light &r_below) const;
	/// Share of the work that is done, 0 to 1; may be read by another thread.
	float progress() const { return _progress.load(std::memory_order_relaxed); }
	/// The triangles, in the order in which they were added.
	const std::vector<Triangle> &triangles() const { return _triangles; }
	/// The triangles and who meets them, after bake().
	const RayScene &scene() const { return _scene; }

private:
	/// A position with a normal: vertices at the same one share their light.
	struct Sample {
		Vec3 position;
		Vec3 normal;
	};

	void find_places();
	void trace_direct(std::size_t p_first, std::size_t p_last);
	void trace_patches(std::size_t p_first, std::size_t p_last);
	void trace_gather(std::size_t p_first, std::size_t p_last);
	void throw_back();
	void fill_hidden();
	void smooth();
	Vec3 lamp_light(const Lamp &p_lamp, const Vec3 &p_from, const Vec3 *p_normal, Vec3 &r_way) const;
	Vec3 sky_light(const Vec3 &p_way) const;

	RayScene _scene;
	std::vector<Triangle> _triangles;
	std::vector<std::array<uint32_t, 3>> _corners;
	std::vector<Vec3> _albedo;
	std::vector<Vec3> _points;
	std::vector<Vec3> _normals;
	std::vector<uint32_t> _place_of;
	std::vector<Sample> _places;
	/// What comes straight from lamps, and all else.
	std::vector<Light> _direct;
	std::vector<Light> _light;
	/// Share of each triangle on which each sun shines, times the sine of its height above the triangle:
	/// what shines through a door is smaller than the triangles.
	std::vector<std::array<float, SUNS>> _patches;
	/// What each triangle sends out, when rays meet it.
	std::vector<Light> _sent;
	/// The triangles that each place's rays have met; Hit::NOTHING for the sky, or one of its own for
	/// what was met from behind.
	std::vector<uint32_t> _met;
	std::vector<uint8_t> _hidden;
	std::vector<Vec3> _grid_ways;
	std::atomic<float> _progress{ 0.0f };
};

} // namespace level
