// SPDX-License-Identifier: MIT
#include "ragdoll_motor.hpp"

#include <godot_cpp/classes/physics_direct_body_state3d.hpp>
#include <godot_cpp/classes/physics_server3d.hpp>

namespace godot {

namespace {

ragdoll::Vec3 to_core(const Vector3 &p_vector) {
	return { p_vector.x, p_vector.y, p_vector.z };
}

Vector3 from_core(const ragdoll::Vec3 &p_vector) {
	return Vector3(p_vector.x, p_vector.y, p_vector.z);
}

ragdoll::Quat to_core(const Quaternion &p_rotation) {
	return { p_rotation.x, p_rotation.y, p_rotation.z, p_rotation.w };
}

Quaternion from_core(const ragdoll::Quat &p_rotation) {
	return Quaternion(p_rotation.x, p_rotation.y, p_rotation.z, p_rotation.w);
}

} // namespace

bool RagdollMotor::setup(const TypedArray<RID> &p_bodies, const TypedArray<RID> &p_joints,
		const PackedInt32Array &p_parents, const PackedVector3Array &p_anchors,
		const PackedVector3Array &p_body_offsets) {
	const int64_t count = p_bodies.size();
	ERR_FAIL_COND_V_MSG(count == 0, false, "RagdollMotor: there are no bodies to drive.");
	ERR_FAIL_COND_V_MSG(p_joints.size() != count || p_parents.size() != count || p_anchors.size() != count ||
					p_body_offsets.size() != count,
			false, "RagdollMotor: bodies, joints, parents, anchors and offsets must be equally many.");
	std::vector<Limb> new_limbs;
	std::vector<int> parents;
	std::vector<ragdoll::Vec3> new_anchors;
	for (int64_t i = 0; i < count; i++) {
		const int parent = p_parents[i];
		ERR_FAIL_COND_V_MSG(parent >= i || parent < -1 || (parent == -1) != (i == 0), false,
				"RagdollMotor: the first limb must be the root (-1), and parents must come before their children.");
		new_limbs.push_back({ p_bodies[i], p_joints[i], to_core(p_body_offsets[i]) });
		parents.push_back(parent);
		new_anchors.push_back(to_core(p_anchors[i]));
	}
	limbs = std::move(new_limbs);
	anchors = std::move(new_anchors);
	stream = std::make_unique<ragdoll::PoseStream>(limbs.size());
	motor = std::make_unique<ragdoll::VelocityMotor>(std::move(parents));
	actual.assign(limbs.size(), ragdoll::Quat());
	meter.clear();
	return true;
}

bool RagdollMotor::push_sample(double p_time_s, const PackedFloat32Array &p_orientations, const Vector3 &p_root) {
	if (!stream || p_orientations.size() != int64_t(limbs.size()) * 4) {
		return false;
	}
	if (!stream->push(p_time_s, p_orientations.ptr(), to_core(p_root))) {
		return false;
	}
	meter.settle(*stream);
	return true;
}

void RagdollMotor::clear_motion() {
	if (stream) {
		stream->clear();
	}
}

bool RagdollMotor::read_bodies() {
	PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	for (std::size_t i = 0; i < limbs.size(); i++) {
		const PhysicsDirectBodyState3D *state = server->body_get_direct_state(limbs[i].body);
		ERR_FAIL_NULL_V_MSG(state, false, "RagdollMotor: a body is not in a physics space (any more).");
		const Transform3D transform = state->get_transform();
		actual[i] = to_core(transform.basis.get_rotation_quaternion());
		if (i == 0) {
			actual_root = to_core(transform.origin) - actual[0].rotate(limbs[0].offset);
		}
	}
	return true;
}

Transform3D RagdollMotor::body_transform(std::size_t p_limb, const ragdoll::Pose &p_pose) const {
	const ragdoll::Quat &orientation = p_pose.orientations[p_limb];
	const ragdoll::Vec3 origin = joints[p_limb] + orientation.rotate(limbs[p_limb].offset);
	return Transform3D(Basis(from_core(orientation)), from_core(origin));
}

bool RagdollMotor::snap_to(double p_time_s) {
	if (!is_ready()) {
		return false;
	}
	stream->predict(p_time_s, now);
	motor->joint_positions(now, anchors, joints);
	PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	if (root_mode == ROOT_HELD) {
		// A kinematic body would travel there within a step and fling the others about.
		server->body_set_mode(limbs[0].body, PhysicsServer3D::BODY_MODE_RIGID);
	}
	for (std::size_t i = 0; i < limbs.size(); i++) {
		server->body_set_state(limbs[i].body, PhysicsServer3D::BODY_STATE_TRANSFORM, body_transform(i, now));
		server->body_set_state(limbs[i].body, PhysicsServer3D::BODY_STATE_LINEAR_VELOCITY, Vector3());
		server->body_set_state(limbs[i].body, PhysicsServer3D::BODY_STATE_ANGULAR_VELOCITY, Vector3());
	}
	if (root_mode == ROOT_HELD) {
		server->body_set_mode(limbs[0].body, PhysicsServer3D::BODY_MODE_KINEMATIC);
	}
	return true;
}

bool RagdollMotor::drive(double p_time_s, double p_delta_s) {
	ERR_FAIL_COND_V_MSG(!(p_delta_s > 0.0), false, "RagdollMotor: the time step must be above zero.");
	if (!is_ready() || !read_bodies()) {
		return false;
	}
	stream->predict(p_time_s, now);
	stream->predict(p_time_s + p_delta_s, next);
	motor->compute(actual, now, next, float(p_delta_s), float(gain), velocities);
	PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	for (std::size_t i = 1; i < limbs.size(); i++) {
		const float axes[3] = { velocities[i].x, velocities[i].y, velocities[i].z };
		for (int axis = 0; axis < 3; axis++) {
			// The engine's sign is the other way round for angular motors (not for linear ones).
			server->generic_6dof_joint_set_param(limbs[i].joint, Vector3::Axis(axis),
					PhysicsServer3D::G6DOF_JOINT_ANGULAR_MOTOR_TARGET_VELOCITY, -axes[axis]);
		}
	}
	drive_root(p_delta_s);
	return true;
}

void RagdollMotor::drive_root(double p_delta_s) {
	PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	if (root_mode == ROOT_HELD) {
		joints.resize(1);
		joints[0] = next.root;
		server->body_set_state(limbs[0].body, PhysicsServer3D::BODY_STATE_TRANSFORM, body_transform(0, next));
		return;
	}
	const ragdoll::Vec3 linear =
			ragdoll::root_velocity(actual_root, now.root, next.root, float(p_delta_s), float(gain));
	const float linear_axes[3] = { linear.x, linear.y, linear.z };
	const float angular_axes[3] = { velocities[0].x, velocities[0].y, velocities[0].z };
	for (int axis = 0; axis < 3; axis++) {
		server->generic_6dof_joint_set_param(limbs[0].joint, Vector3::Axis(axis),
				PhysicsServer3D::G6DOF_JOINT_LINEAR_MOTOR_TARGET_VELOCITY, linear_axes[axis]);
		server->generic_6dof_joint_set_param(limbs[0].joint, Vector3::Axis(axis),
				PhysicsServer3D::G6DOF_JOINT_ANGULAR_MOTOR_TARGET_VELOCITY, -angular_axes[axis]);
	}
}

void RagdollMotor::measure(double p_time_s) {
	if (is_ready() && !stream->is_stalled(p_time_s) && read_bodies()) {
		meter.note(p_time_s, actual);
	}
}

bool RagdollMotor::is_stalled(double p_time_s) const {
	return !stream || stream->is_stalled(p_time_s);
}

Dictionary RagdollMotor::get_tracking() const {
	constexpr double DEGREES = 180.0 / 3.14159265358979323846;
	Dictionary tracking;
	tracking["count"] = int64_t(meter.get_count());
	tracking["mean_deg"] = meter.mean() * DEGREES;
	tracking["p95_deg"] = meter.percentile(0.95) * DEGREES;
	tracking["latest_deg"] = meter.latest() * DEGREES;
	return tracking;
}

void RagdollMotor::clear_tracking() {
	meter.clear();
}

void RagdollMotor::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_gain", "gain"), &RagdollMotor::set_gain);
	ClassDB::bind_method(D_METHOD("get_gain"), &RagdollMotor::get_gain);
	ClassDB::bind_method(D_METHOD("set_root_mode", "mode"), &RagdollMotor::set_root_mode);
	ClassDB::bind_method(D_METHOD("get_root_mode"), &RagdollMotor::get_root_mode);
	ClassDB::bind_method(
			D_METHOD("setup", "bodies", "joints", "parents", "anchors", "body_offsets"), &RagdollMotor::setup);
	ClassDB::bind_method(D_METHOD("push_sample", "time_s", "orientations", "root"), &RagdollMotor::push_sample);
	ClassDB::bind_method(D_METHOD("clear_motion"), &RagdollMotor::clear_motion);
	ClassDB::bind_method(D_METHOD("snap_to", "time_s"), &RagdollMotor::snap_to);
	ClassDB::bind_method(D_METHOD("drive", "time_s", "delta_s"), &RagdollMotor::drive);
	ClassDB::bind_method(D_METHOD("measure", "time_s"), &RagdollMotor::measure);
	ClassDB::bind_method(D_METHOD("is_stalled", "time_s"), &RagdollMotor::is_stalled);
	ClassDB::bind_method(D_METHOD("get_tracking"), &RagdollMotor::get_tracking);
	ClassDB::bind_method(D_METHOD("clear_tracking"), &RagdollMotor::clear_tracking);
	ADD_PROPERTY(
			PropertyInfo(Variant::FLOAT, "gain", PROPERTY_HINT_RANGE, "0,240,0.1,suffix:1/s"), "set_gain", "get_gain");
	ADD_PROPERTY(
			PropertyInfo(Variant::INT, "root_mode", PROPERTY_HINT_ENUM, "Held,Soft"), "set_root_mode", "get_root_mode");
	BIND_ENUM_CONSTANT(ROOT_HELD);
	BIND_ENUM_CONSTANT(ROOT_SOFT);
}

} // namespace godot
