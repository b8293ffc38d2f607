// SPDX-License-Identifier: MIT
#pragma once

#include "driven_ragdoll.hpp"

#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/transform3d.hpp>

namespace godot {

/// Tells scripts what a ragdoll's driver knows and measures. Without a ragdoll it tells of none: zeros, empty lists.
class RagdollReport {
public:
	/// @param p_ragdoll null: none is set up
	explicit RagdollReport(const DrivenRagdoll *p_ragdoll) :
			_driver(p_ragdoll != nullptr ? &p_ragdoll->get_driver() : nullptr) {}

	Dictionary get_tracking() const;
	Dictionary get_balance() const;
	PackedFloat32Array get_limb_torques() const;
	PackedFloat32Array get_limb_saturations() const;
	Transform3D get_frame() const;
	Vector3 get_root_target() const;
	Vector3 get_tether() const;
	bool is_flying() const;

private:
	const ragdoll::Driver *_driver = nullptr;
};

PackedFloat32Array to_packed(const std::vector<float> &p_values);

} // namespace godot
