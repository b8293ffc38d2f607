// SPDX-License-Identifier: MIT
#include "sample_slots.hpp"

#include <algorithm>
#include <utility>

namespace godot {

namespace {

constexpr int64_t MAX_SLOTS = 256;

} // namespace

void SampleSlots::set_slots(const PackedInt32Array &p_slots) {
	_slots = p_slots;
	resize_pose();
}

void SampleSlots::set_limbs(std::vector<ragdoll::Quat> p_reset_pose) {
	_reset_pose = std::move(p_reset_pose);
	_targets.assign(_reset_pose.size() * 4, 0.0f);
	resize_pose();
}

void SampleSlots::resize_pose() {
	int64_t slot_count = int64_t(_reset_pose.size());
	for (int64_t i = 0; i < _slots.size(); i++) {
		slot_count = std::max<int64_t>(slot_count, std::min<int64_t>(_slots[i] + 1, MAX_SLOTS));
	}
	_pose.resize(3 + 4 * slot_count);
	_pose.fill(0.0);
}

const float *SampleSlots::find_targets(const PackedFloat32Array &p_rotations, const PackedFloat32Array &p_rates) {
	const std::size_t count = _reset_pose.size();
	const bool is_chosen = !_slots.is_empty();
	if ((is_chosen && _slots.size() != int64_t(count)) || p_rotations.size() % 4 != 0 ||
			(!is_chosen && p_rotations.size() != int64_t(count) * 4) ||
			(!p_rates.is_empty() && p_rates.size() != int64_t(count) * 3)) {
		return nullptr;
	}
	const float *rotations = p_rotations.ptr();
	const int32_t *slots = is_chosen ? _slots.ptr() : nullptr;
	const int64_t most = p_rotations.size() / 4;
	for (std::size_t i = 0; i < count; i++) {
		const int64_t slot = slots ? slots[i] : int64_t(i);
		if (slot < 0 || slot >= most) {
			return nullptr;
		}
		const float *values = rotations + slot * 4;
		// Thesis section 6.2: q = r i.
		const ragdoll::Quat target = ragdoll::Quat{ values[0], values[1], values[2], values[3] } * _reset_pose[i];
		_targets[i * 4] = target.x;
		_targets[i * 4 + 1] = target.y;
		_targets[i * 4 + 2] = target.z;
		_targets[i * 4 + 3] = target.w;
	}
	return _targets.data();
}

void SampleSlots::note_pose(const std::vector<ragdoll::Quat> &p_orientations, const ragdoll::Vec3 &p_root_centre) {
	const int32_t *slots = _slots.is_empty() ? nullptr : _slots.ptr();
	float *pose = _pose.ptrw();
	const int64_t slot_count = (_pose.size() - 3) / 4;
	pose[0] = p_root_centre.x;
	pose[1] = p_root_centre.y;
	pose[2] = p_root_centre.z;
	for (std::size_t i = 0; i < p_orientations.size(); i++) {
		const int64_t slot = slots != nullptr ? slots[i] : int64_t(i);
		if (slot >= 0 && slot < slot_count) {
			const ragdoll::Quat &orientation = p_orientations[i];
			float *values = pose + 3 + slot * 4;
			values[0] = orientation.x;
			values[1] = orientation.y;
			values[2] = orientation.z;
			values[3] = orientation.w;
		}
	}
}

} // namespace godot
