class_name SeatJoint
extends RefCounted
## Holds a person's hips to a moving body by a joint with limited forces: the forces act on the body
## in return.
##
## All positions and velocities are in the body's frame: m, m/s.

const _AXES: Array[Vector3.Axis] = [Vector3.AXIS_X, Vector3.AXIS_Y, Vector3.AXIS_Z]
## How fast errors are corrected, 1/s.
const _GAIN: float = 30.0
## Mass that the forces have to move, kg: it gives the speed at which they can still brake.
const _MASS: float = 80.0
const _GRAVITY: float = 9.8

var _body: RID = RID()
var _hips: RID = RID()
## The joint of the hips in the frame of their body, m.
var _offset: Vector3 = Vector3.ZERO
var _joint: RID = RID()
var _forces: Vector3 = Vector3.ZERO


## Joins the hips of a ragdoll to a body.
func _init(p_body: RID, p_ragdoll: Ragdoll) -> void:
	_body = p_body
	_hips = p_ragdoll.get_bodies()[0]
	_offset = joint_of(p_ragdoll.profile.limbs[0])
	_joint = PhysicsServer3D.joint_create()
	PhysicsServer3D.joint_make_generic_6dof(
		_joint, _body, Transform3D.IDENTITY, _hips, Transform3D(Basis.IDENTITY, _offset)
	)
	for axis: Vector3.Axis in _AXES:
		PhysicsServer3D.generic_6dof_joint_set_flag(
			_joint, axis, PhysicsServer3D.G6DOF_JOINT_FLAG_ENABLE_LINEAR_MOTOR, true
		)


## Where a limb's joint is in the frame of its body, m.
static func joint_of(p_limb: RagdollLimb) -> Vector3:
	return p_limb.rest_orientation.inverse() * (p_limb.anchor - p_limb.position)


## Frees the joint: before either body.
func release() -> void:
	if _joint.is_valid():
		PhysicsServer3D.free_rid(_joint)
		_joint = RID()


## Where the hips are.
func place() -> Vector3:
	var hips: Transform3D = _state(_hips).transform
	return _state(_body).transform.affine_inverse() * (hips * _offset)


## Pulls the hips for a step of a length, s: from a position at its beginning to another at its end.
## [param p_up] is the greatest force that carries them, [param p_down] the greatest that holds them
## down, N.
func pull(
	p_from: Vector3, p_to: Vector3, p_side: float, p_up: float, p_down: float, p_delta_s: float
) -> void:
	var error: Vector3 = p_from - place()
	var across: Vector3 = Vector3(error.x, 0.0, error.z)
	across = (across * _GAIN).limit_length(sqrt(2.0 * p_side / _MASS * across.length()))
	var strongest: float = p_up / _MASS - _GRAVITY if error.y > 0.0 else p_down / _MASS + _GRAVITY
	var fastest: float = sqrt(2.0 * maxf(strongest, 1.0) * absf(error.y))
	var velocity: Vector3 = (p_to - p_from) / p_delta_s + across
	velocity.y += clampf(error.y * _GAIN, -fastest, fastest)
	# Gravity needs no force: only hips that have to sink faster are pulled down.
	var falls: float = _velocity().y - _GRAVITY * p_delta_s
	_set_forces(Vector3(p_side, p_up if velocity.y > falls else p_down, p_side))
	for axis: Vector3.Axis in _AXES:
		PhysicsServer3D.generic_6dof_joint_set_param(
			_joint, axis, PhysicsServer3D.G6DOF_JOINT_LINEAR_MOTOR_TARGET_VELOCITY, velocity[axis]
		)


## How fast the hips move in the body's frame, m/s.
func _velocity() -> Vector3:
	var body: PhysicsDirectBodyState3D = _state(_body)
	var hips: PhysicsDirectBodyState3D = _state(_hips)
	var middle: Vector3 = body.transform.origin + body.center_of_mass
	var arm: Vector3 = hips.transform.origin - middle
	var moves: Vector3 = body.linear_velocity + body.angular_velocity.cross(arm)
	return body.transform.basis.inverse() * (hips.linear_velocity - moves)


func _set_forces(p_forces: Vector3) -> void:
	for axis: Vector3.Axis in _AXES:
		if p_forces[axis] != _forces[axis]:
			PhysicsServer3D.generic_6dof_joint_set_param(
				_joint, axis, PhysicsServer3D.G6DOF_JOINT_LINEAR_MOTOR_FORCE_LIMIT, p_forces[axis]
			)
	_forces = p_forces


static func _state(p_body: RID) -> PhysicsDirectBodyState3D:
	return PhysicsServer3D.body_get_direct_state(p_body)
