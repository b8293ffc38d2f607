// SPDX-License-Identifier: MIT
#include "body/fingerprint.hpp"

#include "base/archive.hpp"

namespace ragdoll {

std::uint64_t find_fingerprint(const Rig &p_rig, const std::vector<ContactPoint> &p_contacts) {
	StateHash hash;
	for (std::size_t i = 0; i < p_rig.size(); i++) {
		hash.add(p_rig[i].parent);
		hash.add(p_rig[i].group);
		hash.add(p_rig[i].anchor);
		hash.add(p_rig[i].centre);
		hash.add(p_rig[i].rest);
		hash.add(p_rig[i].mass);
		hash.add(p_rig[i].shape.type);
		hash.add(p_rig[i].shape.turn);
		hash.add(p_rig[i].shape.half);
	}
	for (const ContactPoint &contact : p_contacts) {
		hash.add(contact.limb);
		hash.add(contact.local);
		hash.add(contact.radius);
		hash.add(contact.sole);
	}
	return hash.get();
}

} // namespace ragdoll
