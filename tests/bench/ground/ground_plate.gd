class_name GroundPlate
extends RefCounted
## A floor that weighs what stands on it, and tells where: force and torque.
##
## The engine tells no contact force of a ragdoll that could be trusted, so the floor is a free body
## of great mass without gravity: what touches it in a step gives it a velocity and a spin, which
## are read and taken away again after the step. Force = mass x velocity / step (Newton's third
## law).

## So heavy that it yields by less than a nanometre a step, kg.
const MASS: float = 1e6
## Width and thickness of a floor for one person who stays, and for one who walks, m.
const SIZE: Vector3 = Vector3(8.0, 1.0, 8.0)
const WIDE: Vector3 = Vector3(60.0, 1.0, 60.0)

## What the floor did to the person in the last step: N, and N·m about [member at].
var force: Vector3 = Vector3.ZERO
var torque: Vector3 = Vector3.ZERO
## Centre of the floor's body, m.
var at: Vector3 = Vector3.ZERO

var _body: RID
var _inertia: Vector3 = Vector3.ZERO


## Makes the floor, the middle of its top at a place.
func _init(p_world: ContactWorld, p_top: Vector3, p_size: Vector3 = SIZE) -> void:
	at = p_top + Vector3.DOWN * (p_size.y / 2.0)
	var body: RigidBody3D = p_world.add_crate(p_size, at, MASS)
	body.collision_layer = PhysicsLayers.STATIC
	body.collision_mask = PhysicsLayers.ALL  # Or the other side would feel no contact.
	body.gravity_scale = 0.0
	body.linear_damp_mode = RigidBody3D.DAMP_MODE_REPLACE
	body.linear_damp = 0.0
	body.angular_damp_mode = RigidBody3D.DAMP_MODE_REPLACE
	body.angular_damp = 0.0
	var material: PhysicsMaterial = PhysicsMaterial.new()
	material.friction = 1.0
	body.physics_material_override = material
	_body = body.get_rid()
	var squares: Vector3 = p_size * p_size
	_inertia = Vector3(squares.y + squares.z, squares.x + squares.z, squares.x + squares.y)
	_inertia *= MASS / 12.0


## After a step of [param p_delta_s].
func read(p_delta_s: float) -> void:
	var velocity: Vector3 = PhysicsServer3D.body_get_state(
		_body, PhysicsServer3D.BODY_STATE_LINEAR_VELOCITY
	)
	var spin: Vector3 = PhysicsServer3D.body_get_state(
		_body, PhysicsServer3D.BODY_STATE_ANGULAR_VELOCITY
	)
	force = velocity * (-MASS / p_delta_s)
	torque = spin * _inertia * (-1.0 / p_delta_s)
	for state: PhysicsServer3D.BodyState in [
		PhysicsServer3D.BODY_STATE_LINEAR_VELOCITY, PhysicsServer3D.BODY_STATE_ANGULAR_VELOCITY
	]:
		PhysicsServer3D.body_set_state(_body, state, Vector3.ZERO)


## Where the floor's push goes through its top, m.
func find_centre_of_pressure() -> Vector3:
	var up: float = maxf(force.y, 1.0)
	var top: float = SIZE.y / 2.0
	return at + Vector3((torque.z + force.x * top) / up, top, (-torque.x + force.z * top) / up)
