extends SceneTree
## The engine's physics step against Jolt alone, with the same bodies, joints and motor targets.
##
## Options: --people=16 (again for more cases), --bvh=FILE, --hz=60, --seconds=5 (simulated).
## The first run of a case records what Jolt is told ([JoltRecording]), a second one is timed: from
## the last motor's target to the next tick. Then raw_jolt replays the recording, with one thread
## and with as many as there are cores. How far its bodies end from the engine's tells that they
## are the same. ./run adds --program=FILE, or --absent=WHY where there is no Jolt.

const _WARM_UP: int = 60
## Bodies that end further apart were not the same.
const _GOAL_APART_MM: float = 1.0

var _arguments: BenchArguments = null
var _source: BvhSource = BvhSource.new()
var _report: BenchReport = null


func _initialize() -> void:
	_arguments = BenchArguments.parse(
		OS.get_cmdline_user_args(),
		{
			"people": "",
			"bvh": "res://assets/motion/01_01.bvh",
			"hz": 60,
			"seconds": 5.0,
			"program": "",
			"absent": ""
		}
	)
	_run.call_deferred()


func _run() -> void:
	if _arguments.error == "":
		_source.open(_arguments.value("bvh"))
	var fault: String = _arguments.error if _arguments.error != "" else _source.error
	var cases: PackedStringArray = _arguments.list("people")
	if cases.is_empty():
		cases = ["1", "16", "64"]
	for people: String in cases:
		if fault == "" and (people.to_int() < 1 or people.to_int() > 256):
			fault = "--people expects a number from 1 to 256, found '%s'" % people
	Engine.physics_ticks_per_second = _arguments.value("hz")
	# The first frame's step is still to come: nobody is to be there yet.
	await process_frame
	_report = BenchReport.new("raw_jolt", _arguments.value("json"))
	for people: String in cases:
		if fault == "":
			fault = await _run_case(people.to_int())
	if fault != "":
		printerr(fault)
		quit(2)
		return
	quit(_report.finish())


## Returns why the case cannot be run, or an empty text.
func _run_case(p_people: int) -> String:
	var case: String = "%d people, %d Hz" % [p_people, Engine.physics_ticks_per_second]
	var path: String = OS.get_user_data_dir().path_join("raw_jolt_%d.bin" % OS.get_process_id())
	var steps: Statistics = Statistics.new()
	if not await _play(p_people, steps, path):
		return "%s cannot be written" % path
	steps = Statistics.new()
	await _play(p_people, steps, "")
	_report.add(case, "engine step p50", steps.percentile(0.5), "us")
	_report.add(case, "engine step p99", steps.percentile(0.99), "us")
	var fault: String = ""
	if _arguments.value("absent") == "":
		fault = _replay(case, path, steps.percentile(0.5))
	else:
		var why: String = _arguments.value("absent")
		_report.add(case, "raw Jolt is absent: " + why, 0.0, "")
	DirAccess.remove_absolute(path)
	return fault


## Plays a crowd, and records it where there is a path for that.
func _play(p_people: int, p_steps: Statistics, p_path: String) -> bool:
	var crowd: BenchCrowd = BenchCrowd.new(p_people, _source, root)
	# Contacts between people would let the smallest difference grow.
	crowd.in_place = true
	var delta: float = 1.0 / Engine.physics_ticks_per_second
	var ticks: int = int(_arguments.value("seconds") / delta) + _WARM_UP
	var recording: JoltRecording = null
	if p_path != "":
		recording = JoltRecording.new(p_path, crowd, ticks)
	var last: int = 0
	for tick: int in ticks:
		await physics_frame
		if tick > _WARM_UP:
			p_steps.add(Time.get_ticks_usec() - last)
		crowd.push(tick * delta)
		crowd.drive(tick * delta, delta)
		if recording != null and not recording.is_open():
			crowd.leave()
			return false
		if recording != null and tick == 0:
			recording.write_bodies()
		if recording != null:
			recording.write_targets()
		last = Time.get_ticks_usec()
	await physics_frame
	if recording != null:
		recording.write_end()
	crowd.leave()
	await process_frame
	return true


func _replay(p_case: String, p_path: String, p_engine_us: float) -> String:
	var output: Array = []
	var program: String = _arguments.value("program")
	var code: int = OS.execute(program, [p_path, str(_WARM_UP)], output, true)
	var found: Variant = JSON.parse_string(output[0]) if code == 0 else null
	if found is not Dictionary:
		return "'%s' failed (exit %d): %s" % [program, code, output[0]]
	var threads: String = "raw, %d threads" % found["threads"]
	for kind: Array in [[threads, "all"], ["raw, 1 thread", "one"]]:
		var stats: Dictionary = found[kind[1]]
		_report.add(p_case, "%s, step p50" % kind[0], stats["p50_us"], "us")
		_report.add(p_case, "%s, step p99" % kind[0], stats["p99_us"], "us")
		_report.add(p_case, "engine by %s" % kind[0], p_engine_us / stats["p50_us"], "")
	var apart: Dictionary = found["all"]
	var goal: BenchReport.Goal = BenchReport.Goal.AT_MOST
	_report.add(p_case, "bodies apart, max", apart["max_mm"], "mm", goal, _GOAL_APART_MM)
	_report.add(p_case, "bodies turned, max", apart["max_deg"], "deg")
	return ""
