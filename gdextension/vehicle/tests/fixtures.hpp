// SPDX-License-Identifier: MIT
#pragma once

#include <drivetrain.hpp>

constexpr float STEP = 1.0f / 60.0f;

/// A tank of 55 t with four gears, as its preset has it.
inline vehicle::Drivetrain make_tank() {
	vehicle::Drivetrain tank;
	tank.settings = { 55e3f, 0.6f, 300e3f, 400e3f, true };
	tank.engine.settings.curve = { { 600, 2600 }, { 1600, 4700 }, { 2600, 4050 }, { 2860, 0 } };
	tank.gearbox.settings.forward = { 33.3f, 19.0f, 11.7f, 8.1f };
	tank.gearbox.settings.reverse = { 33.3f, 18.8f };
	tank.gearbox.settings.efficiency = 0.72f;
	tank.reset();
	return tank;
}

/// The tank on ideal ground: a mass on rails, with tracks that do not slip.
struct OnRails {
	vehicle::Drivetrain tank = make_tank();
	float speed = 0.0f;
	float slope_force = 0.0f; ///< Against the forward way, N.

	void run(const vehicle::DriverInput &p_input, float p_seconds) {
		for (int i = 0; i < int(p_seconds / STEP); i++) {
			const vehicle::SideForces &forces = tank.step(p_input, { speed, speed, speed, 0.0f, slope_force }, STEP);
			const float brake = forces.left_brake + forces.right_brake + forces.left_parking + forces.right_parking;
			const float drive = forces.left + forces.right - slope_force;
			const float free = speed + drive * STEP / tank.settings.mass;
			const float most = brake * STEP / tank.settings.mass;
			speed = free > most ? free - most : (free < -most ? free + most : 0.0f);
		}
	}
};
