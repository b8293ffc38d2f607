extends SceneTree
## What carries people: weight on the ground, shoves.
##
## Options: --scene=stand|clip|shove (again for more; default all), --root=grounded|soft|inertial
## (default grounded), --bvh=FILE (again for more; default the clips in assets/motion), --hz=60,
## --balance=NAME=NUMBER (of BalanceSettings), --set=PROPERTY=NUMBER (of Ragdoll), --trace.

const _ROOTS: Dictionary[String, RagdollMotor.RootMode] = {
	"grounded": RagdollMotor.ROOT_GROUNDED,
	"soft": RagdollMotor.ROOT_SOFT,
	"inertial": RagdollMotor.ROOT_INERTIAL,
}
const _MOST_S: float = 60.0

var _arguments: BenchArguments = null
var _report: BenchReport = null
var _properties: Dictionary[StringName, float] = {}


func _initialize() -> void:
	_arguments = BenchArguments.parse(
		OS.get_cmdline_user_args(),
		{"scene": "", "root": "grounded", "bvh": "", "hz": 60, "set": "", "trace": false}
	)
	_run.call_deferred()


func _run() -> void:
	if _arguments.error != "":
		printerr(_arguments.error)
		quit(2)
		return
	for pair: String in _arguments.list("set"):
		_properties[StringName(pair.get_slice("=", 0))] = pair.get_slice("=", 1).to_float()
	Engine.physics_ticks_per_second = _arguments.value("hz")
	_report = BenchReport.new("ground", _arguments.value("json"))
	var scenes: PackedStringArray = _arguments.list("scene")
	if scenes.is_empty():
		scenes = ["stand", "clip", "shove", "slopes", "stairs", "crates", "wall", "platforms"]
	if scenes.has("stand"):
		await _stand()
	if scenes.has("clip"):
		for file: String in BenchArguments.clips(_arguments):
			await _clip(file)
	if scenes.has("shove"):
		await _shoves()
	var walks: GroundWalks = GroundWalks.new(
		self, _report, _arguments.value("hz"), _ROOTS[_arguments.value("root")], _soldier()
	)
	for name: StringName in [&"slopes", &"stairs", &"crates", &"wall", &"platforms"]:
		if scenes.has(name):
			await walks.call(name)
	quit(_report.finish())


func _begin(p_performer: ContactPerformer) -> GroundRun:
	var run: GroundRun = GroundRun.new(self, _arguments.value("hz"))
	run.person = p_performer.enter(run.world, _ROOTS[_arguments.value("root")])
	return run


func _soldier() -> ContactPerformer:
	var source: BvhSource = BvhSource.new()
	source.open("res://assets/motion/01_01.bvh")
	return ContactPerformer.new(source, true, _properties)


func _stand() -> void:
	var run: GroundRun = _begin(_soldier())
	_put_standing(run)
	await run.world.run(6.0, run.note)
	_tell("standing", run, 60, 95.0)
	run.end()


func _put_standing(p_run: GroundRun) -> void:
	var pose: PoseSample = ContactPoses.standing(p_run.person)
	var hips: Vector3 = p_run.person.standing_hips()
	p_run.world.add_person(
		p_run.person,
		func(_t: float) -> PoseSample: return pose,
		func(_t: float) -> Vector3: return hips
	)


func _clip(p_file: String) -> void:
	var source: BvhSource = BvhSource.new()
	source.open(p_file)
	if source.error != "":
		printerr(source.error)
		return
	var performer: ContactPerformer = ContactPerformer.new(source, false, _properties)
	if not performer.is_possible():
		printerr("%s: no body can be made of its skeleton" % p_file)
		return
	var run: GroundRun = _begin(performer)
	run.world.add_person(
		run.person,
		source.pose_at,
		func(t: float) -> Vector3: return performer.hips_at(t, run.person)
	)
	await run.world.run(minf(performer.duration(), _MOST_S), run.note)
	_tell(p_file.get_file(), run, 30, 85.0)
	run.end()


