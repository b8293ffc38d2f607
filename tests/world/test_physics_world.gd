extends TestCase
## Wire frames: of the collision shapes, exactly where the snapshots have the bodies.

const NetSamples: GDScript = preload("res://tests/net/net_samples.gd")
const SOLDIER: PackedScene = preload("res://scenes/actor/soldier.tscn")

var _world: PhysicsWorld = null
var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func before_each() -> void:
	_random.seed = 1
	_world = PhysicsWorld.new()
	add_child(_world)


func after_each() -> void:
	_world.free()


func test_frames_are_where_the_bodies_are() -> void:
	var body: RigidBody3D = _body(BoxShape3D.new())
	_world.add_body(1024, body)
	equal(_world.get_child_count(), 0, "nothing is shown until it is known where it is")
	for _round: int in 3:
		var transform: Transform3D = NetSamples.transform(_random)
		_world.set_transforms(1024, [transform])
		equal(_world.get_frame_transform(1024), transform)
		is_true((_world._frames[1024][0] as Node3D).is_visible_in_tree())
	body.free()


func test_wires_have_the_sizes_and_colours_of_the_shapes() -> void:
	var box: BoxShape3D = BoxShape3D.new()
	box.size = Vector3(1, 2, 3)
	var pill: CapsuleShape3D = CapsuleShape3D.new()
	pill.radius = 0.1
	pill.height = 0.6
	for pair: Array in [[box, Vector3(1, 2, 3)], [pill, Vector3(0.2, 0.6, 0.2)]]:
		var body: RigidBody3D = _body(pair[0])
		_world.add_body(1030, body)
		_world.set_transforms(1030, [Transform3D.IDENTITY])
		var wires: MeshInstance3D = _world._frames[1030][0].get_child(0)
		almost_equal(wires.mesh.get_aabb().size, pair[1], 0.01)
		var mesh: ArrayMesh = wires.mesh
		for surface: int in mesh.get_surface_count():
			equal(mesh.surface_get_primitive_type(surface), Mesh.PRIMITIVE_LINES)
		var material: StandardMaterial3D = wires.material_override
		equal(material.albedo_color, PhysicsWorld.PROPS)
		body.free()


func test_a_person_has_a_frame_for_each_limb() -> void:
	var soldier: Ragdoll = SOLDIER.instantiate()
	_world.add_person(3, soldier.get_limb_nodes())
	var transforms: Array[Transform3D] = []
	for _limb: int in Limbs.COUNT:
		transforms.append(NetSamples.transform(_random))
	_world.set_transforms(3, transforms)
	equal(_world.get_child_count(), Limbs.COUNT)
	equal(_world.get_frame_transform(3, 5), transforms[5])
	_world.remove(3)
	_world.set_transforms(3, transforms)
	equal(_world.get_child_count(), 0)
	soldier.free()


func test_the_level_is_drawn_and_its_colour_tells_that_it_differs() -> void:
	var level: Level = LevelStore.instantiate("hall")
	add_child(level)
	var bodies: int = level.get_static_bodies().size()
	_world.set_level(level)
	equal(_world.get_child_count(), bodies)
	equal(_colour(_world.get_child(0)), PhysicsWorld.FIXED)
	_world.set_level(level, true)
	await process_frames(2)
	equal([_world.get_child_count(), _colour(_world.get_child(0))], [bodies, PhysicsWorld.DIFFERS])
	_world.set_level(null)
	await process_frames(2)
	equal(_world.get_child_count(), 0)
	level.free()


static func _colour(p_frame: Node) -> Color:
	var wires: MeshInstance3D = p_frame.get_child(0)
	return (wires.material_override as StandardMaterial3D).albedo_color


static func _body(p_shape: Shape3D) -> RigidBody3D:
	var body: RigidBody3D = RigidBody3D.new()
	var shape: CollisionShape3D = CollisionShape3D.new()
	shape.shape = p_shape
	body.add_child(shape)
	return body


func test_a_large_map_of_heights_has_few_lines_on_its_ground() -> void:
	var map: HeightMapShape3D = HeightMapShape3D.new()
	map.map_width = 1001
	map.map_depth = 1001
	var heights: PackedFloat32Array = []
	heights.resize(1001 * 1001)
	heights.fill(3.0)
	map.map_data = heights
	var lines: ArrayMesh = PhysicsWorld._lines_of(map)
	var points: PackedVector3Array = lines.surface_get_arrays(0)[Mesh.ARRAY_VERTEX]
	is_true(points.size() > 20_000 and points.size() < 70_000, str(points.size()))
	equal(lines.get_aabb().position, Vector3(-500.0, 3.0, -500.0))
	is_true(lines.get_aabb().size.x > 980.0, str(lines.get_aabb()))
