class_name VehicleWander
extends RefCounted
## A vehicle driven at random over a world, with an eye on its energy and on where it is.

## Dunes, a town, a place full of crates.
const WORLDS: PackedStringArray = ["desert", "town", "crates"]
const HZ: int = 60
## Kinetic energy may not be above that at this speed, m/s, besides what a fall gives.
const MAX_SPEED: float = 40.0
## A middle of the hull that is deeper in the ground than this is inside it, m.
const DEEP_M: float = 0.0
## Who has not come 1 m further in this time is put upright, s.
const STUCK_S: float = 8.0
## The world's edge: beyond it the vehicle is put back, m.
const EDGE_M: float = 230.0

var _tree: SceneTree = null
var _preset: String = ""
var _kind: VehicleParameters.GearKind = VehicleParameters.GearKind.SPHERES
var _world: String = ""
var _ground: VehicleGround = null
var _terrain: Terrain = null
var _vehicle: Vehicle = null
var _starts: PackedVector3Array = [Vector3(0.0, 0.3, 0.0)]
var _random: RandomNumberGenerator = RandomNumberGenerator.new()
var _hash: int = 0
var _fastest: float = 0.0
var _spin: float = 0.0
var _inside: int = 0
var _lost: int = 0
var _uprights: int = 0
var _way: float = 0.0


func _init(
	p_tree: SceneTree, p_preset: String, p_kind: VehicleParameters.GearKind, p_world: String
) -> void:
	_tree = p_tree
	_preset = p_preset
	_kind = p_kind
	_world = p_world


## Drives for some minutes of simulated time.
func run(p_seed: int, p_minutes: float) -> void:
	_random.seed = p_seed
	await _build()
	var until: int = 0
	var rest_from: Vector3 = _vehicle.position
	var rest_since: int = 0
	var last: Vector3 = _vehicle.position
	for tick: int in int(p_minutes * 60.0 * HZ):
		if tick >= until:
			until = tick + _random.randi_range(30, 240)
			_choose()
		await _tree.physics_frame
		_check()
		_way += minf(_vehicle.position.distance_to(last), 2.0)
		last = _vehicle.position
		if _vehicle.position.distance_to(rest_from) > 1.0:
			rest_from = _vehicle.position
			rest_since = tick
		if tick - rest_since > int(STUCK_S * HZ):
			rest_since = tick
			_uprights += 1
			_free_it()
		if tick % 30 == 0:
			_note()


## What came of it.
func outcome() -> Dictionary:
	return {
		"hash": str(_hash),
		"fastest": _fastest,
		"spin": _spin,
		"inside": _inside,
		"lost": _lost,
		"uprights": _uprights,
		"way": _way,
	}


## Boxes of 300 kg in a heap.
static func add_crates(p_ground: VehicleGround, p_at: Vector3, p_count: int) -> void:
	var wood: PhysicsMaterial = PhysicsMaterial.new()
	wood.friction = 0.5
	for index: int in p_count:
		var crate: RigidBody3D = RigidBody3D.new()
		crate.add_child(BenchBodies.box(Vector3(0.9, 0.9, 0.9)))
		crate.mass = 300.0
		crate.physics_material_override = wood
		crate.collision_layer = 4
		crate.collision_mask = 7
		var column: int = index % 10
		crate.position = (
			p_at + Vector3(1.0 * (column % 5) - 2.0, 0.46 + 0.92 * (index / 10), 1.0 * (column / 5))
		)
		p_ground.view.add_child(crate)


## Runs seeds in processes of their own, each twice, and reports.
static func run_seeds(
	p_report: BenchReport,
	p_gear: String,
	p_options: PackedStringArray,
	p_worlds: PackedStringArray,
	p_seeds: int
) -> void:
	for world: String in p_worlds:
		var totals: Dictionary[String, float] = {
			"fastest": 0.0, "spin": 0.0, "inside": 0.0, "lost": 0.0, "uprights": 0.0, "way": 0.0
		}
		var others: int = 0
		var done: int = 0
		for number: int in p_seeds:
			if number % p_worlds.size() != p_worlds.find(world) and p_worlds.size() > 1:
				continue
			var twice: Array[Dictionary] = _run_twice(p_options, world, number)
			if twice[0].is_empty() or twice[1].is_empty():
				p_report.leave_out("seed %d in %s" % [number, world], "its process failed")
				continue
			done += 1
			others += 0 if twice[0]["hash"] == twice[1]["hash"] else 1
			for key: String in totals:
				var value: float = twice[0][key]
				totals[key] = (
					maxf(totals[key], value) if key in ["fastest", "spin"] else totals[key] + value
				)
		if done > 0:
			_tell(p_report, "%s, %s, %d seeds" % [p_gear, world, done], totals, others)


