// SPDX-License-Identifier: MIT
#include "skeleton_poser.hpp"

#include "pose_arrays.hpp"
#include <convert.hpp>

#include <utility>

namespace godot {

namespace {

// The neck takes so much of the head's turn.
constexpr float NECK_SHARE = 0.5f;

bool is_turn(const Quaternion &p_turn) {
	const float square = p_turn.length_squared();
	return square > 0.25f && square < 4.0f; // NaN fails too.
}

} // namespace

bool SkeletonPoser::setup(Skeleton3D *p_skeleton, const PackedInt32Array &p_bones,
		const TypedArray<Transform3D> &p_body_offsets, const PackedFloat32Array &p_reset_orientations) {
	_limbs.clear();
	_order.clear();
	_neck = -1;
	const std::size_t count = std::size_t(p_bones.size());
	kinematics::PersonPose reset;
	if (p_skeleton == nullptr || count > kinematics::MAX_LIMBS || p_body_offsets.size() != p_bones.size() ||
			!read_orientations(p_reset_orientations, int(count), reset)) {
		return false;
	}
	const int bone_count = p_skeleton->get_bone_count();
	std::vector<int> limb_of(std::size_t(bone_count), -1);
	for (std::size_t i = 0; i < count; i++) {
		const int bone = p_bones[int64_t(i)];
		if (bone >= bone_count) {
			return false;
		}
		if (bone >= 0) {
			limb_of[std::size_t(bone)] = int(i);
		}
	}
	std::vector<Limb> limbs(count);
	for (std::size_t i = 0; i < count; i++) {
		Limb &limb = limbs[i];
		limb.bone = p_bones[int64_t(i)];
		limb.from_body = Transform3D(p_body_offsets[int64_t(i)]).affine_inverse();
		limb.reset = from_core(reset.orientations[i]);
		int above = limb.bone >= 0 ? p_skeleton->get_bone_parent(limb.bone) : -1;
		while (above >= 0 && limb_of[std::size_t(above)] < 0) {
			limb.between.insert(limb.between.begin(), above);
			above = p_skeleton->get_bone_parent(above);
		}
		limb.parent = above >= 0 ? limb_of[std::size_t(above)] : -1;
		// A child is posed on what its parent has just become.
		if (limb.parent >= int(i) || !is_turn(limb.reset) || !limb.from_body.is_finite()) {
			return false;
		}
	}
	for (std::size_t i = 0; i < count; i++) {
		if (limbs[i].bone >= 0) {
			_order.push_back(i);
		}
	}
	_limbs = std::move(limbs);
	return true;
}

bool SkeletonPoser::set_neck(Skeleton3D *p_skeleton, int64_t p_neck, int64_t p_head_limb) {
	_neck = -1;
	if (p_skeleton == nullptr || p_head_limb < 0 || p_head_limb >= int64_t(_limbs.size())) {
		return false;
	}
	const Limb &head = _limbs[std::size_t(p_head_limb)];
	// It has to be what carries the head, or it would be turned after what hangs on it.
	if (head.between.empty() || head.between.back() != p_neck) {
		return false;
	}
	_head = std::size_t(p_head_limb);
	_neck = int(p_neck);
	_neck_rest = p_skeleton->get_bone_rest(_neck);
	_from_head = p_skeleton->get_bone_rest(head.bone).basis.get_rotation_quaternion().inverse();
	return true;
}

bool SkeletonPoser::pose(Skeleton3D *p_skeleton, const Ref<SnapshotSmoother> &p_smoother, int64_t p_person) {
	if (p_skeleton == nullptr || p_smoother.is_null() || !is_id(p_person) || _limbs.empty()) {
		return false;
	}
	const wire::Smoother::Person *person = p_smoother->get_core().person(uint16_t(p_person));
	if (person == nullptr || std::size_t(person->limb_count) != _limbs.size()) {
		return false;
	}
	std::array<Transform3D, kinematics::MAX_LIMBS> bodies;
	for (std::size_t i = 0; i < _limbs.size(); i++) {
		const Quaternion turn = from_core(person->pose.orientations[i]) * _limbs[i].reset;
		bodies[i] = Transform3D(Basis(turn), from_core(person->positions[i]));
	}
	_apply(*p_skeleton, bodies.data());
	return true;
}

bool SkeletonPoser::pose_floats(Skeleton3D *p_skeleton, const PackedFloat32Array &p_transforms) {
	if (p_skeleton == nullptr || _limbs.empty() || p_transforms.size() != int64_t(_limbs.size()) * TRANSFORM_SIZE) {
		return false;
	}
	std::array<Transform3D, kinematics::MAX_LIMBS> bodies;
	const float *from = p_transforms.ptr();
	for (std::size_t i = 0; i < _limbs.size(); i++, from += TRANSFORM_SIZE) {
		const Vector3 position(from[0], from[1], from[2]);
		const Quaternion turn(from[3], from[4], from[5], from[6]);
		if (!position.is_finite() || !is_turn(turn)) {
			return false;
		}
		bodies[i] = Transform3D(Basis(turn.normalized() * _limbs[i].reset), position);
	}
	_apply(*p_skeleton, bodies.data());
	return true;
}

void SkeletonPoser::_apply(Skeleton3D &r_skeleton, const Transform3D *p_bodies) {
	const Transform3D to_skeleton = r_skeleton.get_global_transform().affine_inverse();
	for (const std::size_t i : _order) {
		Limb &limb = _limbs[i];
		const Transform3D in_world = p_bodies[i] * limb.from_body;
		limb.shown = to_skeleton * in_world;
		if (_neck >= 0 && i == _head) {
			_turn_neck(r_skeleton, limb);
		}
		r_skeleton.set_bone_pose(
				limb.bone, _above(r_skeleton, limb, limb.between.size()).affine_inverse() * limb.shown);
		if (i == 0) {
			_root = in_world.origin;
		}
	}
}

// Where the first p_count of the bones between a limb and the one above have their end, in the skeleton's frame.
Transform3D SkeletonPoser::_above(const Skeleton3D &p_skeleton, const Limb &p_limb, std::size_t p_count) const {
	Transform3D pose = p_limb.parent >= 0 ? _limbs[std::size_t(p_limb.parent)].shown : Transform3D();
	for (std::size_t i = 0; i < p_count; i++) {
		pose = pose * p_skeleton.get_bone_pose(p_limb.between[i]);
	}
	return pose;
}

void SkeletonPoser::_turn_neck(Skeleton3D &r_skeleton, const Limb &p_head) const {
	const Transform3D above = _above(r_skeleton, p_head, p_head.between.size() - 1);
	Transform3D neck = above * _neck_rest;
	const kinematics::Quat straight = to_core(neck.basis.get_rotation_quaternion());
	const kinematics::Quat bent = to_core(p_head.shown.basis.get_rotation_quaternion() * _from_head);
	neck.basis = Basis(from_core(kinematics::slerp(straight, bent, NECK_SHARE).normalized()));
	r_skeleton.set_bone_pose(_neck, above.affine_inverse() * neck);
}

void SkeletonPoser::_bind_methods() {
	ClassDB::bind_method(
			D_METHOD("setup", "skeleton", "bones", "body_offsets", "reset_orientations"), &SkeletonPoser::setup);
	ClassDB::bind_method(D_METHOD("set_neck", "skeleton", "neck", "head_limb"), &SkeletonPoser::set_neck);
	ClassDB::bind_method(D_METHOD("pose", "skeleton", "smoother", "person"), &SkeletonPoser::pose);
	ClassDB::bind_method(D_METHOD("pose_floats", "skeleton", "transforms"), &SkeletonPoser::pose_floats);
	ClassDB::bind_method(D_METHOD("get_root"), &SkeletonPoser::get_root);
}

} // namespace godot
