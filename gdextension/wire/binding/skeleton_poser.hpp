// SPDX-License-Identifier: MIT
#pragma once

#include "snapshot_smoother.hpp"

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/classes/skeleton3d.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>
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
	bool pose(Skeleton3D *p_skeleton, const Ref<SnapshotSmoother> &p_smoother, int64_t p_person);
	bool pose_floats(Skeleton3D *p_skeleton, const PackedFloat32Array &p_transforms);
	Vector3 get_root() const { return _root; }

protected:
	static void _bind_methods();

private:
	struct Limb {
		int bone = -1; // None: the skeleton lacks it.
		int parent = -1; // The limb whose bone is the nearest above; none: -1.
		std::vector<int> between; // Bones from that one down to this, without both.
		Transform3D from_body; // From the body's frame to the bone's.
		Quaternion reset;
		Transform3D shown; // The bone in the skeleton's frame.
	};

	void _apply(Skeleton3D &r_skeleton, const Transform3D *p_bodies);
	Transform3D _above(const Skeleton3D &p_skeleton, const Limb &p_limb, std::size_t p_count) const;
	void _turn_neck(Skeleton3D &r_skeleton, const Limb &p_head) const;

	std::vector<Limb> _limbs;
	std::vector<std::size_t> _order; // Limbs with a bone, parents before children.
	std::size_t _head = 0;
	int _neck = -1; // Its bone; none: -1.
	Transform3D _neck_rest;
	Quaternion _from_head; // Inverse of the head's rest in the neck's frame.
	Vector3 _root; // Of the first limb's bone, in the world.
};

} // namespace godot
