extends Bench
## What carries people, and what becomes of them when they are pushed or the ground is not level.
##
## Options: --scene=stand|clip|gaits|push|rise|ball|blocked|slopes|stairs|crates|wall|doors|
## platforms or town (again for more; default all),
## --root=grounded|soft|inertial|held|lowest_foot|contacts|pendulum|self_righting (default
## grounded), --bvh=FILE (of the scenes clip, gaits, crates and blocked, again for more; default
## the clips in assets/motion), --obstacle=wall|corner|table|door (of blocked, again for more),
## --hz=60, --set=PROPERTY=NUMBER (of Ragdoll, again for more), --world=NAME, --way=KIND (of the
## scene town; KIND again for more; default all).

const _SCENES: Array[String] = [
	"stand",
	"clip",
	"gaits",
	"push",
	"rise",
	"ball",
	"blocked",
	"slopes",
	"stairs",
	"crates",
	"wall",
	"doors",
	"platforms",
	"town"
]
## Of long clips so much is played, s; shorter ones tell nothing.
const _MAX_S: float = 60.0
const _MIN_S: float = 1.0
## The weight on the floor in a clip: that of runs, as nobody knows what a file is.
const _CLIP_SHARE: float = 85.0

## See [method _torque_goal].
const _TORQUES: Array[float] = [15.0, 60.0, 150.0]

## Worlds of people who get up.
const _RISE_BATCHES: int = 5

var _properties: Dictionary[StringName, float] = {}


func options() -> Dictionary:
	return {
		"scene": ["", _SCENES],
		"root": ["grounded", RootModes.BY_NAME.keys()],
		"bvh": "",
		"hz": [60, 10, 1000],
		"set": "",
		"obstacle": ["", GroundObstacles.KINDS],
		"world": "town",
		"way": ["", TownWays.KINDS]
	}


## Reads --set.
func find_fault() -> String:
	for pair: String in arguments.list("set"):
		if not pair.get_slice("=", 1).is_valid_float():
			return "--set expects NAME=NUMBER, found '%s'" % pair
		_properties[StringName(pair.get_slice("=", 0))] = pair.get_slice("=", 1).to_float()
	return ""


func measure() -> void:
	Engine.physics_ticks_per_second = option("hz")
	for name: String in _SCENES:
		if name in values("scene", _SCENES):
			await _play(name)


func _play(p_name: String) -> void:
	match p_name:
		"stand":
			await _stand()
		"clip":
			for file: String in BenchArguments.clips(arguments):
				await _clip(file)
		"gaits":
			for file: String in BenchArguments.clips(arguments):
				await _gaits(file, GroundGaits.KINDS)
		"crates":
			for file: String in BenchArguments.clips(arguments):
				await _gaits(file, [GroundGaits.CRATES])
		"push":
			await _push()
		"rise":
			await _rise()
		"ball":
			await _ball()
		"blocked":
			await _blocked()
		"town":
			await _town()
		_:
			await GroundWalks.new(self, report, option("hz"), root_mode(), _soldier()).call(p_name)


## A clip on ground that its wearer does not have.
func _gaits(p_file: String, p_kinds: Array[String]) -> void:
	var performer: ContactPerformer = _open(p_file)
	if performer == null:
		return
	var gaits: GroundGaits = GroundGaits.new(self, report, option("hz"), root_mode())
	for kind: String in p_kinds:
		await gaits.walk(performer, kind, "%s on %s" % [p_file.get_file(), kind])


func _begin(p_performer: ContactPerformer) -> GroundRun:
	var run: GroundRun = GroundRun.new(self, option("hz"))
	run.person = p_performer.enter(run.world, root_mode())
	return run


func _soldier() -> ContactPerformer:
	var source: BvhSource = BvhSource.new()
	source.open("res://assets/motion/01_01.bvh")
	return ContactPerformer.new(source, true, _properties)


func _begin_standing() -> GroundRun:
	var run: GroundRun = _begin(_soldier())
	var pose: PoseSample = ContactPoses.standing(run.person)
	run.world.add_standing(run.person, pose, run.person.standing_hips())
	return run


func _stand() -> void:
	var run: GroundRun = _begin_standing()
	await run.world.run(6.0, run.note)
	_tell("standing", run, 60, 95.0)
	var jitter: float = GroundRun.mean(run.jitter, 60)
	report.at_most("standing", "jitter", jitter, "deg/s", 0.1)
	run.end()


