// SPDX-License-Identifier: MIT
#include "nodes.hpp"

#include <godot_cpp/classes/physics_direct_body_state3d.hpp>
#include <godot_cpp/classes/physics_server3d.hpp>

using namespace godot;

namespace bindings_test {

int BindingsNode::kind(Node *p_node) const {
	if (p_node == nullptr) {
		return 0;
	}
	if (Object::cast_to<BindingsNodeHeir>(p_node) != nullptr) {
		return 3;
	}
	return Object::cast_to<BindingsNode>(p_node) != nullptr ? 2 : 1;
}

void BindingsNode::spawn(int p_count) {
	for (int i = 0; i < p_count; i++) {
		if (i % 3 == 0) {
			add_child(memnew(BindingsNode));
		} else if (i % 3 == 1) {
			add_child(memnew(BindingsNodeHeir));
		} else {
			add_child(memnew(Node3D));
		}
	}
}

int64_t BindingsNode::kinds_of_children() const {
	int64_t digits = 0;
	for (int i = 0; i < get_child_count(); i++) {
		digits = digits * 10 + kind(get_child(i));
	}
	return digits;
}

void BindingsNode::_notification(int p_what) {
	if (p_what == NOTIFICATION_ENTER_TREE) {
		enter_count++;
	}
}

void BindingsNode::_bind_methods() {
	ClassDB::bind_method(D_METHOD("child_object", "index"), &BindingsNode::child_object);
	ClassDB::bind_method(D_METHOD("kind", "node"), &BindingsNode::kind);
	ClassDB::bind_method(D_METHOD("is_me", "object"), &BindingsNode::is_me);
	ClassDB::bind_method(D_METHOD("spawn", "count"), &BindingsNode::spawn);
	ClassDB::bind_method(D_METHOD("kinds_of_children"), &BindingsNode::kinds_of_children);
	ClassDB::bind_method(D_METHOD("own_callable"), &BindingsNode::own_callable);
	ClassDB::bind_method(D_METHOD("get_enter_count"), &BindingsNode::get_enter_count);
	ClassDB::bind_method(D_METHOD("get_ready_count"), &BindingsNode::get_ready_count);
}

void BindingsNodeHeir::_process(double p_delta) {
	frame_count += p_delta >= 0.0 ? 1 : 0;
}

void BindingsNodeHeir::_bind_methods() {
	ClassDB::bind_method(D_METHOD("get_frame_count"), &BindingsNodeHeir::get_frame_count);
}

void BindingsDriver::_physics_process(double p_delta) {
	tick_count += p_delta > 0.0 ? 1 : 0;
	PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	for (int64_t i = 0; i < bodies.size(); i++) {
		PhysicsDirectBodyState3D *state = server->body_get_direct_state(bodies[i]);
		ERR_CONTINUE(state == nullptr);
		if (i == 0) {
			height = state->get_transform().origin.y;
		}
		state->apply_torque(Vector3(0.0f, 0.1f, 0.0f));
	}
}

RID BindingsDriver::add_joint(const RID &p_body_a, const RID &p_body_b) const {
	PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	const RID joint = server->joint_create();
	server->joint_make_generic_6dof(joint, p_body_a, Transform3D(), p_body_b, Transform3D(Basis(), Vector3(0, 2, 0)));
	server->generic_6dof_joint_set_param(
			joint, Vector3::AXIS_Y, PhysicsServer3D::G6DOF_JOINT_ANGULAR_MOTOR_TARGET_VELOCITY, 1.5);
	return joint;
}

void BindingsDriver::_bind_methods() {
	ClassDB::bind_method(D_METHOD("add_body", "body"), &BindingsDriver::add_body);
	ClassDB::bind_method(D_METHOD("add_joint", "body_a", "body_b"), &BindingsDriver::add_joint);
	ClassDB::bind_method(D_METHOD("get_tick_count"), &BindingsDriver::get_tick_count);
	ClassDB::bind_method(D_METHOD("get_height"), &BindingsDriver::get_height);
}

} // namespace bindings_test
