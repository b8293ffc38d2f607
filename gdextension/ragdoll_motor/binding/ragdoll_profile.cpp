// SPDX-License-Identifier: MIT
#include "ragdoll_profile.hpp"

#include <godot_cpp/core/error_macros.hpp>

#include <cmath>

namespace godot {

Ref<RagdollLimb> RagdollProfile::at(int64_t p_limb) const {
	return Ref<RagdollLimb>(limbs[p_limb]);
}

Ref<RagdollLimb> RagdollProfile::find(const StringName &p_bone) const {
	for (int64_t i = 0; i < limbs.size(); i++) {
		const Ref<RagdollLimb> limb = at(i);
		if (limb.is_valid() && limb->get_bone() == p_bone) {
			return limb;
		}
	}
	return Ref<RagdollLimb>();
}

int64_t RagdollProfile::get_parent_index(int64_t p_limb) const {
	ERR_FAIL_COND_V_MSG(p_limb < 0 || p_limb >= limbs.size(), -1, "RagdollProfile: there is no such limb.");
	const Ref<RagdollLimb> limb = at(p_limb);
	for (int64_t i = 0; limb.is_valid() && i < p_limb; i++) {
		const Ref<RagdollLimb> above = at(i);
		if (above.is_valid() && above->get_bone() == limb->get_parent_bone()) {
			return i;
		}
	}
	return -1;
}

PackedStringArray RagdollProfile::get_groups() const {
	PackedStringArray groups;
	for (int64_t i = 0; i < limbs.size(); i++) {
		const Ref<RagdollLimb> limb = at(i);
		if (limb.is_valid() && !groups.has(String(limb->get_group()))) {
			groups.append(String(limb->get_group()));
		}
	}
	return groups;
}

String RagdollProfile::find_fault_of(int64_t p_limb) const {
	const Ref<RagdollLimb> limb = at(p_limb);
	if (limb.is_null()) {
		return "limb " + String::num_int64(p_limb) + " is empty";
	}
	const String fault = limb->find_fault();
	if (!fault.is_empty()) {
		return fault;
	}
	const String name(limb->get_bone());
	for (int64_t i = 0; i < p_limb; i++) {
		if (at(i)->get_bone() == limb->get_bone()) {
			return name + " is there twice";
		}
	}
	const bool is_root = limb->get_parent_bone() == StringName();
	if (is_root != (p_limb == 0)) {
		return name + ": the first limb, and only the first, must be without a parent";
	}
	if (!is_root && get_parent_index(p_limb) < 0) {
		return name + " comes before its parent " + String(limb->get_parent_bone());
	}
	return String();
}

String RagdollProfile::find_fault() const {
	if (limbs.is_empty()) {
		return "there are no limbs";
	}
	if (limbs.size() > MOST_LIMBS) {
		return "there are " + String::num_int64(limbs.size()) + " limbs instead of at most " +
				String::num_int64(MOST_LIMBS);
	}
	if (!(mass > 0.0 && mass < 10000.0)) {
		return "the mass is " + String::num(mass) + " kg";
	}
	double total = 0.0;
	for (int64_t i = 0; i < limbs.size(); i++) {
		const String fault = find_fault_of(i);
		if (!fault.is_empty()) {
			return fault;
		}
		total += at(i)->get_mass_fraction();
	}
	if (std::abs(total - 1.0) > 0.01) {
		return "the mass fractions add up to " + String::num(total) + " instead of 1";
	}
	return String();
}

void RagdollProfile::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_limbs", "limbs"), &RagdollProfile::set_limbs);
	ClassDB::bind_method(D_METHOD("get_limbs"), &RagdollProfile::get_limbs);
	ClassDB::bind_method(D_METHOD("set_mass", "mass"), &RagdollProfile::set_mass);
	ClassDB::bind_method(D_METHOD("get_mass"), &RagdollProfile::get_mass);
	ClassDB::bind_method(D_METHOD("find", "bone"), &RagdollProfile::find);
	ClassDB::bind_method(D_METHOD("get_parent_index", "limb"), &RagdollProfile::get_parent_index);
	ClassDB::bind_method(D_METHOD("get_groups"), &RagdollProfile::get_groups);
	ClassDB::bind_method(D_METHOD("find_fault"), &RagdollProfile::find_fault);
	ADD_PROPERTY(PropertyInfo(Variant::ARRAY, "limbs", PROPERTY_HINT_TYPE_STRING,
						 String::num_int64(Variant::OBJECT) + "/" + String::num_int64(PROPERTY_HINT_RESOURCE_TYPE) +
								 ":RagdollLimb"),
			"set_limbs", "get_limbs");
	ADD_PROPERTY(
			PropertyInfo(Variant::FLOAT, "mass", PROPERTY_HINT_RANGE, "1,300,0.1,suffix:kg"), "set_mass", "get_mass");
}

} // namespace godot
