extends TestCase
## A description of the world survives the wire; what is none is refused whole.

const NetSamples: GDScript = preload("res://tests/net/net_samples.gd")

var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func before_each() -> void:
	_random.seed = 3


func test_round_trip() -> void:
	for bodies: int in [0, 1, 20, 300]:
		var world: WorldDescription = NetSamples.world(_random, bodies, bodies / 10)
		var got: WorldDescription = WorldDescription.decode(world.encode())
		if got == null:
			fail("%d bodies cannot be decoded" % bodies)
			return
		equal(got.names, world.names)
		equal(got.bodies.keys(), world.bodies.keys())
		for id: int in world.bodies:
			equal(got.bodies[id].id, id)
			equal(got.bodies[id].actor, world.bodies[id].actor)
			equal(got.bodies[id].part, world.bodies[id].part)
			equal(got.bodies[id].shapes, world.bodies[id].shapes)


func test_cut_anywhere_is_none() -> void:
	var bytes: PackedByteArray = NetSamples.world(_random, 4, 2).encode()
	for size: int in bytes.size():
		if WorldDescription.decode(bytes.slice(0, size)) != null:
			fail("cut to %d of %d bytes" % [size, bytes.size()])
	is_null(WorldDescription.decode(bytes + PackedByteArray([0])), "a byte too many")
	not_null(WorldDescription.decode(bytes))


func test_shapes_that_are_none() -> void:
	var place: Transform3D = Transform3D.IDENTITY
	var far: Transform3D = Transform3D(Basis.IDENTITY, Vector3(0.0, NAN, 0.0))
	var bad: Array = [
		[0, Vector3(-1.0, 1.0, 1.0), place],
		[0, Vector3(INF, 1.0, 1.0), place],
		[1, Vector3(NAN, 1.0, 1.0), place],
		[3, Vector3.ONE, place],
		[0, Vector3.ONE, far],
	]
	for shape: Array in bad:
		var world: WorldDescription = WorldDescription.new()
		world.add(1, WorldDescription.PROP, "Crate", [shape])
		is_null(WorldDescription.decode(world.encode()), str(shape))


func test_actor_that_is_none() -> void:
	var world: WorldDescription = WorldDescription.new()
	world.add(1, -3, "Crate", [])
	is_null(WorldDescription.decode(world.encode()))
	var people: WorldDescription = WorldDescription.new()
	people.names[-1] = "nobody"
	is_null(WorldDescription.decode(people.encode()))


func test_control_characters_do_not_pass() -> void:
	var world: WorldDescription = WorldDescription.new()
	world.names[1] = "a\n\u001b[2Jb\u202e"
	equal(WorldDescription.decode(world.encode()).names[1], "a[2Jb")


func test_shapes_there_and_back() -> void:
	var box: BoxShape3D = BoxShape3D.new()
	box.size = Vector3(0.1, 0.2, 0.3)
	var capsule: CapsuleShape3D = CapsuleShape3D.new()
	capsule.radius = 0.07
	capsule.height = 0.5
	var sphere: SphereShape3D = SphereShape3D.new()
	sphere.radius = 0.4
	var place: Transform3D = NetSamples.place(_random)
	var got_box: BoxShape3D = _there_and_back(box, place)
	equal(got_box.size, box.size)
	var got_capsule: CapsuleShape3D = _there_and_back(capsule, place)
	almost_equal(got_capsule.radius, 0.07)
	almost_equal(got_capsule.height, 0.5)
	var got_sphere: SphereShape3D = _there_and_back(sphere, place)
	almost_equal(got_sphere.radius, 0.4)
	equal(WorldDescription.describe_shape(ConcavePolygonShape3D.new(), place), [])


func _there_and_back(p_shape: Shape3D, p_place: Transform3D) -> Shape3D:
	var entry: Array = WorldDescription.describe_shape(p_shape, p_place)
	equal(entry[2], p_place)
	return WorldDescription.make_shape(entry)
