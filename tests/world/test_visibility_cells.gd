extends TestCase
## What is behind a wall is out of sight; what is in the open is not.

var _world: Node3D = null


func before_each() -> void:
	_world = Node3D.new()
	add_child(_world)


func test_an_open_hall_is_visible_from_everywhere() -> void:
	_add(Vector3(0.0, -0.5, 0.0), Vector3(24.0, 1.0, 24.0))
	_add(Vector3(0.0, 7.5, 0.0), Vector3(24.0, 1.0, 24.0))
	var cells: VisibilityCells = await _survey()
	is_true(cells.counts.x * cells.counts.y * cells.counts.z > 20)
	for place: Vector3 in [Vector3(-10, 3, -10), Vector3(10, 3, -10), Vector3(0, 3, 10)]:
		is_true(_sees(cells, Vector3(10, 3, 10), place), str(place))
	almost_equal(cells.openness(), 1.0, 0.001)


func test_a_room_without_a_door() -> void:
	_build_rooms()
	var cells: VisibilityCells = await _survey()
	is_true(_sees(cells, Vector3(-20, 3, 0), Vector3(-6, 3, 0)))
	is_true(_sees(cells, Vector3(20, 3, 0), Vector3(6, 3, 0)))
	is_false(_sees(cells, Vector3(-20, 3, 0), Vector3(20, 3, 0)))
	is_false(_sees(cells, Vector3(20, 3, 0), Vector3(-20, 3, 0)), "both ways alike")
	is_true(cells.openness() < 0.8, "%f" % cells.openness())


func test_what_moves_hides_nothing() -> void:
	_add(Vector3(0.0, -0.5, 0.0), Vector3(24.0, 1.0, 24.0))
	_add(Vector3(0.0, 7.5, 0.0), Vector3(24.0, 1.0, 24.0))
	var wall: RigidBody3D = RigidBody3D.new()
	wall.freeze = true
	_fill(wall, Vector3(1.0, 7.0, 24.0))
	var cells: VisibilityCells = await _survey()
	is_true(_sees(cells, Vector3(-10, 3, 0), Vector3(10, 3, 0)))


## The encoder must take the table as it was meant: two people, one behind the wall.
func test_the_encoder_reads_the_table_in_the_same_order() -> void:
	_build_rooms()
	var cells: VisibilityCells = await _survey()
	var encoder: SnapshotEncoder = SnapshotEncoder.new()
	var decoder: SnapshotDecoder = SnapshotDecoder.new()
	encoder.configure(PackedInt32Array([-1]), 0.1, 60)
	decoder.configure(PackedInt32Array([-1]), 0.1)
	is_true(encoder.set_cells(cells.origin, cells.size, cells.counts, cells.visible))
	encoder.add_client(1, 0, 1e8)
	var told: Dictionary[int, int] = {}
	var places: Array[Vector3] = [Vector3(-20, 3, 10), Vector3(20, 3, -10), Vector3(-6, 3, -10)]
	for tick: int in 180:
		encoder.begin_tick(100 + tick)
		for person: int in places.size():
			var sway: Vector3 = Vector3(0.1 * sin(tick), 0.0, 0.0)
			encoder.put_person(person, places[person] + sway, PackedFloat32Array([0, 0, 0, 1]))
		encoder.end_tick()
		for bytes: PackedByteArray in encoder.encode(1, 0):
			decoder.decode(bytes)
			for person: int in decoder.get_people():
				told[person] = told.get(person, 0) + 1
		var ack: PackedByteArray = decoder.get_ack(Vector3(-20, 3, 0))
		if not ack.is_empty():
			encoder.take_ack(1, ack)
	is_true(told[0] > 150 and told[2] > 150, "in sight: %s" % told)
	is_true(told[1] > 2 and told[1] < 40, "behind the wall: %s" % told)


func test_an_empty_world() -> void:
	is_null(await _survey())
	var shapeless: StaticBody3D = StaticBody3D.new()
	shapeless.add_child(CollisionShape3D.new())
	_world.add_child(shapeless)
	is_null(await _survey())


func test_a_world_without_end() -> void:
	_add(Vector3.ZERO, Vector3(2.0 * VisibilityCells.FARTHEST_M, 1.0, 10.0))
	is_null(await _survey())
	_world.queue_free()
	_world = Node3D.new()
	add_child(_world)
	var plane: StaticBody3D = StaticBody3D.new()
	var shape: CollisionShape3D = CollisionShape3D.new()
	shape.shape = WorldBoundaryShape3D.new()
	plane.add_child(shape)
	_world.add_child(plane)
	_add(Vector3.ZERO, Vector3(8.0, 1.0, 8.0))
	var cells: VisibilityCells = await _survey()
	is_true(cells == null or cells.visible.size() > 0, "an endless floor does no harm")


func test_a_large_world_gets_larger_cells() -> void:
	_add(Vector3(0.0, -0.5, 0.0), Vector3(300.0, 1.0, 300.0))
	_add(Vector3(0.0, 9.5, 0.0), Vector3(300.0, 1.0, 300.0))
	var cells: VisibilityCells = await _survey()
	var count: int = cells.counts.x * cells.counts.y * cells.counts.z
	is_true(count <= VisibilityCells.MAX_CELLS, "%d cells" % count)
	is_true(count > VisibilityCells.MAX_CELLS / 4, "%d cells" % count)
	is_true(cells.size > VisibilityCells.MIN_M)
	equal(cells.visible.size(), count * count)
	var end: Vector3 = cells.origin + Vector3(cells.counts) * cells.size
	is_true(
		cells.origin.x <= -150.0 and cells.origin.y <= -1.0 and end.x >= 150.0 and end.y >= 10.0
	)


## Two rooms, 24 m by 24 m, with a wall between them, floor and ceiling.
func _build_rooms() -> void:
	for side: float in [-1.0, 1.0]:
		_add(Vector3(0.0, 3.0 + 4.0 * side, 0.0), Vector3(48.0, 1.0, 24.0))
		_add(Vector3(23.5 * side, 3.0, 0.0), Vector3(1.0, 7.0, 24.0))
		_add(Vector3(0.0, 3.0, 12.5 * side), Vector3(48.0, 9.0, 1.0))
	_add(Vector3.ZERO + Vector3(0.0, 3.0, 0.0), Vector3(1.0, 9.0, 26.0))


func _add(p_middle: Vector3, p_size: Vector3) -> void:
	var body: StaticBody3D = StaticBody3D.new()
	body.position = p_middle
	_fill(body, p_size)


func _fill(p_body: PhysicsBody3D, p_size: Vector3) -> void:
	var shape: CollisionShape3D = CollisionShape3D.new()
	var box: BoxShape3D = BoxShape3D.new()
	box.size = p_size
	shape.shape = box
	p_body.add_child(shape)
	_world.add_child(p_body)


func _survey() -> VisibilityCells:
	await physics_frames(2)
	return VisibilityCells.survey(_world)


func _sees(p_cells: VisibilityCells, p_from: Vector3, p_to: Vector3) -> bool:
	var count: int = p_cells.counts.x * p_cells.counts.y * p_cells.counts.z
	return p_cells.visible[_cell(p_cells, p_from) * count + _cell(p_cells, p_to)] == 1


func _cell(p_cells: VisibilityCells, p_place: Vector3) -> int:
	var at: Vector3i = Vector3i(((p_place - p_cells.origin) / p_cells.size).floor())
	return (at.x * p_cells.counts.z + at.z) * p_cells.counts.y + at.y
