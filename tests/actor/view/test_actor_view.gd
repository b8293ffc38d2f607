extends TestCase
## What a client draws lies exactly where the server's bodies are.

const NetSamples: GDScript = preload("res://tests/net/net_samples.gd")
const Stage: GDScript = preload("res://tests/actor/ragdoll/stage.gd")
const FastPhysics: GDScript = preload("res://tests/actor/ragdoll/fast_physics.gd")
const SOLDIER: PackedScene = preload("res://scenes/actor/soldier.tscn")

var _node: Ragdoll = null
var _view: ActorView = null
var _joints: PersonSkeleton = null
var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func before_each() -> void:
	_random.seed = 1
	_node = SOLDIER.instantiate()
	add_child(_node)
	_joints = _node.get_joints()
	_view = ActorView.new(_node, _joints)


func after_each() -> void:
	_node.free()


func test_bones_lie_where_the_bodies_are() -> void:
	for _round: int in 20:
		var bodies: Dictionary[StringName, Transform3D] = {}
		for limb: int in Limbs.COUNT:
			bodies[Limbs.BONES[limb]] = Transform3D(
				Basis(NetSamples.rotation(_random)), NetSamples.vector(_random, 20.0)
			)
		is_true(_view.pose_floats(_floats(bodies)))
		_check(bodies)


func test_the_node_may_stand_anywhere() -> void:
	_node.transform = NetSamples.transform(_random)
	var bodies: Dictionary[StringName, Transform3D] = {}
	for limb: int in Limbs.COUNT:
		bodies[Limbs.BONES[limb]] = NetSamples.transform(_random)
	is_true(_view.pose_floats(_floats(bodies)))
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
	is_true(_view.pose_floats(_floats(bodies)))
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
		bodies[Limbs.BONES[limb]] = NetSamples.transform(_random)
	is_true(_view.pose_floats(_floats(bodies)))
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
		is_true(_view.pose_floats(_floats(bodies)))
		for mesh: MeshInstance3D in SkinnedSurface.find_meshes(_node.get_skeleton()):
			var box: AABB = mesh.global_transform * mesh.custom_aabb
			for offset: Vector3 in [Vector3.ZERO, Vector3.UP, Vector3.LEFT, Vector3.FORWARD]:
				is_true(box.has_point(place + offset), "%s is in %s" % [place + offset, box])
			is_true(box.size.length() < 20.0, "%s is no larger than needed" % box)


func test_a_smoothers_person_is_shown_as_its_floats_are() -> void:
	var smoother: SnapshotSmoother = SnapshotSmoother.new()
	smoother.set_skeleton(5, _joints.parents, _joints.joints_in_parent, _joints.joints_in_limb)
	is_false(_view.pose(smoother, 5), "nothing has come")
	var sample: PoseSample = NetSamples.pose(_random)
	for tick: int in 10:
		smoother.push_person(5, tick, tick / 60.0, sample.root, sample.orientations)
	smoother.evaluate(9.0 / 60.0)
	is_true(_view.pose(smoother, 5))
	var shown: Array[Transform3D] = _bones()
	_view.pose_floats(_floats(_rest_bodies()))
	is_false(shown[3].is_equal_approx(_bones()[3]))
	is_true(_view.pose_floats(smoother.person_transforms(5)))
	for bone: int in shown.size():
		almost_equal(_bones()[bone], shown[bone], 1e-4)
	for person: int in [6, -1, 70000]:
		is_false(_view.pose(smoother, person))
	is_false(_view.pose(null, 5))


func test_what_is_no_pose_moves_nothing() -> void:
	var good: PackedFloat32Array = _floats(_rest_bodies())
	is_true(_view.pose_floats(good))
	var before: Array[Transform3D] = _bones()
	is_false(_view.pose_floats([]))
	is_false(_view.pose_floats(good.slice(1)))
	for bad: float in [NAN, INF, -INF]:
		for index: int in [0, 50, 111]:
			var floats: PackedFloat32Array = good.duplicate()
			floats[index] = bad
			is_false(_view.pose_floats(floats))
	var none: PackedFloat32Array = good.duplicate()
	for index: int in range(3, 7):
		none[index] = 0.0
	is_false(_view.pose_floats(none))
	equal(_bones(), before)


func test_a_skeleton_that_is_none_is_not_posed() -> void:
	var view: ActorView = ActorView.new(_node, PersonSkeleton.new())
	is_false(view.pose_floats(_floats(_rest_bodies())))
	var poser: SkeletonPoser = SkeletonPoser.new()
	var skeleton: Skeleton3D = _node.get_skeleton()
	var offsets: Array[Transform3D] = [Transform3D.IDENTITY, Transform3D.IDENTITY]
	var turns: PackedFloat32Array = [0, 0, 0, 1, 0, 0, 0, 1]
	is_true(poser.setup(skeleton, [0, 1], offsets, turns))
	is_false(poser.setup(null, [0, 1], offsets, turns))
	is_false(poser.setup(skeleton, [0, 100000], offsets, turns))
	is_false(poser.setup(skeleton, [0, 1], offsets.slice(1), turns))
	is_false(poser.setup(skeleton, [0, 1], offsets, [0, 0, 0, 1, 0, 0, 0, NAN]))
	is_false(poser.pose_floats(skeleton, [0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1]))
	# A limb without a bone is left out.
	is_true(poser.setup(skeleton, [0, -1], offsets, turns))
	is_true(poser.pose_floats(skeleton, [1, 2, 3, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1]))
	almost_equal(poser.get_root(), Vector3(1.0, 2.0, 3.0), 1e-5)
	for neck: int in [-1, 0, 5000]:
		is_false(poser.set_neck(skeleton, neck, 0))


