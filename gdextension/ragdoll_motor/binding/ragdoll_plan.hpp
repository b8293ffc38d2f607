// SPDX-License-Identifier: MIT
#pragma once

#include "ragdoll_bodies.hpp"
#include "ragdoll_profile.hpp"

#include <body/contact_point.hpp>

#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>
#include <godot_cpp/variant/string_name.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <cstdint>
#include <vector>

namespace godot {

/// What a profile and its bodies come to, as the core needs them: a ragdoll that can be built. Limbs have the
/// profile's order in every list.
class RagdollPlan {
public:
	/// Why there is no plan for these: a fault of the profile, of the bodies or of the space; empty where there is
	/// none.
	static String find_fault(const Ref<RagdollProfile> &p_profile, const TypedArray<RID> &p_bodies,
			const PackedVector3Array &p_centres, const RID &p_space);

	/// @param p_centres the bodies' centres of mass in the limbs' frames, m; empty: as the profile has them
	/// @param p_has_limits whether the joints get the profile's anatomical limits
	RagdollPlan(const Ref<RagdollProfile> &p_profile, const TypedArray<RID> &p_bodies,
			const PackedVector3Array &p_centres, bool p_has_limits);

	const std::vector<ragdoll::Segment> &get_segments() const { return _segments; }
	const std::vector<ragdoll::ContactPoint> &get_contacts() const { return _contacts; }
	const std::vector<RagdollBodies::JointSpec> &get_specs() const { return _specs; }
	const std::vector<RID> &get_bodies() const { return _bodies; }
	const std::vector<StringName> &get_bones() const { return _bones; }
	/// Orientations in the reset pose, model space.
	const std::vector<ragdoll::Quat> &get_reset_pose() const { return _reset_pose; }
	std::vector<int> get_limb_groups() const;
	std::size_t get_group_count() const { return _groups.size(); }
	/// The limb that SELF_RIGHTING keeps upright besides the root; -1 for none.
	int get_righted_limb() const { return _righted_limb; }

	/// The index of a strength group; -1 for the empty name, which means all. Returns false where there is none.
	bool find_group(const StringName &p_group, int &r_group) const;
	/// Marks the limbs that names of bones and groups mean; reports an error where one means none.
	bool find_limbs(const PackedStringArray &p_names, std::vector<std::uint8_t> &r_limbs) const;

private:
	void add_limb(const Ref<RagdollProfile> &p_profile, int p_index, const PackedVector3Array &p_centres);
	void add_spec(const Ref<RagdollLimb> &p_limb, const RID &p_body, bool p_has_limits);
	void add_contacts(const Ref<RagdollLimb> &p_limb, int p_index);

	std::vector<ragdoll::Segment> _segments;
	std::vector<ragdoll::ContactPoint> _contacts;
	std::vector<RagdollBodies::JointSpec> _specs;
	std::vector<RID> _bodies;
	std::vector<StringName> _groups;
	std::vector<StringName> _bones;
	std::vector<ragdoll::Quat> _reset_pose;
	int _righted_limb = -1;
};

} // namespace godot
