// SPDX-License-Identifier: MIT
#include "body_probe.hpp"

#include <godot_cpp/classes/physics_direct_body_state3d.hpp>
#include <godot_cpp/classes/physics_server3d.hpp>

#include <algorithm>
#include <chrono>

using namespace godot;

namespace probe {

void BodyProbe::_physics_process(double) {
	_ticks++;
	PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	for (const RID &body : _bodies) {
		PhysicsDirectBodyState3D *state = server->body_get_direct_state(body);
		ERR_CONTINUE(state == nullptr);
		_height = state->get_transform().origin.y;
		state->apply_torque(Vector3(0, 0.1f, 0));
	}
}

void BodyProbe::set_bodies(const TypedArray<RID> &p_bodies) {
	_bodies.clear();
	for (int64_t i = 0; i < p_bodies.size(); i++) {
		_bodies.push_back(p_bodies[i]);
	}
}

RID BodyProbe::join(const RID &p_body_a, const RID &p_body_b) const {
	PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	const RID joint = server->joint_create();
	server->joint_make_generic_6dof(joint, p_body_a, Transform3D(), p_body_b, Transform3D(Basis(), Vector3(0, -2, 0)));
	for (int axis = 0; axis < 3; axis++) {
		server->generic_6dof_joint_set_flag(
				joint, Vector3::Axis(axis), PhysicsServer3D::G6DOF_JOINT_FLAG_ENABLE_MOTOR, true);
		server->generic_6dof_joint_set_param(
				joint, Vector3::Axis(axis), PhysicsServer3D::G6DOF_JOINT_ANGULAR_MOTOR_FORCE_LIMIT, 50);
	}
	return joint;
}

double BodyProbe::time_state_ns(int p_rounds) const {
	ERR_FAIL_COND_V_MSG(_bodies.empty() || p_rounds <= 0, 0.0, "There is nothing to measure.");
	PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	double best = 1e30;
	double sum = 0.0; // Used, so that nothing is optimised away.
	for (int run = 0; run < 20; run++) {
		const auto start = std::chrono::steady_clock::now();
		for (int i = 0; i < p_rounds; i++) {
			PhysicsDirectBodyState3D *state = server->body_get_direct_state(_bodies[0]);
			sum += state->get_transform().origin.y + state->get_angular_velocity().y;
		}
		const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - start;
		best = std::min(best, taken.count() / p_rounds);
	}
	return sum == sum ? best : 0.0;
}

void BodyProbe::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_bodies", "bodies"), &BodyProbe::set_bodies);
	ClassDB::bind_method(D_METHOD("get_ticks"), &BodyProbe::get_ticks);
	ClassDB::bind_method(D_METHOD("get_height"), &BodyProbe::get_height);
	ClassDB::bind_method(D_METHOD("join", "body_a", "body_b"), &BodyProbe::join);
	ClassDB::bind_method(D_METHOD("time_state_ns", "rounds"), &BodyProbe::time_state_ns);
}

} // namespace probe
