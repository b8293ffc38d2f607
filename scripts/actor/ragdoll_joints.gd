class_name RagdollJoints
extends RefCounted
## The joints of a ragdoll: one 6DOF joint with angular motors per limb, and one to the world.
##
## Made through [PhysicsServer3D] on the bodies of the [PhysicalBone3D]s, because those give no
## joint of their own that a motor can reach. Created from the leaves to the root, the joint to the
## world last: the order of creation is the order of solving. They are freed with this object.

const _ANGULAR_LIMIT := PhysicsServer3D.G6DOF_JOINT_FLAG_ENABLE_ANGULAR_LIMIT
const _ANGULAR_MOTOR := PhysicsServer3D.G6DOF_JOINT_FLAG_ENABLE_MOTOR
const _LINEAR_LIMIT := PhysicsServer3D.G6DOF_JOINT_FLAG_ENABLE_LINEAR_LIMIT
const _LINEAR_MOTOR := PhysicsServer3D.G6DOF_JOINT_FLAG_ENABLE_LINEAR_MOTOR
const _TORQUE := PhysicsServer3D.G6DOF_JOINT_ANGULAR_MOTOR_FORCE_LIMIT
const _FORCE := PhysicsServer3D.G6DOF_JOINT_LINEAR_MOTOR_FORCE_LIMIT

## The joints, one per limb in the limbs' order; the first is the one to the world (may be empty).
var rids: Array[RID] = []

var _anchor: RID = RID()


## What a joint connects: frames are relative to the bodies.
class Spec:
	## The parent's body, or an empty RID for the world.
	var parent: RID
	## The limb's body.
	var body: RID
	## The joint in the parent's body; for the root, in the world.
	var frame_a: Transform3D
	## The joint in the limb's body, with the body's axes.
	var frame_b: Transform3D
	## Greatest torque, N·m.
	var torque: float


## Makes joints, one per entry. The first entry becomes the joint to the world, whose greatest force
## is [param p_root_force] (N); below zero there is none.
func make(p_specs: Array[Spec], p_space: RID, p_root_force: float) -> void:
	rids.resize(p_specs.size())
	for i: int in range(p_specs.size() - 1, 0, -1):
		rids[i] = _make_joint(p_specs[i])
		PhysicsServer3D.joint_disable_collisions_between_bodies(rids[i], true)
		for axis: Vector3.Axis in [Vector3.AXIS_X, Vector3.AXIS_Y, Vector3.AXIS_Z]:
			PhysicsServer3D.generic_6dof_joint_set_flag(rids[i], axis, _LINEAR_LIMIT, true)
	if p_root_force >= 0.0:
		_make_root(p_specs[0], p_space, p_root_force)


func _make_root(p_spec: Spec, p_space: RID, p_force: float) -> void:
	# A joint to the world needs a body there: a static one without a shape.
	_anchor = PhysicsServer3D.body_create()
	PhysicsServer3D.body_set_mode(_anchor, PhysicsServer3D.BODY_MODE_STATIC)
	PhysicsServer3D.body_set_space(_anchor, p_space)
	p_spec.parent = _anchor
	rids[0] = _make_joint(p_spec)
	for axis: Vector3.Axis in [Vector3.AXIS_X, Vector3.AXIS_Y, Vector3.AXIS_Z]:
		PhysicsServer3D.generic_6dof_joint_set_flag(rids[0], axis, _LINEAR_LIMIT, false)
		PhysicsServer3D.generic_6dof_joint_set_flag(rids[0], axis, _LINEAR_MOTOR, true)
		PhysicsServer3D.generic_6dof_joint_set_param(rids[0], axis, _FORCE, p_force)


func _make_joint(p_spec: Spec) -> RID:
	var joint: RID = PhysicsServer3D.joint_create()
	PhysicsServer3D.joint_make_generic_6dof(
		joint, p_spec.parent, p_spec.frame_a, p_spec.body, p_spec.frame_b
	)
	for axis: Vector3.Axis in [Vector3.AXIS_X, Vector3.AXIS_Y, Vector3.AXIS_Z]:
		PhysicsServer3D.generic_6dof_joint_set_flag(joint, axis, _ANGULAR_LIMIT, false)
		PhysicsServer3D.generic_6dof_joint_set_flag(joint, axis, _ANGULAR_MOTOR, true)
		PhysicsServer3D.generic_6dof_joint_set_param(joint, axis, _TORQUE, p_spec.torque)
	return joint


func _notification(p_what: int) -> void:
	if p_what == NOTIFICATION_PREDELETE:
		for rid: RID in rids:
			if rid.is_valid():
				PhysicsServer3D.free_rid(rid)
		if _anchor.is_valid():
			PhysicsServer3D.free_rid(_anchor)
