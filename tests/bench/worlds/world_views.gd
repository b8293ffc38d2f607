extends SceneTree
## Looks at a world from many places, with visible sets and without, and writes what was drawn as
## JSON: draw calls, primitives and times along a path, views whose pictures differ, frame times of
## the tiers of quality. Needs a window: [code]./run bench worlds[/code] starts it.
## Options: --world=NAME, --out=FILE, --steps=N (of the path), --views=N (random ones), --seed=N,
## --tiers=N (frames of each).

const Flight: GDScript = preload("world_flight.gd")
## Pictures differ where more pixels than this differ by more than so much of 255.
const MAX_PIXELS: int = 12
const MAX_STEP: int = 12

var _options: Dictionary[String, String] = {
	"world": "town", "steps": "24", "views": "0", "seed": "1", "tiers": "0"
}
var _level: Level = null
var _flight: Flight = null
var _dice: RandomNumberGenerator = RandomNumberGenerator.new()


func _initialize() -> void:
	for argument: String in OS.get_cmdline_user_args():
		if argument.begins_with("--") and argument.contains("="):
			_options[argument.get_slice("=", 0).trim_prefix("--")] = argument.get_slice("=", 1)
	_dice.seed = _options["seed"].to_int()
	_measure.call_deferred()


func _measure() -> void:
	Quality.use(QualityTier.high(), root)
	var begin: int = ThreadClock.get_usec()
	_level = LevelStore.instantiate(_options["world"])
	if _level == null:
		printerr(LevelStore.describe_missing(_options["world"]))
		quit(2)
		return
	root.add_child(_level)
	var loaded: int = ThreadClock.get_usec()
	var camera: Camera3D = Camera3D.new()
	camera.fov = 70.0
	root.add_child(camera)
	camera.make_current()
	_flight = Flight.new(_level, camera)
	for frame: int in 3:
		await physics_frame
	# What the eye gets used to takes a while, and is no matter here.
	_level.surfaces.air.set_process(false)
	WorldLight.set_exposure(1.0)
	var has_sets: bool = _level.visibility != null
	var result: Dictionary = {"has_sets": has_sets, "load_ms": (loaded - begin) / 1000.0}
	result["path"] = await _fly(has_sets, _options["steps"].to_int())
	if has_sets:
		result["cells"] = _cells_seen(3.0)
		result["views"] = await _compare(_options["views"].to_int())
	result["tiers"] = await _time_tiers(_options["tiers"].to_int())
	var file: FileAccess = FileAccess.open(_options["out"], FileAccess.WRITE)
	file.store_string(JSON.stringify(result))
	file.close()
	quit()


## What is drawn at each step of the path: draw calls, thousands of primitives.
func _fly(p_has_sets: bool, p_steps: int) -> Dictionary:
	var with_sets: Array[Array] = []
	var without: Array[Array] = []
	for step: int in p_steps:
		_flight.look(_options["world"], float(step) / p_steps)
		if p_has_sets:
			with_sets.append(await _count(true))
		without.append(await _count(false))
	return {"with": with_sets, "without": without}


func _count(p_has_sets: bool) -> Array:
	for _frame: int in 2:
		await _flight.draw(p_has_sets)
	return _flight.counts()


## Random views from where people stand: the most draw calls, and how many views differ.
func _compare(p_count: int) -> Dictionary:
	var wrong: Array[String] = []
	var most: float = 0.0
	for number: int in p_count:
		var eye: Vector3 = _random_eye()
		var yaw: float = _dice.randf() * TAU
		var way: Vector3 = Vector3(sin(yaw), _dice.randf_range(-0.35, 0.35), cos(yaw))
		_flight.camera.look_at_from_position(eye, eye + way)
		await _flight.draw(true)
		most = maxf(most, _flight.counts()[0])
		var hidden: Image = root.get_texture().get_image()
		await _flight.draw(false)
		var whole: Image = root.get_texture().get_image()
		var pixels: int = _differing(hidden, whole)
		if pixels > MAX_PIXELS:
			wrong.append("%s towards %s: %d pixels" % [eye, way, pixels])
	return {"count": p_count, "wrong": wrong, "most_draws": most}


## The mean share of the cells that are seen from where people stand below a height, m.
func _cells_seen(p_below: float) -> float:
	var bake: LevelBake = _level.surfaces.bake
	var count: int = bake.cell_counts.x * bake.cell_counts.y * bake.cell_counts.z
	var sum: int = 0
	var eyes: int = 0
	for _try: int in 400:
		var eye: Vector3 = _random_eye()
		var cell: int = bake.cell_at(eye)
		if cell < 0 or eye.y > p_below:
			continue
		eyes += 1
		sum += bake.seen_cells.slice(cell * count, (cell + 1) * count).count(1)
	return float(sum) / maxi(eyes, 1) / count


## Over a floor, a stair or a roof, with air around.
func _random_eye() -> Vector3:
	var bake: LevelBake = _level.surfaces.bake
	var box: AABB = AABB(bake.cell_origin, Vector3(bake.cell_counts) * bake.cell_size).grow(-6.0)
	var space: PhysicsDirectSpaceState3D = root.world_3d.direct_space_state
	var ball: SphereShape3D = SphereShape3D.new()
	ball.radius = 0.25
	var query: PhysicsShapeQueryParameters3D = PhysicsShapeQueryParameters3D.new()
	query.shape = ball
	for tried: int in 200:
		var at: Vector3 = box.position + Vector3(_dice.randf(), 0.0, _dice.randf()) * box.size
		at.y = _flight.ground(Vector3(at.x, _dice.randf_range(1.0, 11.0), at.z)) + Flight.EYE_M
		query.transform.origin = at
		if at.y < 11.5 and space.intersect_shape(query, 1).is_empty():
			return at
	return Vector3(0.0, Flight.EYE_M, 0.0)


## Mean time of a frame along the path in each tier of quality, ms.
func _time_tiers(p_frames: int) -> Dictionary:
	var times: Dictionary[String, float] = {}
	for name: String in Quality.NAMES if p_frames > 0 else []:
		Quality.use(Quality.find(name), root)
		var spent: int = 0
		for frame: int in p_frames:
			_flight.look(_options["world"], float(frame) / p_frames)
			await _flight.draw(true)
			var begin: int = Time.get_ticks_usec()
			await _flight.draw(true)
			spent += Time.get_ticks_usec() - begin
		times[name] = spent / 1000.0 / p_frames
	return times


static func _differing(p_a: Image, p_b: Image) -> int:
	var a: PackedByteArray = p_a.get_data()
	var b: PackedByteArray = p_b.get_data()
	if a == b:
		return 0
	var step: int = 4 if p_a.get_format() == Image.FORMAT_RGBA8 else 3
	var pixels: int = 0
	for index: int in range(0, a.size(), step):
		for channel: int in 3:
			if absi(a[index + channel] - b[index + channel]) > MAX_STEP:
				pixels += 1
				break
	return pixels
