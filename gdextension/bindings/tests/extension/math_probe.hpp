// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/dictionary.hpp>

namespace probe {

/// Computes with the native number types, for comparison with what the engine computes.
class MathProbe : public godot::RefCounted {
	GDCLASS(MathProbe, godot::RefCounted)

public:
	godot::Dictionary vectors(const godot::Vector3 &p_left, const godot::Vector3 &p_right) const;
	godot::Dictionary quaternions(const godot::Quaternion &p_left, const godot::Quaternion &p_right, double p_weight,
			const godot::Vector3 &p_vector) const;
	godot::Dictionary bases(
			const godot::Basis &p_left, const godot::Basis &p_right, const godot::Vector3 &p_vector) const;
	godot::Dictionary transforms(
			const godot::Transform3D &p_left, const godot::Transform3D &p_right, const godot::Vector3 &p_vector) const;

protected:
	static void _bind_methods();
};

} // namespace probe
