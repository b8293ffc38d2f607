extends TestCase
## Numbers of bodies: unique, and the same as long as a body exists, while people come and go.

const HALL: PackedScene = preload("res://scenes/world/hall/hall.tscn")
const Stage: GDScript = preload("res://tests/actor/ragdoll/stage.gd")
const SOLDIER: PackedScene = preload("res://scenes/actor/soldier.tscn")

var _hall: Node3D = null
var _actors: ServerPeople = null
var _registry: BodyRegistry = null


func before_each() -> void:
	_hall = HALL.instantiate()
	add_child(_hall)
	_actors = ServerPeople.new()
	_actors.scene = SOLDIER
	add_child(_actors)
	_registry = BodyRegistry.new()
	_registry.add_world(_hall)


func after_each() -> void:
	_actors.free()
	_hall.free()


func test_props_and_what_never_moves() -> void:
	var world: WorldDescription = _registry.describe(_actors.list())
	var crates: Array = get_tree().get_nodes_in_group("props").filter(_hall.is_ancestor_of)
	var props: int = 0
	var fixed: int = 0
	for id: int in world.bodies:
		var body: WorldDescription.Body = world.bodies[id]
		props += 1 if body.actor == WorldDescription.PROP else 0
		fixed += 1 if body.actor == WorldDescription.FIXED else 0
		is_true(body.shapes.size() > 0, body.part)
		if body.actor == WorldDescription.PROP:
			var node: RigidBody3D = _hall.get_node(NodePath(body.part))
			is_true(node in crates, body.part)
			almost_equal(body.shapes[0][1], Vector3.ONE * 0.5)
	equal(props, crates.size())
	equal(fixed, _hall.find_children("*", "StaticBody3D").size())
	equal(world.names.size(), 0)


func test_shapes_of_what_never_moves_are_placed_in_the_world() -> void:
	var world: WorldDescription = _registry.describe(_actors.list())
	for id: int in world.bodies:
		if world.bodies[id].part == "Floor":
			var shape: Array = world.bodies[id].shapes[0]
			almost_equal((shape[2] as Transform3D).origin, Vector3(0.0, -0.25, 0.0))
			return
	fail("there is no floor")


func test_limbs_of_a_person() -> void:
	_actors.set_people(5, [PersonCard.of("Ada", 0.95)], "")
	var world: WorldDescription = _registry.describe(_actors.list())
	var id: int = _actors.list()[0].id
	equal(world.names, {id: "Ada"} as Dictionary[int, String])
	var parts: Dictionary[String, int] = {}
	for body: int in world.bodies:
		if world.bodies[body].actor == id:
			parts[world.bodies[body].part] = body
			equal(world.bodies[body].shapes.size(), 1)
	equal(parts.size(), Limbs.COUNT)
	for bone: StringName in Limbs.BONES:
		is_true(parts.has(String(bone)), bone)
	not_null(WorldDescription.decode(world.encode()))


func test_snapshots_have_exactly_what_moves() -> void:
	_actors.set_people(5, [PersonCard.of("Ada", 0.95)], "")
	_actors.set_people(6, [PersonCard.of("Bob", 0.95)], "")
	for step: int in 30:
		await physics_frames(1)
		for session: int in [5, 6]:
			var sample: PoseSample = Stage.reset_pose()
			sample.id = step
			sample.time_usec = 1000000 + step * 16667
			# In the air: a foot that is pressed against the floor stretches its joint.
			sample.root = Vector3(0.0, 1.1, 0.0)
			_actors.push_sample(session, sample, 1.0 + step / 60.0)
		_actors.drive(1.0 + step / 60.0, 1.0 / 60.0)
	await physics_frames(1)
	var world: WorldDescription = _registry.describe(_actors.list())
	var encoder: SnapshotEncoder = SnapshotEncoder.new()
	var decoder: SnapshotDecoder = SnapshotDecoder.new()
	var parents: PackedInt32Array = PackedInt32Array(Limbs.PARENTS)
	encoder.configure(parents, Protocol.POSE_ERROR_DEG, 60)
	decoder.configure(parents, Protocol.POSE_ERROR_DEG)
	encoder.add_client(1, 0, 1e8)
	_registry.watch_world(encoder)
	for person: ServerPeople.Person in _actors.list():
		BodyRegistry.watch_person(encoder, person)
	# What has been measured of one person's bodies is not read again, the other's bodies are read.
	_actors.measure()
	var first: ServerPeople.Person = _actors.list()[0]
	is_true(encoder.set_body_pose(first.id, first.ragdoll.motor.get_body_pose()))
	is_false(encoder.set_body_pose(first.id, PackedFloat32Array([1.0, 2.0])))
	is_false(encoder.set_body_pose(4711, first.ragdoll.motor.get_body_pose()))
	encoder.capture(100)
	var datagrams: Array[PackedByteArray] = encoder.encode(1, 0)
	equal(datagrams.size(), 1)
	equal(decoder.decode(datagrams[0]), int(SnapshotDecoder.OK))
	for id: int in world.bodies:
		var is_prop: bool = world.bodies[id].actor == WorldDescription.PROP
		equal(decoder.get_bodies().has(id), is_prop, world.bodies[id].part)
		if is_prop:
			var crate: Node3D = _hall.get_node(NodePath(world.bodies[id].part))
			almost_equal(decoder.get_body_transform(id), crate.global_transform, 0.01)
	for person: ServerPeople.Person in _actors.list():
		_check_limbs(decoder, person, world)


