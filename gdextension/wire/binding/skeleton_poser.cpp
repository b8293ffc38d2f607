// SPDX-License-Identifier: MIT
#include "skeleton_poser.hpp"

#include "pose_arrays.hpp"
#include <convert.hpp>

#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/classes/skin.hpp>
#include <godot_cpp/classes/skin_reference.hpp>

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
	_bones.clear();
	_palettes.clear();
	_neck = -1;
	const std::size_t count = std::size_t(p_bones.size());
	kinematics::PersonPose reset;
	if (p_skeleton == nullptr || count > kinematics::MAX_LIMBS || p_body_offsets.size() != p_bones.size() ||
			!read_orientations(p_reset_orientations, int(count), reset)) {
		return false;
	}
	const int bone_count = p_skeleton->get_bone_count();
	std::vector<Bone> bones;
	bones.resize(std::size_t(bone_count));
	std::vector<Limb> limbs(count);
	for (std::size_t i = 0; i < count; i++) {
		Limb &limb = limbs[i];
		limb.bone = p_bones[int64_t(i)];
		limb.from_body = Transform3D(p_body_offsets[int64_t(i)]).affine_inverse();
		limb.reset = from_core(reset.orientations[i]);
		if (limb.bone >= bone_count || !is_turn(limb.reset) || !limb.from_body.is_finite()) {
			return false;
		}
		if (limb.bone >= 0) {
			bones[std::size_t(limb.bone)].limb = int(i);
		}
	}
	_from_root.clear();
	for (int bone = 0; bone < bone_count; bone++) {
		bones[std::size_t(bone)].parent = p_skeleton->get_bone_parent(bone);
		if (bones[std::size_t(bone)].parent < 0) {
			_from_root.push_back(bone);
		}
	}
	for (std::size_t at = 0; at < _from_root.size(); at++) {
		const PackedInt32Array children = p_skeleton->get_bone_children(_from_root[at]);
		for (int64_t child = 0; child < children.size(); child++) {
			_from_root.push_back(children[child]);
		}
	}
	_limbs = std::move(limbs);
	_bones = std::move(bones);
	_to_world = p_skeleton->is_inside_tree() ? p_skeleton->get_global_transform() : Transform3D();
	_shown.clear();
	for (int bone = 0; bone < bone_count; bone++) {
		_shown.push_back(p_skeleton->get_bone_global_pose(bone));
	}
	find_offsets(p_skeleton);
	return true;
}

void SkeletonPoser::find_offsets(Skeleton3D *p_skeleton) {
	if (p_skeleton == nullptr || p_skeleton->get_bone_count() != int(_bones.size())) {
		return;
	}
	for (const int bone : _from_root) {
		Bone &one = _bones[std::size_t(bone)];
		if (one.limb >= 0 && _limbs[std::size_t(one.limb)].bone == bone) {
			one.offset = Transform3D();
			continue;
		}
		const Transform3D pose = p_skeleton->get_bone_pose(bone);
		one.limb = one.parent >= 0 ? _bones[std::size_t(one.parent)].limb : -1;
		one.offset = one.parent >= 0 ? _bones[std::size_t(one.parent)].offset * pose : pose;
	}
}

bool SkeletonPoser::set_neck(Skeleton3D *p_skeleton, int64_t p_neck, int64_t p_head_limb) {
	_neck = -1;
	if (p_skeleton == nullptr || p_head_limb < 0 || p_head_limb >= int64_t(_limbs.size())) {
		return false;
	}
	const int head = _limbs[std::size_t(p_head_limb)].bone;
	// It has to be what carries the head and is no limb itself.
	if (head < 0 || p_neck < 0 || p_neck >= int64_t(_bones.size()) || _bones[std::size_t(head)].parent != p_neck ||
			_bones[std::size_t(p_neck)].parent < 0) {
		return false;
	}
	const int limb = _bones[std::size_t(p_neck)].limb;
	if (limb >= 0 && _limbs[std::size_t(limb)].bone == p_neck) {
		return false;
	}
	_head = std::size_t(p_head_limb);
	_neck = int(p_neck);
	_neck_rest = p_skeleton->get_bone_rest(_neck);
	_from_head = p_skeleton->get_bone_rest(head).basis.get_rotation_quaternion().inverse();
	return true;
}

