extends "gait_case.gd"
## Motion files, whose own hips are the truth: runs, dances, crawling, lying, getting up, sitting,
## jumps.

const Truth: GDScript = preload("gait_truth.gd")
## Clips shorter than this hold no way that could be measured, s.
const _SHORTEST_S: float = 1.0
## The travel may be off by this share of the way or by this, whichever is more, m.
const _SHARE: float = 0.08
const _LEAST: float = 0.15

var files: PackedStringArray = []

var _within: int = 0
var _count: int = 0
var _flights: int = 0
var _found: int = 0
var _invented: int = 0
var _minutes: float = 0.0
var _climbing: int = 0
var _climbing_within: int = 0
var _climbs: bool = false
var _is_treadmill: bool = false
var _treadmills: int = 0


func run() -> void:
	for file: String in files:
		await _run_clip(file)
	if files.size() < 2:
		return
	var title: String = "%s: all clips" % root_name
	report.add(title, "clips", _count, "")
	report.add(title, "treadmills besides", _treadmills, "")
	report.at_least(title, "within 8 % or 0.15 m", _within, "clips", _count, has_goals())
	report.add(title, "of them climb what is not there", _climbing, "")
	report.add(title, "of those within", _climbing_within, "")
	if _flights > 0:
		report.add(title, "flights in truth", _flights, "")
		var share: float = 100.0 * _found / _flights
		report.at_least(title, "flights found", share, "%", 90.0, has_goals())
	var invented: float = _invented / maxf(_minutes, 0.01)
	report.at_most(title, "flights invented", invented, "1/min", 1.0, has_goals())


func _run_clip(p_file: String) -> void:
	var source: BvhSource = report.open_clip(p_file)
	if source == null:
		return
	if source.rig.clip.duration() < _SHORTEST_S:
		var parts: Array = [source.rig.clip.duration(), _SHORTEST_S]
		report.leave_out(p_file, "%.2f s are too short for a way: %.0f s is the least" % parts)
		return
	begin()
	ragdoll.free()
	ragdoll = BenchBodies.of_clip(source, root_mode)
	if ragdoll.profile == null:
		report.leave_out(p_file, "no body can be made of its skeleton")
		await end()
		return
	Walker.new(ragdoll.profile).build_ground(world)
	world.add_child(ragdoll)
	if ragdoll.start():
		_add(p_file, await _play(source))
	else:
		report.leave_out(p_file, "the ragdoll does not start")
	await end()


func _play(p_source: BvhSource) -> Stats:
	var stats: Stats = Stats.new()
	var delta: float = 1.0 / Engine.physics_ticks_per_second
	var ticks: int = int((p_source.rig.clip.duration() - BvhSource.BLEND_S) / delta)
	var truth: Truth = Truth.new(ragdoll.profile)
	truth.read(p_source, ticks, delta)
	_climbs = truth.climbs
	_is_treadmill = truth.is_treadmill
	var told: Vector3 = p_source.pose_at(0.0).root
	var before: PackedVector3Array = []
	for tick: int in ticks:
		await _tree.physics_frame
		var sample: PoseSample = p_source.pose_at(time_s)
		if tick > 2:
			stats.add_root(root_of(ragdoll), sample.root)
			stats.add_flight(truth.flies[tick], ragdoll.motor.is_flying())
			before = _note_soles(truth, tick, before, stats)
		ragdoll.push_sample(time_s, sample, told)
		ragdoll.drive(time_s, delta)
		time_s += delta
	_minutes += time_s / 60.0
	return stats


## Compares the sole points of the bodies with those of the true motion.
func _note_soles(
	p_truth: Truth, p_tick: int, p_before: PackedVector3Array, p_stats: Stats
) -> PackedVector3Array:
	var delta: float = 1.0 / Engine.physics_ticks_per_second
	var places: PackedVector3Array = p_truth.points[p_tick]
	var lowest: float = INF
	var now: PackedVector3Array = []
	for i: int in places.size():
		lowest = minf(lowest, p_truth.height_of(i, places))
		now.append(point_of(ragdoll, p_truth.limbs[i], p_truth.locals[i]))
	for i: int in places.size() if not p_before.is_empty() else 0:
		if not ragdoll.profile.limbs[p_truth.limbs[i]].is_foot:
			continue
		var moved: Vector3 = (places[i] - p_truth.points[p_tick - 1][i]) / delta
		var shown: Vector3 = (now[i] - p_before[i]) / delta
		var stands: bool = Vector2(moved.x, moved.z).length() < Stats.STANDS_BELOW
		if stands and places[i].y < lowest + Stats.STANDS_WITHIN:
			p_stats.skate.add(Vector2(shown.x - moved.x, shown.z - moved.z).length())
	return now


func _add(p_file: String, p_stats: Stats) -> void:
	var title: String = "%s: %s" % [root_name, p_file.get_file()]
	report.add(title, "way", p_stats.way, "m")
	var most: float = maxf(_SHARE * p_stats.way, _LEAST)
	if _is_treadmill:
		# Where the person would get to on the ground, the file does not say.
		report.add(title, "travel of a treadmill", p_stats.worst, "m")
	else:
		report.at_most(title, "max travel error", p_stats.worst, "m", most, has_goals())
		report.add(title, "the same, of the way", p_stats.travel_percent(), "%")
	report.add(title, "body height error", 1000.0 * p_stats.height.mean(), "mm")
	report.add(title, "stance-foot skate", 100.0 * p_stats.skate.mean(), "cm/s")
	if p_stats.flights > 0 or p_stats.invented > 0:
		var share: float = 100.0 * p_stats.found / maxf(p_stats.flights, 1.0)
		report.add(title, "flights in truth", p_stats.flights, "")
		report.add(title, "flights found", share, "%")
		report.add(title, "flights invented", p_stats.invented, "")
	_flights += p_stats.flights
	_found += p_stats.found
	_invented += p_stats.invented
	if _is_treadmill:
		_treadmills += 1
		return
	_count += 1
	_within += 1 if p_stats.worst <= most else 0
	_climbing += 1 if _climbs else 0
	_climbing_within += 1 if _climbs and p_stats.worst <= most else 0
