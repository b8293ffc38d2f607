extends TestCase
## The hangar: the middle of its floor is free and flat, its gate is open, its crates come to rest.

const FastPhysics: GDScript = preload("res://tests/actor/ragdoll/fast_physics.gd")
const LEVEL: String = "hangar"
## What stays free in the middle for people who move, m.
const FREE: Rect2 = Rect2(-6.0, -2.0, 12.0, 12.0)

var _level: Level = null


func before_each() -> void:
	_level = LevelStore.instantiate(LEVEL)
	add_child(_level)
	await physics_frames(2)


func after_each() -> void:
	_level.free()


func test_people_start_apart_in_the_free_middle() -> void:
	var points: Array[SpawnPoint] = _level.get_spawn_points()
	is_true(points.size() >= 8)
	for point: SpawnPoint in points:
		# The first starts beside it, before a pile of crates.
		var place: Vector2 = Vector2(point.position.x, point.position.z)
		is_true(FREE.grow(2.0 if point == points[0] else 0.0).has_point(place), point.name)
		for other: SpawnPoint in points:
			var distance: float = point.position.distance_to(other.position)
			is_true(other == point or distance > 1.5, "%s, %s" % [point.name, other.name])


func test_the_middle_is_free_and_flat() -> void:
	var box: BoxShape3D = BoxShape3D.new()
	box.size = Vector3(FREE.size.x, 2.5, FREE.size.y)
	var query: PhysicsShapeQueryParameters3D = PhysicsShapeQueryParameters3D.new()
	query.shape = box
	var middle: Vector2 = FREE.get_center()
	query.transform.origin = Vector3(middle.x, 1.27, middle.y)
	equal(_space().intersect_shape(query, 4).size(), 0)
	for step: int in 49:
		var share: Vector2 = Vector2(step % 7, step / 7) / 6.0
		var place: Vector2 = FREE.position + FREE.size * share
		var hit: Dictionary = _ray(Vector3(place.x, 1.0, place.y), Vector3(place.x, -1.0, place.y))
		almost_equal((hit["position"] as Vector3).y, 0.0, 0.001)


func test_the_gate_is_open_and_the_wall_beside_it_is_not() -> void:
	for x: float in [-3.0, 0.0, 3.0]:
		is_true(_ray(Vector3(x, 1.0, 10.0), Vector3(x, 1.0, 14.0)).is_empty(), "at %.1f m" % x)
	is_false(_ray(Vector3(-7.0, 1.0, 9.8), Vector3(-7.0, 1.0, 14.0)).is_empty())


func test_its_light_is_that_of_its_blocks() -> void:
	is_true(_level.bake != null, "there is no bake: ./run level bake hangar")
	var parts: Array[SurfacePart] = SurfacePart.gather(_level)
	is_true(_level.bake.fits(parts), "it was baked of other blocks: ./run level bake hangar")


func test_crates_come_to_rest_where_they_stand() -> void:
	var places: Dictionary[RigidBody3D, Vector3] = {}
	for crate: RigidBody3D in _level.get_props():
		places[crate] = crate.position
	is_true(places.size() >= 15)
	FastPhysics.start()
	await physics_frames(240)
	for crate: RigidBody3D in places:
		is_true(crate.position.distance_to(places[crate]) < 0.05, "%s has moved" % crate.name)


func _space() -> PhysicsDirectSpaceState3D:
	return _level.get_world_3d().direct_space_state


func _ray(p_from: Vector3, p_to: Vector3) -> Dictionary:
	return _space().intersect_ray(PhysicsRayQueryParameters3D.create(p_from, p_to))
