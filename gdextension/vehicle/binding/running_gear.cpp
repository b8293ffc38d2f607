// SPDX-License-Identifier: MIT
#include "running_gear.hpp"

#include "physics.hpp"

#include <convert.hpp>

#include <algorithm>
#include <cmath>

namespace godot {

namespace {

constexpr float AIR_DENSITY = 1.2f; // kg/m^3

} // namespace

bool RunningGear::setup(Node3D *p_hull, const RID &p_body, const RID &p_space, const TypedArray<VehicleWheel> &p_wheels,
		const Ref<VehicleDrivetrain> &p_drivetrain) {
	ERR_FAIL_COND_V_MSG(p_hull == nullptr || !p_body.is_valid() || !p_space.is_valid(), false,
			"RunningGear: the hull must be a body in a physics space.");
	ERR_FAIL_COND_V_MSG(p_wheels.is_empty(), false, "RunningGear: a vehicle needs wheels.");
	ERR_FAIL_COND_V_MSG(p_drivetrain.is_null(), false, "RunningGear: a vehicle needs a drivetrain.");
	release();
	for (int64_t i = 0; i < p_wheels.size(); i++) {
		const VehicleWheel *given = Object::cast_to<VehicleWheel>(p_wheels[i]);
		ERR_FAIL_COND_V_MSG(given == nullptr, false, "RunningGear: a wheel is missing.");
		ERR_FAIL_COND_V_MSG(!(given->get_radius() > 0.0 && given->get_mass() > 0.0 && given->get_stiffness() > 0.0),
				false, "RunningGear: a wheel needs a radius, a mass and a stiffness above zero.");
		_wheels.push_back({ given->get_position(), float(given->get_radius()), float(given->get_mass()),
				float(given->get_stiffness()), float(given->get_damping()), float(given->get_sag()),
				float(given->get_travel_up()), float(given->get_travel_down()), float(given->get_grip()),
				float(given->get_side_grip()), int(given->get_rays()), given->get_is_driven(), given->get_is_steered(),
				given->get_is_parked(), given->get_position().x < 0.0f ? 0 : 1, int(i) });
	}
	std::stable_sort(
			_wheels.begin(), _wheels.end(), [](const Wheel &p_a, const Wheel &p_b) { return p_a.side < p_b.side; });
	_left_count =
			std::size_t(std::count_if(_wheels.begin(), _wheels.end(), [](const Wheel &p_a) { return p_a.side == 0; }));
	_order.assign(_wheels.size(), 0);
	for (std::size_t i = 0; i < _wheels.size(); i++) {
		_order[std::size_t(_wheels[i].given)] = i;
	}
	_hull = p_hull;
	_body = p_body;
	_space = p_space;
	_drivetrain = p_drivetrain;
	_motion = {};
	_frame = PhysicsServer3D::get_singleton()->body_get_state(_body, PhysicsServer3D::BODY_STATE_TRANSFORM);
	if (!make()) {
		_wheels.clear();
		return false;
	}
	return true;
}

void RunningGear::release() {
	if (is_set_up()) {
		unmake();
	}
	_wheels.clear();
	_order.clear();
	_drivetrain.unref();
	_hull = nullptr;
}

void RunningGear::step(double p_delta) {
	ERR_FAIL_COND_MSG(
			!(p_delta > 1e-5 && p_delta <= 1.0), "RunningGear: the time step must be above 0 and 1 s at most.");
	if (!is_set_up()) {
		return;
	}
	PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	const PhysicsDirectBodyState3D *state = server->body_get_direct_state(_body);
	ERR_FAIL_COND_MSG(state == nullptr, "RunningGear: the hull is not in a physics space (any more).");
	_frame = state->get_transform();
	_velocity = state->get_linear_velocity();
	_turning = state->get_angular_velocity();
	_centre = _frame.origin + state->get_center_of_mass();
	if (!_frame.is_finite() || !_velocity.is_finite() || !_turning.is_finite()) {
		return;
	}
	const float delta = float(p_delta);
	const Vector3 ahead = -_frame.basis.get_column(2);
	_motion.speed = velocity_at(_frame.origin).dot(ahead);
	_motion.turning = _turning.dot(_frame.basis.get_column(1));
	_motion.uphill = _drivetrain->get_core().settings.mass * GRAVITY * ahead.y;
	if (state->is_sleeping()) {
		// A vehicle that stands costs no more than its engine, until somebody drives it or runs into it.
		_drivetrain->step(_motion, delta);
		if (_drivetrain->get_core().is_at_rest()) {
			return;
		}
	} else {
		read(delta);
		_drivetrain->step(_motion, delta);
	}
	drive(delta);
	if (_drag_area > 0.0f) {
		const Vector3 force = _velocity * (-0.5f * AIR_DENSITY * _drag_area * _velocity.length());
		if (force.length_squared() > 1.0f) {
			server->body_apply_central_force(_body, force);
		}
	}
	for (Wheel &wheel : _wheels) {
		wheel.turn = std::fmod(wheel.turn + wheel.speed / wheel.radius * delta, 6.28318531f);
	}
}

void RunningGear::place() {
	if (!is_set_up()) {
		return;
	}
	PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	_frame = server->body_get_state(_body, PhysicsServer3D::BODY_STATE_TRANSFORM);
	_velocity = server->body_get_state(_body, PhysicsServer3D::BODY_STATE_LINEAR_VELOCITY);
	_turning = server->body_get_state(_body, PhysicsServer3D::BODY_STATE_ANGULAR_VELOCITY);
	_centre = _frame.origin;
	put();
}

Vector3 RunningGear::velocity_at(const Vector3 &p_point) const {
	return _velocity + _turning.cross(p_point - _centre);
}

Vector3 RunningGear::heading(float p_angle) const {
	return _frame.basis.get_column(2) * -std::cos(p_angle) - _frame.basis.get_column(0) * std::sin(p_angle);
}

void RunningGear::list_bodies(TypedArray<RID> & /*r_bodies*/) const {}

TypedArray<RID> RunningGear::get_bodies() const {
	TypedArray<RID> bodies;
	list_bodies(bodies);
	return bodies;
}

const RunningGear::Wheel *RunningGear::wheel_at(int64_t p_wheel) const {
	ERR_FAIL_INDEX_V_MSG(p_wheel, int64_t(_order.size()), nullptr, "RunningGear: there is no such wheel.");
	return &_wheels[_order[std::size_t(p_wheel)]];
}

Transform3D RunningGear::get_wheel_transform(int64_t p_wheel) const {
	const Wheel *wheel = wheel_at(p_wheel);
	if (wheel == nullptr) {
		return Transform3D();
	}
	const kinematics::Quat steered = kinematics::exp({ 0.0f, wheel->angle, 0.0f });
	return Transform3D(Basis(from_core(steered * kinematics::exp({ -wheel->turn, 0.0f, 0.0f }))),
			wheel->position + Vector3(0.0f, wheel->height, 0.0f));
}

double RunningGear::get_wheel_compression(int64_t p_wheel) const {
	const Wheel *wheel = wheel_at(p_wheel);
	return wheel != nullptr ? double(wheel->height + wheel->sag) : 0.0;
}

double RunningGear::get_wheel_load(int64_t p_wheel) const {
	const Wheel *wheel = wheel_at(p_wheel);
	return wheel != nullptr ? double(wheel->load) : 0.0;
}

double RunningGear::get_wheel_speed(int64_t p_wheel) const {
	const Wheel *wheel = wheel_at(p_wheel);
	return wheel != nullptr ? double(wheel->speed) : 0.0;
}

double RunningGear::get_wheel_slip(int64_t p_wheel) {
	const Wheel *wheel = wheel_at(p_wheel);
	if (wheel == nullptr) {
		return 0.0;
	}
	const Ground ground = ground_of(_order[std::size_t(p_wheel)]);
	if (!ground.is_there) {
		return 0.0;
	}
	const Vector3 ahead = heading(wheel->angle);
	const Vector3 over = velocity_at(ground.point) - ground.velocity - ahead * wheel->speed;
	return double((over - ground.normal * over.dot(ground.normal)).length());
}

bool RunningGear::is_wheel_on_ground(int64_t p_wheel) {
	return wheel_at(p_wheel) != nullptr && ground_of(_order[std::size_t(p_wheel)]).is_there;
}

Vector3 RunningGear::get_contact_point(int64_t p_wheel) {
	return wheel_at(p_wheel) != nullptr ? ground_of(_order[std::size_t(p_wheel)]).point : Vector3();
}

Vector3 RunningGear::get_ground_velocity(int64_t p_wheel) {
	return wheel_at(p_wheel) != nullptr ? ground_of(_order[std::size_t(p_wheel)]).velocity : Vector3();
}

void RunningGear::_bind_methods() {
	ClassDB::bind_method(D_METHOD("setup", "hull", "body", "space", "wheels", "drivetrain"), &RunningGear::setup);
	ClassDB::bind_method(D_METHOD("release"), &RunningGear::release);
	ClassDB::bind_method(D_METHOD("is_set_up"), &RunningGear::is_set_up);
	ClassDB::bind_method(D_METHOD("step", "delta"), &RunningGear::step);
	ClassDB::bind_method(D_METHOD("place"), &RunningGear::place);
	ClassDB::bind_method(D_METHOD("get_left_speed"), &RunningGear::get_left_speed);
	ClassDB::bind_method(D_METHOD("get_right_speed"), &RunningGear::get_right_speed);
	ClassDB::bind_method(D_METHOD("get_wheel_count"), &RunningGear::get_wheel_count);
	ClassDB::bind_method(D_METHOD("get_bodies"), &RunningGear::get_bodies);
	ClassDB::bind_method(D_METHOD("get_wheel_transform", "wheel"), &RunningGear::get_wheel_transform);
	ClassDB::bind_method(D_METHOD("get_wheel_compression", "wheel"), &RunningGear::get_wheel_compression);
	ClassDB::bind_method(D_METHOD("get_wheel_load", "wheel"), &RunningGear::get_wheel_load);
	ClassDB::bind_method(D_METHOD("get_wheel_speed", "wheel"), &RunningGear::get_wheel_speed);
	ClassDB::bind_method(D_METHOD("get_wheel_slip", "wheel"), &RunningGear::get_wheel_slip);
	ClassDB::bind_method(D_METHOD("is_wheel_on_ground", "wheel"), &RunningGear::is_wheel_on_ground);
	ClassDB::bind_method(D_METHOD("get_contact_point", "wheel"), &RunningGear::get_contact_point);
	ClassDB::bind_method(D_METHOD("get_ground_velocity", "wheel"), &RunningGear::get_ground_velocity);
	ClassDB::bind_method(D_METHOD("set_rolling_resistance", "share"), &RunningGear::set_rolling_resistance);
	ClassDB::bind_method(D_METHOD("get_rolling_resistance"), &RunningGear::get_rolling_resistance);
	ClassDB::bind_method(D_METHOD("set_drag_area", "area"), &RunningGear::set_drag_area);
	ClassDB::bind_method(D_METHOD("get_drag_area"), &RunningGear::get_drag_area);
	ClassDB::bind_method(D_METHOD("set_collision_mask", "mask"), &RunningGear::set_collision_mask);
	ClassDB::bind_method(D_METHOD("get_collision_mask"), &RunningGear::get_collision_mask);
	ClassDB::bind_method(D_METHOD("set_collision_layer", "layer"), &RunningGear::set_collision_layer);
	ClassDB::bind_method(D_METHOD("get_collision_layer"), &RunningGear::get_collision_layer);
	ADD_PROPERTY(
			PropertyInfo(Variant::FLOAT, "rolling_resistance"), "set_rolling_resistance", "get_rolling_resistance");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "drag_area", PROPERTY_HINT_NONE, "suffix:m^2"), "set_drag_area",
			"get_drag_area");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "collision_mask", PROPERTY_HINT_LAYERS_3D_PHYSICS), "set_collision_mask",
			"get_collision_mask");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "collision_layer", PROPERTY_HINT_LAYERS_3D_PHYSICS), "set_collision_layer",
			"get_collision_layer");
}

} // namespace godot
