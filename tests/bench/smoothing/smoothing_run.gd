extends RefCounted
## One client that watches a person over a network that delays, jitters and loses, in simulated
## time.

const Motion: GDScript = preload("smoothing_motion.gd")

## Ticks of the server per second.
const TICK_RATE: int = 60
## What is shown before it counts, s.
const SETTLING_S: float = 2.0

## Frames of the display per second.
var display_rate: float = 60.0
## Where the limbs were shown, m.
var shown: PackedVector3Array = PackedVector3Array()
## When each frame was shown, s of the motion.
var times: PackedFloat64Array = PackedFloat64Array()
## Squares of the angles to the truth at that time, rad^2, and how many.
var angle_squares: float = 0.0
var angles: int = 0
## The widest gap at a joint, m.
var gap: float = 0.0
## What was watched.
var motion: Motion = null

var _random: RandomNumberGenerator = RandomNumberGenerator.new()


## Watches a motion. The network is {rate, delay, jitter, loss, seed}: updates per second, ms, ms
## (uniformly more or less), %.
func watch(p_motion: Motion, p_method: SnapshotSmoother.Method, p_network: Dictionary) -> void:
	motion = p_motion
	var smoother: SnapshotSmoother = SnapshotSmoother.new()
	smoother.method = p_method
	smoother.tick_rate = TICK_RATE
	var skeleton: PersonSkeleton = motion.skeleton
	smoother.set_skeleton(0, skeleton.parents, skeleton.joints_in_parent, skeleton.joints_in_limb)
	var arrivals: Array[Vector2] = _send(p_network)
	var next: int = 0
	var frames: int = int((float(motion.count) / Motion.RATE) * display_rate) - 1
	for frame: int in frames:
		# The screen's clock is not the server's: a third of a frame apart.
		var now: float = (frame + 0.33) / display_rate
		while next < arrivals.size() and arrivals[next].x <= now:
			var tick: int = int(arrivals[next].y)
			var sample: int = tick * Motion.RATE / TICK_RATE
			smoother.push_person(
				0, tick, arrivals[next].x, motion.roots[sample], motion.turns_of(sample)
			)
			next += 1
		smoother.evaluate(now)
		if now > SETTLING_S:
			_note(now, smoother.person_transforms(0))


## When which tick arrives, in the order of arrival.
func _send(p_network: Dictionary) -> Array[Vector2]:
	_random.seed = p_network["seed"]
	var arrivals: Array[Vector2] = []
	var step: int = maxi(roundi(float(TICK_RATE) / p_network["rate"]), 1)
	for tick: int in range(0, motion.count * TICK_RATE / Motion.RATE, step):
		var delay: float = p_network["delay"] + _random.randf_range(-1.0, 1.0) * p_network["jitter"]
		if _random.randf() * 100.0 >= p_network["loss"]:
			arrivals.append(Vector2(float(tick) / TICK_RATE + maxf(delay, 0.0) / 1000.0, tick))
	arrivals.sort()
	return arrivals


func _note(p_now_s: float, p_floats: PackedFloat32Array) -> void:
	var limbs: int = motion.skeleton.count()
	var turns: PackedFloat32Array = motion.turns_of(roundi(p_now_s * Motion.RATE))
	var places: PackedVector3Array = PackedVector3Array()
	var orientations: Array[Quaternion] = []
	times.append(p_now_s)
	for limb: int in limbs:
		var at: int = limb * 7
		places.append(Vector3(p_floats[at], p_floats[at + 1], p_floats[at + 2]))
		orientations.append(
			Quaternion(p_floats[at + 3], p_floats[at + 4], p_floats[at + 5], p_floats[at + 6])
		)
		var off: float = orientations[limb].angle_to(Motion._turn(turns, limb))
		angle_squares += off * off
		var parent: int = motion.skeleton.parents[limb]
		if parent >= 0:
			gap = maxf(gap, _gap(places, orientations, limb, parent))
	angles += limbs
	shown.append_array(places)


func _gap(
	p_places: PackedVector3Array, p_turns: Array[Quaternion], p_limb: int, p_parent: int
) -> float:
	var skeleton: PersonSkeleton = motion.skeleton
	var outer: Vector3 = p_places[p_parent] + p_turns[p_parent] * skeleton.joints_in_parent[p_limb]
	return outer.distance_to(p_places[p_limb] + p_turns[p_limb] * skeleton.joints_in_limb[p_limb])
