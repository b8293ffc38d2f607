extends TestCase
## The hall: what is in it, and that its crates come to rest.

const FastPhysics: GDScript = preload("res://tests/actor/ragdoll/fast_physics.gd")
const HALL: PackedScene = preload("res://scenes/world/hall/hall.tscn")

var _hall: Node3D = null


func before_each() -> void:
	_hall = HALL.instantiate()
	add_child(_hall)


func after_each() -> void:
	FastPhysics.stop()
	_hall.free()


func test_has_floor_walls_stairs_light_and_crates() -> void:
	var ground: Block = _hall.get_node(^"Static/Floor")
	almost_equal(ground.position.y + ground.size.y / 2.0, 0.0, 1e-5, "the floor is at height 0")
	is_true(ground.size.x >= 10.0 and ground.size.z >= 10.0)
	var walls: Array[Node] = _hall.find_children("Wall*", "StaticBody3D")
	equal(walls.size(), 4)
	is_true(_hall.find_children("*", "StaticBody3D").any(_is_stairs))
	equal(_hall.find_children("*", "WorldEnvironment").size(), 1)
	is_true(_hall.find_children("*", "Light3D").size() >= 1)
	is_true(_crates().size() >= 3)


func test_nothing_in_it_warns() -> void:
	for node: Node in _hall.find_children("*", "StaticBody3D"):
		var warnings: PackedStringArray = node._get_configuration_warnings()
		equal(warnings, PackedStringArray(), node.name)


func test_what_never_moves_lies_below_static_and_props_below_props() -> void:
	for crate: RigidBody3D in _crates():
		is_true(_hall.get_node(^"Props").is_ancestor_of(crate), crate.name)
	for body: Node in _hall.find_children("*", "StaticBody3D"):
		is_true(_hall.get_node(^"Static").is_ancestor_of(body), body.name)


func test_layers() -> void:
	# World 1, people 2, props 4.
	for body: StaticBody3D in _hall.find_children("*", "StaticBody3D"):
		equal(body.collision_layer, 1, body.name)
	for crate: RigidBody3D in _crates():
		equal([crate.collision_layer, crate.collision_mask], [4, 7], crate.name)


func test_walls_are_solid() -> void:
	await physics_frames(2)
	var space: PhysicsDirectSpaceState3D = _hall.get_world_3d().direct_space_state
	for direction: Vector3 in [Vector3.LEFT, Vector3.RIGHT, Vector3.FORWARD, Vector3.BACK]:
		var from: Vector3 = Vector3(0.0, 3.0, 0.0)
		var ray: PhysicsRayQueryParameters3D = PhysicsRayQueryParameters3D.create(
			from, from + direction * 50.0, 1
		)
		is_false(space.intersect_ray(ray).is_empty(), str(direction))


func test_crates_fall_asleep_upright() -> void:
	var places: Dictionary[RigidBody3D, Vector3] = {}
	for crate: RigidBody3D in _crates():
		places[crate] = crate.position
	FastPhysics.start()
	await physics_frames(180)
	for crate: RigidBody3D in places:
		is_true(crate.sleeping, "%s is awake" % crate.name)
		var tilt: float = rad_to_deg(crate.basis.y.angle_to(Vector3.UP))
		is_true(tilt < 1.0, "%s leans by %f deg" % [crate.name, tilt])
		var moved: float = crate.position.distance_to(places[crate])
		is_true(moved < 0.03, "%s has moved by %f m" % [crate.name, moved])


func _crates() -> Array[Node]:
	return get_tree().get_nodes_in_group("props").filter(_hall.is_ancestor_of)


func _is_stairs(p_node: Node) -> bool:
	return p_node is Stairs
