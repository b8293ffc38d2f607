extends Bench
## What motion costs on the wire: a person, what a trainee sends, and a crowd.
##
## Options: --bvh=FILE (again for more; default the clips in assets/motion), --hz=30 (60, 30, 20,
## 15 ..., what divides 60), --age (ticks of 1/60 s that the acknowledged base is old; default 2
## and 6: a LAN and about 50 ms there and back), --error (degrees; default 0.1 and 0.5),
## --rounds=20. Payload of one person of 16 limbs, the end of the range coder included, no headers.
## Then what one trainee and one with eight people send, with all headers.
## Then, unless --people=0, a client of a world of --people=8 and --crates=200 that all move, for
## --seconds=20, with all headers, on several networks.

const CrowdCases: GDScript = preload("wire/crowd_cases.gd")
const UpstreamCases: GDScript = preload("wire/upstream_cases.gd")

## Goals: by the error (tenths of a degree), then by the age, kbit/s.
const _GOALS: Dictionary[int, Dictionary] = {
	1: {2: 9.0, 6: 10.5},
	5: {2: 5.5, 6: 7.5},
}
const _GOAL_ENCODE_US: float = 30.0


func options() -> Dictionary:
	return {
		"bvh": "",
		"hz": [30, 1, 60],
		"age": [2, 1, 60],
		"error": [0.1, 0.02, 30.0],
		"rounds": [20, 1, 10000],
		"people": [8, 0, 200],
		"crates": [200, 1, 2000],
		"seconds": [20.0, 1.0, 3600.0],
	}


func find_fault() -> String:
	var hz: int = option("hz")
	return "--hz divides 60, found %d" % hz if 60 % hz != 0 else ""


func measure() -> void:
	var clips: Array[WireClip] = []
	for file: String in BenchArguments.clips(arguments):
		var clip: WireClip = WireClip.from_file(file)
		if clip.error == "":
			clips.append(clip)
		else:
			report.leave_out(file, clip.error)
	if clips.is_empty():
		return
	var rates: Array = [option("hz")]
	if not arguments.is_given("hz"):
		rates.append(60)
	for hz: int in rates:
		_measure(clips, hz)
	UpstreamCases.new().run(report, clips)
	if option("people") > 0:
		await _crowd()


func _crowd() -> void:
	var sources: Array[BvhSource] = []
	for file: String in BenchArguments.clips(arguments):
		var source: BvhSource = report.open_clip(file)
		if source != null:
			sources.append(source)
	var cases: CrowdCases = CrowdCases.new()
	root.add_child(cases)
	var people: int = option("people")
	cases.run_one(report, sources, option("seconds"))
	await cases.run(report, sources, people, option("crates"), option("seconds"))


func _measure(p_clips: Array[WireClip], p_hz: int) -> void:
	var every: int = 60 / p_hz
	var ages: Array = [every, 6 if p_hz >= 30 else 3 * every]
	var errors: Array = [0.1, 0.5]
	if arguments.is_given("age"):
		ages = [option("age")]
	if arguments.is_given("error"):
		errors = [option("error")]
	for error: float in errors:
		for age: int in ages:
			_measure_case(p_clips, every, age, error)


func _measure_case(p_clips: Array[WireClip], p_every: int, p_age: int, p_error: float) -> void:
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
		report.add(name, clip.name, own, "kbit/s")
		rate += own / p_clips.size()
		times += stream.measure(7, p_age, p_age + p_every, option("rounds")) / p_clips.size()
	_add_rate(name, p_every, p_age, p_error, rate)
	report.at_most(name, "largest error", worst, "deg", p_error)
	report.at_most(name, "not read back", lost, "", 0.0)
	report.at_most(name, "encode", times.x, "us", _GOAL_ENCODE_US)
	report.add(name, "decode", times.y, "us")


func _add_rate(p_name: String, p_every: int, p_age: int, p_error: float, p_rate: float) -> void:
	var goals: Dictionary = _GOALS.get(roundi(p_error * 10.0), {})
	if (
		p_every == 2
		and is_equal_approx(p_error * 10.0, roundf(p_error * 10.0))
		and goals.has(p_age)
	):
		report.at_most(p_name, "mean", p_rate, "kbit/s", goals[p_age])
	else:
		report.add(p_name, "mean", p_rate, "kbit/s")
