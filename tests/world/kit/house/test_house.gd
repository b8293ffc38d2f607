extends TestCase
## Houses: a person gets in by the door, up the stairs and onto the roof, and nothing gets through
## walls; the same numbers give the same house.

const PersonWalk: GDScript = preload("res://tests/world/kit/person_walk.gd")
const SIZES: Array[Vector2] = [Vector2(7.0, 7.8), Vector2(8.5, 9.0), Vector2(11.0, 10.5)]

var _house: House = null


func after_each() -> void:
	if _house != null:
		_house.free()
		_house = null


func test_a_person_walks_in_through_the_door() -> void:
	for size: Vector2 in SIZES:
		for variant: int in [1, 2, 7, 40]:
			await _stand(size, 2, variant)
			var door: Vector3 = _house.get_door_place().origin
			var way: Array[Vector3] = [door + Vector3(0, 0, 1.0), door + Vector3(0, 0, -0.9)]
			equal(_walk(way), "", "%s, variant %d" % [size, variant])
			after_each()


func test_a_door_hangs_in_each_doorway() -> void:
	var names: Dictionary[StringName, bool] = {}
	await _stand(SIZES[2], 3, 4)
	var wanted: int = 0
	for storey: Array in _house.plan().openings:
		for wall: Array in storey:
			for opening: HousePlan.Opening in wall:
				if opening.kind in [HousePlan.Kind.DOOR, HousePlan.Kind.BALCONY]:
					wanted += 1
	for door: Door in _doors():
		names[door.name] = true
		is_true(door.global_basis.y.is_equal_approx(Vector3.UP))
	is_true(wanted > 1)
	equal(names.size(), wanted, "clients find them by their names")
	_house.doors = false
	_house.rebuild()
	equal(_doors().size(), 0)


func test_a_person_climbs_from_floor_to_floor_onto_the_roof() -> void:
	for size: Vector2 in SIZES:
		for storeys: int in [1, 2, 3]:
			await _stand(size, storeys, 5)
			var stairs: Rect2 = _house.plan().stairs_rect()
			var x: float = stairs.get_center().x
			for storey: int in storeys:
				var y: float = storey * HousePlan.STOREY_M
				var above: float = y + HousePlan.STOREY_M
				var way: Array[Vector3] = [
					Vector3(stairs.position.x - 0.6, y, -stairs.end.y - 0.6),
					Vector3(x, y, -stairs.end.y - 0.6),
					Vector3(x, above, -stairs.position.y + 0.3),
					Vector3(x, above, -stairs.position.y + 0.55),
					Vector3(x - 1.4, above, -stairs.position.y + 0.55),
				]
				equal(_walk(way), "", "%s, storey %d of %d" % [size, storey, storeys])
			after_each()


func test_the_roof_holds_and_its_parapet_stops() -> void:
	await _stand(SIZES[1], 2, 3)
	var roof: float = 2.0 * HousePlan.STOREY_M
	var hit: Dictionary = _ray(Vector3(2.0, roof + 1.0, -2.0), Vector3(2.0, roof - 3.0, -2.0))
	almost_equal((hit["position"] as Vector3).y, roof, 0.01)
	hit = _ray(Vector3(2.0, roof + 0.5, -2.0), Vector3(-3.0, roof + 0.5, -2.0))
	is_false(hit.is_empty(), "the parapet is open")


func test_windows_are_open_and_walls_are_not() -> void:
	await _stand(SIZES[2], 2, 9)
	var windows: int = 0
	var walls: int = 0
	for step: int in 100:
		var x: float = 0.45 + 0.1 * step
		var at: Vector2 = Vector2(x, 1.7)
		var near: bool = false
		var wanted: bool = false
		for opening: HousePlan.Opening in _house.plan().openings[1][HousePlan.Facade.FRONT]:
			near = near or opening.rect.grow(0.1).has_point(at)
			var is_window: bool = opening.kind == HousePlan.Kind.WINDOW
			wanted = wanted or (is_window and opening.rect.grow(-0.05).has_point(at))
		if near and not wanted:
			continue
		var from: Vector3 = Vector3(x, HousePlan.STOREY_M + 1.7, 1.0)
		equal(_ray(from, from + Vector3(0.0, 0.0, -1.34)).is_empty(), wanted, "at x = %.2f" % x)
		windows += 1 if wanted else 0
		walls += 0 if wanted else 1
	is_true(windows > 3 and walls > 20, "%d, %d" % [windows, walls])


