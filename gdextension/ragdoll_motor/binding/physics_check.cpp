// SPDX-License-Identifier: MIT
#include "physics_check.hpp"

#include <godot_cpp/classes/project_settings.hpp>
#include <godot_cpp/variant/variant.hpp>

namespace godot {

namespace {

constexpr const char *ENGINE = "physics/3d/physics_engine";
constexpr const char *STEPS = "physics/jolt_physics_3d/simulation/velocity_steps";
/// With the engine's default of 10 limbs are off by degrees (docs/ragdoll.md).
constexpr int64_t MIN_STEPS = 40;

} // namespace

String find_physics_problem() {
	ProjectSettings *settings = ProjectSettings::get_singleton();
	const String engine = settings->get_setting(ENGINE, Variant(String()));
	if (engine != String("Jolt Physics")) {
		return String("RagdollMotor: the physics engine is \"") + engine +
				"\", with which limbs do not follow (measured: 85 degrees off). Set " + ENGINE +
				" to \"Jolt Physics\".";
	}
	const int64_t steps = settings->get_setting(STEPS, Variant(int64_t(0)));
	if (steps < MIN_STEPS) {
		return String("RagdollMotor: with ") + String::num_int64(steps) +
				" velocity steps limbs follow badly (measured: 2.1 degrees off instead of 0.07). Set " + STEPS +
				" to " + String::num_int64(MIN_STEPS) + " or more.";
	}
	return String();
}

} // namespace godot
