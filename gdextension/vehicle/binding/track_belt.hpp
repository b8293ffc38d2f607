// SPDX-License-Identifier: MIT
#pragma once

#include <belt.hpp>

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_vector2_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>
#include <godot_cpp/variant/rid.hpp>

namespace godot {

/// The links of a track as transforms of a MultiMesh. Documented in doc_classes/TrackBelt.xml.
class TrackBelt : public RefCounted {
	GDCLASS(TrackBelt, RefCounted)

public:
	bool configure(
			const PackedVector3Array &p_wheels, int64_t p_first_sagging, int64_t p_links, double p_pitch, double p_x);
	void lay(double p_way, const PackedFloat32Array &p_lifts);
	void show(const RID &p_multimesh) const;
	PackedFloat32Array get_buffer() const { return _buffer; }
	PackedVector2Array get_outline() const;
	int64_t get_link_count() const { return int64_t(_belt.link_count()); }
	double get_pitch() const { return _belt.drawn_pitch(); }
	double get_sag() const { return _belt.sag(); }
	double get_sprocket_angle(double p_way) const { return _belt.sprocket_angle(p_way); }

protected:
	static void _bind_methods();

private:
	/// Three rows of four numbers a link.
	static constexpr int64_t NUMBERS = 12;

	vehicle::Belt _belt;
	std::vector<vehicle::BeltLink> _links;
	PackedFloat32Array _buffer;
};

} // namespace godot
