@tool
class_name Ragdoll
extends RagdollFigure
## A person made of physical bodies that follow live motion.
##
## Place it in a scene with a [Skeleton3D] (humanoid bone names) below it, then call
## [method start] on the server. The bodies come from the [PhysicalBone3D]s of the scene, which a
## designer may edit; [RagdollBuilder] makes them. Frames: Godot's, metres, N, N·m, seconds.

## Group of all people.
const PEOPLE: StringName = &"people"

## How the hips' travel is found and how they follow it.
@export var root_mode: RagdollMotor.RootMode = RagdollMotor.ROOT_SOFT
## How the limbs follow the motion.
@export var actuation: RagdollMotor.Actuation = RagdollMotor.VELOCITY_MOTOR
## Grounded: greatest horizontal force from outside, as a share of the weight.
@export_range(0.0, 1.0, 0.01) var residual_share: float = 0.06
## Grounded: greatest torque that keeps the hips of somebody upright who stands, and is to give way
## when pushed. While the feet move, [member root_torque] holds.
@export_range(0.0, 5000.0, 10.0, "suffix:Nm") var standing_torque: float = 240.0
## Scales the torque of every joint: 1 is a strong adult, 0 is limp.
@export_range(0.0, 4.0, 0.01) var strength: float = 1.0
## Scales the inertia of trunk and legs, which bear the other limbs: 6 keeps a body that stands calm
## and exact at 60 ticks/s.
@export_range(1.0, 10.0, 0.1) var inertia_scale: float = 6.0
## Scales the inertia of head and arms.
@export_range(1.0, 10.0, 0.1) var arm_inertia_scale: float = 2.5
## How fast errors are corrected; never above one error per tick. 30 is calmer under noise.
@export_range(1.0, 240.0, 1.0, "suffix:1/s") var gain: float = 50.0
## Speed of the motion at which a joint has hardly any torque left besides what the motion needs, as
## in muscles: a blow pushes no more than an arm can. 0 leaves it all torque at any speed.
@export_range(0.0, 60.0, 0.5, "suffix:rad/s") var muscle_speed: float = 8.0
## Greatest depth to which targets of arms and legs may lie in the own body; what lies deeper in the
## motion is moved out. 1 leaves the motion as it is.
@export_range(0.0, 1.0, 0.001, "suffix:m") var self_overlap: float = 0.01
## Whether the person's own limbs collide with each other.
@export var self_collision: bool = false
## Whether joints are limited to what people's joints can do.
@export var anatomical_limits: bool = false
## Ways to control the limbs that [method RagdollMotor.invoke_control_profile] finds by their names.
@export var control_profiles: Array[RagdollControlProfile] = [
	preload("res://assets/control/standing.tres"),
	preload("res://assets/control/wounded_left_arm.tres"),
	preload("res://assets/control/wounded_right_arm.tres"),
	preload("res://assets/control/limp_legs.tres"),
]

@warning_ignore("unused_private_class_variable")
@export_tool_button("Make bodies", "PhysicalBone3D") var _make_button: Callable = make_bodies

## On a client, where the skeleton's own bones rest: says where a bone is shown.
## [code]func(bone: int) -> Transform3D[/code], in the world.
var shown_bone: Callable = Callable()
## Drives the bodies; null until [method start].
var motor: RagdollMotor = null

var _bodies: Array[RID] = []
var _hips: PhysicalBone3D = null
var _is_fitted: bool = false
## Bones of the limbs in the profile's order, as far as they were found already.
var _bones: Array[PhysicalBone3D] = []
## Bodies in the rest pose, in the profile's order, in model space, as far as they were found.
var _rests: Array[Transform3D] = []


func _init() -> void:
	add_to_group(PEOPLE)


