// SPDX-License-Identifier: MIT
#include "seat_motion.hpp"

#include "triple.hpp"

#include <convert.hpp>

namespace godot {

bool SeatMotion::push_state(double p_time, const Transform3D &p_transform) {
	cueing::SeatState state;
	state.time = p_time;
	state.position = to_triple(p_transform.origin);
	state.orientation = to_core(p_transform.basis.orthonormalized());
	return _core.add(state);
}

bool SeatMotion::estimate(double p_time) {
	return _core.estimate(p_time, _motion);
}

Vector3 SeatMotion::get_specific_force() const {
	return from_triple(_motion.felt.specific_force);
}

Vector3 SeatMotion::get_rates() const {
	return from_triple(_motion.felt.rates);
}

Vector3 SeatMotion::get_velocity() const {
	return from_triple(_motion.velocity);
}

void SeatMotion::_bind_methods() {
	ClassDB::bind_method(D_METHOD("push_state", "time", "transform"), &SeatMotion::push_state);
	ClassDB::bind_method(D_METHOD("estimate", "time"), &SeatMotion::estimate);
	ClassDB::bind_method(D_METHOD("clear"), &SeatMotion::clear);
	ClassDB::bind_method(D_METHOD("get_specific_force"), &SeatMotion::get_specific_force);
	ClassDB::bind_method(D_METHOD("get_rates"), &SeatMotion::get_rates);
	ClassDB::bind_method(D_METHOD("get_velocity"), &SeatMotion::get_velocity);
}

} // namespace godot
