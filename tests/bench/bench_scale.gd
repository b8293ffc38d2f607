extends SceneTree
## What a server tick costs with many people: motor, physics step, read-out.
##
## Options: --people=16 (again for more cases), --bvh=FILE, --hz=60, --seconds=10 (simulated).

const _GOAL_FREE: float = 50.0
const _GOAL_PEOPLE: int = 16
const _WARM_UP: int = 60

var _arguments: BenchArguments = null


func _initialize() -> void:
	_arguments = BenchArguments.parse(
		OS.get_cmdline_user_args(),
		{"people": "", "bvh": "res://assets/motion/01_01.bvh", "hz": 60, "seconds": 10.0}
	)
	_run.call_deferred()


func _run() -> void:
	var source: BvhSource = BvhSource.new()
	if _arguments.error == "":
		source.open(_arguments.value("bvh"))
	var fault: String = _arguments.error if _arguments.error != "" else source.error
	if fault != "":
		printerr(fault)
		quit(2)
		return
	Engine.physics_ticks_per_second = _arguments.value("hz")
	var report: BenchReport = BenchReport.new("scale", _arguments.value("json"))
	var cases: PackedStringArray = _arguments.list("people")
	if cases.is_empty():
		cases = ["1", "4", "16", "64"]
	for people: String in cases:
		if people.to_int() < 1 or people.to_int() > 1024:
			printerr("--people expects a number from 1 to 1024, found '%s'" % people)
			quit(2)
			return
		await _run_case(people.to_int(), source, report)
	report.finish()
	quit(0)


func _run_case(p_people: int, p_source: BvhSource, p_report: BenchReport) -> void:
	var scene: PackedScene = load("res://scenes/actor/soldier.tscn")
	var ragdolls: Array[Ragdoll] = []
	for i: int in p_people:
		var ragdoll: Ragdoll = scene.instantiate()
		root.add_child(ragdoll)
		ragdoll.start()
		ragdolls.append(ragdoll)
	var motors: Statistics = Statistics.new()
	var ticks: Statistics = Statistics.new()
	var delta: float = 1.0 / Engine.physics_ticks_per_second
	var last: int = 0
	for tick: int in int(_arguments.value("seconds") / delta) + _WARM_UP:
		await physics_frame
		var begin: int = Time.get_ticks_usec()
		if tick > _WARM_UP:
			ticks.add((begin - last) / 1000.0)
		last = begin
		for i: int in p_people:
			# Everybody is at another moment of the clip, three metres apart.
			var sample: PoseSample = p_source.pose_at(tick * delta + i * 0.7)
			var place: Vector3 = Vector3(i % 16, 0.0, i / 16) * 3.0
			ragdolls[i].push_sample(tick * delta, sample, sample.root + place)
		var pushed: int = Time.get_ticks_usec()
		for ragdoll: Ragdoll in ragdolls:
			ragdoll.drive(tick * delta, delta)
		var driven: int = Time.get_ticks_usec()
		# Making the motion is the trainees' work, not the server's.
		last += pushed - begin
		if tick > _WARM_UP:
			motors.add(float(driven - pushed) / p_people)
	for ragdoll: Ragdoll in ragdolls:
		ragdoll.queue_free()
	await process_frame
	_add_figures(p_people, ticks, motors, p_report)


func _add_figures(
	p_people: int, p_ticks: Statistics, p_motors: Statistics, p_report: BenchReport
) -> void:
	var name: String = "%d people, %d Hz" % [p_people, Engine.physics_ticks_per_second]
	var tick_ms: float = 1000.0 / Engine.physics_ticks_per_second
	var free: float = 100.0 * (1.0 - p_ticks.percentile(0.5) / tick_ms)
	var kind: BenchReport.Goal = BenchReport.Goal.NONE
	if p_people == _GOAL_PEOPLE and Engine.physics_ticks_per_second == 60:
		kind = BenchReport.Goal.AT_LEAST
	p_report.add(name, "tick p50", p_ticks.percentile(0.5), "ms")
	p_report.add(name, "tick p99", p_ticks.percentile(0.99), "ms")
	p_report.add(name, "motor p50, each", p_motors.percentile(0.5), "us")
	p_report.add(name, "tick left over", free, "%", kind, _GOAL_FREE)
