extends Bench
## How a walker's body follows its mover: search, cost, sliding feet, place, heading and answer.
##
## A plain mover on level ground. Options: --set=FILE (default the walker's), --seed=1 (of random
## walks), --walks=10 (random walks of 30 s), --walkers=64, --searches=2000, --rows=10000 (frames
## that are searched), --cases=search|cost|gaits|walks|answers (again for more; default all).

const PlainMover: GDScript = preload("motion_set/plain_mover.gd")
const ShownBody: GDScript = preload("motion_set/shown_body.gd")
const _CASES: Array[String] = ["search", "cost", "gaits", "walks", "answers"]
const _DELTA: float = 1.0 / 60.0
## Gaits: name, speed m/s, direction from where the walker faces, deg, turning, deg/s.
const _GAITS: Array[Array] = [
	["stand", 0.0, 0.0, 0.0],
	["turn on the spot", 0.0, 0.0, 90.0],
	["slow", 0.8, 0.0, 0.0],
	["walk", 1.5, 0.0, 0.0],
	["fast walk", 2.0, 0.0, 0.0],
	["jog", 2.8, 0.0, 0.0],
	["run", 4.0, 0.0, 0.0],
	["sprint", 5.0, 0.0, 0.0],
	["left", 1.2, 90.0, 0.0],
	["right", 1.2, -90.0, 0.0],
	["ahead to the left", 1.5, 45.0, 0.0],
	["back", 1.2, 180.0, 0.0],
	["back to the right", 1.2, -135.0, 0.0],
	["walk in a curve", 1.5, 0.0, 60.0],
	["run in a curve", 3.5, 0.0, 60.0],
	["start and stop", 1.5, 0.0, 0.0],
	["run and stop", 4.0, 0.0, 0.0],
	["crouched", 0.9, 0.0, 0.0],
]
const _GAIT_S: float = 8.0
## A limb that has turned by more is seen, deg.
const _SEEN_DEG: float = 5.0

var _set: MotionSet = MotionSet.new()


func options() -> Dictionary:
	return {
		"set": "res://assets/motion/walker.motionset",
		"seed": 1,
		"walks": [10, 1, 1000],
		"walkers": [64, 1, 1000],
		"searches": [2000, 1, 1000000],
		"rows": [10000, 100, 1000000],
		"cases": ["", _CASES],
	}


func measure() -> void:
	var fault: String = _set.load_file(option("set"))
	if fault != "":
		report.leave_out(option("set"), fault)
		return
	for kind: String in values("cases", _CASES):
		call("_measure_" + kind)


func _measure_search() -> void:
	var nanoseconds: int = _set.measure_search(option("searches"), option("seed"), option("rows"))
	var name: String = "search in %d frames" % option("rows")
	report.at_most(name, "mean", nanoseconds / 1e6, "ms", 0.1)


func _measure_cost() -> void:
	var movers: Array[PlainMover] = []
	var matchers: Array[MotionMatcher] = []
	for i: int in option("walkers"):
		movers.append(PlainMover.new())
		movers[i].position = Vector3(3.0 * (i % 8), 0.0, 3.0 * (i / 8))
		matchers.append(_matcher(movers[i]))
	var random: RandomNumberGenerator = _random(0)
	var times: PackedFloat64Array = PackedFloat64Array()
	for tick: int in 900:
		for i: int in movers.size():
			if random.randf() < 1.0 / 90.0:
				_wish_anything(movers[i], random)
			movers[i].advance(_DELTA)
		var begin: int = Time.get_ticks_usec()
		for i: int in movers.size():
			movers[i].show(matchers[i], _DELTA)
		times.append((Time.get_ticks_usec() - begin) / 1000.0)
	times.sort()
	var name: String = "%d walkers" % option("walkers")
	report.at_most(name, "median tick", times[times.size() / 2], "ms", 0.6)
	report.add(name, "99th percentile", times[times.size() * 99 / 100], "ms")


func _measure_gaits() -> void:
	var all: ShownBody = ShownBody.new()
	for gait: Array in _GAITS:
		var body: ShownBody = ShownBody.new()
		var mover: PlainMover = PlainMover.new()
		mover.stance = MotionMatcher.CROUCH if gait[0] == "crouched" else MotionMatcher.STAND
		var matcher: MotionMatcher = _matcher(mover)
		var heading: float = 0.0
		for tick: int in roundi(_GAIT_S / _DELTA):
			var stops: bool = "stop" in gait[0] and tick % 120 >= 60
			heading += deg_to_rad(gait[3]) * _DELTA
			mover.wish(0.0 if stops else gait[1], deg_to_rad(gait[2]), heading)
			if tick == 0 or ("stop" in gait[0] and tick % 60 == 0):
				body.changed()
			_tick(mover, matcher, body)
		_report(gait[0], body, false)
		all.slide.speeds.append_array(body.slide.speeds)
		all.distances.append_array(body.distances)
		all.headings.append_array(body.headings)
		all.ticks += body.ticks
	_report("all gaits", all, true)