bool SkeletonPoser::add_mesh(Skeleton3D *p_skeleton, MeshInstance3D *p_mesh) {
	if (p_skeleton == nullptr || p_mesh == nullptr || _bones.empty()) {
		return false;
	}
	const Ref<SkinReference> reference = p_mesh->get_skin_reference();
	if (reference.is_null() || reference->get_skin().is_null()) {
		return false;
	}
	const Ref<Skin> skin = reference->get_skin();
	for (const Palette &palette : _palettes) {
		if (palette.skin == skin->get_instance_id()) {
			return true; // Meshes with the same skin share its palette.
		}
	}
	Palette palette;
	palette.skeleton = reference->get_skeleton();
	palette.skin = skin->get_instance_id();
	for (int bind = 0; bind < skin->get_bind_count(); bind++) {
		const StringName name = skin->get_bind_name(bind);
		Palette::Entry entry;
		entry.bone = name.is_empty() ? skin->get_bind_bone(bind) : p_skeleton->find_bone(name);
		entry.bind = skin->get_bind_pose(bind);
		if (entry.bone < 0 || entry.bone >= int(_bones.size())) {
			return false;
		}
		palette.entries.push_back(entry);
	}
	_palettes.push_back(std::move(palette));
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

// Thesis section 6.4: each entry of the palette follows from the global pose of a limb alone. What hangs between
// limbs keeps its offset to the one above; nothing is chained through the skeleton.
void SkeletonPoser::_apply(Skeleton3D &r_skeleton, const Transform3D *p_bodies) {
	_to_world = r_skeleton.get_global_transform();
	const Transform3D to_skeleton = _to_world.affine_inverse();
	for (std::size_t i = 0; i < _limbs.size(); i++) {
		Limb &limb = _limbs[i];
		const Transform3D in_world = p_bodies[i] * limb.from_body;
		limb.shown = to_skeleton * in_world;
		if (i == 0) {
			_root = in_world.origin;
		}
	}
	for (std::size_t bone = 0; bone < _bones.size(); bone++) {
		const Bone &one = _bones[bone];
		_shown[bone] = one.limb >= 0 ? _limbs[std::size_t(one.limb)].shown * one.offset : one.offset;
	}
	if (_neck >= 0) {
		_place_neck();
	}
	_fill_palettes();
	if (_drives_skeleton) {
		write_skeleton(&r_skeleton);
	}
}

void SkeletonPoser::_place_neck() {
	Transform3D &neck = _shown[std::size_t(_neck)];
	const Transform3D &head = _limbs[_head].shown;
	neck = _shown[std::size_t(_bones[std::size_t(_neck)].parent)] * _neck_rest;
	const kinematics::Quat straight = to_core(neck.basis.get_rotation_quaternion());
	const kinematics::Quat bent = to_core(head.basis.get_rotation_quaternion() * _from_head);
	neck.basis = Basis(from_core(kinematics::slerp(straight, bent, NECK_SHARE).normalized()));
}

void SkeletonPoser::_fill_palettes() {
	RenderingServer *server = RenderingServer::get_singleton();
	for (Palette &palette : _palettes) {
		int32_t number = 0;
		const bool is_drawn = palette.skeleton.is_valid();
		for (Palette::Entry &entry : palette.entries) {
			entry.shown = _shown[std::size_t(entry.bone)] * entry.bind;
			if (is_drawn) {
				server->skeleton_bone_set_transform(palette.skeleton, number, entry.shown);
			}
			number++;
		}
	}
}

void SkeletonPoser::write_skeleton(Skeleton3D *p_skeleton) const {
	if (p_skeleton == nullptr || p_skeleton->get_bone_count() != int(_bones.size())) {
		return;
	}
	for (const Limb &limb : _limbs) {
		if (limb.bone < 0) {
			continue;
		}
		const int above = _bones[std::size_t(limb.bone)].parent;
		const Transform3D pose = above >= 0 ? _shown[std::size_t(above)].affine_inverse() * limb.shown : limb.shown;
		p_skeleton->set_bone_pose(limb.bone, pose);
	}
	if (_neck >= 0) {
		const int above = _bones[std::size_t(_neck)].parent;
		p_skeleton->set_bone_pose(_neck, _shown[std::size_t(above)].affine_inverse() * _shown[std::size_t(_neck)]);
	}
}

Transform3D SkeletonPoser::get_bone_transform(int64_t p_bone) const {
	if (p_bone < 0 || p_bone >= int64_t(_shown.size())) {
		return Transform3D();
	}
	return _to_world * _shown[std::size_t(p_bone)];
}

int64_t SkeletonPoser::get_palette_size(int64_t p_palette) const {
	const bool is_known = p_palette >= 0 && p_palette < int64_t(_palettes.size());
	return is_known ? int64_t(_palettes[std::size_t(p_palette)].entries.size()) : 0;
}

Transform3D SkeletonPoser::get_palette_entry(int64_t p_palette, int64_t p_entry) const {
	if (p_entry < 0 || p_entry >= get_palette_size(p_palette)) {
		return Transform3D();
	}
	return _palettes[std::size_t(p_palette)].entries[std::size_t(p_entry)].shown;
}

void SkeletonPoser::_bind_methods() {
	ClassDB::bind_method(
			D_METHOD("setup", "skeleton", "bones", "body_offsets", "reset_orientations"), &SkeletonPoser::setup);
	ClassDB::bind_method(D_METHOD("set_neck", "skeleton", "neck", "head_limb"), &SkeletonPoser::set_neck);
	ClassDB::bind_method(D_METHOD("add_mesh", "skeleton", "mesh"), &SkeletonPoser::add_mesh);
	ClassDB::bind_method(D_METHOD("find_offsets", "skeleton"), &SkeletonPoser::find_offsets);
	ClassDB::bind_method(D_METHOD("set_driving_skeleton", "is_driving"), &SkeletonPoser::set_driving_skeleton);
	ClassDB::bind_method(D_METHOD("is_driving_skeleton"), &SkeletonPoser::is_driving_skeleton);
	ClassDB::bind_method(D_METHOD("write_skeleton", "skeleton"), &SkeletonPoser::write_skeleton);
	ClassDB::bind_method(D_METHOD("get_bone_transform", "bone"), &SkeletonPoser::get_bone_transform);
	ClassDB::bind_method(D_METHOD("get_palette_size", "palette"), &SkeletonPoser::get_palette_size);
	ClassDB::bind_method(D_METHOD("get_palette_entry", "palette", "entry"), &SkeletonPoser::get_palette_entry);
	ClassDB::bind_method(D_METHOD("pose", "skeleton", "smoother", "person"), &SkeletonPoser::pose);
	ClassDB::bind_method(D_METHOD("pose_floats", "skeleton", "transforms"), &SkeletonPoser::pose_floats);
	ClassDB::bind_method(D_METHOD("get_root"), &SkeletonPoser::get_root);
}

} // namespace godot
