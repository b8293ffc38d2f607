// SPDX-License-Identifier: MIT
#pragma once

#include "wheel_forces.hpp"

#include <linux/input.h>

namespace cueing {

/// The kernel's bit of an effect (EVIOCGBIT with EV_FF).
int force_bit(ForceKind p_kind);
/// What EVIOCSFF is given, for an effect that goes on until it is stopped. Forces beyond their ranges are cut, those
/// that are no numbers are 0.
ff_effect make_effect(ForceKind p_kind, const WheelForces &p_forces, int p_id);
/// All bytes of an effect, to compare: those between its members are 0.
std::array<uint8_t, sizeof(ff_effect)> effect_bytes(const ff_effect &p_effect);
/// Whether an effect does nothing.
bool is_idle(ForceKind p_kind, const WheelForces &p_forces);

} // namespace cueing