func _get_configuration_warnings() -> PackedStringArray:
	var warnings: PackedStringArray = _find_obstacles()
	if RagdollMotor.find_physics_problem() != "":
		warnings.append(RagdollMotor.find_physics_problem())
	if profile != null:
		for pair: Array in RagdollBuilder.overlaps(profile):
			var text: String = "%s and %s touch in the reset pose: make one of them smaller."
			warnings.append(text % pair)
	if is_inside_tree() and not global_basis.get_scale().is_equal_approx(Vector3.ONE):
		warnings.append("It is scaled, bodies cannot be: set its scale to 1, scale the character.")
	if get_skeleton() != null and SkinnedSurface.find_meshes(get_skeleton()).is_empty():
		warnings.append(
			(
				"No skinned mesh belongs to the skeleton: 'Make bodies' takes the thickness of an "
				+ "average adult. Add a MeshInstance3D whose 'Skeleton' is this one."
			)
		)
	return warnings


## Where a bone is shown in the world, on a server and on a client. The identity where there is none
## of that name.
func get_bone_transform(p_bone: StringName) -> Transform3D:
	var skeleton: Skeleton3D = get_skeleton()
	var bone: int = skeleton.find_bone(p_bone) if skeleton != null else -1
	if bone < 0:
		return Transform3D.IDENTITY
	if shown_bone.is_valid():
		return shown_bone.call(bone)
	if motor != null:
		return BoneTransforms.of(skeleton, get_simulator(), bone)
	return skeleton.global_transform * skeleton.get_bone_global_pose(bone)


## Gives the skeleton its physical bones, replacing those it may have. Without a profile one is
## made from the skeleton and the skinned meshes below this node. The button in the inspector
## calls it; the editor can undo it.
func make_bodies() -> void:
	var skeleton: Skeleton3D = get_skeleton()
	if skeleton == null:
		push_error("%s has no Skeleton3D below it: add a rigged character first." % name)
		return
	stop()
	var described: RagdollProfile = profile
	if described == null:
		described = SkeletonShapes.describe(skeleton)
	var made: PhysicalBoneSimulator3D = null
	if described != null:
		made = RagdollBuilder.make(skeleton, described)
	if made == null:
		return
	var former: PhysicalBoneSimulator3D = get_simulator()
	if Engine.is_editor_hint() and is_inside_tree():
		_put_bodies_with_undo(described, made, former)
		return
	_put_bodies(described, made)
	if former != null:
		former.free()


## Gives the body the size of a person, once and before [method start]: the lengths of the limbs,
## m, in the order of [constant Limbs.BONES], 0 where one is not known, and the height of the hips
## when standing, m, 0 where it is not known. What is not known follows from the rest; where no
## length is, the body stays as it is. See [BodyScale] for what the lengths mean. Returns whether it
## has changed.
func fit(p_lengths: PackedFloat32Array, p_hip_height: float = 0.0) -> bool:
	return _can_fit() and _fit(BodyScale.of_lengths(self, p_lengths, p_hip_height))


## Gives the body the size of another whose joints are given, see [method get_joints]: on a client.
## Returns whether it has changed.
func fit_to(p_joints: PersonSkeleton) -> bool:
	return _can_fit() and _fit(BodyScale.between(get_joints(), p_joints))


## The same as [method fit] in parts and without the skin, for a server that must not stand still:
## call [method RagdollFit.advance] until it is done. Null where nothing is to be changed.
func begin_fit(p_lengths: PackedFloat32Array, p_hip_height: float = 0.0) -> RagdollFit:
	if not _can_fit():
		return null
	var scale: BodyScale = BodyScale.of_lengths(self, p_lengths, p_hip_height)
	if scale.is_none():
		return null
	_is_fitted = true
	return RagdollFit.begin(self, scale, false)


## Starts the simulation; restarts it if it runs. The node must be in the tree. Returns false (and
## reports an error) if the scene lacks something.
func start() -> bool:
	if _bones.is_empty() and not check():
		return false
	var bones: Array[PhysicalBone3D] = _bones
	_bones = []
	stop()  # Two motors would pull at the same bodies.
	get_simulator().physical_bones_start_simulation()
	_bodies.clear()
	_hips = bones[0]
	for i: int in bones.size():
		# Otherwise the body would be put back to where the bone rests at the end of the frame.
		bones[i].force_update_transform()
		_bodies.append(bones[i].get_rid())
	return _start_motor(bones)


