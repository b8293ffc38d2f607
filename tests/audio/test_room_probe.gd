extends TestCase
## Rooms by their size and walls.


func after_each() -> void:
	for child: Node in get_children():
		child.queue_free()
	await process_frames(2)


func test_the_open_is_no_room() -> void:
	var probe: RoomProbe = RoomProbe.new()
	probe.look(_space(), Vector3.ZERO, 12)
	is_false(probe.is_room())
	equal(probe.wetness(), 0.0)


func test_a_hall_rings_longer_than_a_chamber() -> void:
	var small: RoomProbe = await _probe_in(Vector3(4.0, 2.6, 4.0), 0.1)
	is_true(small.is_room())
	var hall: RoomProbe = await _probe_in(Vector3(40.0, 12.0, 24.0), 0.1)
	is_true(hall.is_room())
	is_true(hall.time_s() > 1.8 * small.time_s(), "%f %f" % [hall.time_s(), small.time_s()])
	is_true(hall.reverb_size() > small.reverb_size())


func test_soft_walls_ring_shorter() -> void:
	var hard: RoomProbe = await _probe_in(Vector3(10.0, 4.0, 10.0), 0.03)
	var soft: RoomProbe = await _probe_in(Vector3(10.0, 4.0, 10.0), 0.4)
	is_true(soft.time_s() < hard.time_s() * 0.4)


func _probe_in(p_size: Vector3, p_absorption: float) -> RoomProbe:
	for child: Node in get_children():
		child.free()
	for axis: int in 3:
		for side: float in [-0.5, 0.5]:
			var wall: StaticBody3D = StaticBody3D.new()
			var shape: CollisionShape3D = CollisionShape3D.new()
			var box: BoxShape3D = BoxShape3D.new()
			box.size = p_size + Vector3.ONE
			box.size[axis] = 0.3
			shape.shape = box
			wall.add_child(shape)
			wall.position[axis] = p_size[axis] * side
			add_child(wall)
	await physics_frames(2)
	var probe: RoomProbe = RoomProbe.new()
	probe.absorption_of = func(_collider: Object, _place: Vector3) -> float: return p_absorption
	probe.look(_space(), Vector3.ZERO, 12)
	return probe


func _space() -> PhysicsDirectSpaceState3D:
	return get_viewport().find_world_3d().direct_space_state
