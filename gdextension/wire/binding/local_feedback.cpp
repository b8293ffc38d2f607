// SPDX-License-Identifier: MIT
#include "local_feedback.hpp"

#include "pose_arrays.hpp"
#include <convert.hpp>

namespace godot {

bool LocalFeedback::set_skeleton(const PackedInt32Array &p_parents, const PackedVector3Array &p_joints_in_parent,
		const PackedVector3Array &p_joints_in_limb) {
	kinematics::Skeleton skeleton;
	return read_skeleton(p_parents, p_joints_in_parent, p_joints_in_limb, skeleton) && _feedback.set_skeleton(skeleton);
}

bool LocalFeedback::push_local(double p_moment_s, const Vector3 &p_root, const PackedFloat32Array &p_orientations) {
	kinematics::PersonPose pose;
	pose.root = to_core(p_root);
	return read_orientations(p_orientations, _feedback.limb_count(), pose) && _feedback.push_local(p_moment_s, pose);
}

bool LocalFeedback::push_truth(double p_moment_s, const PackedFloat32Array &p_transforms) {
	const int count = _feedback.limb_count();
	if (count == 0 || p_transforms.size() != int64_t(count) * TRANSFORM_SIZE) {
		return false;
	}
	kinematics::PersonPose pose;
	const float *from = p_transforms.ptr();
	pose.root = { from[0], from[1], from[2] };
	for (std::size_t i = 0; i < std::size_t(count); i++) {
		const float *turn = from + i * TRANSFORM_SIZE + 3;
		pose.orientations[i] = { turn[0], turn[1], turn[2], turn[3] };
	}
	return _feedback.push_truth(p_moment_s, pose);
}

PackedFloat32Array LocalFeedback::transforms() const {
	return write_transforms(_feedback.get_pose(), _feedback.get_positions(), _feedback.limb_count());
}

double LocalFeedback::deviation(int64_t p_limb) const {
	ERR_FAIL_COND_V_MSG(
			p_limb < 0 || p_limb >= _feedback.limb_count(), 0.0, "LocalFeedback: there is no limb of that number.");
	return _feedback.deviation(std::size_t(p_limb));
}

void LocalFeedback::_bind_methods() {
	ClassDB::bind_method(
			D_METHOD("set_skeleton", "parents", "joints_in_parent", "joints_in_limb"), &LocalFeedback::set_skeleton);
	ClassDB::bind_method(D_METHOD("set_heading", "heading"), &LocalFeedback::set_heading);
	ClassDB::bind_method(D_METHOD("push_local", "moment_s", "root", "orientations"), &LocalFeedback::push_local);
	ClassDB::bind_method(D_METHOD("push_truth", "moment_s", "transforms"), &LocalFeedback::push_truth);
	ClassDB::bind_method(D_METHOD("evaluate", "now_s", "moment_s"), &LocalFeedback::evaluate);
	ClassDB::bind_method(D_METHOD("transforms"), &LocalFeedback::transforms);
	ClassDB::bind_method(D_METHOD("deviation", "limb"), &LocalFeedback::deviation);
	ClassDB::bind_method(D_METHOD("newest_moment"), &LocalFeedback::newest_moment);
	ClassDB::bind_method(D_METHOD("clear"), &LocalFeedback::clear);
}

} // namespace godot