## Whether it can be started; reports an error if not. Callers that cannot wait call it some time
## before [method start], which then need not check again.
func check() -> bool:
	var obstacles: PackedStringArray = _find_obstacles()
	if not obstacles.is_empty():
		push_error("%s cannot start: %s" % [name, obstacles[0]])
		return false
	_bones = _find_bones()
	return not _bones.is_empty()


## Finds where the bodies are at rest, as [method check] finds them. Callers that cannot wait call
## it after that and after fitting; then [method get_joints] and [method start] need not search
## again.
func measure_rests() -> void:
	_rests = BodyRests.find(get_skeleton(), profile.limbs, _bones)


## Ends the simulation: the joints and the motor go, the bodies rest where the skeleton has them.
func stop() -> void:
	if motor != null:
		motor.release()
		motor.queue_free()
		motor = null
		_bodies.clear()
		if get_simulator() != null:
			get_simulator().physical_bones_stop_simulation()


## Bodies of the limbs, in the profile's order; empty unless started.
func get_bodies() -> Array[RID]:
	return _bodies


## Where the body of the hips is, m; once started.
func get_hips() -> Vector3:
	return _hips.global_position


## Nodes of the limbs' bodies, in the order of [constant Limbs.BONES]; empty where one is missing.
func get_limb_nodes() -> Array[PhysicsBody3D]:
	var nodes: Array[PhysicsBody3D] = []
	for bone: StringName in Limbs.BONES:
		var node: PhysicsBody3D = get_simulator().get_node_or_null(NodePath(bone)) as PhysicsBody3D
		if node != null:
			nodes.append(node)
	return nodes if nodes.size() == Limbs.COUNT else ([] as Array[PhysicsBody3D])


## How the bodies hang together: what a client needs to place them by their orientations alone. Null
## where the profile does not have all limbs.
func get_joints() -> PersonSkeleton:
	var order: PackedInt32Array = get_limb_order()
	if order.has(-1):
		return null
	var rests: Array[Transform3D] = _rests
	if rests.is_empty():
		rests = BodyRests.find(get_skeleton(), profile.limbs, _find_bones())
	return BodyRests.joints_of(profile.limbs, order, rests)


## Takes a sample of the motion and returns whether it was usable. [param p_time_s] is in the
## wearer's clock; [param p_root] is the target of the hips in the world, m. Known rates are used.
func push_sample(p_time_s: float, p_sample: PoseSample, p_root: Vector3) -> bool:
	var rates: PackedFloat32Array = PackedFloat32Array()
	if p_sample.details != null and p_sample.details.knows_all_rates():
		rates = LimbRates.of(p_sample, profile)
	return motor.push_sample(p_time_s, p_sample.orientations, p_root, rates)


## Sets the motors for the next step, from a [method Node._physics_process]. Many people are driven
## by one call of [method RagdollMotor.drive_all].
func drive(p_time_s: float, p_delta_s: float) -> void:
	motor.drive(p_time_s, p_delta_s)


func _can_fit() -> bool:
	var is_whole: bool = not _bones.is_empty() or _find_obstacles().is_empty()
	if _is_fitted or motor != null or not is_whole:
		Log.warning("actor", "%s cannot be given another size" % name)
		return false
	return not get_limb_order().has(-1)


func _fit(p_scale: BodyScale) -> bool:
	if p_scale.is_none():
		return false
	_is_fitted = true
	RagdollFit.apply(self, p_scale)
	return true


