extends TestCase
## What a client shows of a server's world, also of a broken or hostile one.

const NetSamples: GDScript = preload("../net/net_samples.gd")
const CLIENT: PackedScene = preload("res://scenes/client/client.tscn")
const SnapshotStream: GDScript = preload("res://tests/wire/snapshot_stream.gd")
const ADA: int = 3

var _client: Node = null
var _scene: ClientScene = null
var _stream: SnapshotStream = null
var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func before_each() -> void:
	_random.seed = 1
	# Only the scene: the client's own node would connect to a server.
	_client = CLIENT.instantiate()
	_scene = _client.get_node(^"Scene")
	_client.remove_child(_scene)
	_scene.owner = null
	add_child(_scene)


func after_each() -> void:
	_scene.free()
	_client.free()


func test_props_and_people_are_where_the_snapshots_have_them() -> void:
	var world: WorldDescription = _world()
	equal(_scene.apply("mesh,static,physics", ""), "")
	is_false(_scene.has_world())
	_scene.describe(world)
	is_true(_scene.has_world())
	_show([ADA], [0])
	var crate: Node3D = _scene.get_node(^"Hall/Props/Crate1")
	almost_equal(crate.global_transform, _stream.places[0], 0.01)
	var people: Node = _scene.get_node(^"People")
	equal(people.get_child_count(), 1)
	var node: Ragdoll = people.get_child(0)
	is_true(node.visible)
	var skeleton: Skeleton3D = node.get_skeleton()
	var order: int = node.get_limb_order()[Limbs.find(&"Head")]
	var reset: Quaternion = node.profile.limbs[order].reset_orientation
	var bone: PhysicalBone3D = node.get_simulator().get_node(^"Head")
	var head: Transform3D = skeleton.get_bone_global_pose(skeleton.find_bone("Head"))
	var shown: Transform3D = skeleton.global_transform * head * bone.body_offset
	var turn: Quaternion = _stream.poses[ADA].orientation(Limbs.find(&"Head"))
	almost_equal(shown.basis, Basis(turn * reset), 0.01)
	var hips: Transform3D = skeleton.get_bone_global_pose(skeleton.find_bone("Hips"))
	var pelvis: PhysicalBone3D = node.get_simulator().get_node(^"Hips")
	almost_equal((hips * pelvis.body_offset).origin, _stream.poses[ADA].root, 0.003)
	var wires: PhysicsWorld = _scene.get_node(^"PhysicsWorld")
	almost_equal(wires.get_placed(4096 + Limbs.find(&"Head")), shown, 0.01)


func test_the_own_body_is_where_it_is_told() -> void:
	_scene.describe(_world())
	_show([ADA], [0])
	var floats: PackedFloat32Array = _scene.replica.person_floats(ADA)
	for limb: int in Limbs.COUNT:
		floats[limb * WorldReplica.FLOATS] += 2.0
	_scene.update(_stream.tick / 60.0, {ADA: floats} as Dictionary[int, PackedFloat32Array])
	var node: Ragdoll = _scene.get_node(^"People").get_child(0)
	var hips: int = node.get_skeleton().find_bone("Hips")
	var pelvis: PhysicalBone3D = node.get_simulator().get_node(^"Hips")
	var place: Transform3D = node.get_skeleton().get_bone_global_pose(hips) * pelvis.body_offset
	almost_equal(place.origin, _stream.poses[ADA].root + Vector3(2.0, 0.0, 0.0), 0.003)
	equal([_scene.person_of(7), _scene.person_of(8)], [ADA, -1])


func test_people_are_shown_in_their_size() -> void:
	var people: Node = _scene.get_node(^"People")
	var world: WorldDescription = _world()
	var usual: PersonSkeleton = world.skeletons[ADA]
	for factors: Vector2 in [Vector2(0.8, 0.8), Vector2(1.13, 1.13), Vector2(0.85, 1.2)]:
		var small: Ragdoll = _scene.person_scene.instantiate()
		var lengths: PackedFloat32Array = BodyScale.own_lengths(small)
		for limb: int in Limbs.COUNT:
			lengths[limb] *= factors.x if limb < 10 else factors.y
		small.fit(lengths)
		world.skeletons[ADA] = small.get_joints()
		_scene.describe(world)
		_show([ADA], [0])
		await process_frames(2)
		equal(people.get_child_count(), 1)
		almost_equal(_scene.hips_of(ADA), small.get_hip_height(), 1e-4)
		_check_shown(people.get_child(0), lengths)
		small.free()
	world.skeletons[ADA] = usual
	_scene.describe(world)
	await process_frames(2)
	equal(people.get_child_count(), 1)
	almost_equal(_scene.hips_of(ADA), 1.0115, 1e-4)