func _measure_walks() -> void:
	var body: ShownBody = ShownBody.new()
	for walk: int in option("walks"):
		var random: RandomNumberGenerator = _random(walk + 1)
		var mover: PlainMover = PlainMover.new()
		var matcher: MotionMatcher = _matcher(mover)
		var left: int = 0
		body.begin()
		for tick: int in 1800:
			left -= 1
			if left < 0:
				left = random.randi_range(20, 180)
				_wish_anything(mover, random)
				body.changed()
			_tick(mover, matcher, body)
	_report("random walks", body, true)


func _measure_answers() -> void:
	var worst: float = 0.0
	for speed: float in [0.0, 1.5, 4.0]:
		for wish: Array in [["start", 1.5, 0.0], ["stop", 0.0, 0.0], ["turn", speed, 90.0]]:
			if (speed > 0.0) == (wish[0] == "start"):
				continue
			var late: float = _answer(speed, wish)
			worst = maxf(worst, late)
			report.at_most("%s at %.1f m/s" % [wish[0], speed], "answer", late, "ms", 100.0)
	report.at_most("all wishes", "slowest answer", worst, "ms", 100.0)


## How long it takes until a walker looks otherwise than one that goes on, ms: the worst of moments
## all over a stride.
func _answer(p_speed: float, p_wish: Array) -> float:
	var mover: PlainMover = PlainMover.new()
	var matcher: MotionMatcher = _matcher(mover)
	mover.wish(p_speed, 0.0, 0.0)
	var worst: float = 0.0
	for tick: int in 300:
		mover.advance(_DELTA)
		mover.show(matcher, _DELTA)
		if tick >= 180 and tick % 6 == 0:
			var other: PlainMover = mover.copy()
			other.wish(p_wish[1], 0.0, deg_to_rad(p_wish[2]))
			worst = maxf(worst, _apart_after(mover.copy(), matcher.copy(), other, matcher.copy()))
	return worst


func _apart_after(
	p_mover: PlainMover, p_matcher: MotionMatcher, p_other: PlainMover, p_changed: MotionMatcher
) -> float:
	for tick: int in 60:
		p_mover.advance(_DELTA)
		p_other.advance(_DELTA)
		p_mover.show(p_matcher, _DELTA)
		p_other.show(p_changed, _DELTA)
		var pose: PoseSample = PoseSample.new()
		var other: PoseSample = PoseSample.new()
		pose.orientations = p_matcher.get_orientations()
		other.orientations = p_changed.get_orientations()
		for limb: int in Limbs.COUNT:
			var angle: float = pose.orientation(limb).angle_to(other.orientation(limb))
			if rad_to_deg(angle) > _SEEN_DEG:
				return (tick + 1) * _DELTA * 1000.0
	return 1000.0


func _report(p_case: String, p_body: ShownBody, p_has_goals: bool) -> void:
	report.at_most(p_case, "skate, mean", 100.0 * p_body.slide.mean(), "cm/s", 3.0, p_has_goals)
	report.add(p_case, "skate, 95th percentile", 100.0 * _share(p_body.slide.speeds, 0.95), "cm/s")
	report.at_most(
		p_case,
		"from the mover, worst",
		100.0 * _share(p_body.distances, 1.0),
		"cm",
		10.0,
		p_has_goals
	)
	report.at_most(
		p_case,
		"heading off, worst",
		rad_to_deg(_share(p_body.headings, 1.0)),
		"deg",
		5.0,
		p_has_goals
	)
	if not p_has_goals:
		report.add(
			p_case, "without a foot on the ground", 100.0 * p_body.flying / p_body.ticks, "%"
		)
		report.add(p_case, "sole below the ground", 100.0 * p_body.slide.deepest, "cm")


func _tick(p_mover: PlainMover, p_matcher: MotionMatcher, p_body: ShownBody) -> void:
	p_mover.advance(_DELTA)
	p_mover.show(p_matcher, _DELTA)
	p_body.look(p_matcher, p_mover.position, p_mover.heading, _DELTA)


func _matcher(p_mover: PlainMover) -> MotionMatcher:
	var matcher: MotionMatcher = MotionMatcher.new()
	matcher.set_motion_set(_set)
	matcher.set_body(0.95, PackedFloat32Array())
	matcher.reset(p_mover.position, p_mover.heading)
	return matcher


func _random(p_offset: int) -> RandomNumberGenerator:
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = option("seed") * 1000 + p_offset
	return random


## What somebody at the keys may want next.
func _wish_anything(p_mover: PlainMover, p_random: RandomNumberGenerator) -> void:
	var speeds: PackedFloat32Array = [0.0, 0.0, 0.8, 1.5, 1.5, 2.5, 4.0, 5.0]
	var speed: float = speeds[p_random.randi() % speeds.size()]
	var direction: float = p_random.randi_range(-3, 4) * PI / 4.0
	if speed > 2.0:
		direction = clampf(direction, -PI / 4.0, PI / 4.0)
	var heading: float = p_mover.wished_heading
	if p_random.randf() < 0.5:
		heading = wrapf(heading + p_random.randf_range(-PI, PI), -PI, PI)
	p_mover.wish(minf(speed, 1.5) if absf(direction) > 1.0 else speed, direction, heading)


func _share(p_values: PackedFloat64Array, p_share: float) -> float:
	if p_values.is_empty():
		return 0.0
	var sorted: PackedFloat64Array = p_values.duplicate()
	sorted.sort()
	return sorted[mini(int(sorted.size() * p_share), sorted.size() - 1)]
