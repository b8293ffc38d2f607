extends TestCase
## What a client shows of a server's world, also of a broken or hostile one.

const NetSamples: GDScript = preload("res://tests/net/net_samples.gd")
const CLIENT: PackedScene = preload("res://scenes/client/client.tscn")
const SnapshotStream: GDScript = preload("res://tests/wire/snapshot_stream.gd")
const ADA: int = 3
const CRATE: int = 1024

var _client: Node = null
var _scene: ClientScene = null
var _stream: SnapshotStream = null
var _skeleton: PersonSkeleton = null
## Name of the avatar of all people.
var _avatar: String = ""
var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func before_each() -> void:
	_random.seed = 1
	# Only the scene: the client's own node would connect to a server.
	_client = CLIENT.instantiate()
	_scene = _client.get_node(^"Scene")
	_client.remove_child(_scene)
	_scene.owner = null
	add_child(_scene)
	var person: Ragdoll = _scene.person_scene.instantiate()
	_skeleton = person.get_joints()
	person.free()


func after_each() -> void:
	_scene.free()
	_client.free()


func test_props_and_people_are_where_the_snapshots_have_them() -> void:
	equal(_scene.apply("mesh,static,physics", ""), "")
	is_false(_scene.replica.is_ready())
	_show([ADA], [CRATE])
	is_true(_scene.replica.is_ready())
	var crate: Node3D = _scene.get_level().level.get_node(^"Props/Crate1")
	almost_equal(crate.global_transform, _stream.places[CRATE], 0.01)
	var people: Node = _scene.get_node(^"People")
	equal(people.get_child_count(), 1)
	var node: Ragdoll = people.get_child(0)
	is_true(node.visible)
	var order: int = node.get_limb_order()[Limbs.find(&"Head")]
	var reset: Quaternion = node.profile.limbs[order].reset_orientation
	var bone: PhysicalBone3D = node.get_simulator().get_node(^"Head")
	var shown: Transform3D = node.get_bone_transform(&"Head") * bone.body_offset
	var turn: Quaternion = _stream.poses[ADA].orientation(Limbs.find(&"Head"))
	almost_equal(shown.basis, Basis(turn * reset), 0.01)
	var hips: Transform3D = node.get_bone_transform(&"Hips")
	var pelvis: PhysicalBone3D = node.get_simulator().get_node(^"Hips")
	almost_equal((hips * pelvis.body_offset).origin, _stream.poses[ADA].root, 0.003)
	var wires: PhysicsWorld = _scene.get_node(^"PhysicsWorld")
	almost_equal(wires.get_frame_transform(ADA, Limbs.find(&"Head")), shown, 0.01)


func test_a_prop_that_is_named_late_is_placed_though_it_rests() -> void:
	_show([ADA], [CRATE])
	var crate: Node3D = _scene.get_level().level.get_node(^"Props/Crate1")
	var row: EntityRow = _scene.replica.table.find(CRATE)
	_scene.get_level().remove_entity(row)
	crate.global_position = Vector3(1.0, 2.0, 3.0)
	_scene.update(_stream.tick / 60.0)
	almost_equal(crate.global_position, Vector3(1.0, 2.0, 3.0), 1e-5)
	_scene.get_level().add_entity(row)
	_scene.update(_stream.tick / 60.0)
	almost_equal(crate.global_transform, _stream.places[CRATE], 0.01)


func test_the_own_body_is_where_it_is_reported() -> void:
	_show([ADA], [CRATE])
	var floats: PackedFloat32Array = _scene.replica.person_floats(ADA)
	for limb: int in Limbs.COUNT:
		floats[limb * WorldReplica.FLOATS] += 2.0
	_scene.update(_stream.tick / 60.0, {ADA: floats} as Dictionary[int, PackedFloat32Array])
	var node: Ragdoll = _scene.get_node(^"People").get_child(0)
	var pelvis: PhysicalBone3D = node.get_simulator().get_node(^"Hips")
	var place: Transform3D = node.get_bone_transform(&"Hips") * pelvis.body_offset
	almost_equal(place.origin, _stream.poses[ADA].root + Vector3(2.0, 0.0, 0.0), 0.003)


