@tool
class_name RagdollBuilder
extends RefCounted
## Gives a skeleton the physical bones of a [RagdollProfile].
##
## Each body has the axes of its bone and its origin (the centre of mass) in the middle of its
## shape. Joints are not made here, but by [RagdollMotor].

## Name of the node that holds the bones.
const SIMULATOR: StringName = &"PhysicalBoneSimulator3D"
## Friction of clothes and boots.
const FRICTION: float = 0.8


## Makes a [PhysicalBoneSimulator3D] with a [PhysicalBone3D] per limb, adds it to the skeleton and
## returns it; on a fault it reports an error and returns null. [param p_owner] is the scene that
## will save them, or null. The profile's frame must be the figure's: see [RestSkeleton].
static func build(
	p_skeleton: Skeleton3D, p_profile: RagdollProfile, p_owner: Node = null
) -> PhysicalBoneSimulator3D:
	var simulator: PhysicalBoneSimulator3D = make(p_skeleton, p_profile)
	if simulator != null:
		add(p_skeleton, simulator, p_owner)
	return simulator


## Adds such bones to a skeleton and to the scene that will save them.
static func add(
	p_skeleton: Skeleton3D, p_simulator: PhysicalBoneSimulator3D, p_owner: Node
) -> void:
	p_skeleton.add_child(p_simulator)
	p_simulator.owner = p_owner
	for node: Node in p_simulator.find_children("*", "", true, false):
		node.owner = p_owner


## The same bones as [method build], not added to anything yet.
static func make(p_skeleton: Skeleton3D, p_profile: RagdollProfile) -> PhysicalBoneSimulator3D:
	var fault: String = p_profile.find_fault()
	if fault == "":
		for limb: RagdollLimb in p_profile.limbs:
			if p_skeleton.find_bone(limb.bone) < 0:
				fault = "the skeleton has no bone %s" % limb.bone
				break
	if fault != "":
		push_error("The ragdoll cannot be built: %s." % fault)
		return null
	var simulator: PhysicalBoneSimulator3D = PhysicalBoneSimulator3D.new()
	simulator.name = SIMULATOR
	var figure: RestSkeleton = RestSkeleton.new(p_skeleton)
	for limb: RagdollLimb in p_profile.limbs:
		var bone: PhysicalBone3D = _make_bone(limb, p_profile.mass)
		# The offset takes the skeleton's scale away: bodies have none.
		var rest: Transform3D = figure.scaled_rest(limb.bone)
		bone.body_offset = rest.affine_inverse() * RestSkeleton.body_of(limb)
		simulator.add_child(bone)
	return simulator


## The shape of a limb for the physics engine.
static func make_shape(p_limb: RagdollLimb) -> Shape3D:
	if p_limb.type == RagdollLimb.BOX:
		var box: BoxShape3D = BoxShape3D.new()
		box.size = p_limb.size
		return box
	var capsule: CapsuleShape3D = CapsuleShape3D.new()
	capsule.radius = p_limb.radius
	capsule.height = p_limb.length + 2.0 * p_limb.radius
	return capsule


## Pairs of bones whose limbs are closer than [constant LimbDistance.GAP] in the reset pose though
## no joint connects them: each an array of two names. They would push each other all the time.
static func overlaps(p_profile: RagdollProfile) -> Array[Array]:
	return LimbDistance.overlaps(p_profile)


static func _make_bone(p_limb: RagdollLimb, p_mass: float) -> PhysicalBone3D:
	var bone: PhysicalBone3D = PhysicalBone3D.new()
	bone.name = p_limb.bone
	bone.bone_name = p_limb.bone
	bone.joint_type = PhysicalBone3D.JOINT_TYPE_NONE
	bone.mass = p_mass * p_limb.mass_fraction
	bone.friction = FRICTION
	bone.can_sleep = false
	bone.linear_damp_mode = PhysicalBone3D.DAMP_MODE_REPLACE
	bone.linear_damp = 0.0
	bone.angular_damp_mode = PhysicalBone3D.DAMP_MODE_REPLACE
	bone.angular_damp = 0.0
	bone.collision_layer = PhysicsLayers.PEOPLE
	bone.collision_mask = PhysicsLayers.ALL
	var shape: CollisionShape3D = CollisionShape3D.new()
	shape.name = "Shape"
	shape.shape = make_shape(p_limb)
	var turn: Quaternion = p_limb.rest_orientation.inverse() * p_limb.orientation
	shape.transform = Transform3D(Basis(turn), Vector3.ZERO)
	bone.add_child(shape)
	return bone
