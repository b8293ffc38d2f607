// SPDX-License-Identifier: MIT
#pragma once

#include "driven_ragdoll.hpp"

#include <godot_cpp/variant/packed_byte_array.hpp>

#include <cstdint>

namespace godot {

/// Everything that decides how a ragdoll goes on, as bytes; empty where its bodies are not there.
PackedByteArray save_ragdoll(DrivenRagdoll &r_ragdoll);

/// Brings a ragdoll back to what was saved; false (and an error) where it was saved of another one.
bool restore_ragdoll(const PackedByteArray &p_bytes, DrivenRagdoll &r_ragdoll);

/// A fingerprint of the bodies' state.
std::uint64_t hash_ragdoll(DrivenRagdoll &r_ragdoll);

} // namespace godot
