extends TestCase
## Where people start: apart, in ranks, not in things.

var _positions: StartPositions = null
var _things: Node3D = null


func before_each() -> void:
	_positions = StartPositions.new()
	_things = Node3D.new()
	add_child(_things)


func after_each() -> void:
	_things.free()


func test_many_stand_apart_in_ranks() -> void:
	_positions.set_points([_at(Vector3(1.0, 0.0, 2.0)), _at(Vector3(3.5, 0.0, 2.0))])
	var taken: Array[Vector3] = []
	for who: int in 100:
		taken.append(_positions.take(who, null).origin)
	equal(taken.slice(0, 2), [Vector3(1.0, 0.0, 2.0), Vector3(3.5, 0.0, 2.0)], "points first")
	almost_equal(_nearest(taken), 2.5, 0.001)
	for position: Vector3 in taken:
		almost_equal(fmod(absf(position.z - 2.0), 2.5), 0.0, 0.001, "in a rank")


func test_who_leaves_makes_room() -> void:
	_positions.set_points([Transform3D.IDENTITY])
	equal(_positions.take(1, null), Transform3D.IDENTITY)
	not_equal(_positions.take(2, null), Transform3D.IDENTITY)
	_positions.release(1)
	equal(_positions.take(3, null), Transform3D.IDENTITY)


func test_sides_start_apart() -> void:
	var points: Array[Transform3D] = [
		_at(Vector3.ZERO), _at(Vector3(50.0, 0.0, 0.0)), _at(Vector3(0.0, 0.0, 50.0))
	]
	_positions.set_points(points, null, ["", "raider", "civilian_man"])
	for who: int in 20:
		var raider: Vector3 = _positions.take(3 * who, null, "raider").origin
		var other: Vector3 = _positions.take(3 * who + 1, null, "soldier").origin
		var civilian: Vector3 = _positions.take(3 * who + 2, null, "civilian_man").origin
		is_true(raider.distance_to(Vector3(50.0, 0.0, 0.0)) < 25.0)
		is_true(civilian.distance_to(Vector3(0.0, 0.0, 50.0)) < 25.0)
		is_true(other.length() < 25.0)


func test_a_side_without_room_starts_with_the_others() -> void:
	_positions.set_points([_at(Vector3.ZERO)], null, ["raider"])
	equal(_positions.take(1, null, "soldier").origin, Vector3.ZERO, "nobody is left out")


func test_nobody_starts_in_behind_or_below_things() -> void:
	_add_box(Vector3(0.0, -0.5, 0.0), Vector3(14.0, 1.0, 14.0))
	# A wall to the right, a crate to the left, and the floor ends.
	_add_box(Vector3(1.6, 1.0, 0.0), Vector3(0.2, 2.0, 20.0))
	_add_box(Vector3(-2.5, 0.5, 0.0), Vector3(1.0, 1.0, 1.0))
	await physics_frames(2)
	var space: PhysicsDirectSpaceState3D = get_viewport().find_world_3d().direct_space_state
	_positions.set_points([Transform3D.IDENTITY], space)
	var taken: Array[Vector3] = []
	for who: int in 8:
		taken.append(_positions.take(who, space).origin)
	equal(taken[0], Vector3.ZERO)
	for position: Vector3 in taken:
		is_true(position.x < 1.0, "not behind the wall: %s" % position)
		is_true(position.z > -7.5, "not beyond the floor: %s" % position)
		is_true(position.distance_to(Vector3(-2.5, 0.0, 0.0)) > 1.0, "not in the crate")
	almost_equal(_nearest(taken), 2.5, 0.001)


func test_a_full_hall_is_filled_more_closely() -> void:
	_add_box(Vector3(0.0, -0.5, 0.0), Vector3(12.0, 1.0, 12.0))
	await physics_frames(2)
	var space: PhysicsDirectSpaceState3D = get_viewport().find_world_3d().direct_space_state
	_positions.set_points([Transform3D.IDENTITY], space)
	var taken: Array[Vector3] = []
	for who: int in 25:
		taken.append(_positions.take(who, space).origin)
	almost_equal(_nearest(taken), 2.5, 0.001)
	for who: int in range(25, 60):
		taken.append(_positions.take(who, space).origin)
	almost_equal(_nearest(taken), 1.25, 0.001)


func test_a_full_level_still_has_a_position() -> void:
	_add_box(Vector3.ZERO, Vector3(400.0, 4.0, 400.0))
	await physics_frames(2)
	var space: PhysicsDirectSpaceState3D = get_viewport().find_world_3d().direct_space_state
	_positions.set_points([Transform3D.IDENTITY], space)
	equal(_positions.take(1, space), Transform3D.IDENTITY)
	equal(_positions.take(2, space), Transform3D.IDENTITY)


func test_everybody_faces_as_the_point_does() -> void:
	# One looks along +X, far from it one along -Z.
	var points: Array[Transform3D] = [
		Transform3D(Basis(Vector3.UP, PI / 2.0), Vector3.ZERO),
		Transform3D(Basis(Vector3.UP, PI), Vector3(0.0, 0.0, 1000.0)),
	]
	_positions.set_points(points)
	equal([_positions.take(0, null), _positions.take(1, null)], points)
	var ranks: Dictionary[int, bool] = {}
	for who: int in range(2, 60):
		var start: Transform3D = _positions.take(who, null)
		var near: Transform3D = points[0 if start.origin.z < 500.0 else 1]
		almost_equal(start.basis, near.basis, 1e-6)
		# Ranks stand behind and before the point, as it faces.
		var seen: Vector3 = near.affine_inverse() * start.origin
		almost_equal(seen.z / 2.5, roundf(seen.z / 2.5), 0.001, "in a rank")
		is_true(absf(seen.x) < 4 * 2.5 + 0.001, "abreast, %s" % seen)
		ranks[roundi(seen.z / 2.5)] = true
	is_true(ranks.size() >= 3, "%s" % [ranks.keys()])


func test_the_room_for_outstretched_arms_is_turned() -> void:
	_add_box(Vector3(0.0, -0.5, 0.0), Vector3(14.0, 1.0, 14.0))
	# A wall 0.6 m before a point that faces +Z; it is beside one that faces +X.
	_add_box(Vector3(0.0, 1.0, 0.7), Vector3(20.0, 2.0, 0.2))
	await physics_frames(2)
	var space: PhysicsDirectSpaceState3D = get_viewport().find_world_3d().direct_space_state
	_positions.set_points([Transform3D.IDENTITY], space)
	equal(_positions.take(0, space).origin, Vector3.ZERO)
	_positions.set_points([Transform3D(Basis(Vector3.UP, PI / 2.0), Vector3.ZERO)], space)
	not_equal(_positions.take(0, space).origin, Vector3.ZERO)


static func _at(p_position: Vector3) -> Transform3D:
	return Transform3D(Basis.IDENTITY, p_position)


static func _nearest(p_positions: Array[Vector3]) -> float:
	var nearest: float = INF
	for i: int in p_positions.size():
		for j: int in i:
			nearest = minf(nearest, p_positions[i].distance_to(p_positions[j]))
	return nearest


func _add_box(p_position: Vector3, p_size: Vector3) -> void:
	var body: StaticBody3D = StaticBody3D.new()
	var shape: CollisionShape3D = CollisionShape3D.new()
	var box: BoxShape3D = BoxShape3D.new()
	box.size = p_size
	shape.shape = box
	body.add_child(shape)
	body.position = p_position
	_things.add_child(body)
