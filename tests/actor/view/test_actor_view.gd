extends TestCase
## What a client draws lies exactly where the server's bodies are.

const NetSamples: GDScript = preload("res://tests/net/net_samples.gd")
const Stage: GDScript = preload("res://tests/actor/ragdoll/stage.gd")
const FastPhysics: GDScript = preload("res://tests/actor/ragdoll/fast_physics.gd")
const SOLDIER: PackedScene = preload("res://scenes/actor/soldier.tscn")

var _node: Ragdoll = null
var _view: ActorView = null
var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func before_each() -> void:
	_random.seed = 1
	_node = SOLDIER.instantiate()
	add_child(_node)
	_view = ActorView.new(_node)


func after_each() -> void:
	_node.free()


func test_bones_lie_where_the_bodies_are() -> void:
	for _round: int in 20:
		var bodies: Dictionary[StringName, Transform3D] = {}
		for limb: int in Limbs.COUNT:
			bodies[Limbs.BONES[limb]] = Transform3D(
				Basis(NetSamples.rotation(_random)), NetSamples.vector(_random, 20.0)
			)
		_view.show(bodies)
		_check(bodies)


func test_the_node_may_stand_anywhere() -> void:
	_node.transform = NetSamples.place(_random)
	var bodies: Dictionary[StringName, Transform3D] = {}
	for limb: int in Limbs.COUNT:
		bodies[Limbs.BONES[limb]] = NetSamples.place(_random)
	_view.show(bodies)
	_check(bodies, 0.002)


func test_bodies_of_a_simulated_person() -> void:
	FastPhysics.start()
	var stage: Stage = Stage.new()
	add_child(stage)
	var place: Vector3 = Vector3(3.0, 1.2, -2.0)
	var player: Stage.Player = stage.add_soldier(place, RagdollMotor.ROOT_SOFT)
	player.pose = func(time: float) -> PoseSample: return Stage.arms_pose(60.0 * time, 30.0)
	await stage.run(45)
	FastPhysics.stop()
	var bodies: Dictionary[StringName, Transform3D] = {}
	for limb: int in Limbs.COUNT:
		bodies[Limbs.BONES[limb]] = player.body(limb)
	_view.show(bodies)
	_check(bodies)
	almost_equal(_view.hips(), player.joint(0), 1e-3)
	# The neck stays between chest and head.
	var skeleton: Skeleton3D = _node.get_skeleton()
	var neck: Vector3 = _global(skeleton.find_bone("Neck")).origin
	is_true(neck.distance_to(player.joint(Limbs.find(&"Head"))) < 0.2, "neck at %s" % neck)
	stage.free()


func test_stays_there_over_frames() -> void:
	var bodies: Dictionary[StringName, Transform3D] = {}
	for limb: int in Limbs.COUNT:
		bodies[Limbs.BONES[limb]] = NetSamples.place(_random)
	_view.show(bodies)
	await physics_frames(3)
	await process_frames(3)
	_check(bodies, 0.002)


## The engine leaves out what it takes for being out of view: it must look where the person is.
func test_the_box_of_what_is_visible_goes_with_the_person() -> void:
	for place: Vector3 in [Vector3.ZERO, Vector3(30.0, 2.0, -7.0), Vector3(0.0, -40.0, 500.0)]:
		var bodies: Dictionary[StringName, Transform3D] = {}
		for limb: int in Limbs.COUNT:
			var turn: Basis = Basis(NetSamples.rotation(_random))
			bodies[Limbs.BONES[limb]] = Transform3D(turn, place)
		_view.show(bodies)
		for mesh: MeshInstance3D in SkinnedSurface.find_meshes(_node.get_skeleton()):
			var box: AABB = mesh.global_transform * mesh.custom_aabb
			for offset: Vector3 in [Vector3.ZERO, Vector3.UP, Vector3.LEFT, Vector3.FORWARD]:
				is_true(box.has_point(place + offset), "%s is in %s" % [place + offset, box])
			is_true(box.size.length() < 20.0, "%s is no larger than needed" % box)


func test_parts_and_unknown_limbs() -> void:
	var place: Transform3D = NetSamples.place(_random)
	_view.show({&"Tail": place, &"Head": place, &"LeftHand": place})
	_check({&"Head": place, &"LeftHand": place}, 0.002)
	_view.show({} as Dictionary[StringName, Transform3D])


func test_neck_takes_half_of_the_heads_turn() -> void:
	var skeleton: Skeleton3D = _node.get_skeleton()
	var turn: Quaternion = Quaternion(Vector3.UP, deg_to_rad(60.0))
	var bodies: Dictionary[StringName, Transform3D] = {}
	for limb: StringName in [&"Hips", &"Spine", &"Chest", &"Head"]:
		var rest: Transform3D = skeleton.get_bone_global_rest(skeleton.find_bone(limb))
		bodies[limb] = skeleton.global_transform * rest * _offset(limb)
	bodies[&"Head"].basis = Basis(turn) * bodies[&"Head"].basis
	_view.show(bodies)
	var neck: int = skeleton.find_bone("Neck")
	var before: Quaternion = skeleton.get_bone_global_rest(neck).basis.get_rotation_quaternion()
	var after: Quaternion = skeleton.get_bone_global_pose(neck).basis.get_rotation_quaternion()
	almost_equal(rad_to_deg(before.angle_to(after)), 30.0, 1.0)


func _check(p_bodies: Dictionary, p_tolerance: float = 0.001) -> void:
	var skeleton: Skeleton3D = _node.get_skeleton()
	for limb: StringName in p_bodies:
		var shown: Transform3D = _global(skeleton.find_bone(limb)) * _offset(limb)
		var body: Transform3D = p_bodies[limb]
		almost_equal(shown.origin, body.origin, p_tolerance, limb)
		var wanted: Quaternion = body.basis.get_rotation_quaternion()
		var off: float = wanted.angle_to(shown.basis.get_rotation_quaternion())
		is_true(rad_to_deg(off) < 0.1, "%s is turned by %f deg" % [limb, rad_to_deg(off)])


func _global(p_bone: int) -> Transform3D:
	var skeleton: Skeleton3D = _node.get_skeleton()
	return skeleton.global_transform * skeleton.get_bone_global_pose(p_bone)


func _offset(p_limb: StringName) -> Transform3D:
	return (_node.get_simulator().get_node(NodePath(p_limb)) as PhysicalBone3D).body_offset
