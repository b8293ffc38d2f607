extends TestCase
## The town: houses enough, its light is that of its blocks, people start on the ground.

const LEVEL: String = "town"

var _level: Level = null


func before_each() -> void:
	_level = LevelStore.instantiate(LEVEL)
	add_child(_level)


func after_each() -> void:
	_level.free()


func test_houses_and_ways_in() -> void:
	var houses: int = 0
	var entered: int = 0
	for node: Node in _level.find_children("*", "StaticBody3D", true, false):
		if node is House:
			houses += 1
			entered += 1 if (node as House).entered else 0
			equal((node as House)._get_configuration_warnings(), PackedStringArray(), node.name)
	is_true(houses >= 40, "%d houses" % houses)
	is_true(entered >= 15, "%d are entered" % entered)


func test_its_light_is_that_of_its_blocks() -> void:
	is_true(_level.bake != null, "there is no bake: ./run level bake town")
	var parts: Array[SurfacePart] = SurfacePart.gather(_level)
	is_true(_level.bake.fits(parts), "it was baked of other blocks: ./run level bake town")


func test_people_start_on_the_ground_with_room_around() -> void:
	await physics_frames(2)
	var space: PhysicsDirectSpaceState3D = _level.get_world_3d().direct_space_state
	var capsule: CapsuleShape3D = CapsuleShape3D.new()
	capsule.radius = 0.4
	var query: PhysicsShapeQueryParameters3D = PhysicsShapeQueryParameters3D.new()
	query.shape = capsule
	var points: Array[SpawnPoint] = _level.get_spawn_points()
	is_true(points.size() >= 8)
	for point: SpawnPoint in points:
		var at: Vector3 = point.global_position
		var ray: PhysicsRayQueryParameters3D = PhysicsRayQueryParameters3D.create(
			at + Vector3.UP, at + Vector3.DOWN
		)
		almost_equal((space.intersect_ray(ray)["position"] as Vector3).y, at.y, 0.05, point.name)
		query.transform.origin = at + Vector3.UP * 1.15
		equal(space.intersect_shape(query).size(), 0, point.name)


func test_no_wall_stands_in_a_house() -> void:
	var outlines: Dictionary[String, Rect2] = {}
	for node: Node in _level.find_children("*", "StaticBody3D", true, false):
		if node is House:
			var size: Vector2 = (node as House).size
			outlines[node.name] = _seen_from_above(
				node as House, AABB(Vector3(0.0, 0.0, -size.y), Vector3(size.x, 1.0, size.y))
			)
	for node: Node in _level.find_children("*", "StaticBody3D", true, false):
		if node is not Wall:
			continue
		for child: Node in node.get_children(true):
			var shape: CollisionShape3D = child as CollisionShape3D
			if shape == null:
				continue
			var extent: Vector3 = (shape.shape as BoxShape3D).size
			var wall: Rect2 = _seen_from_above(shape, AABB(extent * -0.5, extent))
			for house: String in outlines:
				is_false(wall.intersects(outlines[house].grow(-0.1)), "%s: %s" % [node.name, house])


func _seen_from_above(p_node: Node3D, p_box: AABB) -> Rect2:
	var box: AABB = p_node.global_transform * p_box
	return Rect2(box.position.x, box.position.z, box.size.x, box.size.z)
