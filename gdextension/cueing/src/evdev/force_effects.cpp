// SPDX-License-Identifier: MIT
#include "force_effects.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace cueing {

namespace {

constexpr double MAX_LEVEL = 32767.0;
constexpr double MAX_SHARE = 65535.0;
/// Along the wheel's only axis, with positive levels to the right.
constexpr uint16_t SIDEWAYS = 0xC000;
constexpr double LOWEST_HZ = 0.5;
constexpr double HIGHEST_HZ = 200.0;

double clean(double p_value, double p_lowest, double p_highest) {
	return std::isfinite(p_value) ? std::clamp(p_value, p_lowest, p_highest) : std::clamp(0.0, p_lowest, p_highest);
}

int16_t to_level(double p_share) {
	return int16_t(std::lround(clean(p_share, -1.0, 1.0) * MAX_LEVEL));
}

uint16_t to_share(double p_share) {
	return uint16_t(std::lround(clean(p_share, 0.0, 1.0) * MAX_SHARE));
}

void set_condition(ff_effect &r_effect, double p_coefficient, double p_centre, double p_dead_band) {
	ff_condition_effect &condition = r_effect.u.condition[0];
	condition.right_saturation = uint16_t(MAX_SHARE);
	condition.left_saturation = uint16_t(MAX_SHARE);
	condition.right_coeff = to_level(clean(p_coefficient, 0.0, 1.0));
	condition.left_coeff = condition.right_coeff;
	condition.center = to_level(p_centre);
	condition.deadband = to_share(p_dead_band);
}

} // namespace

int force_bit(ForceKind p_kind) {
	switch (p_kind) {
		case ForceKind::SPRING:
			return FF_SPRING;
		case ForceKind::DAMPER:
			return FF_DAMPER;
		case ForceKind::PERIODIC:
			return FF_PERIODIC;
		default:
			return FF_CONSTANT;
	}
}

const char *force_name(ForceKind p_kind) {
	switch (p_kind) {
		case ForceKind::SPRING:
			return "spring";
		case ForceKind::DAMPER:
			return "damper";
		case ForceKind::PERIODIC:
			return "periodic";
		default:
			return "constant";
	}
}

ff_effect make_effect(ForceKind p_kind, const WheelForces &p_forces, int p_id) {
	ff_effect effect;
	std::memset(&effect, 0, sizeof(effect));
	effect.type = uint16_t(force_bit(p_kind));
	effect.id = int16_t(p_id);
	effect.direction = SIDEWAYS;
	switch (p_kind) {
		case ForceKind::CONSTANT:
			effect.u.constant.level = to_level(p_forces.constant);
			break;
		case ForceKind::SPRING:
			set_condition(effect, p_forces.spring, p_forces.spring_centre, p_forces.spring_dead_band);
			break;
		case ForceKind::DAMPER:
			set_condition(effect, p_forces.damper, 0.0, 0.0);
			break;
		case ForceKind::PERIODIC:
			effect.u.periodic.waveform = FF_SINE;
			effect.u.periodic.period =
					uint16_t(std::lround(1000.0 / clean(p_forces.periodic_hz, LOWEST_HZ, HIGHEST_HZ)));
			effect.u.periodic.magnitude = to_level(clean(p_forces.periodic, 0.0, 1.0));
			break;
	}
	return effect;
}

std::array<uint8_t, sizeof(ff_effect)> effect_bytes(const ff_effect &p_effect) {
	std::array<uint8_t, sizeof(ff_effect)> bytes{};
	std::memcpy(bytes.data(), &p_effect, sizeof(p_effect));
	return bytes;
}

bool is_idle(ForceKind p_kind, const WheelForces &p_forces) {
	const ff_effect effect = make_effect(p_kind, p_forces, 0);
	switch (p_kind) {
		case ForceKind::CONSTANT:
			return effect.u.constant.level == 0;
		case ForceKind::PERIODIC:
			return effect.u.periodic.magnitude == 0;
		default:
			return effect.u.condition[0].right_coeff == 0;
	}
}

} // namespace cueing