func test_people_that_leave_are_gone() -> void:
	var world: WorldDescription = _world()
	_scene.describe(world)
	_show([ADA], [0])
	var empty: WorldDescription = WorldDescription.new()
	_scene.describe(empty)
	await process_frames(2)
	equal(_scene.get_node(^"People").get_child_count(), 0)
	_show([ADA], [0])
	equal(_scene.get_node(^"People").get_child_count(), 0)


func test_snapshot_before_the_world_and_unknown_bodies() -> void:
	_show([ADA, 9], [0, 40, 50])
	_scene.describe(_world())
	_show([ADA, 9], [0, 40, 50])
	is_true(_scene.has_world())


func test_a_hostile_server_moves_nothing_but_the_halls_props() -> void:
	var camera: Node3D = _scene.get_node(^"Camera")
	for path: String in [
		"../Camera", "..", ".", "Props/../../Camera", "/root", "", "no:such", "%x"
	]:
		var before: Array = [camera.transform, _scene.transform]
		before.append((_scene.get_node(^"Hall") as Node3D).transform)
		var world: WorldDescription = WorldDescription.new()
		world.add(0, WorldDescription.PROP, path, [])
		world.add(1, WorldDescription.PROP, str(camera.get_path()), [])
		_scene.describe(world)
		_show([], [0, 1])
		var after: Array = [camera.transform, _scene.transform]
		after.append((_scene.get_node(^"Hall") as Node3D).transform)
		equal(after, before, path)


func test_random_worlds() -> void:
	for _round: int in 20:
		var world: WorldDescription = NetSamples.world(_random, 40, 0)
		for id: int in world.bodies:
			if _random.randf() < 0.5:
				world.bodies[id].actor = ADA
		world.names.clear()
		world.add_person(ADA, 7, "Ada", NetSamples.skeleton(_random))
		_scene.describe(world)
		_show([ADA], [0, 3])
	await process_frames(2)
	equal(_scene.get_node(^"People").get_child_count(), 1)


func test_wrong_views_and_camera_are_told() -> void:
	contains(_scene.apply("mesh,sky", ""), "no world 'sky'")
	contains(_scene.apply("mesh", "1,2"), "a camera is azimuth,elevation,distance")
	equal(_scene.apply("mesh", "1,2,3"), "")
	equal(_scene.describe_views(), "1 mesh on   2 static off   3 physics off")


## The visible arms and legs are as long as they are told, whatever the pose.
func _check_shown(p_node: Ragdoll, p_lengths: PackedFloat32Array) -> void:
	var skeleton: Skeleton3D = p_node.get_skeleton()
	for limb: int in [4, 5, 7, 8, 10, 11, 13, 14]:
		var from: int = skeleton.find_bone(Limbs.BONES[limb])
		var to: int = skeleton.find_bone(Limbs.BONES[limb + 1])
		var way: Vector3 = skeleton.get_bone_global_pose(to).origin
		way -= skeleton.get_bone_global_pose(from).origin
		almost_equal(way.length(), p_lengths[limb], 0.002, Limbs.BONES[limb])
		almost_equal(skeleton.get_bone_global_pose(to).basis.get_scale(), Vector3.ONE, 1e-3)


func _world() -> WorldDescription:
	var world: WorldDescription = WorldDescription.new()
	var box: Array = [WorldDescription.ShapeType.BOX, Vector3.ONE, Transform3D.IDENTITY]
	var soldier: Ragdoll = _scene.person_scene.instantiate()
	world.add_person(ADA, 7, "Ada", soldier.get_joints())
	soldier.free()
	world.add(0, WorldDescription.PROP, "Props/Crate1", [box])
	for limb: int in Limbs.COUNT:
		world.add(4096 + limb, ADA, Limbs.BONES[limb], [box])
	return world


## Lets a new server tell of a world often enough for it to be shown, and shows it.
func _show(p_people: PackedInt32Array, p_bodies: PackedInt32Array) -> void:
	_scene.clear()
	if _scene.has_world():
		_scene.describe(_scene.replica.world)
	_stream = SnapshotStream.new(p_people, p_bodies)
	_stream.move()
	for _tick: int in 20:
		_stream.stay()
		for bytes: PackedByteArray in _stream.datagrams():
			_scene.replica.take(bytes, _stream.tick / 60.0)
		_scene.update(_stream.tick / 60.0)
