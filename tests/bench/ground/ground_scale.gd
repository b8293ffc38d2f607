class_name GroundScale
extends RefCounted
## A floor that weighs what stands on it.
##
## The engine tells no contact force of a ragdoll that could be trusted, so the floor is a free body
## of great mass without gravity: what touches it in a step gives it a velocity, which is read and
## taken away again after the step. Force = mass x velocity / step (Newton's third law).

## Mass of the floor, kg: so heavy that it yields by less than a nanometre a step.
const MASS: float = 1e5

## The force on the floor in the last step, world axes, N. Who stands pushes it down.
var force: Vector3 = Vector3.ZERO

var _body: RigidBody3D = null


## Makes the floor, its top at a height (m) below the origin. [param p_slope] turns it about that
## point.
func _init(p_world: ContactWorld, p_height: float = 0.0, p_slope: Basis = Basis.IDENTITY) -> void:
	_body = p_world.add_crate(Vector3(60.0, 1.0, 60.0), Vector3.ZERO, MASS)
	_body.transform = Transform3D(p_slope, Vector3.UP * p_height - p_slope.y * 0.5)
	_body.collision_layer = PhysicsLayers.STATIC
	_body.collision_mask = PhysicsLayers.ALL  # Or the other side would feel no contact.
	_body.gravity_scale = 0.0
	_body.lock_rotation = true
	_body.linear_damp_mode = RigidBody3D.DAMP_MODE_REPLACE
	_body.linear_damp = 0.0
	var material: PhysicsMaterial = PhysicsMaterial.new()
	material.friction = 1.0
	_body.physics_material_override = material


## After a step of [param p_delta_s].
func read(p_delta_s: float) -> void:
	var body: RID = _body.get_rid()
	var velocity: Vector3 = PhysicsServer3D.body_get_state(
		body, PhysicsServer3D.BODY_STATE_LINEAR_VELOCITY
	)
	force = velocity * (MASS / p_delta_s)
	PhysicsServer3D.body_set_state(body, PhysicsServer3D.BODY_STATE_LINEAR_VELOCITY, Vector3.ZERO)