func _ball() -> void:
	var ball: GroundBall = GroundBall.new(report)
	for direction: Vector3 in [Vector3.BACK, Vector3.FORWARD, Vector3.RIGHT, Vector3.LEFT]:
		var run: GroundRun = _begin_standing()
		await ball.throw(run, direction)
		run.end()


func _push() -> void:
	var pushes: GroundPushes = GroundPushes.new(report)
	for impulse: float in [40.0, 80.0, 160.0]:
		for direction: Vector3 in [Vector3.BACK, Vector3.FORWARD, Vector3.RIGHT, Vector3.LEFT]:
			var run: GroundRun = _begin_standing()
			await pushes.push(run, impulse, direction)
			run.end()


func _rise() -> void:
	for load_kg: float in [0.0, 15.0]:
		var rises: GroundRises = GroundRises.new(report)
		for batch: int in _RISE_BATCHES:
			var world: ContactWorld = ContactWorld.new(option("hz"))
			root.add_child(world)
			var soldier: ContactPerformer = _soldier()
			var enter: Callable = func() -> ContactPerson: return soldier.enter(world, root_mode())
			await rises.run(world, enter, load_kg, batch)
			world.queue_free()
		rises.tell(load_kg)


func _blocked() -> void:
	var side: int = 0
	for file: String in BenchArguments.clips(arguments):
		var performer: ContactPerformer = _open(file)
		if performer == null:
			continue
		for kind: String in values("obstacle", GroundObstacles.KINDS):
			var world: ContactWorld = ContactWorld.new(option("hz"))
			root.add_child(world)
			var person: ContactPerson = performer.enter(world, root_mode())
			var blocked: GroundBlocked = GroundBlocked.new()
			await blocked.run(world, person, performer, kind, side)
			blocked.tell(report, "%s, %s" % [kind, file.get_file()])
			world.queue_free()
			side += 1


func _town() -> void:
	var town: GroundTown = GroundTown.new(self, report, option("hz"), root_mode(), _soldier())
	for kind: String in TownWays.KINDS:
		if kind in values("way", TownWays.KINDS):
			await town.run(option("world"), kind)


## Somebody who plays a motion file, or null, which is noted.
func _open(p_file: String) -> ContactPerformer:
	var source: BvhSource = report.open_clip(p_file)
	if source == null:
		return null
	var performer: ContactPerformer = ContactPerformer.new(source, false, _properties)
	if not performer.is_possible():
		report.leave_out(p_file, "no body can be made of its skeleton")
		return null
	if performer.duration() < _MIN_S:
		report.leave_out(p_file, "shorter than %.0f s" % _MIN_S)
		return null
	return performer


func _clip(p_file: String) -> void:
	var performer: ContactPerformer = _open(p_file)
	if performer == null:
		return
	var source: BvhSource = performer.source
	var run: GroundRun = _begin(performer)
	run.world.add_person(
		run.person,
		source.pose_at,
		func(t: float) -> Vector3: return performer.hips_at(t, run.person)
	)
	await run.world.run(minf(performer.duration(), _MAX_S), run.note)
	_tell(p_file.get_file(), run, 30, _CLIP_SHARE)
	run.end()


## Greatest torque from outside, p95, of somebody who stands, walks or runs at a speed, N·m.
func _torque_goal(p_speed: float) -> float:
	return _TORQUES[2 if p_speed >= GroundGaits.RUN else (1 if p_speed >= 0.3 else 0)]


func _tell(p_case: String, p_run: GroundRun, p_from: int, p_share: float) -> void:
	var weight: float = p_run.weight()
	var share: float = 100.0 * GroundRun.mean(p_run.carried, p_from) / weight
	report.at_least(p_case, "weight on the ground", share, "%", p_share)
	var force: float = 100.0 * GroundRun.percentile(p_run.forces, 0.95) / weight
	report.at_most(p_case, "force from outside p95", force, "% of weight", 6.0)
	var torques: PackedFloat64Array = p_run.torques.slice(p_from)
	var middle: float = GroundRun.percentile(torques, 0.5)
	report.add(p_case, "torque from outside, median", middle, "N m")
	var torque: float = GroundRun.percentile(torques, 0.95)
	report.at_most(p_case, "torque from outside p95", torque, "N m", _torque_goal(p_run.speed()))
	report.at_most(p_case, "error", GroundRun.mean(p_run.errors), "deg", 2.0)
	report.at_most(p_case, "error above the legs", GroundRun.mean(p_run.upper), "deg", 1.2)
	report.at_most(
		p_case, "body to wearer p99", GroundRun.percentile(p_run.distances, 0.99), "m", 0.3
	)
