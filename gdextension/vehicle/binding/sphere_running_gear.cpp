// SPDX-License-Identifier: MIT
#include "sphere_running_gear.hpp"

#include "physics.hpp"

#include <algorithm>
#include <cmath>

namespace godot {

namespace {

constexpr int CONTACTS = 4;
/// Motors are written to when what they are to do has changed by such a share: each time wakes the bodies up.
constexpr float CHANGE = 0.03f;
/// A sphere that is so far from its slider (m) has been left behind.
constexpr float TORN = 0.8f;
/// The spin about the vertical that friction under a real track would stop, as a share of that across.
constexpr float SPIN_SHARE = 0.2f;
/// The springs' stops give way by so much before the load counts as endless, as a multiple of the static one.
constexpr float ENDLESS_LOAD = 12.0f;

bool has_changed(float p_old, float p_new, float p_scale) {
	return std::abs(p_old - p_new) > CHANGE * std::max(std::abs(p_old), p_scale);
}

/// How steep what a sphere touches is against the hull, 0 to 1.
float steepness(const PhysicsDirectBodyState3D *p_state, const Vector3 &p_up) {
	float found = 0.0f;
	for (int i = 0; i < int(p_state->get_contact_count()); i++) {
		found = std::max(found, 1.0f - std::max(0.0f, p_state->get_contact_local_normal(i).dot(p_up)));
	}
	return found;
}

} // namespace

SphereRunningGear::~SphereRunningGear() {
	release();
}

bool SphereRunningGear::make() {
	_spheres.assign(_wheels.size(), Sphere());
	_motors.assign(_wheels.size(), vehicle::SphereMotor());
	for (std::size_t i = 0; i < _wheels.size(); i++) {
		make_sphere(_wheels[i], _spheres[i]);
		for (std::size_t j = 0; j < i; j++) {
			server()->body_add_collision_exception(_spheres[i].body, _spheres[j].body);
			server()->body_add_collision_exception(_spheres[j].body, _spheres[i].body);
		}
	}
	return true;
}

void SphereRunningGear::make_sphere(const Wheel &p_wheel, Sphere &r_sphere) {
	const RID shape = server()->sphere_shape_create();
	server()->shape_set_data(shape, p_wheel.radius);
	_shapes.push_back(shape);
	const RID body = server()->body_create();
	server()->body_set_mode(body, Server::BODY_MODE_RIGID);
	server()->body_add_shape(body, shape);
	server()->body_set_param(body, Server::BODY_PARAM_MASS, p_wheel.mass);
	server()->body_set_param(body, Server::BODY_PARAM_FRICTION, p_wheel.grip);
	server()->body_set_param(body, Server::BODY_PARAM_BOUNCE, 0.0);
	server()->body_set_collision_layer(body, uint32_t(_collision_layer));
	server()->body_set_collision_mask(body, uint32_t(_collision_mask));
	server()->body_set_max_contacts_reported(body, CONTACTS);
	// Rays and contacts that meet it find the vehicle.
	server()->body_attach_object_instance_id(body, _hull->get_instance_id());
	server()->body_set_state(body, Server::BODY_STATE_TRANSFORM, _frame * Transform3D(Basis(), p_wheel.position));
	server()->body_add_collision_exception(body, _body);
	server()->body_add_collision_exception(_body, body);
	server()->body_set_space(body, _space);
	r_sphere.body = body;
	// The slider: free up and down on its spring, and free to turn.
	r_sphere.slider = server()->joint_create();
	server()->joint_make_generic_6dof(
			r_sphere.slider, _body, Transform3D(Basis(), p_wheel.position), body, Transform3D());
	for (const Vector3::Axis axis : { Vector3::AXIS_X, Vector3::AXIS_Y, Vector3::AXIS_Z }) {
		const double lower = axis == Vector3::AXIS_Y ? -p_wheel.travel_down : 0.0;
		const double upper = axis == Vector3::AXIS_Y ? p_wheel.travel_up : 0.0;
		server()->generic_6dof_joint_set_flag(
				r_sphere.slider, axis, Server::G6DOF_JOINT_FLAG_ENABLE_LINEAR_LIMIT, true);
		server()->generic_6dof_joint_set_param(r_sphere.slider, axis, Server::G6DOF_JOINT_LINEAR_LOWER_LIMIT, lower);
		server()->generic_6dof_joint_set_param(r_sphere.slider, axis, Server::G6DOF_JOINT_LINEAR_UPPER_LIMIT, upper);
	}
	const Vector3::Axis up = Vector3::AXIS_Y;
	server()->generic_6dof_joint_set_flag(r_sphere.slider, up, Server::G6DOF_JOINT_FLAG_ENABLE_LINEAR_SPRING, true);
	server()->generic_6dof_joint_set_param(
			r_sphere.slider, up, Server::G6DOF_JOINT_LINEAR_SPRING_STIFFNESS, p_wheel.stiffness);
	server()->generic_6dof_joint_set_param(
			r_sphere.slider, up, Server::G6DOF_JOINT_LINEAR_SPRING_DAMPING, p_wheel.damping);
	server()->generic_6dof_joint_set_param(
			r_sphere.slider, up, Server::G6DOF_JOINT_LINEAR_SPRING_EQUILIBRIUM_POINT, -p_wheel.sag);
	// The motors turn about the axes of body B: that must be the hull.
	r_sphere.motor = server()->joint_create();
	server()->joint_make_generic_6dof(
			r_sphere.motor, body, Transform3D(), _body, Transform3D(Basis(), p_wheel.position));
	for (const Vector3::Axis axis : { Vector3::AXIS_X, Vector3::AXIS_Y, Vector3::AXIS_Z }) {
		server()->generic_6dof_joint_set_flag(r_sphere.motor, axis, Server::G6DOF_JOINT_FLAG_ENABLE_MOTOR, true);
		server()->generic_6dof_joint_set_param(
				r_sphere.motor, axis, Server::G6DOF_JOINT_ANGULAR_MOTOR_TARGET_VELOCITY, 0.0);
		server()->generic_6dof_joint_set_param(
				r_sphere.motor, axis, Server::G6DOF_JOINT_ANGULAR_MOTOR_FORCE_LIMIT, 0.0);
	}
}

void SphereRunningGear::unmake() {
	for (const Sphere &sphere : _spheres) {
		server()->free_rid(sphere.slider);
		server()->free_rid(sphere.motor);
		server()->free_rid(sphere.body);
	}
	for (const RID &shape : _shapes) {
		server()->free_rid(shape);
	}
	_spheres.clear();
	_shapes.clear();
}

bool SphereRunningGear::is_torn(const Wheel &p_wheel, const Vector3 &p_offset) const {
	return (p_offset - p_wheel.position).length_squared() > TORN * TORN;
}

void SphereRunningGear::read(float /*p_delta*/) {
	const Transform3D inverse = _frame.affine_inverse();
	const Vector3 right = _frame.basis.get_column(0);
	const Vector3 up = _frame.basis.get_column(1);
	bool torn = false;
	for (std::size_t i = 0; i < _wheels.size(); i++) {
		Wheel &wheel = _wheels[i];
		const PhysicsDirectBodyState3D *state = server()->body_get_direct_state(_spheres[i].body);
		if (state == nullptr) {
			continue;
		}
		const Vector3 origin = state->get_transform().origin;
		const Vector3 offset = inverse.xform(origin);
		torn = torn || is_torn(wheel, offset);
		wheel.height = offset.y - wheel.position.y;
		const float rate = (state->get_linear_velocity() - velocity_at(origin)).dot(up);
		const float load = wheel.stiffness * (wheel.height + wheel.sag) + wheel.damping * rate;
		wheel.load = std::clamp(load, 0.0f, ENDLESS_LOAD * wheel.stiffness * std::max(wheel.sag, 0.05f));
		wheel.speed = -(state->get_angular_velocity() - _turning).dot(right) * wheel.radius;
		_motors[i].load = wheel.load;
		_motors[i].speed = wheel.speed;
		_motors[i].wall = steepness(state, up);
	}
	if (torn) {
		put();
	}
	_motion.left = vehicle::track_speed(_motors, first_of(0), count_of(0));
	_motion.right = vehicle::track_speed(_motors, first_of(1), count_of(1));
}

void SphereRunningGear::drive(float p_delta) {
	const vehicle::SideForces &forces = _drivetrain->get_forces();
	for (int side = 0; side < 2; side++) {
		const std::size_t first = first_of(side);
		const std::size_t count = count_of(side);
		float loads = 0.0f;
		float mass = 0.0f;
		for (std::size_t i = first; i < first + count; i++) {
			loads += _motors[i].load;
			mass = std::max(mass, 0.4f * _wheels[i].mass); // A sphere's inertia is 2/5 m r^2.
		}
		const float drive = side == 0 ? forces.left : forces.right;
		float brake = side == 0 ? forces.left_brake : forces.right_brake;
		brake += (side == 0 ? forces.left_parking : forces.right_parking) + _rolling_resistance * loads;
		vehicle::share_track(_motors, first, count, drive, brake, mass, p_delta);
		for (std::size_t i = first; i < first + count; i++) {
			const Wheel &wheel = _wheels[i];
			write(wheel, _spheres[i], _motors[i].target, _motors[i].force, wheel.side_grip * wheel.load);
		}
	}
}

void SphereRunningGear::write(const Wheel &p_wheel, Sphere &r_sphere, float p_target, float p_force, float p_across) {
	const float scale = 0.2f * p_wheel.stiffness * std::max(p_wheel.sag, 0.05f);
	if (has_changed(r_sphere.target, p_target, 0.01f)) {
		r_sphere.target = p_target;
		server()->generic_6dof_joint_set_param(r_sphere.motor, Vector3::AXIS_X,
				Server::G6DOF_JOINT_ANGULAR_MOTOR_TARGET_VELOCITY, -p_target / p_wheel.radius);
	}
	if (has_changed(r_sphere.force, p_force, scale)) {
		r_sphere.force = p_force;
		server()->generic_6dof_joint_set_param(r_sphere.motor, Vector3::AXIS_X,
				Server::G6DOF_JOINT_ANGULAR_MOTOR_FORCE_LIMIT, p_force * p_wheel.radius);
	}
	// The hull's sideways way is braked by as much as the ground would: the sphere itself rolls there.
	if (has_changed(r_sphere.across, p_across, scale)) {
		r_sphere.across = p_across;
		server()->generic_6dof_joint_set_param(r_sphere.motor, Vector3::AXIS_Z,
				Server::G6DOF_JOINT_ANGULAR_MOTOR_FORCE_LIMIT, p_across * p_wheel.radius);
		server()->generic_6dof_joint_set_param(r_sphere.motor, Vector3::AXIS_Y,
				Server::G6DOF_JOINT_ANGULAR_MOTOR_FORCE_LIMIT, SPIN_SHARE * p_across * p_wheel.radius);
	}
}

void SphereRunningGear::put() {
	for (std::size_t i = 0; i < _wheels.size(); i++) {
		const RID &body = _spheres[i].body;
		const Vector3 at = _frame.xform(_wheels[i].position);
		server()->body_set_state(body, Server::BODY_STATE_TRANSFORM, Transform3D(_frame.basis, at));
		server()->body_set_state(body, Server::BODY_STATE_LINEAR_VELOCITY, velocity_at(at));
		server()->body_set_state(body, Server::BODY_STATE_ANGULAR_VELOCITY, _turning);
	}
}

RunningGear::Ground SphereRunningGear::ground_of(std::size_t p_wheel) {
	Ground ground;
	PhysicsDirectBodyState3D *state = server()->body_get_direct_state(_spheres[p_wheel].body);
	if (state == nullptr) {
		return ground;
	}
	// Of several contacts the one that points up most carries.
	float best = -2.0f;
	for (int i = 0; i < int(state->get_contact_count()); i++) {
		const Vector3 normal = state->get_contact_local_normal(i);
		const float upright = normal.dot(_frame.basis.get_column(1));
		if (upright > best) {
			best = upright;
			ground = { true, state->get_contact_local_position(i), normal,
				state->get_contact_collider_velocity_at_position(i) };
		}
	}
	return ground;
}

void SphereRunningGear::list_bodies(TypedArray<RID> &r_bodies) const {
	for (const Sphere &sphere : _spheres) {
		r_bodies.push_back(sphere.body);
	}
}

} // namespace godot