func test_people_are_shown_in_their_size() -> void:
	var people: Node = _scene.get_node(^"People")
	for factors: Vector2 in [Vector2(0.8, 0.8), Vector2(1.13, 1.13), Vector2(0.85, 1.2)]:
		var small: Ragdoll = _scene.person_scene.instantiate()
		var lengths: PackedFloat32Array = BodyScale.own_lengths(small)
		for limb: int in Limbs.COUNT:
			lengths[limb] *= factors.x if limb < 10 else factors.y
		small.fit(lengths)
		_skeleton = small.get_joints()
		_show([ADA], [CRATE])
		await process_frames(2)
		equal(people.get_child_count(), 1)
		almost_equal(_scene.people()[ADA].node.get_hip_height(), small.get_hip_height(), 1e-4)
		_check_shown(people.get_child(0), lengths)
		small.free()


func test_people_that_leave_are_gone() -> void:
	_show([ADA], [CRATE])
	_tell([], ["Props/Crate1"])
	await process_frames(2)
	equal(_scene.get_node(^"People").get_child_count(), 0)


func test_snapshots_before_the_table_and_unknown_bodies() -> void:
	_stream = SnapshotStream.new([ADA, 9], [CRATE, 1064])
	_stream.move()
	for bytes: PackedByteArray in _stream.datagrams():
		is_false(_scene.replica.take(bytes, 1.0))
	_scene.update(1.0)
	equal(_scene.get_node(^"People").get_child_count(), 0)


func test_a_hostile_server_moves_nothing_but_what_is_in_the_level() -> void:
	var camera: Node3D = _scene.get_node(^"Camera")
	for path: String in [
		"../../Camera",
		"..",
		".",
		"Props/../../../Camera",
		"/root",
		"",
		"no:such",
		"%x",
		"Static/Floor"
	]:
		_tell([], [path])
		var level: Node3D = _scene.get_level().level
		var before: Array = [camera.transform, _scene.transform, level.transform]
		_play([], [CRATE])
		equal([camera.transform, _scene.transform, level.transform], before, path)


func test_a_hostile_server_names_scenes_that_are_none() -> void:
	for path: String in [
		"res://scenes/client/client.tscn",
		"res://../x.tscn",
		"user://x.tscn",
		"res://project.godot",
		"res://scenes/world/props/crate.tscn",
	]:
		var row: EntityRow = _row(CRATE, path)
		row.source = EntityRow.Source.SCENE
		_tell([], [])
		var children: int = _level_child_count()
		_send([row])
		_play([], [CRATE])
		equal(_level_child_count(), children, path)


func test_a_level_that_is_not_here_is_said() -> void:
	var missing: Array[String] = []
	_scene.level_missing.connect(missing.append)
	for name: String in ["atlantis", "../hall", "", "Hall"]:
		_scene.replica.take(LevelMessage.encode(name, PackedByteArray()), 0.0)
	equal(missing.size(), 4)
	contains(missing[0], "no world 'atlantis' here: %s" % ", ".join(LevelStore.names()))


func test_a_level_that_is_another_is_said() -> void:
	var notes: Array[String] = []
	_scene.level_noted.connect(notes.append)
	_scene.replica.take(LevelMessage.encode("yard", PackedByteArray([1, 2])), 0.0)
	contains(notes[0], "'yard' is not the server's")
	is_true(_scene.get_level().differs)
	var same: PackedByteArray = LevelFingerprint.of(_scene.get_level().level)
	_scene.replica.take(LevelMessage.encode("yard", same), 0.0)
	equal(notes[1], "")
	is_false(_scene.get_level().differs)


func test_a_wrong_camera_is_reported() -> void:
	contains(_scene.apply("mesh", "1,2"), "a camera is azimuth,elevation,distance")
	equal(_scene.apply("mesh", "1,2,3"), "")
	equal(_scene.describe_views(), "1 mesh on   2 static off   3 physics off")


