extends TestCase
## The physical bones of a skeleton: masses, places, shapes, inertia and errors.

const NetSamples: GDScript = preload("res://tests/net/net_samples.gd")
const People: GDScript = preload("res://tests/mocap/people_samples.gd")
const SOLDIER: PackedScene = preload("res://scenes/actor/soldier.tscn")

var _soldier: Ragdoll = null
var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func before_each() -> void:
	_random.seed = 1
	_soldier = SOLDIER.instantiate()


func after_each() -> void:
	_soldier.free()


func test_masses_add_up_to_80_kg() -> void:
	for rebuilt: bool in [false, true]:
		var simulator: Node = _soldier.get_simulator()
		if rebuilt:
			simulator = _rebuild(_soldier.profile)
		var total: float = 0.0
		for bone: PhysicalBone3D in simulator.get_children():
			total += bone.mass
		almost_equal(total, 80.0, 0.1)


func test_another_mass() -> void:
	var profile: RagdollProfile = _soldier.profile.duplicate()
	profile.mass = 100.0
	var total: float = 0.0
	for bone: PhysicalBone3D in _rebuild(profile).get_children():
		total += bone.mass
	almost_equal(total, 100.0, 0.1)


func test_bodies_lie_in_the_middle_of_their_shapes() -> void:
	for rebuilt: bool in [false, true]:
		var simulator: Node = _soldier.get_simulator()
		if rebuilt:
			simulator = _rebuild(_soldier.profile)
		equal(simulator.get_child_count(), Limbs.COUNT)
		for bone: PhysicalBone3D in simulator.get_children():
			var limb: RagdollLimb = _soldier.profile.find(bone.bone_name)
			var body: Transform3D = _rest(bone.bone_name) * bone.body_offset
			almost_equal(body.origin, limb.position, 1e-4, bone.name)
			almost_equal(body.basis, _rest(bone.bone_name).basis, 1e-4, "axes of the bone")
			var shape: CollisionShape3D = bone.get_child(0)
			almost_equal(shape.position, Vector3.ZERO, 1e-5)
			var turn: Quaternion = (body * shape.transform).basis.get_rotation_quaternion()
			almost_equal(turn, limb.orientation, 1e-3, bone.name)
			equal(shape.shape.get_class(), RagdollBuilder.make_shape(limb).get_class())


func test_people_collide_with_world_people_and_props() -> void:
	for bone: PhysicalBone3D in _rebuild(_soldier.profile).get_children():
		equal([bone.collision_layer, bone.collision_mask], [2, 7])
		is_false(bone.can_sleep)


func test_inertia_about_the_bodys_axes() -> void:
	for _round: int in 100:
		var limb: RagdollLimb = RagdollLimb.new()
		limb.type = _random.randi_range(0, 1) as RagdollLimb.Type
		limb.orientation = NetSamples.rotation(_random)
		limb.size = NetSamples.vector(_random, 0.5).abs() + Vector3.ONE * 0.05
		limb.rest_orientation = NetSamples.rotation(_random)
		var got: Vector3 = limb.get_body_inertia(5.0)
		# The whole tensor, turned.
		var turn: Basis = Basis(limb.rest_orientation.inverse() * limb.orientation)
		var whole: Basis = turn * Basis.from_scale(limb.get_inertia(5.0)) * turn.inverse()
		almost_equal(got, Vector3(whole.x.x, whole.y.y, whole.z.z), 1e-4)


func test_faults_are_reported() -> void:
	var skeleton: Skeleton3D = Skeleton3D.new()
	add_child(skeleton)
	var children: int = skeleton.get_child_count()
	expect_error("cannot be built: there are no limbs")
	is_null(RagdollBuilder.build(skeleton, RagdollProfile.new()))
	expect_error("cannot be built: the skeleton has no bone Hips")
	is_null(RagdollBuilder.build(skeleton, _soldier.profile))
	equal(skeleton.get_child_count(), children, "nothing half built")
	skeleton.free()


func test_built_scene_can_be_saved() -> void:
	var root: Node3D = Node3D.new()
	var skeleton: Skeleton3D = _skeleton_of_a_clip()
	root.add_child(skeleton)
	skeleton.owner = root
	RagdollBuilder.build(skeleton, SkeletonShapes.describe(skeleton), root)
	var packed: PackedScene = PackedScene.new()
	equal(packed.pack(root), OK)
	var copy: Node = packed.instantiate()
	equal(copy.find_children("*", "PhysicalBone3D").size(), Limbs.COUNT)
	equal(copy.find_children("*", "CollisionShape3D").size(), Limbs.COUNT)
	copy.free()
	root.free()


func test_shapes_for_any_skeleton() -> void:
	var skeleton: Skeleton3D = _skeleton_of_a_clip()
	var profile: RagdollProfile = SkeletonShapes.describe(skeleton)
	equal(profile.find_fault(), "")
	equal(profile.limbs.size(), Limbs.COUNT)
	var arm: RagdollLimb = profile.find(&"LeftUpperArm")
	almost_equal(arm.anchor, Vector3(0.18, 1.43, 0.0), 1e-3)
	almost_equal(arm.position, Vector3(0.32, 1.43, 0.0), 1e-3)
	almost_equal(arm.length + 2.0 * arm.radius, 0.28, 1e-3)
	almost_equal(Basis(arm.orientation).y, Vector3.RIGHT, 1e-3)
	skeleton.free()


func test_skeleton_without_a_limb_is_refused() -> void:
	var skeleton: Skeleton3D = Skeleton3D.new()
	skeleton.add_bone("Hips")
	expect_error("The skeleton has no bone Spine, Chest")
	is_null(SkeletonShapes.describe(skeleton))
	skeleton.free()


func _skeleton_of_a_clip() -> Skeleton3D:
	var rig: BvhRig = BvhRig.from_clip(People.make(People.Person.new()))
	equal(rig.error, "")
	return BvhSkeleton.make(rig)


func _rebuild(p_profile: RagdollProfile) -> Node:
	_soldier.get_simulator().free()
	return RagdollBuilder.build(_soldier.get_skeleton(), p_profile)


func _rest(p_bone: StringName) -> Transform3D:
	var skeleton: Skeleton3D = _soldier.get_skeleton()
	return skeleton.get_bone_global_rest(skeleton.find_bone(p_bone)).orthonormalized()
