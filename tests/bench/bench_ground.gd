extends SceneTree
## What carries people, and what becomes of them when they are pushed or the ground is not level.
##
## Options: --scene=stand|clip|push|ball|blocked|slopes|stairs|crates|wall|doors|platforms|town
## (again for more; default all),
## --root=grounded|soft|inertial|held|lowest_foot|contacts|pendulum|self_righting (default
## grounded), --bvh=FILE (of the scenes clip and blocked, again for more; default the clips in
## assets/motion), --obstacle=wall|corner|table|door (of blocked, again for more; default all),
## --hz=60, --set=PROPERTY=NUMBER (of Ragdoll, again for more), --trace (prints pushes and the
## deepest limbs as they go), --world=NAME, --way=KIND (of the scene town; KIND again for more;
## default all).

const _SCENES: Array[String] = [
	"stand",
	"clip",
	"push",
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

var _arguments: BenchArguments = null
var _report: BenchReport = null
var _properties: Dictionary[StringName, float] = {}


func _initialize() -> void:
	_arguments = BenchArguments.parse(
		OS.get_cmdline_user_args(),
		{
			"scene": "",
			"root": "grounded",
			"bvh": "",
			"hz": 60,
			"set": "",
			"trace": false,
			"obstacle": "",
			"world": "town",
			"way": ""
		}
	)
	_run.call_deferred()


func _run() -> void:
	var fault: String = _find_fault()
	if fault != "":
		printerr(fault)
		quit(2)
		return
	Engine.physics_ticks_per_second = _arguments.value("hz")
	_report = BenchReport.new("ground", _arguments.value("json"))
	var scenes: PackedStringArray = _arguments.list("scene")
	var walks: GroundWalks = GroundWalks.new(
		self,
		_report,
		_arguments.value("hz"),
		RootModes.BY_NAME[_arguments.value("root")],
		_soldier()
	)
	for name: String in _SCENES:
		if not scenes.is_empty() and not scenes.has(name):
			continue
		match name:
			"stand":
				await _stand()
			"clip":
				for file: String in BenchArguments.clips(_arguments):
					await _clip(file)
			"push":
				await _push()
			"ball":
				await _ball()
			"blocked":
				await _blocked()
			"town":
				await _town()
			_:
				await walks.call(name)
	quit(_report.finish())


func _find_fault() -> String:
	if _arguments.error != "":
		return _arguments.error
	for name: String in _arguments.list("scene"):
		if not name in _SCENES:
			return "--scene is one of %s; found '%s'" % [", ".join(_SCENES), name]
	for name: String in _arguments.list("way"):
		if not name in TownWays.KINDS:
			return "--way is one of %s; found '%s'" % [", ".join(TownWays.KINDS), name]
	if not RootModes.BY_NAME.has(_arguments.value("root")):
		return "--root is one of %s" % ", ".join(RootModes.BY_NAME.keys())
	for name: String in _arguments.list("obstacle"):
		if not name in GroundObstacles.KINDS:
			return "--obstacle is one of %s" % ", ".join(GroundObstacles.KINDS)
	if _arguments.value("hz") < 10 or _arguments.value("hz") > 1000:
		return "a tick rate is between 10 and 1000, found %d" % _arguments.value("hz")
	for pair: String in _arguments.list("set"):
		if not pair.get_slice("=", 1).is_valid_float():
			return "--set expects NAME=NUMBER, found '%s'" % pair
		_properties[StringName(pair.get_slice("=", 0))] = pair.get_slice("=", 1).to_float()
	return ""


func _begin(p_performer: ContactPerformer) -> GroundRun:
	var run: GroundRun = GroundRun.new(self, _arguments.value("hz"))
	run.person = p_performer.enter(run.world, RootModes.BY_NAME[_arguments.value("root")])
	return run


func _soldier() -> ContactPerformer:
	var source: BvhSource = BvhSource.new()
	source.open("res://assets/motion/01_01.bvh")
	return ContactPerformer.new(source, true, _properties)


func _begin_standing() -> GroundRun:
	var run: GroundRun = _begin(_soldier())
	var pose: PoseSample = ContactPoses.standing(run.person)
	var hips: Vector3 = run.person.standing_hips()
	run.world.add_person(
		run.person,
		func(_t: float) -> PoseSample: return pose,
		func(_t: float) -> Vector3: return hips
	)
	return run


func _stand() -> void:
	var run: GroundRun = _begin_standing()
	await run.world.run(6.0, run.note)
	_tell("standing", run, 60, 95.0)
	var jitter: float = GroundRun.mean(run.jitter, 60)
	_report.add("standing", "jitter", jitter, "deg/s", BenchReport.Goal.AT_MOST, 0.1)
	run.end()


func _ball() -> void:
	var ball: GroundBall = GroundBall.new(_report)
	for direction: Vector3 in [Vector3.BACK, Vector3.FORWARD, Vector3.RIGHT, Vector3.LEFT]:
		var run: GroundRun = _begin_standing()
		await ball.throw(run, direction)
		run.end()


func _push() -> void:
	var pushes: GroundPushes = GroundPushes.new(_report, _arguments.value("trace"))
	for impulse: float in [40.0, 80.0, 160.0]:
		for direction: Vector3 in [Vector3.BACK, Vector3.FORWARD, Vector3.RIGHT, Vector3.LEFT]:
			var run: GroundRun = _begin_standing()
			await pushes.push(run, impulse, direction)
			run.end()


func _blocked() -> void:
	var kinds: PackedStringArray = _arguments.list("obstacle")
	var side: int = 0
	for file: String in BenchArguments.clips(_arguments):
		var performer: ContactPerformer = _open(file)
		if performer == null:
			continue
		for kind: String in GroundObstacles.KINDS if kinds.is_empty() else kinds:
			var world: ContactWorld = ContactWorld.new(_arguments.value("hz"))
			root.add_child(world)
			var person: ContactPerson = performer.enter(
				world, RootModes.BY_NAME[_arguments.value("root")]
			)
			var blocked: GroundBlocked = GroundBlocked.new(_arguments.value("trace"))
			await blocked.run(world, person, performer, kind, side)
			blocked.tell(_report, "%s, %s" % [kind, file.get_file()])
			world.queue_free()
			side += 1


func _town() -> void:
	var town: GroundTown = GroundTown.new(
		self,
		_report,
		_arguments.value("hz"),
		RootModes.BY_NAME[_arguments.value("root")],
		_soldier()
	)
	var kinds: PackedStringArray = _arguments.list("way")
	for kind: String in TownWays.KINDS:
		if kinds.is_empty() or kinds.has(kind):
			await town.run(_arguments.value("world"), kind, _arguments.value("trace"))


## Somebody who plays a motion file, or null, which is noted.
func _open(p_file: String) -> ContactPerformer:
	var source: BvhSource = _report.open_clip(p_file)
	if source == null:
		return null
	var performer: ContactPerformer = ContactPerformer.new(source, false, _properties)
	if not performer.is_possible():
		_report.leave_out(p_file, "no body can be made of its skeleton")
		return null
	if performer.duration() < _MIN_S:
		_report.leave_out(p_file, "shorter than %.0f s" % _MIN_S)
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


func _tell(p_case: String, p_run: GroundRun, p_from: int, p_share: float) -> void:
	var at_most: BenchReport.Goal = BenchReport.Goal.AT_MOST
	var weight: float = p_run.weight()
	var share: float = 100.0 * GroundRun.mean(p_run.carried, p_from) / weight
	_report.add(p_case, "weight on the ground", share, "%", BenchReport.Goal.AT_LEAST, p_share)
	var force: float = 100.0 * GroundRun.percentile(p_run.residual, 0.95) / weight
	_report.add(p_case, "force from outside p95", force, "% of weight", at_most, 8.0)
	_report.add(p_case, "error", GroundRun.mean(p_run.errors), "deg", at_most, 2.0)
	_report.add(p_case, "error above the legs", GroundRun.mean(p_run.upper), "deg", at_most, 1.2)
	_report.add(p_case, "error p99", GroundRun.percentile(p_run.errors, 0.99), "deg")
	_report.add(p_case, "drift mean", GroundRun.mean(p_run.drifts), "m")
	_report.add(p_case, "drift p99", GroundRun.percentile(p_run.drifts, 0.99), "m")
	_report.add(p_case, "steps of its own", p_run.steps, "")
	_report.add(p_case, "hips too low at most", p_run.lowest(), "m")
