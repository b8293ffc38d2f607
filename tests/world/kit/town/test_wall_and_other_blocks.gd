extends TestCase
## Every small block of a town: faces that are sound, solid boxes, no warnings as it comes.


func test_each_has_faces_and_is_solid() -> void:
	for block: KitBlock in _all():
		add_child(block)
		var mesh: BlockMesh = KitChecks.mesh_of(block)
		var name: String = block.get_script().get_global_name()
		is_true(mesh.get_triangle_count() > 10, name)
		KitChecks.check_sound(self, block, mesh)
		equal(mesh.get_solid_count() > 0, block is not Wire, name)
		equal(block.get_child_count(true), mesh.get_solid_count(), name)
		block.free()


func test_a_wall_has_holes_where_its_openings_are() -> void:
	var wall: Wall = Wall.new()
	wall.size = Vector3(5.0, 2.5, 0.3)
	wall.openings = [Rect2(1.0, 0.0, 1.2, 2.1), Rect2(3.0, 1.0, 0.8, 0.8)]
	add_child(wall)
	await physics_frames(2)
	var places: PackedVector2Array = [
		Vector2(1.6, 1.0), Vector2(3.4, 1.4), Vector2(0.5, 1.0), Vector2(3.4, 0.5)
	]
	for place: Vector2 in places:
		var from: Vector3 = Vector3(place.x, place.y, 1.0)
		var query: PhysicsRayQueryParameters3D = PhysicsRayQueryParameters3D.create(
			from, from + Vector3(0.0, 0.0, -2.0)
		)
		var is_open: bool = wall.get_world_3d().direct_space_state.intersect_ray(query).is_empty()
		var wanted: bool = false
		for opening: Rect2 in wall.openings:
			wanted = wanted or opening.has_point(place)
		equal(is_open, wanted, str(place))
	wall.free()


func test_openings_that_do_not_fit_warn() -> void:
	var wall: Wall = Wall.new()
	wall.openings = [Rect2(3.0, 0.0, 2.0, 2.1)]
	contains(wall._get_configuration_warnings()[0], "reaches beyond the wall")
	wall.openings = [Rect2(1.0, 0.0, 0.6, 2.1)]
	contains(wall._get_configuration_warnings()[0], "do not fit through")
	wall.free()


func test_lamps_shine_from_where_they_are() -> void:
	var lamp: StreetLamp = StreetLamp.new()
	lamp.height = 5.0
	var lights: Array[LampLight] = lamp.get_lamps()
	equal(lights.size(), 1)
	almost_equal(lights[0].position.x, 1.15, 0.01)
	var place: Transform3D = Transform3D(Basis(Vector3.UP, PI), Vector3(2.0, 0.0, 0.0))
	almost_equal(lights[0].moved(place).position.x, 0.85, 0.01)
	lamp.free()


func _all() -> Array[KitBlock]:
	var ruin: Wall = Wall.new()
	ruin.ruin = 0.7
	return [
		ruin,
		Wall.new(),
		Barrels.new(),
		Gate.new(),
		Palm.new(),
		Road.new(),
		Rubble.new(),
		Sandbags.new(),
		Stall.new(),
		StreetLamp.new(),
		Tower.new(),
		Wire.new(),
	]
