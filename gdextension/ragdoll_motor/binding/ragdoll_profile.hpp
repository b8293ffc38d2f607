// SPDX-License-Identifier: MIT
#pragma once

#include "ragdoll_limb.hpp"

#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/typed_array.hpp>

namespace godot {

/// What a ragdoll is made of. Documented in doc_classes/RagdollProfile.xml.
class RagdollProfile : public Resource {
	GDCLASS(RagdollProfile, Resource)

public:
	/// More limbs than any figure has; a file with more is refused.
	static constexpr int64_t MOST_LIMBS = 256;

	void set_limbs(const TypedArray<RagdollLimb> &p_limbs) { limbs = p_limbs; }
	TypedArray<RagdollLimb> get_limbs() const { return limbs; }
	void set_mass(double p_mass) { mass = p_mass; }
	double get_mass() const { return mass; }

	Ref<RagdollLimb> find(const StringName &p_bone) const;
	/// Index of the limb that holds another, or -1.
	int64_t get_parent_index(int64_t p_limb) const;
	PackedStringArray get_groups() const;
	/// Why this cannot be a ragdoll, or an empty text if it can.
	String find_fault() const;

protected:
	static void _bind_methods();

private:
	Ref<RagdollLimb> at(int64_t p_limb) const;
	String find_fault_of(int64_t p_limb) const;

	TypedArray<RagdollLimb> limbs;
	double mass = 80.0;
};

} // namespace godot
