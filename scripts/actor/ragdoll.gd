@tool
class_name Ragdoll
extends Node3D
## A person made of physical bodies that follow live motion.
##
## Place it in a scene with a [Skeleton3D] (humanoid bone names) below it, then call
## [method start] on the server. The bodies come from the [PhysicalBone3D]s of the scene, which a
## designer may edit; [RagdollBuilder] makes them. Frames: Godot's, metres, N, N·m, seconds.

## Who moves the hips.
enum RootMode {
	## They follow the motion exactly and cannot be pushed.
	HELD,
	## They are drawn along with limited force, so that walls and other people hold them up.
	SOFT,
}

## A pause of the motion after which the body is put where it is to be, s.
const SNAP_AFTER_S: float = 1.0

## What the body is made of.
@export var description: RagdollDescription:
	set(value):
		description = value
		update_configuration_warnings()
## Who moves the hips.
@export var root_mode: RootMode = RootMode.SOFT
## Greatest force that draws the hips along. 0 leaves them to gravity.
@export_range(0.0, 10000.0, 10.0, "suffix:N") var root_force: float = 2000.0
## Greatest torque that keeps the hips upright. Below about 100 the person falls over.
@export_range(0.0, 5000.0, 10.0, "suffix:Nm") var root_torque: float = 800.0
## Scales the torque of every joint: 1 is a strong adult, 0 is limp.
@export_range(0.0, 4.0, 0.01) var strength: float = 1.0
## Scales the limbs' inertia: 3 keeps long chains of light limbs stable at 60 ticks/s.
@export_range(1.0, 10.0, 0.1) var inertia_scale: float = 3.0
## How fast errors are corrected; never above one error per tick.
@export_range(1.0, 240.0, 1.0, "suffix:1/s") var gain: float = 45.0

@export_tool_button("Make bodies", "PhysicalBone3D") var _make_button: Callable = make_bodies

## Drives the bodies; null until [method start].
var motor: RagdollMotor = null

var _joints: RagdollJoints = null
var _bodies: Array[RID] = []
var _reset_pose: Array[Quaternion] = []
var _alive_s: float = -INF


func _get_configuration_warnings() -> PackedStringArray:
	var warnings: PackedStringArray = []
	if description == null:
		warnings.append(
			"It has no description: load one, or press 'Make bodies' to make one from the skeleton."
		)
	elif description.find_fault() != "":
		warnings.append("The description has a fault: %s." % description.find_fault())
	if get_skeleton() == null:
		warnings.append("There is no Skeleton3D below it: add a rigged character.")
	elif get_simulator() == null:
		warnings.append("The skeleton has no physical bones: press 'Make bodies'.")
	return warnings


## The skeleton below this node, or null.
func get_skeleton() -> Skeleton3D:
	var found: Array[Node] = find_children("*", "Skeleton3D", true, false)
	return found[0] if not found.is_empty() else null


## The simulator that holds the physical bones, or null.
func get_simulator() -> PhysicalBoneSimulator3D:
	var skeleton: Skeleton3D = get_skeleton()
	if skeleton == null:
		return null
	# Not find_children(): every skeleton has an internal one of the engine's, which is of no use.
	for child: Node in skeleton.get_children():
		if child is PhysicalBoneSimulator3D:
			return child
	return null


## Gives the skeleton its physical bones, in place of those it may have. Without a description one
## is made from the lengths of the skeleton. The button in the inspector calls it.
func make_bodies() -> void:
	var skeleton: Skeleton3D = get_skeleton()
	if skeleton == null:
		push_error("%s has no Skeleton3D below it: add a rigged character first." % name)
		return
	if description == null:
		description = SkeletonShapes.describe(skeleton)
	if get_simulator() != null:
		get_simulator().free()
	if description != null:
		RagdollBuilder.build(skeleton, description, owner if owner != null else self)
	update_configuration_warnings()


## Starts the simulation. The node must be in the tree. Returns false (and reports an error) where
## the scene lacks something.
func start() -> bool:
	var warnings: PackedStringArray = _get_configuration_warnings()
	if not warnings.is_empty():
		push_error("%s cannot start: %s" % [name, warnings[0]])
		return false
	var bones: Array[PhysicalBone3D] = _find_bones()
	if bones.is_empty():
		return false
	get_simulator().physical_bones_start_simulation()
	_bodies.clear()
	for i: int in bones.size():
		# Otherwise the body would be put back to where the bone rests at the end of the frame.
		bones[i].force_update_transform()
		_bodies.append(bones[i].get_rid())
		_prepare_body(bones[i], description.limbs[i])
	_joints = RagdollJoints.new()
	var soft: bool = root_mode == RootMode.SOFT
	_joints.make(_specify_joints(bones), get_world_3d().space, root_force if soft else -1.0)
	return _start_motor(bones)


## Ends the simulation: the joints and the motor go, the bodies rest where the skeleton has them.
func stop() -> void:
	if motor != null:
		motor.queue_free()
		motor = null
		_joints = null
		_bodies.clear()
		get_simulator().physical_bones_stop_simulation()


## Bodies of the limbs, in the description's order; empty unless started.
func get_bodies() -> Array[RID]:
	return _bodies


## Height of the hips above the feet in the rest pose, m: scales the travel of taller wearers.
func get_hip_height() -> float:
	return description.limbs[0].anchor.y


