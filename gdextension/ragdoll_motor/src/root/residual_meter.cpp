// SPDX-License-Identifier: MIT
#include "root/residual_meter.hpp"

#include <algorithm>

namespace ragdoll {

void ResidualMeter::Histogram::add(float p_value) {
	bins[std::min(std::size_t(p_value / BIN), BINS - 1)]++;
}

float ResidualMeter::Histogram::find(double p_fraction, std::uint64_t p_count) const {
	std::uint64_t below = 0;
	for (std::size_t i = 0; i < BINS; i++) {
		below += bins[i];
		if (below > 0 && double(below) >= p_fraction * double(p_count)) {
			return float(i + 1) * BIN;
		}
	}
	return 0.0f;
}

void ResidualMeter::note(const Residual &p_joint) {
	_latest = { p_joint.force + _applied.force, p_joint.torque + _applied.torque };
	_forces.add(_latest.force.length());
	_torques.add(_latest.torque.length());
	_count++;
}

void ResidualMeter::clear() {
	*this = ResidualMeter();
}

} // namespace ragdoll
