extends TestCase
## The way from an animated skeleton to poses: of the soldier, and of characters with any axes.

const RestSamples: GDScript = preload("rest_samples.gd")

var _root: Node3D = null


func before_each() -> void:
	_root = Node3D.new()
	add_child(_root)


func after_each() -> void:
	_root.free()


func test_the_rest_pose_is_the_way_from_the_t_pose() -> void:
	for axes: int in 4:
		var person: Ragdoll = _person(axes)
		var pose: PoseSample = SkeletonMotion.new(person.get_skeleton(), person).sample()
		equal(pose.find_fault(), "")
		var figure: RestSkeleton = RestSkeleton.new(person.get_skeleton())
		for limb: int in Limbs.COUNT:
			var turn: Quaternion = Limbs.rest_to_reset(limb, figure.direction(limb))
			is_true(pose.orientation(limb).angle_to(turn.inverse()) < 1e-3, Limbs.BONES[limb])
		almost_equal(pose.root, figure.rest(&"Hips").origin, 1e-4)


func test_a_limb_turns_in_the_world() -> void:
	for axes: int in 4:
		var person: Ragdoll = _person(axes)
		var skeleton: Skeleton3D = person.get_skeleton()
		var motion: SkeletonMotion = SkeletonMotion.new(skeleton, person)
		var before: PoseSample = motion.sample()
		var turn: Quaternion = Quaternion(Vector3.UP, 0.7)
		var bone: int = skeleton.find_bone(&"LeftLowerArm")
		var place: Transform3D = skeleton.global_transform * skeleton.get_bone_global_pose(bone)
		var turned: Transform3D = Transform3D(Basis(turn) * place.basis, place.origin)
		skeleton.set_bone_global_pose(bone, skeleton.global_transform.affine_inverse() * turned)
		var after: PoseSample = motion.sample()
		for limb: int in [Limbs.LEFT_UPPER_ARM, Limbs.RIGHT_LOWER_ARM]:
			is_true(after.orientation(limb).angle_to(before.orientation(limb)) < 1e-3)
		for limb: int in [Limbs.LEFT_LOWER_ARM, Limbs.LEFT_HAND]:
			var wanted: Quaternion = turn * before.orientation(limb)
			is_true(after.orientation(limb).angle_to(wanted) < 1e-3, Limbs.BONES[limb])


func test_a_copy_that_is_turned_turns_all() -> void:
	var person: Ragdoll = _person(1)
	var copy: Ragdoll = _person(1)
	var motion: SkeletonMotion = SkeletonMotion.new(copy.get_skeleton(), person)
	var before: PoseSample = motion.sample()
	var place: Transform3D = Transform3D(Basis(Vector3.UP, 1.2), Vector3(3.0, 0.5, -2.0))
	copy.transform = place
	var after: PoseSample = motion.sample()
	for limb: int in Limbs.COUNT:
		var wanted: Quaternion = Quaternion(Vector3.UP, 1.2) * before.orientation(limb)
		is_true(after.orientation(limb).angle_to(wanted) < 1e-3, Limbs.BONES[limb])
	almost_equal(after.root, place * before.root, 1e-4)


func test_a_skeleton_of_other_bones_is_refused() -> void:
	var person: Ragdoll = _person(0)
	var motion: SkeletonMotion = SkeletonMotion.new(person.get_skeleton(), person)
	equal(motion.find_fault(), "")
	var other: Skeleton3D = Skeleton3D.new()
	other.name = "Other"
	_root.add_child(other)
	contains(SkeletonMotion.new(other, person).find_fault(), "Other has no bone Hips")


## A character whose bones have axes of their own, scaled and with Z up where they are drawn.
func _person(p_axes: int) -> Ragdoll:
	var kind: RestSamples.Kind = RestSamples.Kind.new()
	kind.axes = p_axes
	kind.unit = 0.01 if p_axes > 1 else 1.0
	kind.is_z_up = p_axes > 1
	var person: Ragdoll = RestSamples.make(kind)
	_root.add_child(person)
	return person
