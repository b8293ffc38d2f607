// SPDX-License-Identifier: MIT
#include "ragdoll_profile.hpp"

namespace godot {

void RagdollProfile::set_limbs(const TypedArray<RagdollLimb> &p_limbs) {
	_limbs = p_limbs;
	emit_changed();
}

void RagdollProfile::set_mass(double p_mass) {
	_mass = p_mass;
	emit_changed();
}

Ref<RagdollLimb> RagdollProfile::get_limb(int64_t p_index) const {
	return Ref<RagdollLimb>(_limbs[p_index]);
}

int64_t RagdollProfile::find_index(const StringName &p_bone) const {
	for (int64_t i = 0; i < _limbs.size(); i++) {
		const Ref<RagdollLimb> limb = get_limb(i);
		if (limb.is_valid() && limb->get_bone() == p_bone) {
			return i;
		}
	}
	return -1;
}

Ref<RagdollLimb> RagdollProfile::find(const StringName &p_bone) const {
	const int64_t index = find_index(p_bone);
	return index < 0 ? Ref<RagdollLimb>() : get_limb(index);
}

int RagdollProfile::get_parent_index(int p_limb) const {
	ERR_FAIL_COND_V_MSG(p_limb < 0 || p_limb >= _limbs.size(), -1, "RagdollProfile: there is no limb of this number.");
	const Ref<RagdollLimb> limb = get_limb(p_limb);
	if (limb.is_null() || limb->get_parent_bone().is_empty()) {
		return -1;
	}
	return int(find_index(limb->get_parent_bone()));
}

PackedStringArray RagdollProfile::get_groups() const {
	PackedStringArray groups;
	for (int64_t i = 0; i < _limbs.size(); i++) {
		const Ref<RagdollLimb> limb = get_limb(i);
		if (limb.is_valid() && !limb->get_group().is_empty() && !groups.has(limb->get_group())) {
			groups.push_back(limb->get_group());
		}
	}
	return groups;
}

String RagdollProfile::find_fault() const {
	const int64_t count = _limbs.size();
	std::vector<ragdoll::Limb> core;
	// Of too many limbs only the number matters.
	const bool is_readable = count <= int64_t(ragdoll::MAX_LIMBS);
	for (int64_t i = 0; i < count && is_readable; i++) {
		const Ref<RagdollLimb> limb = get_limb(i);
		if (limb.is_null()) {
			const std::string fault =
					"limb " + std::to_string(i) + " is empty: make a RagdollLimb there or remove the entry";
			return String::utf8(fault.c_str());
		}
		core.push_back(limb->to_core());
	}
	core.resize(std::size_t(count));
	return String::utf8(ragdoll::find_fault(core, _mass).c_str());
}

void RagdollProfile::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_limbs", "limbs"), &RagdollProfile::set_limbs);
	ClassDB::bind_method(D_METHOD("get_limbs"), &RagdollProfile::get_limbs);
	ClassDB::bind_method(D_METHOD("set_mass", "mass"), &RagdollProfile::set_mass);
	ClassDB::bind_method(D_METHOD("get_mass"), &RagdollProfile::get_mass);
	ClassDB::bind_method(D_METHOD("find_index", "bone"), &RagdollProfile::find_index);
	ClassDB::bind_method(D_METHOD("find", "bone"), &RagdollProfile::find);
	ClassDB::bind_method(D_METHOD("get_parent_index", "limb"), &RagdollProfile::get_parent_index);
	ClassDB::bind_method(D_METHOD("get_groups"), &RagdollProfile::get_groups);
	ClassDB::bind_method(D_METHOD("find_fault"), &RagdollProfile::find_fault);
	// 24 is an object, 17 a resource type: how the engine writes the elements of an array.
	ADD_PROPERTY(PropertyInfo(Variant::ARRAY, "limbs", PROPERTY_HINT_ARRAY_TYPE, "24/17:RagdollLimb"), "set_limbs",
			"get_limbs");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "mass", PROPERTY_HINT_RANGE, "1,300,0.1,or_greater,suffix:kg"),
			"set_mass", "get_mass");
	BIND_CONSTANT(MAX_LIMBS);
}

} // namespace godot