func _tell(p_case: String, p_run: GroundRun, p_from: int, p_share: float) -> void:
	var weight: float = p_run.weight()
	var share: float = 100.0 * GroundRun.mean(p_run.carried, p_from) / weight
	_report.add(p_case, "weight on the ground", share, "%", BenchReport.Goal.AT_LEAST, p_share)
	var force: float = 100.0 * GroundRun.percentile(p_run.residual, 0.95) / weight
	_report.add(p_case, "residual p95", force, "% of weight", BenchReport.Goal.AT_MOST, 8.0)
	_report.add(p_case, "error", GroundRun.mean(p_run.errors), "deg", BenchReport.Goal.AT_MOST, 2.0)
	_report.add(
		p_case, "upper body", GroundRun.mean(p_run.upper), "deg", BenchReport.Goal.AT_MOST, 1.2
	)
	_report.add(p_case, "worst error p99", GroundRun.percentile(p_run.errors, 0.99), "deg")
	_report.add(p_case, "drift mean", GroundRun.mean(p_run.drifts), "m")
	_report.add(p_case, "drift p99", GroundRun.percentile(p_run.drifts, 0.99), "m")
	_report.add(p_case, "steps of its own", p_run.steps, "")
	var low: float = 0.0
	for i: int in p_run.heights.size():
		low = maxf(low, p_run.wanted_heights[i] - p_run.heights[i])
	_report.add(p_case, "hips too low at most", low, "m")


func _shoves() -> void:
	for impulse: float in [40.0, 80.0, 160.0]:
		for direction: Vector3 in [Vector3.BACK, Vector3.FORWARD, Vector3.RIGHT, Vector3.LEFT]:
			await _shove(impulse, direction)


func _shove(p_impulse: float, p_direction: Vector3) -> void:
	var run: GroundRun = _begin(_soldier())
	_put_standing(run)
	await run.world.run(1.0, run.note)
	var chest: int = run.person.find(&"Chest")
	var body: RID = run.person.ragdoll.get_bodies()[chest]
	var start: Vector3 = run.person.bodies()[chest].origin
	PhysicsServer3D.body_apply_central_impulse(body, p_direction * p_impulse)
	var seen: Dictionary = {"far": 0.0, "back_s": -1.0, "low": 9.0}
	var watch: Callable = func() -> bool:
		run.note()
		var here: Transform3D = run.person.bodies()[chest]
		seen.far = maxf(seen.far, (here.origin - start).dot(p_direction))
		seen.low = minf(seen.low, run.heights[-1])
		var upright: bool = run.errors[-1] < 3.0 and run.heights[-1] > run.wanted_heights[-1] - 0.05
		if not upright:
			seen.back_s = -1.0
		elif seen.back_s < 0.0:
			seen.back_s = run.world.time_s - 1.0
		if _arguments.value("trace") and roundi(run.world.time_s * 60.0) % 6 == 0:
			var balance: Dictionary = run.person.ragdoll.motor.get_balance()
			print(
				(
					"%d %.2f hips %.2f error %.1f chest %.2f capture %v offset %v step %s force %.0f carried %.0f"
					% [
						balance.phase,
						run.world.time_s,
						run.heights[-1],
						run.errors[-1],
						(here.origin - start).dot(p_direction),
						balance.capture_error_m,
						balance.offset_m,
						balance.is_stepping,
						balance.force_n,
						run.carried[-1]
					]
				)
			)
		return false
	await run.world.run(6.0, watch)
	var name: String = "shove %d N s towards %s" % [p_impulse, p_direction]
	_report.add(name, "chest moves", 100.0 * seen.far, "cm")
	_report.add(name, "recovered after", seen.back_s, "s")
	_report.add(name, "steps", run.steps, "")
	var force: float = 0.0
	for i: int in range(run.residual.size() - 60, run.residual.size()):
		force += run.residual[i] / 60.0
	_report.add(name, "residual at rest", force, "N")
	_report.add(name, "lowest hips", seen.low, "m")
	run.end()