func test_a_house_that_is_not_entered_is_solid_and_costs_less() -> void:
	await _stand(SIZES[1], 2, 4)
	var open: int = _mesh().get_triangle_count()
	_house.entered = false
	await physics_frames(2)
	var shut: int = _mesh().get_triangle_count()
	is_true(shut < open * 0.6, "%d of %d" % [shut, open])
	is_false(_ray(Vector3(4.0, 1.0, 3.0), Vector3(4.0, 1.0, -4.0)).is_empty())
	equal(_house.get_parts(), [KitBlock.OUTSIDE, KitBlock.ROOF] as Array[StringName])


func test_nobody_looks_through_a_house_that_is_not_entered() -> void:
	for variant: int in 6:
		_house = House.new()
		_house.size = SIZES[variant % 3]
		_house.storeys = 3
		_house.variant = variant
		_house.entered = false
		var mesh: BlockMesh = KitBlock.make_mesh(false)
		for part: StringName in _house.get_parts():
			_house.build(mesh, part)
		var tracer: LevelTracer = LevelTracer.new()
		tracer.set_effort(4, 0, 1)
		tracer.add_part(mesh)
		tracer.bake()
		equal(_gaps(tracer, _house.plan()), PackedStringArray(), "variant %d" % variant)
		after_each()


func test_the_same_numbers_give_the_same_house_and_others_another() -> void:
	await _stand(SIZES[1], 2, 4)
	var first: PackedVector3Array = _mesh().get_points()
	equal(_mesh().get_points(), first)
	_house.variant = 5
	is_false(_mesh().get_points() == first)


func test_a_house_without_room_for_stairs_warns() -> void:
	_house = House.new()
	equal(_house._get_configuration_warnings().size(), 0)
	_house.size = Vector2(6.0, 5.0)
	contains(_house._get_configuration_warnings()[0], "There is no room for stairs")
	_house.entered = false
	equal(_house._get_configuration_warnings().size(), 0)


func _stand(p_size: Vector2, p_storeys: int, p_variant: int) -> void:
	_house = House.new()
	_house.size = p_size
	_house.storeys = p_storeys
	_house.variant = p_variant
	add_child(_house)
	await physics_frames(2)


func _mesh() -> BlockMesh:
	var mesh: BlockMesh = KitBlock.make_mesh(false)
	for part: StringName in _house.get_parts():
		_house.build(mesh, part)
	return mesh


## Where rays from outside get through what fills the openings.
func _gaps(p_tracer: LevelTracer, p_plan: HousePlan) -> PackedStringArray:
	# Two centimetres are a gap.
	const ACROSS: int = 100
	const UP: int = 160
	var gaps: PackedStringArray = []
	for storey: int in p_plan.openings.size():
		for wall: int in p_plan.openings[storey].size():
			var way: Vector3 = HousePlan.along(wall)
			var corner: Vector3 = p_plan.corner_of(wall, HousePlan.STOREY_M * storey)
			for opening: HousePlan.Opening in p_plan.openings[storey][wall]:
				var through: int = 0
				for step: int in ACROSS * UP:
					var share: Vector2 = Vector2(step % ACROSS + 0.5, step / ACROSS + 0.5)
					share /= Vector2(ACROSS, UP)
					var at: Vector2 = opening.rect.position + opening.rect.size * share
					var from: Vector3 = corner + way * at.x + Vector3.UP * at.y
					var out: Vector3 = way.cross(Vector3.UP)
					if not p_tracer.is_blocked(from + out * 0.5, from - out * 0.5):
						through += 1
				if through > 0:
					gaps.append(
						"storey %d, wall %d, %s: %d" % [storey, wall, opening.rect, through]
					)
	return gaps


func _ray(p_from: Vector3, p_to: Vector3) -> Dictionary:
	var query: PhysicsRayQueryParameters3D = PhysicsRayQueryParameters3D.create(p_from, p_to)
	return _house.get_world_3d().direct_space_state.intersect_ray(query)


## Moves a capsule of a person's size along points on the ground, over steps; returns where it is
## stopped.
func _walk(p_way: Array[Vector3]) -> String:
	var needs_ground: Callable = func(p_feet: Vector3) -> bool: return p_feet.z < 0.0
	return PersonWalk.walk(_house, p_way, needs_ground)


func _doors() -> Array[Node]:
	return _house.get_children(true).filter(func(node: Node) -> bool: return node is Door)
