extends Bench
## People without a suit, who walk by keys: whether client and server agree, stairs, corners, the
## network, and what it costs.
##
## Options: --scene=all|equal|cost|stairs|corners|network|body|shove|crowd, --seed=1, --ticks=10000,
## --delay=80 (ms there and back), --jitter=20 (ms), --loss=0.02, --shoves=24.

const WalkerCourse: GDScript = preload("res://tests/bench/walker/walker_course.gd")
const WalkerLine: GDScript = preload("res://tests/bench/walker/walker_line.gd")
const WalkerKnocks: GDScript = preload("res://tests/bench/walker/walker_knocks.gd")
const WalkerBody: GDScript = preload("res://tests/bench/walker/walker_body.gd")
const SCENES: Array[String] = [
	"all", "equal", "cost", "stairs", "corners", "network", "body", "shove", "crowd"
]
## What walkers' bodies are measured in, as --walk has it.
const GAITS: Dictionary[String, String] = {
	"stands": "0:0:0:6",
	"walks": "1.5:0:0:6",
	"jogs": "2.4:0:0:6",
	"runs": "3.2:0:0:6",
	"runs at 4 m/s": "4:0:0:6",
	"runs and stops": "3.2:0:0:2,0:0:0:1.5,3.2:0:0:1.5,0:0:0:1",
	"walks in circles": "1.5:0:45:6",
	"backwards": "-1:0:0:6",
	"sideways": "0:1:0:6",
	"ahead to the right": "1:1:0:6",
	"turns on the spot": "0:0:90:6",
	"starts and stops": "1.5:0:0:1.5,0:0:0:1,1.5:0:90:1,0:0:0:1,1.5:0:0:1.5",
	"crouches": "1:0:0:6:crouch",
	"crawls": "0.5:0:0:6:prone",
	"jumps": "1.5:0:0:1,1.5:0:0:0.2:jump,1.5:0:0:2,1.5:0:0:0.2:jump,1.5:0:0:2",
}
## Bodies that walk side by side, and for how long, ticks.
const BODIES: int = 4
const BODY_TICKS: int = 420
## Walkers of a crowd.
const CROWD: int = 64
const TICK_S: float = 1.0 / 60.0
## Ticks that are made again when a correction comes.
const REPLAYED: int = 12
## Pushes into corners, and for how many ticks each.
const PUSHES: int = 1000
const PUSH_TICKS: int = 20


func options() -> Dictionary:
	return {
		"scene": ["all", SCENES],
		"seed": [1, 0, 1000000],
		"ticks": [10000, 100, 1000000],
		"delay": [80.0, 0.0, 1000.0],
		"jitter": [20.0, 0.0, 500.0],
		"loss": [0.02, 0.0, 0.9],
		"shoves": [24, 1, 1000],
	}


func measure() -> void:
	var course: WalkerCourse = WalkerCourse.new(option("seed"), root)
	await physics_frame
	await physics_frame
	var scenes: Dictionary[String, Callable] = {
		"equal": _measure_equality,
		"cost": _measure_cost,
		"stairs": _measure_stairs,
		"corners": _measure_corners,
		"network": _measure_network,
		"body": _measure_bodies,
		"shove": _measure_shoves,
		"crowd": _measure_crowd,
	}
	for name: String in scenes:
		if option("scene") in ["all", name]:
			await scenes[name].call(course)
	course.view.queue_free()


## The same inputs while physics runs, and while it does not.
func _measure_equality(p_course: WalkerCourse) -> void:
	var inputs: Array[WalkerInput] = WalkerCourse.inputs(option("seed") + 1, option("ticks"))
	for place: Array in [["boxes", 22.0], ["turntable", 12.0], ["truck", -12.0], ["door", 0.0]]:
		var at: Vector3 = Vector3(place[1], 1.0, 0.0)
		PhysicsServer3D.set_active(true)
		var there: PackedInt64Array = await _play(p_course, inputs, at, true)
		PhysicsServer3D.set_active(false)
		var here: PackedInt64Array = await _play(p_course, inputs, at, false)
		PhysicsServer3D.set_active(true)
		var differing: int = 0
		for tick: int in there.size():
			differing += int(there[tick] != here[tick])
		report.at_most("server and client, " + place[0], "differing ticks", differing, "", 0.0)


