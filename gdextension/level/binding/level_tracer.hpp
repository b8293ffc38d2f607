// SPDX-License-Identifier: MIT
#pragma once

#include "block_mesh.hpp"

#include <light_tracer.hpp>
#include <visibility.hpp>

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/variant/color.hpp>
#include <godot_cpp/variant/packed_color_array.hpp>
#include <godot_cpp/variant/vector3i.hpp>

#include <memory>

namespace godot {

/// Works out a level's light and what can be seen from where. Documented in doc_classes/LevelTracer.xml.
class LevelTracer : public RefCounted {
	GDCLASS(LevelTracer, RefCounted)

public:
	void set_palette(const PackedColorArray &p_layers, const PackedColorArray &p_tints);
	void set_suns(const Vector3 &p_morning, const Vector3 &p_noon, const Vector3 &p_evening);
	void set_effort(int64_t p_rays, int64_t p_bounces, int64_t p_threads);
	void add_lamp(
			const Vector3 &p_position, const Color &p_colour, double p_range, const Vector3 &p_way, double p_angle);
	int64_t add_part(const Ref<BlockMesh> &p_mesh);
	void add_surface(const PackedVector3Array &p_points, const PackedVector3Array &p_normals,
			const PackedInt32Array &p_indices, const Color &p_colour);

	void bake();
	double get_progress() const;
	PackedByteArray get_light(int64_t p_part) const;
	PackedByteArray make_grid(const Vector3 &p_origin, const Vector3 &p_spacing, const Vector3i &p_counts) const;
	bool is_blocked(const Vector3 &p_from, const Vector3 &p_to) const;

	/// Cells of the sets of parts along the edge of a cell.
	int64_t get_divisions() const;
	bool survey(const Vector3 &p_origin, double p_size, const Vector3i &p_counts);
	PackedByteArray get_seen_parts() const;
	PackedByteArray get_seen_cells() const;

protected:
	static void _bind_methods();

private:
	struct Range {
		std::size_t first = 0;
		std::size_t count = 0;
	};
	level::Vec3 _albedo(int p_layer, int p_tint) const;

	level::LightTracer _light;
	std::unique_ptr<level::Visibility> _visibility;
	std::vector<Range> _parts;
	std::vector<int32_t> _part_of;
	std::vector<level::Vec3> _layers;
	std::vector<level::Vec3> _tints;
};

} // namespace godot