## A client comes to the server's places by forward kinematics.
func _check_limbs(
	p_decoder: SnapshotDecoder, p_person: ServerPeople.Person, p_world: WorldDescription
) -> void:
	var joints: PersonSkeleton = p_world.skeletons[p_person.id]
	is_true(joints.is_sound())
	var smoother: SnapshotSmoother = SnapshotSmoother.new()
	smoother.set_skeleton(
		p_person.id, joints.parents, joints.joints_in_parent, joints.joints_in_limb
	)
	smoother.take(p_decoder, 1.0)
	var floats: PackedFloat32Array = smoother.newest_person_transforms(p_person.id)
	var order: PackedInt32Array = p_person.ragdoll.get_limb_order()
	for limb: int in Limbs.COUNT:
		var truth: Transform3D = PhysicsServer3D.body_get_state(
			p_person.ragdoll.get_bodies()[order[limb]], PhysicsServer3D.BODY_STATE_TRANSFORM
		)
		var at: int = limb * WorldReplica.FLOATS
		var place: Vector3 = Vector3(floats[at], floats[at + 1], floats[at + 2])
		almost_equal(place, truth.origin, 0.004)
		var turn: Quaternion = Quaternion(
			floats[at + 3], floats[at + 4], floats[at + 5], floats[at + 6]
		)
		almost_equal(joints.body_at(limb, place, turn).basis, truth.basis, 0.01)


func test_numbers_stay_while_others_come_and_go() -> void:
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 1
	var known: Dictionary[String, int] = {}
	var here: Array[int] = []
	for step: int in 40:
		if here.size() > 4 or (not here.is_empty() and random.randf() < 0.4):
			var gone: int = here.pop_at(random.randi_range(0, here.size() - 1))
			_actors.remove(gone)
			for key: String in known.keys():
				if key.begins_with("peer%d/" % gone):
					known.erase(key)
		else:
			here.append(100 + step)
			_actors.set_people(100 + step, [PersonCard.of("peer%d" % (100 + step), 0.95)], "")
		var world: WorldDescription = _registry.describe(_actors.list())
		equal(world.names.size(), here.size())
		for id: int in world.bodies:
			var body: WorldDescription.Body = world.bodies[id]
			var key: String = "%s/%s" % [world.names.get(body.actor, body.actor), body.part]
			equal(known.get(key, id), id, key)
			known[key] = id
		await process_frames(1)


func test_numbers_are_unique_after_thousands_have_come_and_gone() -> void:
	# One stays, while another's connection breaks again and again.
	_actors.set_people(5, [PersonCard.of("stays", 0.95)], "")
	for next: int in [1023, 1024, 2048, 65535, 65536, 1000000]:
		_actors._next_id = next
		_actors.set_people(6, [PersonCard.of("comes again", 0.95)], "")
		var people: Array[ServerPeople.Person] = _actors.list()
		not_equal(people[0].id, people[1].id)
		is_true(people[1].id <= 65535, "an actor is 16 bits on the wire, not %d" % people[1].id)
		var world: WorldDescription = _registry.describe(people)
		var limbs: int = 0
		for id: int in world.bodies:
			is_true(id < 65536)
			limbs += 1 if world.bodies[id].actor >= 0 else 0
		equal(limbs, 2 * Limbs.COUNT, "with number %d" % next)
		_actors.remove(6)
		await process_frames(1)