func _play(
	p_course: WalkerCourse, p_inputs: Array[WalkerInput], p_from: Vector3, p_steps: bool
) -> PackedInt64Array:
	var mover: WalkerMover = p_course.mover()
	mover.place(p_from, 0.0)
	var states: PackedInt64Array = []
	for tick: int in p_inputs.size():
		if tick % 10 == 0 and p_steps:
			await physics_frame
		# Back where things move, before it has strayed.
		if tick % 300 == 0:
			mover.place(p_from, 0.0)
		p_course.set_tick(tick)
		p_inputs[tick].apply(mover, TICK_S)
		states.append(hash(mover.get_state()))
	return states


func _measure_cost(p_course: WalkerCourse) -> void:
	var inputs: Array[WalkerInput] = WalkerCourse.inputs(option("seed") + 2, option("ticks"))
	var mover: WalkerMover = p_course.mover()
	mover.place(Vector3(20.0, 1.0, 0.0), 0.0)
	var ticks: Statistics = Statistics.new()
	var replays: Statistics = Statistics.new()
	var states: Array[PackedByteArray] = []
	for tick: int in inputs.size():
		var begin: int = ThreadClock.get_usec()
		inputs[tick].apply(mover, TICK_S)
		ticks.add(ThreadClock.get_usec() - begin)
		states.append(mover.get_state())
		if tick % 50 == 49:
			begin = ThreadClock.get_usec()
			mover.set_state(states[tick - REPLAYED])
			for again: int in range(tick - REPLAYED + 1, tick + 1):
				inputs[again].apply(mover, TICK_S)
			replays.add(ThreadClock.get_usec() - begin)
	report.at_most("among boxes", "a tick, median", ticks.percentile(0.5), "us", 25.0)
	report.add("among boxes", "a tick, 95 %", ticks.percentile(0.95), "us")
	report.at_most("among boxes", "12 ticks again", replays.percentile(0.5), "us", 300.0)


func _measure_stairs(p_course: WalkerCourse) -> void:
	for speed: float in [1.5, 5.0]:
		for way: float in [1.0, -1.0]:
			var mover: WalkerMover = p_course.mover()
			var top: float = WalkerCourse.STEP_M * WalkerCourse.STEPS
			var begin: Vector3 = WalkerCourse.STAIRS
			begin += Vector3.ZERO if way > 0.0 else Vector3(0.0, top, 9.5)
			mover.place(begin, 0.0 if way > 0.0 else PI)
			var name: String = "stairs %s at %.1f m/s" % ["up" if way > 0.0 else "down", speed]
			_walk_on(mover, Vector2(0.0, speed * way), 600, 9.5, name)
			var wanted: float = top if way > 0.0 else 0.0
			report.at_most(
				name, "off the end's height", absf(mover.get_position().y - wanted), "m", 0.02
			)
	var climber: WalkerMover = p_course.mover()
	climber.place(WalkerCourse.SLOPE + Vector3(0.0, 0.0, -1.0), 0.0)
	_walk_on(climber, Vector2(0.0, 3.0), 240, 5.0, "slope of 45 deg")
	report.at_least("slope of 45 deg", "height", climber.get_position().y, "m", 4.0)


## Walks until it has come so far along the Z axis; reports the camera's largest step.
func _walk_on(
	r_mover: WalkerMover, p_wish: Vector2, p_ticks: int, p_far_m: float, p_name: String
) -> void:
	var worst: float = 0.0
	var begin: float = r_mover.get_position().z
	var before: float = r_mover.get_position().y
	for tick: int in p_ticks:
		r_mover.tick(p_wish, r_mover.get_heading(), WalkerMover.STAND, false, TICK_S)
		var shown: float = r_mover.get_position().y - r_mover.get_lift()
		worst = maxf(worst, absf(shown - before)) if tick > 5 else worst
		before = shown
		if absf(r_mover.get_position().z - begin) >= p_far_m:
			break
	report.at_most(p_name, "the camera's largest step", worst * 100.0, "cm a tick", 3.0)