static func _tell(
	p_report: BenchReport, p_case: String, p_totals: Dictionary[String, float], p_others: int
) -> void:
	p_report.add(p_case, "way", 0.001 * p_totals["way"], "km")
	p_report.at_most(p_case, "fastest", p_totals["fastest"], "m/s", MAX_SPEED)
	p_report.at_most(p_case, "fastest turn", p_totals["spin"], "rad/s", 8.0)
	p_report.at_most(p_case, "ticks inside the ground", p_totals["inside"], "", 0.0)
	p_report.at_most(p_case, "states that are not finite", p_totals["lost"], "", 0.0)
	p_report.add(p_case, "put upright or freed", p_totals["uprights"], "")
	p_report.at_most(p_case, "seeds with another hash the second time", p_others, "", 0.0)


static func _run_twice(
	p_options: PackedStringArray, p_world: String, p_seed: int
) -> Array[Dictionary]:
	var results: Array[Dictionary] = [{}, {}]
	var threads: Array[Thread] = []
	for time: int in 2:
		var thread: Thread = Thread.new()
		thread.start(_run_process.bind(p_options, p_world, p_seed))
		threads.append(thread)
	for time: int in 2:
		results[time] = threads[time].wait_to_finish()
	return results


static func _run_process(p_options: PackedStringArray, p_world: String, p_seed: int) -> Dictionary:
	var command: PackedStringArray = [
		"--headless", "--path", ProjectSettings.globalize_path("res://")
	]
	command.append_array(["--fixed-fps", "60", "-s", "res://tests/bench/bench_vehicle.gd", "--"])
	command.append_array(p_options)
	command.append_array(["--world=" + p_world, "--seed=%d" % p_seed])
	var output: Array = []
	OS.execute(OS.get_executable_path(), command, output)
	for line: String in (output[0] as String).split("\n"):
		if line.begins_with("{"):
			return JSON.parse_string(line)
	return {}


func _build() -> void:
	_ground = VehicleGround.new(_tree.root)
	if _world == "crates":
		_ground.add_floor()
		for heap: int in 12:
			var angle: float = TAU * heap / 12.0
			add_crates(_ground, Vector3(25.0 * cos(angle), 0.0, 25.0 * sin(angle)), 20)
	else:
		var level: Level = LevelStore.instantiate(_world)
		_ground.view.add_child(level)
		for node: Node in level.find_children("*", "Terrain", true, false):
			_terrain = node
		_starts.clear()
		for point: Node3D in level.get_spawn_points() if _terrain != null else _roads(level):
			_starts.append(point.global_position + Vector3(0.0, 0.3, 0.0))
		if _terrain == null:
			# The world beyond the town's edge.
			_ground.add_floor().position.y -= 0.1
	_vehicle = _ground.add_vehicle(_preset, _kind, _place())
	for _tick: int in 60:
		await _tree.physics_frame


func _roads(p_level: Level) -> Array[Node]:
	return p_level.find_children("Road*", "StaticBody3D", true, false)


## One of the places where people start, above the ground.
func _place() -> Transform3D:
	var at: Vector3 = _starts[_random.randi() % _starts.size()]
	if _terrain != null:
		at.y = _terrain.height_at(at) + 0.5
	return Transform3D(Basis(Vector3.UP, _random.randf_range(0.0, TAU)), at)


func _choose() -> void:
	var input: VehicleInput = _vehicle.input
	input.clear()
	var dice: float = _random.randf()
	input.throttle = (
		_random.randf_range(0.3, 1.0) if dice < 0.75 else _random.randf_range(-1.0, 0.0)
	)
	input.brake = 1.0 if _random.randf() < 0.08 else 0.0
	input.steer = 0.0 if _random.randf() < 0.4 else _random.randf_range(-1.0, 1.0)


func _check() -> void:
	if not _vehicle.global_transform.is_finite() or not _vehicle.linear_velocity.is_finite():
		_lost += 1
		return
	_fastest = maxf(_fastest, _vehicle.linear_velocity.length())
	_spin = maxf(_spin, _vehicle.angular_velocity.length())
	var middle: Vector3 = _vehicle.to_global(_vehicle.center_of_mass)
	var floor_height: float = -1.0 if _terrain == null else _terrain.height_at(middle) - DEEP_M
	if middle.y < floor_height:
		_inside += 1
	elif _is_in_solid(middle):
		_inside += 1
	var flat: Vector2 = Vector2(_vehicle.position.x, _vehicle.position.z)
	if flat.length() > EDGE_M or _vehicle.position.y < -100.0:
		_vehicle.teleport(_place())


func _is_in_solid(p_point: Vector3) -> bool:
	var query: PhysicsPointQueryParameters3D = PhysicsPointQueryParameters3D.new()
	query.position = p_point
	query.collision_mask = 1
	var space: PhysicsDirectSpaceState3D = _vehicle.get_world_3d().direct_space_state
	return not space.intersect_point(query, 1).is_empty()


## Somebody gets it out: upright, and away from what it is stuck at.
func _free_it() -> void:
	if _vehicle.global_basis.y.y > 0.7:
		_vehicle.teleport(_place())
	else:
		_vehicle.reset_upright()


func _note() -> void:
	var state: Array = [
		_hash,
		_vehicle.global_transform,
		_vehicle.linear_velocity,
		_vehicle.angular_velocity,
		_vehicle.state.rpm,
	]
	_hash = hash(state)
