class_name GroundResidual
extends RefCounted
## What neither gravity nor the floor explains of how a person moves: what the motor does to the
## hips from outside, force and torque, as vectors.
##
## The engine tells no force of a joint that could be trusted. Newton's second law does: the change
## of the momentum and of the angular momentum, with the inertias that the engine has, less what the
## floor gave, which is a [GroundPlate]. Nothing else may touch the person.

var person: ContactPerson = null
var plate: GroundPlate = null
## What lies on the person and counts as part of it; null for nothing.
var crate: RigidBody3D = null
## In the last step: N, and N·m about the common centre of mass.
var force: Vector3 = Vector3.ZERO
var torque: Vector3 = Vector3.ZERO

var _momentum: Vector3 = Vector3.INF
var _spin: Vector3 = Vector3.ZERO


func _init(p_person: ContactPerson, p_plate: GroundPlate) -> void:
	person = p_person
	plate = p_plate


## After a step of [param p_delta_s]. Returns whether there was a step before it to compare with.
func note(p_delta_s: float) -> bool:
	plate.read(p_delta_s)
	var bodies: Array[Transform3D] = person.bodies()
	var rids: Array[RID] = person.ragdoll.get_bodies().duplicate()
	var places: PackedVector3Array = []
	var masses: PackedFloat64Array = []
	for limb: int in person.count:
		places.append(bodies[limb].origin)
		masses.append(person.mass_of(limb))
	if crate != null:
		rids.append(crate.get_rid())
		places.append(crate.global_position)
		masses.append(crate.mass)
	var mass: float = 0.0
	var centre: Vector3 = Vector3.ZERO
	for i: int in masses.size():
		mass += masses[i]
		centre += places[i] * masses[i]
	centre /= mass
	var momentum: Vector3 = Vector3.ZERO
	var spin: Vector3 = Vector3.ZERO
	for i: int in masses.size():
		var state: PhysicsDirectBodyState3D = PhysicsServer3D.body_get_direct_state(rids[i])
		momentum += state.linear_velocity * masses[i]
		spin += (places[i] - centre).cross(state.linear_velocity * masses[i])
		spin += state.inverse_inertia_tensor.inverse() * state.angular_velocity
	var is_known: bool = _momentum != Vector3.INF
	if is_known:
		force = (momentum - _momentum) / p_delta_s - plate.force + Vector3.UP * (9.81 * mass)
		var arm: Vector3 = plate.at - centre
		torque = (spin - _spin) / p_delta_s - plate.torque - arm.cross(plate.force)
	_momentum = momentum
	_spin = spin
	return is_known
