extends SceneTree
## What a world costs without a window, a JSON object for each figure: checking it, crates on its
## static collision, boxes and balls that are thrown at its walls and floors.
## [code]./run bench worlds[/code] starts it.
## Options: --world=NAME, --crates=N, --throws=N, --seed=N.

## Bodies in the air at once, and ticks that each flies.
const FLYING: int = 250
const TICKS: int = 60
## Ticks in which crates come to rest, and in which they are measured.
const SETTLE: int = 30
const MEASURED: int = 240
const BOX_SPEED: float = 10.0
const BALL_SPEED: float = 40.0
const BALL_M: float = 0.11
const CRATE: PackedScene = preload("res://scenes/world/props/crate.tscn")

var _options: Dictionary[String, String] = {
	"world": "town", "crates": "200", "throws": "10000", "seed": "1"
}
var _level: Level = null
var _space: PhysicsDirectSpaceState3D = null
var _dice: RandomNumberGenerator = RandomNumberGenerator.new()
var _box: AABB = AABB()
var _ray: PhysicsRayQueryParameters3D = PhysicsRayQueryParameters3D.new()


func _initialize() -> void:
	for argument: String in OS.get_cmdline_user_args():
		if argument.begins_with("--") and argument.contains("="):
			_options[argument.get_slice("=", 0).trim_prefix("--")] = argument.get_slice("=", 1)
	_dice.seed = _options["seed"].to_int()
	_ray.collision_mask = PhysicsLayers.STATIC
	_run.call_deferred()


func _run() -> void:
	_level = LevelStore.instantiate(_options["world"])
	if _level == null:
		printerr(LevelStore.describe_missing(_options["world"]))
		quit(2)
		return
	root.add_child(_level)
	await physics_frame
	await physics_frame
	_space = root.world_3d.direct_space_state
	var begin: int = ThreadClock.get_usec()
	var check: LevelCheck = LevelCheck.new(_level)
	check.run()
	_tell("check_s", (ThreadClock.get_usec() - begin) / 1e6)
	_tell("faults", check.count_faults())
	var bake: LevelBake = _level.bake
	_box = AABB(bake.cell_origin, Vector3(bake.cell_counts) * bake.cell_size).grow(-4.0)
	await _measure_crates(_options["crates"].to_int())
	var throws: int = _options["throws"].to_int() / 2
	await _throw_many("boxes", throws, _make_box)
	await _throw_many("balls", throws, _make_ball)
	quit()


func _tell(p_what: String, p_value: float) -> void:
	print(JSON.stringify({"what": p_what, "value": p_value}))


## What crates cost that fall on the streets, against the same world without them.
func _measure_crates(p_count: int) -> void:
	var empty_ms: float = await _time_ticks()
	var crates: Array[RigidBody3D] = []
	for _crate: int in p_count:
		var crate: RigidBody3D = CRATE.instantiate()
		crate.position = _open_place() + Vector3.UP * _dice.randf_range(0.0, 2.0)
		root.add_child(crate)
		crates.append(crate)
	for _tick: int in SETTLE:
		await physics_frame
	await _time_ticks()
	for _tick: int in MEASURED:
		await physics_frame
	_tell("crates_resting_ms", await _time_ticks() - empty_ms)
	for crate: RigidBody3D in crates:
		crate.free()


## The mean time of a tick, ms: the engine makes them as fast as it can.
func _time_ticks() -> float:
	var begin: int = Time.get_ticks_usec()
	for _tick: int in MEASURED:
		await physics_frame
	return (Time.get_ticks_usec() - begin) / 1000.0 / MEASURED


## Throws bodies from places in streets and rooms, in any direction. Whose middle passes what never
## moves has gone through.
func _throw_many(p_name: String, p_count: int, p_make: Callable) -> void:
	var through: int = 0
	var done: int = 0
	while done < p_count:
		var bodies: Array[RigidBody3D] = []
		var last: PackedVector3Array = []
		var passed: PackedByteArray = []
		for _body: int in mini(FLYING, p_count - done):
			var body: RigidBody3D = p_make.call()
			bodies.append(body)
			last.append(body.position)
		passed.resize(bodies.size())
		for _tick: int in TICKS:
			await physics_frame
			for index: int in bodies.size():
				var at: Vector3 = bodies[index].global_position
				if passed[index] == 0 and _passes(last[index], at):
					passed[index] = 1
					printerr("%s: through at %s, from %s" % [p_name, at, last[index]])
				last[index] = at
		through += passed.count(1)
		done += bodies.size()
		for body: RigidBody3D in bodies:
			body.free()
	_tell(p_name + "_thrown", done)
	_tell(p_name + "_through", through)


func _passes(p_from: Vector3, p_to: Vector3) -> bool:
	_ray.from = p_from
	_ray.to = p_to
	return not _space.intersect_ray(_ray).is_empty()


func _make_box() -> RigidBody3D:
	var crate: RigidBody3D = CRATE.instantiate()
	return _throw(crate, BOX_SPEED)


func _make_ball() -> RigidBody3D:
	var ball: RigidBody3D = RigidBody3D.new()
	ball.add_child(BenchBodies.ball(BALL_M))
	ball.mass = 0.4
	ball.continuous_cd = true
	return _throw(ball, BALL_SPEED)


func _throw(p_body: RigidBody3D, p_speed: float) -> RigidBody3D:
	p_body.collision_layer = PhysicsLayers.PROPS
	# Others that fly are no matter here.
	p_body.collision_mask = PhysicsLayers.STATIC
	p_body.position = _open_place()
	p_body.rotation = Vector3(_dice.randf(), _dice.randf(), _dice.randf()) * TAU
	var way: Vector3 = Vector3(_dice.randfn(), 0.5 * _dice.randfn(), _dice.randfn())
	p_body.linear_velocity = way.normalized() * p_speed
	root.add_child(p_body)
	return p_body


## A place in the air over a floor, with room for a crate.
func _open_place() -> Vector3:
	var ball: SphereShape3D = SphereShape3D.new()
	ball.radius = 0.5
	var query: PhysicsShapeQueryParameters3D = PhysicsShapeQueryParameters3D.new()
	query.shape = ball
	query.collision_mask = PhysicsLayers.STATIC
	for _try: int in 500:
		var at: Vector3 = _box.position + Vector3(_dice.randf(), 0.0, _dice.randf()) * _box.size
		at.y = _dice.randf_range(0.6, minf(_box.end.y, 10.0))
		query.transform.origin = at
		_ray.from = at
		_ray.to = at + Vector3.DOWN * 12.0
		if (
			_space.intersect_shape(query, 1).is_empty()
			and not _space.intersect_ray(_ray).is_empty()
		):
			return at
	return Vector3.UP * 2.0