## Takes a sample of the motion and returns whether it was usable. [param p_time_s] is in the
## wearer's clock; [param p_root] is where the hips are to be, in the world.
## Thesis section 6.2: [code]q = r i[/code], the sample times the limb's reset pose.
func push_sample(p_time_s: float, p_sample: PoseSample, p_root: Vector3) -> bool:
	var targets: PackedFloat32Array = PackedFloat32Array()
	targets.resize(description.limbs.size() * 4)
	for i: int in description.limbs.size():
		var limb: int = Limbs.find(description.limbs[i].bone)
		var target: Quaternion = p_sample.orientation(limb) * _reset_pose[i]
		targets[i * 4] = target.x
		targets[i * 4 + 1] = target.y
		targets[i * 4 + 2] = target.z
		targets[i * 4 + 3] = target.w
	return motor.push_sample(p_time_s, targets, p_root)


## Sets the motors for the next step, from a [method Node._physics_process]. After a pause longer
## than [constant SNAP_AFTER_S] the body is put into the new pose instead of being flung there.
func drive(p_time_s: float, p_delta_s: float) -> void:
	if not motor.is_stalled(p_time_s):
		if p_time_s - _alive_s > SNAP_AFTER_S:
			motor.snap_to(p_time_s)
		_alive_s = p_time_s
	motor.drive(p_time_s, p_delta_s)


func _find_bones() -> Array[PhysicalBone3D]:
	var bones: Array[PhysicalBone3D] = []
	for limb: LimbShape in description.limbs:
		var bone: PhysicalBone3D = null
		for child: Node in get_simulator().get_children():
			if child is PhysicalBone3D and (child as PhysicalBone3D).bone_name == limb.bone:
				bone = child
		if bone == null or Limbs.find(limb.bone) < 0:
			push_error("%s cannot start: no PhysicalBone3D for the limb %s." % [name, limb.bone])
			return []
		bones.append(bone)
	return bones


func _prepare_body(p_bone: PhysicalBone3D, p_limb: LimbShape) -> void:
	var body: RID = p_bone.get_rid()
	var rest: Basis = _rest(p_limb.bone).basis
	var inertia: Vector3 = RagdollBuilder.body_inertia(p_limb, rest, p_bone.mass) * inertia_scale
	PhysicsServer3D.body_set_param(body, PhysicsServer3D.BODY_PARAM_INERTIA, inertia)
	PhysicsServer3D.body_set_enable_continuous_collision_detection(body, true)
	# A person's own limbs do not collide: at the joints their shapes overlap.
	for other: RID in _bodies:
		if other != body:
			PhysicsServer3D.body_add_collision_exception(body, other)
	if p_limb.parent_bone == &"" and root_mode == RootMode.HELD:
		PhysicsServer3D.body_set_mode(body, PhysicsServer3D.BODY_MODE_KINEMATIC)


func _specify_joints(p_bones: Array[PhysicalBone3D]) -> Array[RagdollJoints.Spec]:
	var specs: Array[RagdollJoints.Spec] = []
	for i: int in p_bones.size():
		var limb: LimbShape = description.limbs[i]
		var spec: RagdollJoints.Spec = RagdollJoints.Spec.new()
		var body: Transform3D = _rest(limb.bone) * p_bones[i].body_offset
		var joint: Transform3D = Transform3D(body.basis, _rest(limb.bone).origin)
		spec.body = _bodies[i]
		spec.frame_b = body.affine_inverse() * joint
		var parent: int = _parent_of(i)
		if parent < 0:
			spec.frame_a = Transform3D.IDENTITY
			spec.torque = root_torque if root_mode == RootMode.SOFT else 0.0
		else:
			var above: PhysicalBone3D = p_bones[parent]
			var parent_body: Transform3D = _rest(above.bone_name) * above.body_offset
			spec.parent = _bodies[parent]
			spec.frame_a = parent_body.affine_inverse() * joint
			spec.torque = Limbs.TORQUES[Limbs.find(limb.bone)] * strength
		specs.append(spec)
	return specs


func _start_motor(p_bones: Array[PhysicalBone3D]) -> bool:
	var parents: PackedInt32Array = []
	var anchors: PackedVector3Array = []
	var offsets: PackedVector3Array = []
	_reset_pose.clear()
	for i: int in p_bones.size():
		var bone: StringName = description.limbs[i].bone
		var parent: int = _parent_of(i)
		parents.append(parent)
		offsets.append(p_bones[i].body_offset.origin)
		var above: Transform3D = _rest(description.limbs[maxi(parent, 0)].bone)
		anchors.append(above.affine_inverse() * _rest(bone).origin)
		var limb: int = Limbs.find(bone)
		var turn: Quaternion = Limbs.rest_to_reset(limb, _limb_direction(limb))
		_reset_pose.append(turn * _rest(bone).basis.get_rotation_quaternion())
	motor = RagdollMotor.new()
	motor.gain = gain
	var held: bool = root_mode == RootMode.HELD
	motor.root_mode = RagdollMotor.ROOT_HELD if held else RagdollMotor.ROOT_SOFT
	add_child(motor)
	_alive_s = -INF
	return motor.setup(_bodies, _joints.rids, parents, anchors, offsets)


func _parent_of(p_limb: int) -> int:
	var parent_bone: StringName = description.limbs[p_limb].parent_bone
	for i: int in description.limbs.size():
		if description.limbs[i].bone == parent_bone:
			return i
	return -1


## Rest pose of a bone in the skeleton.
func _rest(p_bone: StringName) -> Transform3D:
	var skeleton: Skeleton3D = get_skeleton()
	return skeleton.get_bone_global_rest(skeleton.find_bone(p_bone)).orthonormalized()


func _limb_direction(p_limb: int) -> Vector3:
	var skeleton: Skeleton3D = get_skeleton()
	for tail: StringName in Limbs.TAILS[p_limb]:
		if skeleton.find_bone(tail) >= 0:
			return _rest(tail).origin - _rest(Limbs.BONES[p_limb]).origin
	return Vector3.ZERO