func test_the_camera_follows_whom_the_user_chooses() -> void:
	_show([ADA, 9], [CRATE])
	equal(_scene.view.followed(), ADA)
	_scene.view.follow_next()
	equal(_scene.view.followed(), 9)
	_scene.update(_stream.tick / 60.0)
	var camera: OrbitCamera = _scene.get_node(^"Camera")
	almost_equal(camera.target, _stream.poses[9].root, 0.01)
	_scene.view.follow_next()
	equal(_scene.view.followed(), ADA)
	_scene.view.follow_next()
	_show([ADA], [CRATE])
	equal(_scene.view.followed(), ADA, "the other one has left")


func test_another_viewport_looks_at_whom_it_chooses() -> void:
	_show([ADA, 9], [CRATE])
	var viewport: SubViewport = SubViewport.new()
	add_child(viewport)
	var other: SceneView = _scene.add_view(viewport)
	equal(viewport.world_3d, _scene.get_world_3d(), "it shows the same world")
	other.follow(9)
	_scene.update(_stream.tick / 60.0)
	almost_equal(other.camera.target, _stream.poses[9].root, 0.01)
	almost_equal(_scene.view.camera.target, _stream.poses[ADA].root, 0.01)
	_show([ADA], [CRATE])
	_scene.update(_stream.tick / 60.0)
	almost_equal(other.camera.target, _stream.poses[ADA].root, 0.01)
	_scene.remove_view(other)
	await process_frames(1)
	equal(viewport.get_child_count(), 0)
	viewport.free()


func test_a_trainee_is_followed_from_behind_but_where_a_camera_was_asked_for() -> void:
	_show([ADA, 9], [CRATE])
	var camera: OrbitCamera = _scene.get_node(^"Camera")
	_scene.view.follow_own(9, false)
	equal([_scene.view.followed(), camera.view], [9, OrbitCamera.View.AROUND])
	_scene.view.follow_own(-1, true)
	equal(camera.view, OrbitCamera.View.AROUND)
	_scene.view.follow_own(9, true)
	equal([_scene.view.followed(), camera.view], [9, OrbitCamera.View.BEHIND])
	_scene.view.change_view()
	_scene.view.follow_own(9, true)
	equal(camera.view, OrbitCamera.View.EYES, "the user's choice stays")


func test_names_are_over_heads_until_their_key_is_pressed() -> void:
	_show([ADA], [CRATE])
	# The camera comes near, and names are of those who are.
	(_scene.get_node(^"Camera") as OrbitCamera)._process(1.0)
	_play([ADA], [CRATE])
	var names: NameTags = _scene.get_node(^"Names")
	equal(names.get_child_count(), 1)
	var label: Label3D = names.get_child(0)
	equal(label.text, "Ada")
	is_true(label.is_visible_in_tree())
	var ada: Ragdoll = _scene.get_node(^"People").get_child(0)
	var head: Vector3 = ada.get_bone_transform(&"Head").origin
	almost_equal(label.global_position, head + Vector3.UP * 0.45, 1e-3)
	var event: InputEventKey = InputEventKey.new()
	event.keycode = KEY_N
	event.pressed = true
	names._unhandled_key_input(event)
	is_false(label.is_visible_in_tree())
	_tell([], [])
	equal(names.get_child_count(), 0)


## The visible arms and legs are as long as they are told, whatever the pose.
func _check_shown(p_node: Ragdoll, p_lengths: PackedFloat32Array) -> void:
	for limb: int in [4, 5, 7, 8, 10, 11, 13, 14]:
		var from: Transform3D = p_node.get_bone_transform(Limbs.BONES[limb])
		var to: Transform3D = p_node.get_bone_transform(Limbs.BONES[limb + 1])
		var way: Vector3 = to.origin - from.origin
		almost_equal(way.length(), p_lengths[limb], 0.002, Limbs.BONES[limb])
		almost_equal(to.basis.get_scale(), Vector3.ONE, 1e-3)


## Lets a new server tell of people and bodies often enough for them to be shown.
func _show(p_people: PackedInt32Array, p_bodies: PackedInt32Array) -> void:
	var paths: PackedStringArray = []
	for _body: int in p_bodies:
		paths.append("Props/Crate1")
	_tell(p_people, paths)
	_play(p_people, p_bodies)


