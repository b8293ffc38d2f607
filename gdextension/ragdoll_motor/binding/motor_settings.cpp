// SPDX-License-Identifier: MIT
#include "motor_settings.hpp"

#include <algorithm>

namespace godot {

namespace {

constexpr double PENETRATION_SLOP = 0.002; // That of the project settings, m.

} // namespace

void MotorSettings::apply(ragdoll::Driver &r_driver) const {
	r_driver.root_mode = root_mode;
	r_driver.root_settings.force = float(root_force);
	r_driver.root_settings.torque = float(root_torque);
	ragdoll::BalanceSettings &balance = r_driver.get_balance().settings;
	balance.residual = float(residual_share);
	balance.leg_push = float(leg_push);
	balance.torque = float(root_torque);
	balance.standing_torque = std::min(float(standing_torque), float(root_torque));
	r_driver.get_controller().settings.gain = float(gain);
	r_driver.get_controller().settings.muscle_speed = float(muscle_speed);
	// Limbs that collide are pushed out by the engine from its slop on.
	const bool collides = self_collision && self_overlap < ragdoll::SelfClearance::NO_LIMIT;
	r_driver.get_clearance().overlap = float(collides ? std::min(self_overlap, PENETRATION_SLOP) : self_overlap);
	r_driver.get_guard().max_energy = float(max_energy);
	r_driver.measures_torque = measures_torque;
	r_driver.get_meter().measures_lag = measures_lag;
}

} // namespace godot