## Pushes into corners from all sides; then it must get away again.
func _measure_corners(p_course: WalkerCourse) -> void:
	var chance: RandomNumberGenerator = RandomNumberGenerator.new()
	chance.seed = option("seed")
	var mover: WalkerMover = p_course.mover()
	mover.place(WalkerCourse.CORNERS + Vector3(0.0, 0.1, 0.0), 0.0)
	var through: int = 0
	var stuck: int = 0
	for push: int in PUSHES * 10:
		var angle: float = chance.randf() * TAU
		var wish: Vector2 = Vector2.from_angle(angle) * 5.5
		for tick: int in PUSH_TICKS:
			mover.tick(wish, PI / 2.0 - angle, WalkerMover.STAND, chance.randf() < 0.01, TICK_S)
		var at: Vector3 = mover.get_position() - WalkerCourse.CORNERS
		var far: float = maxf(absf(at.x), absf(at.z))
		if far > WalkerCourse.ROOM_M or at.y < -0.05:
			through += 1
			mover.place(WalkerCourse.CORNERS + Vector3(0.0, 0.1, 0.0), 0.0)
		elif push % 10 == 9 and not _gets_away(p_course, mover):
			stuck += 1
	report.at_most("%d pushes" % (PUSHES * 10), "through a wall", through, "", 0.0)
	report.at_most("%d pushes" % (PUSHES * 10), "stuck", stuck, "of %d" % PUSHES, 0.0)


func _gets_away(p_course: WalkerCourse, p_mover: WalkerMover) -> bool:
	for direction: int in 8:
		var mover: WalkerMover = p_course.mover()
		mover.set_state(p_mover.get_state())
		var wish: Vector2 = Vector2.from_angle(direction * TAU / 8.0) * 2.0
		for tick: int in 60:
			mover.tick(wish, PI / 2.0 - wish.angle(), WalkerMover.STAND, false, TICK_S)
		if mover.get_position().distance_to(p_mover.get_position()) > 0.3:
			return true
	return false


## A client behind a bad network: how far corrections pull the picture, and when an input is seen.
func _measure_network(p_course: WalkerCourse) -> void:
	var inputs: Array[WalkerInput] = WalkerCourse.inputs(option("seed") + 3, option("ticks"))
	var line: WalkerLine = WalkerLine.new(
		p_course, option("delay"), option("jitter"), option("loss"), option("seed")
	)
	for input: WalkerInput in inputs:
		line.advance(input)
	var name: String = (
		"%.0f +- %.0f ms, %.0f %% lost"
		% [option("delay"), option("jitter"), option("loss") * 100.0]
	)
	report.add(name, "corrections", line.prediction.corrections, "of %d" % inputs.size())
	report.at_most(name, "frames later than offline", line.late_frames, "", 0.0)
	report.at_most(name, "pull of a tick, 99 %", line.pulls.percentile(0.99) * 100.0, "cm", 2.0)
	report.add(name, "largest pull", line.pulls.percentile(1.0) * 100.0, "cm")
	report.at_most(
		name, "up, without headers", line.sent_bytes / line.seconds() / 1000.0, "kB/s", 8.0
	)


## Bodies in physics, in every gait: how far from their walkers, and how feet slide.
func _measure_bodies(p_course: WalkerCourse) -> void:
	for name: String in GAITS:
		var lists: Array[WalkScript] = []
		for index: int in BODIES:
			lists.append(WalkScript.parse(GAITS[name]))
			lists[index].begin(0.0)
		await _walk_bodies(
			p_course,
			name,
			func(p_index: int, _p_tick: int) -> WalkerInput: return lists[p_index].advance(TICK_S)
		)
	var wishes: Array[WalkerInput] = WalkerCourse.inputs(option("seed") + 5, BODIES * BODY_TICKS)
	for input: WalkerInput in wishes:
		# Who changes his mind so often, but stands and crouches only, and does not sprint.
		input.wish = input.wish.limit_length(3.2)
		input.stance = mini(input.stance, WalkerMover.CROUCH) as WalkerMover.Stance
		input.jumps = false
	await _walk_bodies(
		p_course,
		"changes his mind",
		func(p_index: int, p_tick: int) -> WalkerInput: return wishes[p_index * BODY_TICKS + p_tick]
	)


