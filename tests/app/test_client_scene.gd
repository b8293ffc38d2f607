extends TestCase
## What a client shows of a server's world, also of a broken or hostile one.

const NetSamples: GDScript = preload("../net/net_samples.gd")
const CLIENT: PackedScene = preload("res://scenes/app/client.tscn")
const ADA: int = 3

var _client: Node = null
var _scene: ClientScene = null
var _tick: int = 100
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
	var snapshot: Snapshot = _snapshot(world)
	equal(_scene.apply("mesh,static,physics", ""), "")
	is_false(_scene.has_world())
	_scene.describe(world)
	is_true(_scene.has_world())
	_show(snapshot)
	var crate: Node3D = _scene.get_node(^"Hall/Props/Crate1")
	almost_equal(crate.global_transform, snapshot.bodies[0], 1e-4)
	var people: Node = _scene.get_node(^"People")
	equal(people.get_child_count(), 1)
	var node: Ragdoll = people.get_child(0)
	is_true(node.visible)
	var skeleton: Skeleton3D = node.get_skeleton()
	var head: int = skeleton.find_bone("Head")
	var bone: PhysicalBone3D = node.get_simulator().get_node(^"Head")
	var shown: Transform3D = (
		skeleton.global_transform * skeleton.get_bone_global_pose(head) * bone.body_offset
	)
	var body: int = 4096 + Limbs.find(&"Head")
	almost_equal(shown, snapshot.bodies[body], 0.002)
	equal(
		(_scene.get_node(^"PhysicsWorld") as PhysicsWorld).get_placed(body), snapshot.bodies[body]
	)
	equal(_scene.shown_sample_usec(), 777)


func test_people_that_leave_are_gone() -> void:
	var world: WorldDescription = _world()
	_scene.describe(world)
	_show(_snapshot(world))
	var empty: WorldDescription = WorldDescription.new()
	_scene.describe(empty)
	await process_frames(2)
	equal(_scene.get_node(^"People").get_child_count(), 0)
	_show(_snapshot(empty))
	equal(_scene.shown_sample_usec(), -1)


func test_snapshot_before_the_world_and_unknown_bodies() -> void:
	_show(NetSamples.snapshot(_random, 30, 3))
	_scene.describe(_world())
	_show(NetSamples.snapshot(_random, 30, 3))
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
		_show(_snapshot(world))
		var after: Array = [camera.transform, _scene.transform]
		after.append((_scene.get_node(^"Hall") as Node3D).transform)
		equal(after, before, path)


func test_random_worlds() -> void:
	for _round: int in 20:
		var world: WorldDescription = NetSamples.world(_random, 40, 0)
		for id: int in world.bodies:
			if _random.randf() < 0.5:
				world.bodies[id].actor = ADA
		world.names[ADA] = "Ada"
		_scene.describe(world)
		_show(_snapshot(world))
	await process_frames(2)
	equal(_scene.get_node(^"People").get_child_count(), 1)


func test_wrong_views_and_camera_are_told() -> void:
	contains(_scene.apply("mesh,sky", ""), "no world 'sky'")
	contains(_scene.apply("mesh", "1,2"), "a camera is azimuth,elevation,distance")
	equal(_scene.apply("mesh", "1,2,3"), "")
	equal(_scene.describe_views(), "1 mesh on   2 static off   3 physics off")


func _world() -> WorldDescription:
	var world: WorldDescription = WorldDescription.new()
	var box: Array = [WorldDescription.ShapeType.BOX, Vector3.ONE, Transform3D.IDENTITY]
	world.names[ADA] = "Ada"
	world.add(0, WorldDescription.PROP, "Props/Crate1", [box])
	for limb: int in Limbs.COUNT:
		world.add(4096 + limb, ADA, Limbs.BONES[limb], [box])
	return world


func _snapshot(p_world: WorldDescription) -> Snapshot:
	var snapshot: Snapshot = Snapshot.new()
	for id: int in p_world.bodies:
		snapshot.bodies[id] = NetSamples.place(_random)
	var mark: Snapshot.SampleMark = Snapshot.SampleMark.new()
	mark.time_usec = 777
	snapshot.samples[ADA] = mark
	return snapshot


## Pushes a snapshot often enough for it to be shown, and shows it.
func _show(p_snapshot: Snapshot) -> void:
	for _push: int in 10:
		_tick += 1
		p_snapshot.tick = _tick
		p_snapshot.tick_rate = 60
		_scene.push(p_snapshot, _tick / 60.0)
	_scene.update(_tick / 60.0)
