class_name JoltRecording
extends RefCounted
## What Jolt was told by the engine in some ticks, as numbers that [code]raw_jolt.cpp[/code]
## replays: settings, bodies, joints, the motors' targets of every tick, and where the bodies were
## in the end.

const _VERSION: float = 2.0
const _JOLT: String = "physics/jolt_physics_3d/"
const _SETTINGS: Array[String] = [
	"simulation/velocity_steps",
	"simulation/position_steps",
	"simulation/baumgarte_stabilization_factor",
	"simulation/speculative_contact_distance",
	"simulation/penetration_slop",
	"simulation/continuous_cd_movement_threshold",
	"simulation/continuous_cd_max_penetration",
	"simulation/body_pair_contact_cache_distance_threshold",
	"simulation/body_pair_contact_cache_angle_threshold",
	"simulation/bounce_velocity_threshold",
	"limits/max_linear_velocity",
	"limits/max_angular_velocity",
	"collisions/collision_margin_fraction",
]
const _AXES: Array[Vector3.Axis] = [Vector3.AXIS_X, Vector3.AXIS_Y, Vector3.AXIS_Z]
const _TURN: PhysicsServer3D.G6DOFJointAxisParam = (
	PhysicsServer3D.G6DOF_JOINT_ANGULAR_MOTOR_TARGET_VELOCITY
)
const _TORQUE: PhysicsServer3D.G6DOFJointAxisParam = (
	PhysicsServer3D.G6DOF_JOINT_ANGULAR_MOTOR_FORCE_LIMIT
)
const _MOVE: PhysicsServer3D.G6DOFJointAxisParam = (
	PhysicsServer3D.G6DOF_JOINT_LINEAR_MOTOR_TARGET_VELOCITY
)

var _crowd: BenchCrowd = null
var _file: FileAccess = null


## Opens a file for a crowd; [method is_open] tells whether that went well.
func _init(p_path: String, p_crowd: BenchCrowd, p_ticks: int) -> void:
	_crowd = p_crowd
	_file = FileAccess.open(p_path, FileAccess.WRITE)
	if _file == null:
		return
	var limbs: int = _crowd.ragdolls[0].get_bodies().size()
	_store([_VERSION, _crowd.ragdolls.size(), limbs, p_ticks, Engine.physics_ticks_per_second])
	for setting: String in _SETTINGS:
		_store([ProjectSettings.get_setting(_JOLT + setting)])
	_store([ProjectSettings.get_setting("physics/3d/default_gravity")])


## Whether the file could be opened.
func is_open() -> bool:
	return _file != null


## Writes what the bodies and joints are, when the first tick's motors have been set.
func write_bodies() -> void:
	for ragdoll: Ragdoll in _crowd.ragdolls:
		for body: RID in ragdoll.get_bodies():
			_write_body(body)
	for ragdoll: Ragdoll in _crowd.ragdolls:
		for i: int in ragdoll.profile.limbs.size():
			_write_joint(ragdoll, i)


## Writes the motors' targets and greatest torques for the step that follows.
func write_targets() -> void:
	var numbers: PackedFloat32Array = PackedFloat32Array()
	for ragdoll: Ragdoll in _crowd.ragdolls:
		for joint: RID in ragdoll.motor.get_joints():
			for axis: Vector3.Axis in _AXES:
				# The engine turns the sign of angular motors round for Jolt.
				numbers.append(-PhysicsServer3D.generic_6dof_joint_get_param(joint, axis, _TURN))
			# All three axes have the same.
			numbers.append(
				PhysicsServer3D.generic_6dof_joint_get_param(joint, Vector3.AXIS_X, _TORQUE)
			)
	for ragdoll: Ragdoll in _crowd.ragdolls:
		for axis: Vector3.Axis in _AXES:
			var joint: RID = ragdoll.motor.get_joints()[0]
			numbers.append(PhysicsServer3D.generic_6dof_joint_get_param(joint, axis, _MOVE))
	_file.store_buffer(numbers.to_byte_array())


## Writes where the bodies are, and closes the file.
func write_end() -> void:
	for ragdoll: Ragdoll in _crowd.ragdolls:
		for body: RID in ragdoll.get_bodies():
			_store_place(PhysicsServer3D.body_get_state(body, PhysicsServer3D.BODY_STATE_TRANSFORM))
	_file.close()


## A joint as [RagdollMotor] makes it: where it is in both bodies, with the axes that both have in
## the reset pose.
func _write_joint(p_ragdoll: Ragdoll, p_limb: int) -> void:
	var limb: RagdollLimb = p_ragdoll.profile.limbs[p_limb]
	var parent: int = p_ragdoll.profile.get_parent_index(p_limb)
	var frame: Transform3D = Transform3D.IDENTITY
	if parent >= 0:
		var above: RagdollLimb = p_ragdoll.profile.limbs[parent]
		frame.basis = Basis(above.reset_orientation.inverse() * limb.reset_orientation)
		frame.origin = above.rest_orientation.inverse() * (limb.anchor - above.position)
	_store([parent])
	_store_place(frame)
	var arm: Vector3 = limb.rest_orientation.inverse() * (limb.anchor - limb.position)
	_store_place(Transform3D(Basis.IDENTITY, arm))
	_store([p_ragdoll.root_force if parent < 0 else 0.0])


func _write_body(p_body: RID) -> void:
	var inertia: Vector3 = PhysicsServer3D.body_get_param(
		p_body, PhysicsServer3D.BODY_PARAM_INERTIA
	)
	_store([PhysicsServer3D.body_get_param(p_body, PhysicsServer3D.BODY_PARAM_MASS)])
	_store([inertia.x, inertia.y, inertia.z])
	_store([PhysicsServer3D.body_get_param(p_body, PhysicsServer3D.BODY_PARAM_FRICTION)])
	var shape: RID = PhysicsServer3D.body_get_shape(p_body, 0)
	var data: Variant = PhysicsServer3D.shape_get_data(shape)
	if PhysicsServer3D.shape_get_type(shape) == PhysicsServer3D.SHAPE_BOX:
		var half: Vector3 = data
		_store([0.0, half.x, half.y, half.z])
	else:
		var capsule: Dictionary = data
		_store([1.0, capsule["radius"], capsule["height"] / 2.0 - capsule["radius"], 0.0])
	_store_place(PhysicsServer3D.body_get_shape_transform(p_body, 0))
	_store_place(PhysicsServer3D.body_get_state(p_body, PhysicsServer3D.BODY_STATE_TRANSFORM))


## A place: 3 numbers, and 4 of its rotation.
func _store_place(p_place: Transform3D) -> void:
	var turn: Quaternion = p_place.basis.get_rotation_quaternion()
	_store([p_place.origin.x, p_place.origin.y, p_place.origin.z, turn.x, turn.y, turn.z, turn.w])


func _store(p_numbers: Array) -> void:
	_file.store_buffer(PackedFloat32Array(p_numbers).to_byte_array())
