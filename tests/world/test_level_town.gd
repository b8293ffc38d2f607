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
