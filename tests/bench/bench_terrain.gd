extends Bench
## Terrain of 500 x 500 m: error of its heights, cost of its shape, boxes and balls thrown at it.
##
## Options: --cells=1000, --throws=10000, --seed=1.

## Goals: error of heights, mm; time until the ground can be stood on, ms; what fell through.
const _GOAL_ERROR_MM: float = 5.0
const _GOAL_LOAD_MS: float = 700.0
const _GOAL_THROUGH: float = 0.0
## Edge of the ground, m.
const _EDGE_M: float = 500.0
## Bodies in the air at once.
const _FLYING: int = 250
## Ticks that each flies and rolls.
const _TICKS: int = 90
## Speeds of boxes and of balls, m/s, and their edges and radius, m.
const _BOX_SPEED: float = 10.0
const _BALL_SPEED: float = 40.0
const _BOX_M: float = 0.5
const _BALL_M: float = 0.11

var _terrain: Terrain = null
var _dice: RandomNumberGenerator = RandomNumberGenerator.new()
var _deepest_m: float = 0.0


func options() -> Dictionary:
	return {"cells": 1000, "throws": 10000, "seed": 1}


func measure() -> void:
	_dice.seed = option("seed")
	await _measure_load()
	await physics_frame
	_measure_heights()
	await _measure_throws("boxes at 10 m/s", _make_box)
	await _measure_throws("balls at 40 m/s", _make_ball)


## The desert where the cells are its own, else dunes of waves.
func _measure_load() -> void:
	var cells: int = option("cells")
	var bytes: PackedByteArray = HeightFile.encode(_waves(cells))
	if cells == 1000:
		bytes = FileAccess.get_file_as_bytes("res://scenes/world/desert/desert.height")
	var memory: int = _resident_kb()
	var begin: int = ThreadClock.get_usec()
	var file: HeightFile = HeightFile.parse(bytes)
	report.add("load", "read and check the file", (ThreadClock.get_usec() - begin) / 1e3, "ms")
	_terrain = Terrain.new()
	_terrain.collision_layer = PhysicsLayers.STATIC
	root.add_child(_terrain)
	_terrain.set_field(file.field)
	await physics_frame
	var spent: float = (ThreadClock.get_usec() - begin) / 1e3
	report.at_most("load", "until it can be stood on", spent, "ms", _GOAL_LOAD_MS)
	report.add("load", "memory", (_resident_kb() - memory) / 1024.0, "MB")


func _waves(p_cells: int) -> HeightField:
	var field: HeightField = HeightField.create(p_cells + 1, p_cells + 1, _EDGE_M / p_cells)
	for index: int in field.points():
		var place: Vector2 = Vector2(index % field.columns, index / field.columns) * field.cell_m
		field.heights[index] = 6.0 * sin(place.x / 23.0) * cos(place.y / 31.0)
	return field


func _measure_heights() -> void:
	var space: PhysicsDirectSpaceState3D = root.world_3d.direct_space_state
	var query: PhysicsRayQueryParameters3D = PhysicsRayQueryParameters3D.new()
	var rays: int = 20000
	var worst: float = 0.0
	var missed: int = 0
	var spent: int = 0
	var half: float = _EDGE_M / 2.0 - 0.01
	for ray: int in rays:
		var place: Vector3 = Vector3(
			_dice.randf_range(-half, half), 0.0, _dice.randf_range(-half, half)
		)
		if ray % 10 == 0:
			# The edge holds too.
			place.x = half * (1.0 if ray % 20 == 0 else -1.0)
		query.from = place + Vector3.UP * 200.0
		query.to = place + Vector3.DOWN * 200.0
		var begin: int = Time.get_ticks_usec()
		var hit: Dictionary = space.intersect_ray(query)
		spent += Time.get_ticks_usec() - begin
		if hit.is_empty():
			missed += 1
			continue
		worst = maxf(worst, absf((hit["position"] as Vector3).y - _terrain.height_at(place)))
	report.at_most("heights", "worst of 20,000 places", worst * 1000.0, "mm", _GOAL_ERROR_MM)
	report.at_most("heights", "holes", missed, "", 0.0)
	report.add("heights", "a ray", float(spent) / rays, "us")


func _measure_throws(p_name: String, p_make: Callable) -> void:
	var through: int = 0
	var thrown: int = 0
	var ticks: int = 0
	var begin: int = ThreadClock.get_usec()
	_deepest_m = 0.0
	while thrown < option("throws"):
		var bodies: Array[RigidBody3D] = []
		for _body: int in mini(_FLYING, option("throws") - thrown):
			bodies.append(p_make.call())
		for _tick: int in _TICKS:
			await physics_frame
			ticks += 1
		for body: RigidBody3D in bodies:
			through += 1 if _is_below(body.global_position) else 0
			body.free()
		thrown += bodies.size()
	report.at_most(p_name, "fell through, of %d" % thrown, through, "", _GOAL_THROUGH)
	report.add(p_name, "deepest centre below the ground", _deepest_m * 1000.0, "mm")
	var spent: float = (ThreadClock.get_usec() - begin) / 1e3
	report.add(p_name, "%d in the air" % _FLYING, spent / ticks, "ms a tick")


## Whether the middle of a body is below the ground, or it has left the level.
func _is_below(p_place: Vector3) -> bool:
	var below: float = _terrain.height_at(p_place) - p_place.y
	_deepest_m = maxf(_deepest_m, below)
	return below > 0.02 or not _terrain.covers(p_place)


func _make_box() -> RigidBody3D:
	return _throw(BenchBodies.box(Vector3.ONE * _BOX_M), 10.0, _BOX_SPEED, _BOX_M)


func _make_ball() -> RigidBody3D:
	return _throw(BenchBodies.ball(_BALL_M), 0.4, _BALL_SPEED, _BALL_M)


## Throws a body at the ground from a little above it, downwards at any angle.
func _throw(p_shape: CollisionShape3D, p_mass: float, p_speed: float, p_size: float) -> RigidBody3D:
	var body: RigidBody3D = RigidBody3D.new()
	body.add_child(p_shape)
	body.mass = p_mass
	body.continuous_cd = true
	body.collision_layer = PhysicsLayers.PROPS
	body.collision_mask = PhysicsLayers.STATIC
	var half: float = _EDGE_M / 2.0 - 80.0
	var place: Vector3 = Vector3(
		_dice.randf_range(-half, half), 0.0, _dice.randf_range(-half, half)
	)
	place.y = _terrain.height_at(place) + 1.0 + p_size + _dice.randf()
	body.position = place
	body.rotation = Vector3(_dice.randf(), _dice.randf(), _dice.randf()) * TAU
	var way: Vector3 = Vector3(_dice.randfn(), -0.15 - 1.5 * _dice.randf(), _dice.randfn())
	body.linear_velocity = way.normalized() * p_speed
	root.add_child(body)
	return body


func _resident_kb() -> int:
	var pages: String = FileAccess.open("/proc/self/statm", FileAccess.READ).get_line()
	return pages.get_slice(" ", 1).to_int() * 4
