extends TestCase
## Wire frames: of the server's shapes, exactly where the snapshots have the bodies.

const NetSamples: GDScript = preload("../net/net_samples.gd")

var _world: PhysicsWorld = null
var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func before_each() -> void:
	_random.seed = 1
	_world = PhysicsWorld.new()
	add_child(_world)


func after_each() -> void:
	_world.free()


func test_frames_are_where_the_bodies_are() -> void:
	var description: WorldDescription = NetSamples.world(_random, 50, 3)
	_world.describe(description)
	for _round: int in 3:
		for id: int in description.bodies:
			var place: Transform3D = NetSamples.place(_random)
			_world.place(id, place)
			equal(_world.get_placed(id), place)
			var frame: Node3D = _world._frames[id]
			is_true(frame.is_visible_in_tree())
			equal(frame.global_transform, place)


func test_moving_bodies_are_hidden_until_they_are_known() -> void:
	var description: WorldDescription = WorldDescription.new()
	var box: Array = [WorldDescription.ShapeType.BOX, Vector3.ONE, Transform3D.IDENTITY]
	description.add(1, WorldDescription.PROP, "Crate", [box])
	description.add(2, WorldDescription.FIXED, "Floor", [box])
	_world.describe(description)
	equal([_world._frames[1].visible, _world._frames[2].visible], [false, true])
	_world.place(1, Transform3D.IDENTITY)
	is_true(_world._frames[1].visible)


func test_wires_have_the_sizes_places_and_colours() -> void:
	var place: Transform3D = NetSamples.place(_random)
	var description: WorldDescription = WorldDescription.new()
	var box: Array = [WorldDescription.ShapeType.BOX, Vector3(1, 2, 3), place]
	var pill: Array = [WorldDescription.ShapeType.CAPSULE, Vector3(0.1, 0.6, 0), place]
	var ball: Array = [WorldDescription.ShapeType.SPHERE, Vector3(0.5, 0, 0), place]
	description.add(1, WorldDescription.PROP, "", [box])
	description.add(2, WorldDescription.FIXED, "", [ball])
	description.add(3, 7, "Head", [pill, box])
	_world.describe(description)
	_check_wires(1, 0, Vector3(1, 2, 3), place, PhysicsWorld.PROPS)
	_check_wires(2, 0, Vector3.ONE, place, PhysicsWorld.FIXED)
	_check_wires(3, 0, Vector3(0.2, 0.6, 0.2), place, PhysicsWorld.LIMBS)
	_check_wires(3, 1, Vector3(1, 2, 3), place, PhysicsWorld.LIMBS)


func test_a_new_world_replaces_the_old_one() -> void:
	_world.describe(NetSamples.world(_random, 20, 0))
	var description: WorldDescription = NetSamples.world(_random, 5, 0)
	_world.describe(description)
	await process_frames(2)
	equal(_world.get_child_count(), 5)
	_world.place(70000, Transform3D.IDENTITY)


func _check_wires(
	p_id: int, p_shape: int, p_size: Vector3, p_place: Transform3D, p_colour: Color
) -> void:
	var wires: MeshInstance3D = _world._frames[p_id].get_child(p_shape)
	equal(wires.transform, p_place)
	almost_equal(wires.mesh.get_aabb().size, p_size, 0.01)
	is_true(wires.mesh.get_surface_count() > 0)
	for surface: int in wires.mesh.get_surface_count():
		var mesh: ArrayMesh = wires.mesh
		equal(mesh.surface_get_primitive_type(surface), Mesh.PRIMITIVE_LINES)
	equal((wires.material_override as StandardMaterial3D).albedo_color, p_colour)