func _walk_bodies(p_course: WalkerCourse, p_name: String, p_wish: Callable) -> void:
	var bodies: Array[WalkerBody] = []
	for index: int in BODIES:
		var at: Vector3 = Vector3(60.0 + 5.3 * index, 0.0, -60.0 + 0.17 * index)
		bodies.append(WalkerBody.new(p_course.view, at))
	for tick: int in BODY_TICKS:
		await physics_frame
		for index: int in BODIES:
			var input: WalkerInput = WalkerInput.new()
			bodies[index].advance(input if tick < 60 else p_wish.call(index, tick))
	_report_bodies(p_name, bodies)
	for body: WalkerBody in bodies:
		body.free_all()
	await process_frame


func _report_bodies(p_name: String, p_bodies: Array[WalkerBody]) -> void:
	var sums: PackedFloat64Array = [0.0, 0.0, 0.0, 0.0, 0.0]
	var worst: float = 0.0
	for body: WalkerBody in p_bodies:
		sums[0] += body.distances.mean()
		sums[1] += body.headings.mean()
		sums[2] += body.slide.mean()
		sums[3] += body.down_ticks
		sums[4] += body.walker.waits
		worst = maxf(worst, body.distances.percentile(0.95))
	var share: float = 1.0 / p_bodies.size()
	report.at_most(p_name, "off the walker, mean", sums[0] * share * 100.0, "cm", 10.0)
	report.add(p_name, "off the walker, 95 % of the worst", worst * 100.0, "cm")
	report.at_most(p_name, "off its heading, mean", rad_to_deg(sums[1] * share), "deg", 5.0)
	report.at_most(p_name, "feet on the ground slide, mean", sums[2] * share * 100.0, "cm/s", 3.0)
	report.at_most(p_name, "ticks down", sums[3], "of %d" % (BODIES * BODY_TICKS), 0.0)
	report.add(p_name, "ticks waited for the body", sums[4], "of %d" % (BODIES * BODY_TICKS))


## Knocks people out of a stand, a walk and a run: who falls gets up, and walks again.
func _measure_shoves(p_course: WalkerCourse) -> void:
	for kind: String in WalkerKnocks.KINDS:
		var knocks: WalkerKnocks = WalkerKnocks.new(p_course, option("seed"))
		for number: int in option("shoves"):
			await knocks.knock(kind, number)
		report.add(kind, "fallen", knocks.fallen, "of %d" % option("shoves"))
		report.at_most(kind, "up again, median", knocks.times.percentile(0.5), "s", 4.0)
		report.at_most(kind, "up again, worst", knocks.times.percentile(1.0), "s", 4.0)
		report.at_least(kind, "walk again", knocks.back, "of %d" % knocks.fallen, knocks.fallen)


## What walkers cost a server besides their bodies' motors.
func _measure_crowd(p_course: WalkerCourse) -> void:
	var movers: Array[WalkerMover] = []
	var poses: Array[WalkerPose] = []
	var inputs: Array[WalkerInput] = WalkerCourse.inputs(option("seed") + 4, CROWD * 64)
	for index: int in CROWD:
		movers.append(p_course.mover())
		movers[index].place(Vector3(index % 8, 0.1, index / 8.0), 0.0)
		poses.append(WalkerPose.new())
		poses[index].restart(movers[index])
	var cost: Statistics = Statistics.new()
	for tick: int in 600:
		var begin: int = ThreadClock.get_usec()
		for index: int in CROWD:
			var input: WalkerInput = inputs[(index * 61 + tick) % inputs.size()]
			input.apply(movers[index], TICK_S)
			poses[index].advance(movers[index], input, TICK_S)
		cost.add(ThreadClock.get_usec() - begin)
	report.at_most("%d walkers" % CROWD, "a tick, median", cost.percentile(0.5) / 1000.0, "ms", 1.5)
	report.add("%d walkers" % CROWD, "a tick, 95 %", cost.percentile(0.95) / 1000.0, "ms")