## Replaces the bodies that are there, which are taken out of the tree. Either may be null.
func _put_bodies(p_profile: RagdollProfile, p_simulator: PhysicalBoneSimulator3D) -> void:
	if get_simulator() != null:
		get_skeleton().remove_child(get_simulator())
	profile = p_profile
	if p_simulator != null:
		RagdollBuilder.add(get_skeleton(), p_simulator, owner if owner != null else self)
	update_configuration_warnings()


func _put_bodies_with_undo(
	p_profile: RagdollProfile, p_made: PhysicalBoneSimulator3D, p_former: PhysicalBoneSimulator3D
) -> void:
	# By name, as exported programs do not know these classes.
	var undo: Object = Engine.get_singleton(&"EditorInterface").call(&"get_editor_undo_redo")
	undo.call(&"create_action", "Make bodies of %s" % name, UndoRedo.MERGE_DISABLE, self)
	undo.call(&"add_do_method", self, &"_put_bodies", p_profile, p_made)
	undo.call(&"add_do_reference", p_made)
	undo.call(&"add_undo_method", self, &"_put_bodies", profile, p_former)
	if p_former != null:
		undo.call(&"add_undo_reference", p_former)
	undo.call(&"commit_action")


## What the simulation needs and the scene lacks.
func _find_obstacles() -> PackedStringArray:
	var obstacles: PackedStringArray = []
	if profile == null:
		obstacles.append(
			"It has no profile: load one, or press 'Make bodies' to make one from the character."
		)
	elif profile.find_fault() != "":
		obstacles.append("The profile has a fault: %s." % profile.find_fault())
	var skeleton: Skeleton3D = get_skeleton()
	if skeleton == null:
		obstacles.append("There is no Skeleton3D below it: add a rigged character.")
	elif RestSkeleton.new(skeleton).find_fault() != "":
		obstacles.append(RestSkeleton.new(skeleton).find_fault() + ".")
	elif get_simulator() == null:
		obstacles.append("The skeleton has no physical bones: press 'Make bodies'.")
	return obstacles


func _find_bones() -> Array[PhysicalBone3D]:
	var by_name: Dictionary[StringName, PhysicalBone3D] = {}
	for child: Node in get_simulator().get_children():
		if child is PhysicalBone3D:
			by_name[StringName((child as PhysicalBone3D).bone_name)] = child
	var bones: Array[PhysicalBone3D] = []
	for limb: RagdollLimb in profile.limbs:
		if not by_name.has(limb.bone) or Limbs.find(limb.bone) < 0:
			push_error("%s cannot start: no PhysicalBone3D for the limb %s." % [name, limb.bone])
			return []
		bones.append(by_name[limb.bone])
	return bones


func _start_motor(p_bones: Array[PhysicalBone3D]) -> bool:
	var centres: PackedVector3Array = []
	var slots: PackedInt32Array = []
	var limbs: Array[RagdollLimb] = profile.limbs
	var rests: Array[Transform3D] = (
		_rests if not _rests.is_empty() else BodyRests.find(get_skeleton(), profile.limbs, p_bones)
	)
	_rests = []
	for i: int in p_bones.size():
		centres.append((rests[i].origin - limbs[i].anchor) * rests[i].basis)
		slots.append(Limbs.find(limbs[i].bone))
	motor = RagdollMotor.new()
	motor.gain = gain
	motor.muscle_speed = muscle_speed
	motor.root_mode = root_mode
	motor.root_force = root_force
	motor.root_torque = root_torque
	motor.residual_share = residual_share
	motor.standing_torque = standing_torque
	motor.inertia_scale = inertia_scale
	motor.arm_inertia_scale = arm_inertia_scale
	motor.self_overlap = self_overlap
	motor.self_collision = self_collision
	motor.anatomical_limits = anatomical_limits
	motor.sample_slots = slots
	motor.control_profiles = control_profiles
	add_child(motor)
	if not motor.setup(profile, _bodies, centres, get_world_3d().space):
		return false
	motor.set_actuation(actuation)
	motor.set_group_strength(strength)
	return true
