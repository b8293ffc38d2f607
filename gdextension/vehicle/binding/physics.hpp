// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/classes/physics_server3d.hpp>

namespace godot {

using Server = PhysicsServer3D;

constexpr float GRAVITY = 9.81f;

inline Server *server() {
	return Server::get_singleton();
}

} // namespace godot
