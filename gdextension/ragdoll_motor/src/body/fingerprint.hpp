// SPDX-License-Identifier: MIT
#pragma once

#include "body/contact_point.hpp"
#include "body/rig.hpp"

#include <cstdint>
#include <vector>

namespace ragdoll {

/// A number that differs between bodies of other limbs or contact points: it says whose state an archive holds.
std::uint64_t find_fingerprint(const Rig &p_rig, const std::vector<ContactPoint> &p_contacts);

} // namespace ragdoll
