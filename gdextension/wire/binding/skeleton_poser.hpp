// SPDX-License-Identifier: MIT
#pragma once

#include "snapshot_smoother.hpp"

#include <godot_cpp/classes/mesh_instance3d.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/classes/skeleton3d.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>
#include <godot_cpp/variant/rid.hpp>
#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace godot {

/// Puts the bones of a skeleton where a person's bodies are. Documented in doc_classes/SkeletonPoser.xml.
///
/// The skeleton comes with every call instead of being kept: a freed one then arrives as null.
class SkeletonPoser : public RefCounted {
	GDCLASS(SkeletonPoser, RefCounted)

public:
	bool setup(Skeleton3D *p_skeleton, const PackedInt32Array &p_bones, const TypedArray<Transform3D> &p_body_offsets,
			const PackedFloat32Array &p_reset_orientations);
	bool set_neck(Skeleton3D *p_skeleton, int64_t p_neck, int64_t p_head_limb);
	bool add_mesh(Skeleton3D *p_skeleton, MeshInstance3D *p_mesh);
	void find_offsets(Skeleton3D *p_skeleton);
	void set_driving_skeleton(bool p_is_driving) { _drives_skeleton = p_is_driving; }
	bool is_driving_skeleton() const { return _drives_skeleton; }
	void write_skeleton(Skeleton3D *p_skeleton) const;
	Transform3D get_bone_transform(int64_t p_bone) const;
	int64_t get_palette_size(int64_t p_palette) const;
	Transform3D get_palette_entry(int64_t p_palette, int64_t p_entry) const;
	bool pose(Skeleton3D *p_skeleton, const Ref<SnapshotSmoother> &p_smoother, int64_t p_person);
	bool pose_floats(Skeleton3D *p_skeleton, const PackedFloat32Array &p_transforms);
	Vector3 get_root() const { return _root; }

protected:
	static void _bind_methods();

private:
	struct Limb {
		int bone = -1; // None: the skeleton lacks it.
		Transform3D from_body; // From the body's frame to the bone's.
		Quaternion reset;
		Transform3D shown; // The bone in the skeleton's frame.
	};
	struct Bone {
		int parent = -1;
		int limb = -1; // The limb that it hangs on, itself or by bones between; none: -1.
		Transform3D offset; // From the limb's bone, or from the skeleton.
	};
	// What moves the vertices of some meshes: one transform for each bind of their skin.
	struct Palette {
		RID skeleton;
		uint64_t skin = 0; // Its instance.
		struct Entry {
			int bone = 0;
			Transform3D bind;
			Transform3D shown;
		};
		std::vector<Entry> entries;
	};

	void _apply(Skeleton3D &r_skeleton, const Transform3D *p_bodies);
	void _place_neck();
	void _fill_palettes();

	std::vector<Limb> _limbs;
	std::vector<Bone> _bones; // Of the skeleton.
	std::vector<int> _from_root; // The same, parents before children.
	std::vector<Transform3D> _shown; // Each bone in the skeleton's frame.
	std::vector<Palette> _palettes;
	bool _drives_skeleton = false;
	std::size_t _head = 0;
	int _neck = -1; // Its bone; none: -1.
	Transform3D _neck_rest;
	Quaternion _from_head; // Inverse of the head's rest in the neck's frame.
	Vector3 _root; // Of the first limb's bone, in the world.
	Transform3D _to_world; // Of the skeleton, when it was posed last.
};

} // namespace godot
