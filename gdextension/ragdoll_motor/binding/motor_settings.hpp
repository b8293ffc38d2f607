// SPDX-License-Identifier: MIT
#pragma once

#include <driver.hpp>

#include <cstdint>

namespace godot {

/// The properties of a RagdollMotor that a driver takes over. Documented in doc_classes/RagdollMotor.xml.
struct MotorSettings {
	ragdoll::RootMode root_mode = ragdoll::RootMode::SOFT;
	double gain = 50.0; ///< 1/s
	double muscle_speed = 8.0; ///< rad/s
	double root_force = 2000.0; ///< N
	double residual_share = 0.06;
	double standing_torque = 240.0; ///< N m
	double leg_push = 0.0; ///< m
	double root_torque = 800.0; ///< N m
	double inertia_scale = 6.0;
	double arm_inertia_scale = 2.5;
	double max_energy = 60.0; ///< J/kg
	int64_t ground_mask = 5; ///< World and props, not people.
	double self_overlap = 0.01; ///< m
	bool self_collision = false;
	bool anatomical_limits = false;
	bool measures_torque = false;
	bool measures_lag = false;

	/// Gives the driver those that may change at any time.
	void apply(ragdoll::Driver &r_driver) const;
};

} // namespace godot
