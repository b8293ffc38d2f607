extends Bench
## How soon a body moves as its motion does that begins half-way, or goes on after a pause.
##
## At eight moments of each clip a body begins, and another one goes on after a pause of 0.2 to 3 s.
## Options: --bvh=FILE (again for more; default the clips in assets/motion), --root=grounded|soft|
## held|inertial|... (again for more; default these four), --hz=60 (ticks; again for more; default
## 30, 60 and 120), --samples=0 (samples a second; 0: as many as ticks), --buffer=0 (ticks of delay
## that make the next sample known), --list (each beginning that throws a limb).

const _ROOTS: Array[String] = ["grounded", "soft", "held", "inertial"]
## So much of what a limb is off by may be the beginning's, deg.
const _BECAUSE_DEG: float = 2.0
const _RATES: Array[String] = ["30", "60", "120"]


func options() -> Dictionary:
	return {
		"bvh": "",
		"root": ["", RootModes.BY_NAME.keys()],
		"hz": "",
		"samples": [0, 0, 1000],
		"buffer": [0, 0, 8],
		"list": false,
	}


func measure() -> void:
	for rate: String in values("hz", _RATES):
		Engine.physics_ticks_per_second = rate.to_int()
		for name: String in values("root", _ROOTS):
			var all: Array[StartBody] = []
			for file: String in BenchArguments.clips(arguments):
				all.append_array(await _run_clip(file, name, rate.to_int()))
			_tell("%s, %s Hz" % [name, rate], all)


func _run_clip(p_file: String, p_root: String, p_hz: int) -> Array[StartBody]:
	var source: BvhSource = report.open_clip(p_file)
	if source == null:
		return []
	if source.get_period() < 0.6:
		report.leave_out(p_file, "it is too short")
		return []
	if not ContactPerformer.new(source, false, {}).is_possible():
		report.leave_out(p_file, "no body can be made of its skeleton")
		return []
	var run: StartsRun = StartsRun.new()
	run.root_mode = RootModes.BY_NAME[p_root]
	run.buffer = option("buffer")
	run.sample_hz = option("samples")
	await run.run(self, source, p_hz)
	if option("list"):
		for body: StartBody in run.bodies:
			_list(p_file.get_file(), body)
	return run.bodies


func _list(p_name: String, p_body: StartBody) -> void:
	if p_body.later_deg <= _BECAUSE_DEG:
		return
	var pause: float = p_body.goes_on_s - p_body.stops_s if is_finite(p_body.stops_s) else 0.0
	var parts: Array = [p_name, p_body.goes_on_s, pause]
	for found: Array in [
		[p_body.first_limb, p_body.first_deg], [p_body.later_limb, p_body.later_deg]
	]:
		parts += [Limbs.BONES[found[0]], found[1]]
	parts.append(p_body.later_s)
	printerr("%s at %.2f s, pause %.2f s: %s %.1f deg; %s %.1f deg more after %.2f s" % parts)


func _tell(p_case: String, p_bodies: Array[StartBody]) -> void:
	for is_pause: bool in [false, true]:
		var firsts: PackedFloat64Array = PackedFloat64Array()
		var usual: float = 0.0
		var usually_off: int = 0
		var off: int = 0
		var thrown: int = 0
		var worst: float = 0.0
		for body: StartBody in p_bodies:
			if is_finite(body.stops_s) == is_pause:
				firsts.append(body.first_deg)
				usual = maxf(usual, body.usual_deg)
				off += 1 if body.first_deg > StartBody.LIMIT_DEG else 0
				usually_off += 1 if body.usual_deg > StartBody.LIMIT_DEG else 0
				thrown += 1 if body.later_deg > _BECAUSE_DEG else 0
				worst = maxf(worst, body.later_deg)
		if firsts.is_empty():
			continue
		firsts.sort()
		var case: String = "%s, %s" % [p_case, "goes on" if is_pause else "begins"]
		report.add(case, "cases", firsts.size(), "")
		report.add(case, "worst limb after 0.1 s, median", firsts[firsts.size() / 2], "deg")
		report.add(case, "worst limb after 0.1 s", firsts[firsts.size() - 1], "deg")
		report.add(case, "the same of who never paused", usual, "deg")
		report.add(case, "a limb off by 8 deg after 0.1 s", off, "")
		report.add(case, "the same of who never paused (cases)", usually_off, "")
		report.add(case, "beyond that, where off by 8 deg", worst, "deg")
		report.at_most(case, "throw a limb", thrown, "", 0.0)
