// SPDX-License-Identifier: MIT
#include "ray_running_gear.hpp"

#include "physics.hpp"

#include <godot_cpp/variant/dictionary.hpp>

#include <algorithm>
#include <cmath>

namespace godot {

namespace {

/// A tread that friction holds as much as it can is bent by so much, m.
constexpr float BEND = 0.03f;
/// Of the tread, as a ratio to critical damping.
constexpr float TREAD_DAMPING = 0.5f;
/// A stop is so many times as stiff as the spring.
constexpr float STOP = 8.0f;
/// A wheel that is thrown onto a step does not push with more than so many times its weight.
constexpr float MAX_LOAD = 8.0f;
/// Rays at the rim begin and end at such a share of the radius from the middle.
constexpr float SPREAD = 0.85f;
/// Rays begin so many radii above the highest place of the wheel's middle: from inside a step they would not see it.
constexpr float ABOVE = 2.0f;
/// Ground that leans so far against the hull (cosine) is the face of a step.
constexpr float EDGE = 0.7f;
/// Loose things are not pushed with a greater acceleration than this, m/s^2.
constexpr float MAX_PUSH = 40.0f;

/// Offset of a ray from the wheel's middle, forward positive, as a share of the radius.
float ray_offset(int p_ray, int p_count) {
	return p_count < 2 ? 0.0f : SPREAD * (2.0f * float(p_ray) / float(p_count - 1) - 1.0f);
}

/// The keys of what a ray finds, made once.
struct Keys {
	Variant position = String("position");
	Variant normal = String("normal");
	Variant rid = String("rid");
};

} // namespace

RayRunningGear::~RayRunningGear() {
	release();
}

bool RayRunningGear::make() {
	const bool is_tracked = _drivetrain->get_core().settings.is_tracked;
	_contacts.assign(_wheels.size(), Contact());
	_patches.assign(_wheels.size(), vehicle::Patch());
	_rims.assign(is_tracked ? 2 : _wheels.size(), vehicle::Rim());
	float weight = 0.0f;
	for (const Wheel &wheel : _wheels) {
		weight += wheel.stiffness * std::max(wheel.sag, 0.0f);
	}
	for (vehicle::Rim &rim : _rims) {
		rim.mass = 0.0f;
	}
	for (std::size_t i = 0; i < _wheels.size(); i++) {
		const Wheel &wheel = _wheels[i];
		_rims[is_tracked ? std::size_t(wheel.side) : i].mass += wheel.mass;
		// Wheels that carry nothing at rest have the tread of the others.
		const float load = std::max(wheel.stiffness * wheel.sag, 0.3f * weight / float(_wheels.size()));
		_patches[i].stiffness = wheel.grip * load / BEND;
		_patches[i].damping = 2.0f * TREAD_DAMPING * std::sqrt(_patches[i].stiffness * load / GRAVITY);
	}
	for (std::size_t side = 0; is_tracked && side < 2; side++) {
		if (!(_rims[side].mass > 0.0f)) {
			_rims[side].mass = 1.0f;
		}
	}
	// All wheels turn about a point beside the ones that are not steered.
	float unsteered = 0.0f;
	_axle = 0.0f;
	for (const Wheel &wheel : _wheels) {
		_axle += wheel.is_steered ? 0.0f : wheel.position.z;
		unsteered += wheel.is_steered ? 0.0f : 1.0f;
	}
	_axle = unsteered > 0.0f ? _axle / unsteered : 0.0f;
	_query.instantiate();
	TypedArray<RID> own;
	own.push_back(_body);
	_query->set_exclude(own);
	_query->set_collision_mask(uint32_t(_collision_mask));
	return true;
}

void RayRunningGear::unmake() {
	_query.unref();
	_contacts.clear();
	_patches.clear();
	_rims.clear();
}

void RayRunningGear::put() {
	for (vehicle::Rim &rim : _rims) {
		rim.speed = 0.0f;
	}
	for (vehicle::Patch &patch : _patches) {
		patch.bend_along = patch.bend_across = 0.0f;
	}
}

void RayRunningGear::meet(std::size_t p_wheel, const Dictionary &p_hit) {
	static const Keys keys;
	Contact &contact = _contacts[p_wheel];
	contact.ground.is_there = true;
	contact.ground.point = p_hit[keys.position];
	contact.ground.normal = p_hit[keys.normal];
	contact.ground.velocity = Vector3();
	const RID body = p_hit[keys.rid];
	vehicle::Patch &patch = _patches[p_wheel];
	const auto friction = float(double(server()->body_get_param(body, Server::BODY_PARAM_FRICTION)));
	patch.grip_along = std::min(_wheels[p_wheel].grip, friction);
	patch.grip_across = std::min(_wheels[p_wheel].side_grip, friction);
	contact.body = RID();
	if (server()->body_get_mode(body) == Server::BODY_MODE_STATIC) {
		return;
	}
	const PhysicsDirectBodyState3D *state = server()->body_get_direct_state(body);
	if (state != nullptr) {
		const Vector3 centre = state->get_transform().origin + state->get_center_of_mass();
		contact.ground.velocity =
				state->get_linear_velocity() + state->get_angular_velocity().cross(contact.ground.point - centre);
		contact.body = server()->body_get_mode(body) == Server::BODY_MODE_KINEMATIC ? RID() : body;
		contact.mass = float(server()->body_get_param(body, Server::BODY_PARAM_MASS));
	}
}

void RayRunningGear::cast(std::size_t p_wheel, PhysicsDirectSpaceState3D *p_space) {
	static const Keys keys;
	Wheel &wheel = _wheels[p_wheel];
	_contacts[p_wheel].ground.is_there = false;
	const float top = wheel.travel_up + ABOVE * wheel.radius;
	const Vector3 up = _frame.basis.get_column(1);
	float best = -wheel.travel_down;
	float chosen = 0.0f;
	Dictionary hit;
	for (int ray = 0; ray < wheel.rays; ray++) {
		const float ahead = ray_offset(ray, wheel.rays) * wheel.radius;
		const float sagitta = std::sqrt(wheel.radius * wheel.radius - ahead * ahead);
		const Vector3 swung(-ahead * std::sin(wheel.angle), 0.0f, -ahead * std::cos(wheel.angle));
		const Vector3 from = _frame.xform(wheel.position + swung + Vector3(0.0f, top, 0.0f));
		const float length = top + wheel.travel_down + sagitta;
		_query->set_from(from);
		_query->set_to(from - up * length);
		const Dictionary found = p_space->intersect_ray(_query);
		if (found.is_empty()) {
			continue;
		}
		const Vector3 point = found[keys.position];
		const float height = top - (from - point).dot(up) + sagitta;
		if (height > best) {
			best = height;
			chosen = ahead;
			hit = found;
		}
	}
	wheel.height = best;
	if (hit.is_empty()) {
		return;
	}
	meet(p_wheel, hit);
	const bool is_edge = _contacts[p_wheel].ground.normal.dot(up) < EDGE;
	if (chosen != 0.0f || is_edge) {
		// A wheel touches an edge with its rim: the force goes through its middle. A ray that meets the face of a
		// step would push the vehicle back.
		const Vector3 middle = _frame.xform(wheel.position + Vector3(0.0f, best, 0.0f));
		_contacts[p_wheel].ground.normal = (middle - _contacts[p_wheel].ground.point).normalized();
	}
}

void RayRunningGear::find_load(std::size_t p_wheel) {
	Wheel &wheel = _wheels[p_wheel];
	vehicle::Patch &patch = _patches[p_wheel];
	Contact &contact = _contacts[p_wheel];
	patch.load = wheel.load = 0.0f;
	if (!contact.ground.is_there) {
		return;
	}
	const Vector3 over = velocity_at(contact.ground.point) - contact.ground.velocity;
	const Vector3 &normal = contact.ground.normal;
	const float beyond = std::max(0.0f, wheel.height - wheel.travel_up);
	const float force = wheel.stiffness * (wheel.height + wheel.sag + STOP * beyond) - wheel.damping * over.dot(normal);
	const float most = MAX_LOAD * wheel.stiffness * std::max(wheel.sag, 0.08f);
	patch.load = wheel.load = std::clamp(force, 0.0f, most);
	Vector3 ahead = heading(wheel.angle);
	ahead = (ahead - normal * ahead.dot(normal)).normalized();
	contact.ahead = ahead;
	contact.aside = normal.cross(ahead); // To the left.
	patch.speed_along = over.dot(contact.ahead);
	patch.speed_across = over.dot(contact.aside);
}

void RayRunningGear::read(float /*p_delta*/) {
	PhysicsDirectSpaceState3D *space = server()->space_get_direct_state(_space);
	const vehicle::Drivetrain &core = _drivetrain->get_core();
	float sums[2] = { 0.0f, 0.0f };
	int counts[2] = { 0, 0 };
	for (std::size_t i = 0; i < _wheels.size(); i++) {
		Wheel &wheel = _wheels[i];
		wheel.angle = wheel.is_steered ? core.wheels.angle_at(_axle - wheel.position.z, wheel.position.x) : 0.0f;
		if (space != nullptr) {
			cast(i, space);
		}
		find_load(i);
		wheel.speed = _rims[core.settings.is_tracked ? std::size_t(wheel.side) : i].speed;
		if (wheel.is_driven || core.settings.is_tracked) {
			sums[wheel.side] += wheel.speed;
			counts[wheel.side]++;
		}
	}
	_motion.left = counts[0] > 0 ? sums[0] / float(counts[0]) : _motion.speed;
	_motion.right = counts[1] > 0 ? sums[1] / float(counts[1]) : _motion.speed;
}

void RayRunningGear::turn_rims(const vehicle::SideForces &p_forces, float p_delta) {
	const bool is_tracked = _drivetrain->get_core().settings.is_tracked;
	for (int side = 0; side < 2; side++) {
		const std::size_t first = first_of(side);
		const std::size_t count = count_of(side);
		float loads = 0.0f;
		float driven = 0.0f;
		float parked = 0.0f;
		for (std::size_t i = first; i < first + count; i++) {
			loads += _wheels[i].load;
			driven += _wheels[i].is_driven ? 1.0f : 0.0f;
			parked += _wheels[i].is_parked ? 1.0f : 0.0f;
		}
		const float drive = side == 0 ? p_forces.left : p_forces.right;
		const float brake = side == 0 ? p_forces.left_brake : p_forces.right_brake;
		const float parking = side == 0 ? p_forces.left_parking : p_forces.right_parking;
		if (is_tracked) {
			_rims[std::size_t(side)].step(
					drive, brake + parking + _rolling_resistance * loads, _patches, first, count, p_delta);
			continue;
		}
		for (std::size_t i = first; i < first + count; i++) {
			const Wheel &wheel = _wheels[i];
			// Brakes by load, so that no wheel locks long before the others.
			const float share =
					(wheel.load + 0.02f * loads + 1.0f) / (loads * (1.0f + 0.02f * float(count)) + float(count));
			const float held =
					brake * share + (wheel.is_parked ? parking / parked : 0.0f) + _rolling_resistance * wheel.load;
			_rims[i].step(wheel.is_driven ? drive / driven : 0.0f, held, _patches, i, 1, p_delta);
		}
	}
}

void RayRunningGear::push(std::size_t p_wheel) {
	const Contact &contact = _contacts[p_wheel];
	const vehicle::Patch &patch = _patches[p_wheel];
	if (patch.load <= 0.0f) {
		return;
	}
	const Vector3 force =
			contact.ground.normal * patch.load + contact.ahead * patch.force_along + contact.aside * patch.force_across;
	server()->body_apply_force(_body, force, contact.ground.point - _frame.origin);
	if (contact.body.is_valid()) {
		const Transform3D frame = server()->body_get_state(contact.body, Server::BODY_STATE_TRANSFORM);
		// What is light lies between wheel and ground, which carries it: it would be shot away within a step.
		const float most = contact.mass * MAX_PUSH;
		const float share = std::min(1.0f, most / std::max(force.length(), 1.0f));
		server()->body_apply_force(contact.body, force * -share, contact.ground.point - frame.origin);
	}
}

void RayRunningGear::drive(float p_delta) {
	turn_rims(_drivetrain->get_forces(), p_delta);
	for (std::size_t i = 0; i < _wheels.size(); i++) {
		push(i);
	}
}

RunningGear::Ground RayRunningGear::ground_of(std::size_t p_wheel) {
	return _contacts[p_wheel].ground;
}

} // namespace godot
