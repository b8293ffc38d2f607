extends TestCase
## Ground from a map of heights: it is where it is said to be, of what it is said to be.

var _terrain: Terrain = null


func after_each() -> void:
	if _terrain != null:
		_terrain.free()
		_terrain = null


func test_rays_meet_the_ground_where_it_is() -> void:
	for size: Vector2i in [Vector2i(65, 65), Vector2i(81, 40), Vector2i(23, 50)]:
		_make(size, 0.5)
		await physics_frames(2)
		var space: PhysicsDirectSpaceState3D = _terrain.get_world_3d().direct_space_state
		var half: Vector2 = _terrain.field.size() / 2.0 - Vector2.ONE * 0.05
		var dice: RandomNumberGenerator = RandomNumberGenerator.new()
		dice.seed = 3
		for _ray: int in 300:
			var place: Vector3 = Vector3(
				dice.randf_range(-half.x, half.x), 0.0, dice.randf_range(-half.y, half.y)
			)
			place += _terrain.position
			var query: PhysicsRayQueryParameters3D = PhysicsRayQueryParameters3D.create(
				place + Vector3.UP * 50.0, place + Vector3.DOWN * 50.0
			)
			var hit: Dictionary = space.intersect_ray(query)
			if hit.is_empty():
				fail("a hole at %s in a field of %s" % [place, size])
				return
			almost_equal((hit["position"] as Vector3).y, _terrain.height_at(place), 0.005)
		_terrain.free()
		_terrain = null


func test_walls_keep_things_on_it() -> void:
	_make(Vector2i(33, 33), 1.0)
	await physics_frames(2)
	var space: PhysicsDirectSpaceState3D = _terrain.get_world_3d().direct_space_state
	for way: Vector3 in [Vector3.LEFT, Vector3.RIGHT, Vector3.FORWARD, Vector3.BACK]:
		var from: Vector3 = _terrain.position + Vector3.UP * 10.0
		var query: PhysicsRayQueryParameters3D = PhysicsRayQueryParameters3D.create(
			from, from + way * 40.0
		)
		var hit: Dictionary = space.intersect_ray(query)
		is_false(hit.is_empty(), "no wall towards %s" % way)


func test_squares_fill_any_rectangle() -> void:
	for cells: Vector2i in [
		Vector2i(1000, 1000),
		Vector2i(997, 997),
		Vector2i(100, 37),
		Vector2i(3, 8),
		Vector2i(1500, 600)
	]:
		var squares: Array[Rect2i] = Terrain.squares_of(cells)
		var area: int = 0
		for square: Rect2i in squares:
			equal(square.size.x, square.size.y)
			area += square.get_area()
			for other: Rect2i in squares:
				is_true(square == other or not square.intersects(other), "%s, %s" % [square, other])
		equal(area, cells.x * cells.y)


func test_large_shapes_are_cut_up() -> void:
	for square: Rect2i in Terrain.squares_of(Vector2i(1000, 1000)):
		equal(square.size.x, 250)
	# What leaves a rest is not.
	equal(Terrain.squares_of(Vector2i(997, 997)).size(), 1)


func test_shapes_that_enter_later_are_the_same_ground() -> void:
	_terrain = Terrain.new()
	_terrain.height_file = "res://scenes/world/desert/desert.height"
	_terrain.read_ahead()
	var pieces: Array[Node] = _terrain.take_pieces()
	is_true(pieces.size() > 1)
	add_child(_terrain)
	await physics_frames(2)
	var places: Array[Vector3] = []
	for index: int in 50:
		places.append(Vector3(-240.0 + 9.7 * index, 0.0, 235.0 - 9.3 * index))
	equal(places.filter(_is_ground).size(), 0, "before the pieces are there")
	for piece: Node in pieces:
		_terrain.add_piece(piece)
	await physics_frames(2)
	equal(places.filter(_is_ground).size(), places.size())
	# Another file replaces them all.
	_terrain.set_field(HeightField.create(101, 101, 0.5))
	await physics_frames(2)
	is_true(_is_ground(Vector3(1.0, 0.0, 1.0)))
	is_false(_is_ground(Vector3(200.0, 0.0, 200.0)))


func _is_ground(p_place: Vector3) -> bool:
	var at: Vector3 = _terrain.position + p_place
	var query: PhysicsRayQueryParameters3D = PhysicsRayQueryParameters3D.create(
		at + Vector3.UP * 200.0, at + Vector3.DOWN * 200.0
	)
	var hit: Dictionary = _terrain.get_world_3d().direct_space_state.intersect_ray(query)
	return not hit.is_empty() and absf(hit["position"].y - _terrain.height_at(at)) < 0.01


func test_surfaces() -> void:
	_make(Vector2i(65, 65), 0.5)
	var field: HeightField = HeightField.create(65, 65, 0.5)
	for row: int in 65:
		for column: int in 65:
			field.heights[row * 65 + column] = maxf(column - 48.0, 0.0)
			if row < 20:
				field.paint[(row * 65 + column) * 4 + HeightField.Paint.GRAVEL] = 255
	_terrain.set_field(field)
	var middle: Vector3 = _terrain.position
	equal(_terrain.surface_at(middle + Vector3(0.0, 0.0, 5.0)), &"sand")
	equal(_terrain.surface_at(middle + Vector3(0.0, 0.0, -12.0)), &"gravel")
	equal(_terrain.surface_at(middle + Vector3(12.0, 0.0, 5.0)), &"dirt")
	is_true(_terrain.covers(middle))
	is_false(_terrain.covers(middle + Vector3(17.0, 0.0, 0.0)))


func test_it_warns() -> void:
	_terrain = Terrain.new()
	add_child(_terrain)
	equal(_terrain._get_configuration_warnings().size(), 1)
	_terrain.height_file = "res://project.godot"
	contains(_terrain._get_configuration_warnings()[0], "cannot be used")
	_terrain.height_file = "res://scenes/world/desert/desert.height"
	equal(_terrain._get_configuration_warnings(), PackedStringArray())
	_terrain.scale = Vector3.ONE * 2.0
	contains(_terrain._get_configuration_warnings()[0], "turned or scaled")


func _make(p_size: Vector2i, p_cell_m: float) -> void:
	var field: HeightField = HeightField.create(p_size.x, p_size.y, p_cell_m)
	for row: int in p_size.y:
		for column: int in p_size.x:
			field.heights[row * p_size.x + column] = 3.0 * sin(column * 0.21) * cos(row * 0.17)
	_terrain = Terrain.new()
	_terrain.position = Vector3(7.0, 2.0, -5.0)
	add_child(_terrain)
	_terrain.set_field(field)
