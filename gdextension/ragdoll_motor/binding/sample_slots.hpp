// SPDX-License-Identifier: MIT
#pragma once

#include <base/vectors.hpp>

#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>

#include <vector>

namespace godot {

/// Translates between the limbs of a ragdoll and the slots that samples of motion have for them. A sample may be of
/// more limbs than the profile has; without slots it has the profile's limbs in their order.
class SampleSlots {
public:
	const PackedInt32Array &get_slots() const { return _slots; }
	/// Sets the slot of each limb; empty: the limbs' own order.
	void set_slots(const PackedInt32Array &p_slots);
	/// Sets the limbs, by their orientations in the reset pose, model space.
	void set_limbs(std::vector<ragdoll::Quat> p_reset_pose);

	/// The orientations of the limbs, four numbers each, to which a sample turns them; null where the sample does
	/// not fit. Valid until the next call.
	/// @param p_rotations from the reset pose, four numbers a slot
	/// @param p_rates three numbers a limb, or none
	const float *find_targets(const PackedFloat32Array &p_rotations, const PackedFloat32Array &p_rates);

	/// The pose that was noted last: the root's centre (m), and the orientation of each slot.
	const PackedFloat32Array &get_pose() const { return _pose; }
	void note_pose(const std::vector<ragdoll::Quat> &p_orientations, const ragdoll::Vec3 &p_root_centre);

private:
	void resize_pose();

	PackedInt32Array _slots;
	std::vector<ragdoll::Quat> _reset_pose;
	std::vector<float> _targets;
	PackedFloat32Array _pose;
};

} // namespace godot