func test_people_are_shown_as_the_server_names_them() -> void:
	for name: String in ["show", "", "civilian_woman", "../person", "x".repeat(1000)]:
		_avatar = name
		_show([ADA], [CRATE])
		var node: Ragdoll = _scene.get_node(^"People").get_child(0)
		is_true(node.visible)
		var file: String = node.get_node(^"Avatar").scene_file_path.get_file()
		equal(file.get_basename(), name if AvatarStore.NAMES.has(name) else "soldier")


func test_people_are_shown_when_their_avatar_is_there() -> void:
	_scene.avatars.waits = true
	_avatar = "range_dummy"
	_show([ADA, ADA + 1], [CRATE])
	var people: Node = _scene.get_node(^"People")
	# Another test may have loaded it.
	var came_later: bool = people.get_child_count() == 0
	if came_later:
		_tell([ADA], ["Props/Crate1"])
		while people.get_child_count() == 0:
			await get_tree().process_frame
			_play([ADA], [CRATE])
		equal(people.get_child_count(), 1, "who has left does not come")
		is_true((people.get_child(0) as Node3D).visible)
	_scene.clear()
	equal(people.get_child_count(), 0)


func test_who_looks_out_of_eyes_does_not_see_that_head() -> void:
	_show([ADA], [CRATE])
	var camera: OrbitCamera = _scene.get_node(^"Camera")
	for view: OrbitCamera.View in [OrbitCamera.View.EYES, OrbitCamera.View.BEHIND]:
		camera.view = view
		_play([ADA], [CRATE])
		var ada: Node = _scene.get_node(^"People").get_child(0)
		var head: MeshInstance3D = ada.find_children("HeadMesh", "", true, false)[0]
		var is_hidden: bool = view == OrbitCamera.View.EYES
		var shadow: bool = (
			head.cast_shadow == GeometryInstance3D.SHADOW_CASTING_SETTING_SHADOWS_ONLY
		)
		equal(shadow, is_hidden, "its shadow only")


## Plays snapshots of people and bodies.
func _play(p_people: PackedInt32Array, p_bodies: PackedInt32Array) -> void:
	_stream = SnapshotStream.new(p_people, p_bodies)
	_stream.move()
	for _tick: int in 20:
		_stream.stay()
		for bytes: PackedByteArray in _stream.datagrams():
			_scene.replica.take(bytes, _stream.tick / 60.0)
		_scene.update(_stream.tick / 60.0)


## Sends the level, and a table with people and with props at these paths, from [constant CRATE] on.
func _tell(p_people: PackedInt32Array, p_paths: PackedStringArray) -> void:
	var rows: Array[EntityRow] = []
	for index: int in p_paths.size():
		rows.append(_row(CRATE + index, p_paths[index]))
	for person: int in p_people:
		var row: EntityRow = _row(person, "")
		row.type = EntityType.person()
		row.values = row.type.spawn_schema().defaults()
		row.owner = 7
		row.path = _avatar
		row.person_name = "Ada"
		row.skeleton = _skeleton
		rows.append(row)
	_send(rows)


func _send(p_rows: Array[EntityRow]) -> void:
	_scene.clear()
	_scene.replica.take(LevelMessage.encode("hall", PackedByteArray()), 0.0)
	var message: EntityTableMessage = EntityTableMessage.new()
	message.is_full = true
	message.types = [EntityType.person(), _prop_type()]
	for row: EntityRow in p_rows:
		row.type_number = 0 if row.is_person() else 1
	message.spawned = p_rows
	is_true(_scene.replica.take(message.encode(), 0.0))


func _level_child_count() -> int:
	return _scene.get_level().level.get_child_count()


static func _prop_type() -> EntityType:
	var type: EntityType = EntityType.new()
	type.name = &"prop"
	type.body = EntityType.Body.RIGID
	return type


static func _row(p_id: int, p_path: String) -> EntityRow:
	var row: EntityRow = EntityRow.new()
	row.id = p_id
	row.type = _prop_type()
	row.source = EntityRow.Source.LEVEL
	row.path = p_path
	return row
