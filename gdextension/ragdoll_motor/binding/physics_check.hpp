// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/variant/string.hpp>

namespace godot {

/// Why the project's physics cannot drive a ragdoll well, and what to set; empty if it can.
String find_physics_problem();

} // namespace godot
