// SPDX-License-Identifier: MIT
#pragma once

#include "ragdoll_control.hpp"

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/variant/string_name.hpp>
#include <godot_cpp/variant/typed_array.hpp>

namespace godot {

/// A named set of controls. Documented in doc_classes/RagdollControlProfile.xml.
class RagdollControlProfile : public Resource {
	GDCLASS(RagdollControlProfile, Resource)

public:
	void set_profile_name(const StringName &p_name);
	StringName get_profile_name() const { return _profile_name; }
	void set_controls(const TypedArray<RagdollControl> &p_controls);
	TypedArray<RagdollControl> get_controls() const { return _controls; }
	void set_blend_s(double p_blend_s);
	double get_blend_s() const { return _blend_s; }

protected:
	static void _bind_methods();

private:
	StringName _profile_name;
	TypedArray<RagdollControl> _controls;
	double _blend_s = 0.3;
};

} // namespace godot