func test_neck_takes_half_of_the_heads_turn() -> void:
	var skeleton: Skeleton3D = _node.get_skeleton()
	var turn: Quaternion = Quaternion(Vector3.UP, deg_to_rad(60.0))
	var bodies: Dictionary[StringName, Transform3D] = _rest_bodies()
	bodies[&"Head"].basis = Basis(turn) * bodies[&"Head"].basis
	is_true(_view.pose_floats(_floats(bodies)))
	var neck: int = skeleton.find_bone("Neck")
	var before: Quaternion = skeleton.get_bone_global_rest(neck).basis.get_rotation_quaternion()
	var after: Quaternion = _global(neck).basis.get_rotation_quaternion()
	almost_equal(rad_to_deg(before.angle_to(after)), 30.0, 1.0)


## Thesis 6.4: the palette follows from the limbs' global poses alone, without a hierarchy; the
## engine's skeleton, driven bone by bone, comes to the same.
func test_the_palette_is_what_the_engines_skeleton_comes_to() -> void:
	_node.transform = Transform3D(Basis(Vector3.UP, 0.7), Vector3(2.0, 0.3, -1.0))
	var skeleton: Skeleton3D = _node.get_skeleton()
	is_true(_view.set_hands("grip", 1))
	var mesh: MeshInstance3D = SkinnedSurface.find_meshes(skeleton)[0]
	var skin: Skin = mesh.get_skin_reference().get_skin()
	equal(_view.poser.get_palette_size(0), skin.get_bind_count())
	equal(_view.poser.get_palette_size(1), 0, "the meshes share a skin")
	for _round: int in 20:
		var bodies: Dictionary[StringName, Transform3D] = {}
		for limb: StringName in Limbs.BONES:
			bodies[limb] = NetSamples.transform(_random)
		is_true(_view.pose_floats(_floats(bodies)))
		_view.write_skeleton()
		for bind: int in skin.get_bind_count():
			var name: StringName = skin.get_bind_name(bind)
			var bone: int = skin.get_bind_bone(bind) if name == &"" else skeleton.find_bone(name)
			var theirs: Transform3D = skeleton.get_bone_global_pose(bone) * skin.get_bind_pose(bind)
			var ours: Transform3D = _view.poser.get_palette_entry(0, bind)
			almost_equal(ours.origin, theirs.origin, 2e-3, name)
			for axis: int in 3:
				almost_equal(ours.basis[axis], theirs.basis[axis], 1e-4, name)


func test_fingers_bend_towards_the_palm() -> void:
	var skeleton: Skeleton3D = _node.get_skeleton()
	var before: Dictionary[StringName, Vector3] = {}
	is_true(_view.set_hands("open"))
	_view.pose_floats(_floats(_rest_bodies()))
	for side: String in ["Left", "Right"]:
		for finger: String in ["Index", "Middle", "Ring", "Little"]:
			var tip: StringName = "%s%sDistal" % [side, finger]
			before[tip] = _global(skeleton.find_bone(tip)).origin
	is_true(_view.set_hands("fist"))
	_view.pose_floats(_floats(_rest_bodies()))
	for tip: StringName in before:
		var moved: Vector3 = _global(skeleton.find_bone(tip)).origin - before[tip]
		# The arms hang aslant, palms down and inwards: a fist goes down and to the middle.
		is_true(moved.length() > 0.03, "%s moves by %s" % [tip, moved])
		is_true(moved.y < 0.0 or signf(moved.x) != signf(before[tip].x), "%s: %s" % [tip, moved])
	is_false(_view.set_hands("salute"))


func test_the_wearer_sees_no_head_but_its_shadow() -> void:
	var heads: Array[Node] = _node.find_children("HeadMesh", "MeshInstance3D", true, false)
	equal(heads.size(), 1)
	var head: MeshInstance3D = heads[0]
	_view.set_first_person(true)
	equal(head.cast_shadow, GeometryInstance3D.SHADOW_CASTING_SETTING_SHADOWS_ONLY)
	is_true(head.visible)
	_view.set_first_person(false)
	equal(head.cast_shadow, GeometryInstance3D.SHADOW_CASTING_SETTING_ON)


## The bodies of the rest pose.
func _rest_bodies() -> Dictionary[StringName, Transform3D]:
	var skeleton: Skeleton3D = _node.get_skeleton()
	var bodies: Dictionary[StringName, Transform3D] = {}
	for limb: StringName in Limbs.BONES:
		var rest: Transform3D = skeleton.get_bone_global_rest(skeleton.find_bone(limb))
		bodies[limb] = skeleton.global_transform * rest * _offset(limb)
	return bodies


## As the smoother gives the bodies of all limbs.
func _floats(p_bodies: Dictionary[StringName, Transform3D]) -> PackedFloat32Array:
	var floats: PackedFloat32Array = []
	for limb: int in Limbs.COUNT:
		var body: Transform3D = p_bodies[Limbs.BONES[limb]]
		var turn: Quaternion = body.basis.get_rotation_quaternion()
		turn *= _joints.reset_orientations[limb].inverse()
		floats.append_array([body.origin.x, body.origin.y, body.origin.z])
		floats.append_array([turn.x, turn.y, turn.z, turn.w])
	return floats


func _bones() -> Array[Transform3D]:
	var poses: Array[Transform3D] = []
	for bone: int in _node.get_skeleton().get_bone_count():
		poses.append(_global(bone))
	return poses


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
	return _view.poser.get_bone_transform(p_bone)


func _offset(p_limb: StringName) -> Transform3D:
	return (_node.get_simulator().get_node(NodePath(p_limb)) as PhysicalBone3D).body_offset
