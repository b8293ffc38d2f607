extends SceneTree
## What motion costs on the wire: a person, and a crowd.
##
## Options: --bvh=FILE (again for more; default the clips in assets/motion), --hz=30 (60, 30, 20,
## 15 ..., what divides 60), --age (ticks of 1/60 s that the acknowledged base is old; default 2
## and 6: a LAN and about 50 ms there and back), --error (degrees; default 0.1 and 0.5),
## --rounds=20. Payload of one person of 16 limbs, the end of the range coder included, no headers.
## Then what one trainee and one with eight people send, with all headers.
## Then, unless --people=0, a client of a world of --people=8 and --crates=200 that all move, for
## --seconds=20, with all headers, on several networks, and Godot's own MultiplayerSynchronizer
## beside it.

const CrowdCases: GDScript = preload("wire/crowd_cases.gd")
const UpstreamCases: GDScript = preload("wire/upstream_cases.gd")

## Goals: by the error (tenths of a degree), then by the age, kbit/s.
const _GOALS: Dictionary[int, Dictionary] = {
	1: {2: 9.0, 6: 10.5},
	5: {2: 5.5, 6: 7.5},
}
const _GOAL_ENCODE_US: float = 30.0


func _initialize() -> void:
	_run.call_deferred()


func _run() -> void:
	var arguments: BenchArguments = (
		BenchArguments
		. parse(
			OS.get_cmdline_user_args(),
			{
				"bvh": "",
				"hz": 30,
				"age": 2,
				"error": 0.1,
				"rounds": 20,
				"people": 8,
				"crates": 200,
				"seconds": 20.0,
			}
		)
	)
	var fault: String = _find_fault(arguments)
	var clips: Array[WireClip] = []
	if fault != "":
		printerr(fault)
		quit(2)
		return
	var report: BenchReport = BenchReport.new("wire", arguments.value("json"))
	for file: String in BenchArguments.clips(arguments):
		var clip: WireClip = WireClip.from_file(file)
		if clip.error == "":
			clips.append(clip)
		else:
			report.leave_out(file, clip.error)
	if clips.is_empty():
		quit(report.finish())
		return
	var rates: Array = [arguments.value("hz")]
	if not arguments.is_given("hz"):
		rates.append(60)
	for hz: int in rates:
		_measure(clips, hz, arguments, report)
	UpstreamCases.new().run(report, clips)
	if arguments.value("people") > 0:
		await _crowd(arguments, report)
	quit(report.finish())


func _find_fault(p_arguments: BenchArguments) -> String:
	if p_arguments.error != "":
		return p_arguments.error
	var hz: int = p_arguments.value("hz")
	if hz < 1 or hz > 60 or 60 % hz != 0:
		return "--hz divides 60, found %d" % hz
	if p_arguments.value("age") < 1 or p_arguments.value("age") > 60:
		return "--age is between 1 and 60 ticks, found %d" % p_arguments.value("age")
	var error: float = p_arguments.value("error")
	if not (error >= 0.02 and error <= 30.0):
		return "--error is between 0.02 and 30 degrees, found %f" % error
	if p_arguments.value("people") < 0 or p_arguments.value("people") > 200:
		return "--people is between 0 and 200, found %d" % p_arguments.value("people")
	if p_arguments.value("crates") < 1 or p_arguments.value("crates") > 2000:
		return "--crates is between 1 and 2000, found %d" % p_arguments.value("crates")
	if not (p_arguments.value("seconds") >= 1.0 and p_arguments.value("seconds") <= 3600.0):
		return "--seconds is between 1 and 3600, found %f" % p_arguments.value("seconds")
	if p_arguments.value("rounds") < 1 or p_arguments.value("rounds") > 10000:
		return "--rounds is between 1 and 10000, found %d" % p_arguments.value("rounds")
	return ""


func _crowd(p_arguments: BenchArguments, p_report: BenchReport) -> void:
	var sources: Array[BvhSource] = []
	for file: String in BenchArguments.clips(p_arguments):
		var source: BvhSource = p_report.open_clip(file)
		if source != null:
			sources.append(source)
	var cases: CrowdCases = CrowdCases.new()
	root.add_child(cases)
	var people: int = p_arguments.value("people")
	cases.run_one(p_report, sources, p_arguments.value("seconds"))
	await cases.run(
		p_report, sources, people, p_arguments.value("crates"), p_arguments.value("seconds")
	)


func _measure(
	p_clips: Array[WireClip], p_hz: int, p_arguments: BenchArguments, p_report: BenchReport
) -> void:
	var every: int = 60 / p_hz
	var ages: Array = [every, 6 if p_hz >= 30 else 3 * every]
	var errors: Array = [0.1, 0.5]
	if p_arguments.is_given("age"):
		ages = [p_arguments.value("age")]
	if p_arguments.is_given("error"):
		errors = [p_arguments.value("error")]
	for error: float in errors:
		for age: int in ages:
			_measure_case(p_clips, every, age, error, p_arguments.value("rounds"), p_report)


func _measure_case(
	p_clips: Array[WireClip],
	p_every: int,
	p_age: int,
	p_error: float,
	p_rounds: int,
	p_report: BenchReport
) -> void:
	var name: String = "%d Hz, base %d ticks old, %s deg" % [60 / p_every, p_age, p_error]
	var rate: float = 0.0
	var worst: float = 0.0
	var lost: int = 0
	var times: Vector2 = Vector2.ZERO
	for clip: WireClip in p_clips:
		var stream: PersonStream = clip.to_stream(PersonStream.resolution_for(p_error))
		var bytes: int = 0
		var count: int = 0
		for tick: int in range(p_age + p_every, clip.poses.size(), p_every):
			var base: int = tick - p_age
			var message: PackedByteArray = stream.encode(tick, base, base - p_every)
			lost += 0 if stream.decode(message, tick, base, base - p_every) else 1
			bytes += message.size()
			count += 1
			worst = maxf(
				worst, WireClip.worst_angle(clip.poses[tick].orientations, stream.restore(tick))
			)
		var own: float = 8.0 * bytes / count * (60.0 / p_every) / 1000.0
		p_report.add(name, clip.name, own, "kbit/s")
		rate += own / p_clips.size()
		times += stream.measure(7, p_age, p_age + p_every, p_rounds) / p_clips.size()
	_add_rate(name, p_every, p_age, p_error, rate, p_report)
	p_report.add(name, "largest error", worst, "deg", BenchReport.Goal.AT_MOST, p_error)
	p_report.add(name, "not read back", lost, "", BenchReport.Goal.AT_MOST, 0.0)
	p_report.add(name, "encode", times.x, "us", BenchReport.Goal.AT_MOST, _GOAL_ENCODE_US)
	p_report.add(name, "decode", times.y, "us")


func _add_rate(
	p_name: String, p_every: int, p_age: int, p_error: float, p_rate: float, p_report: BenchReport
) -> void:
	var goals: Dictionary = _GOALS.get(roundi(p_error * 10.0), {})
	if (
		p_every == 2
		and is_equal_approx(p_error * 10.0, roundf(p_error * 10.0))
		and goals.has(p_age)
	):
		p_report.add(p_name, "mean", p_rate, "kbit/s", BenchReport.Goal.AT_MOST, goals[p_age])
	else:
		p_report.add(p_name, "mean", p_rate, "kbit/s")
