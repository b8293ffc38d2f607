// SPDX-License-Identifier: MIT
#pragma once

#include "ragdoll_limb.hpp"

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/typed_array.hpp>

namespace godot {

/// What a ragdoll is made of. Documented in doc_classes/RagdollProfile.xml.
class RagdollProfile : public Resource {
	GDCLASS(RagdollProfile, Resource)

public:
	enum {
		MAX_LIMBS = ragdoll::MAX_LIMBS,
	};

	void set_limbs(const TypedArray<RagdollLimb> &p_limbs);
	TypedArray<RagdollLimb> get_limbs() const { return _limbs; }
	void set_mass(double p_mass);
	double get_mass() const { return _mass; }

	Ref<RagdollLimb> find(const StringName &p_bone) const;
	int get_parent_index(int p_limb) const;
	PackedStringArray get_groups() const;
	String find_fault() const;

	/// The limb at an index, or null.
	Ref<RagdollLimb> get_limb(int64_t p_index) const;
	int64_t get_limb_count() const { return _limbs.size(); }

protected:
	static void _bind_methods();

private:
	int64_t find_index(const StringName &p_bone) const;

	TypedArray<RagdollLimb> _limbs;
	double _mass = 80.0;
};

} // namespace godot
