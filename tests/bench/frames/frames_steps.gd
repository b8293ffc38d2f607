extends RefCounted
## How long it takes until something sudden is seen: a hand that is turned from one sample to the
## next. Nothing of it can be guessed.

const Display: GDScript = preload("frames_display.gd")
## How far the hand turns, rad, and how often, ticks.
const STEP_RAD: float = 0.7
const EVERY: int = 31
## How long it is watched, s.
const SECONDS: float = 60.0

## From the sample to the first frame that shows a tenth of the step, and half of it, ms.
var first: LatencyHistogram = LatencyHistogram.new()
var half: LatencyHistogram = LatencyHistogram.new()
## The furthest that the hand was shown beyond where it was at any time, as a fraction of the step.
var overshoot: float = 0.0

var _smoother: SnapshotSmoother = SnapshotSmoother.new()
var _waits_for_first: bool = false
var _waits_for_half: bool = false
var _step: int = -1


## Watches a person that is but steps.
func watch_on(p_skeleton: PersonSkeleton, p_display: Display) -> void:
	_smoother.set_skeleton(
		0, p_skeleton.parents, p_skeleton.joints_in_parent, p_skeleton.joints_in_limb
	)
	p_display.play(_smoother, SECONDS, _push, _show)


func _push(p_tick: int, p_arrival_s: float) -> void:
	var turns: PackedFloat32Array = PackedFloat32Array()
	for limb: int in Limbs.COUNT:
		var angle: float = STEP_RAD * _target(p_tick) if limb == Limbs.LEFT_HAND else 0.0
		turns.append_array([0.0, 0.0, sin(angle / 2.0), cos(angle / 2.0)])
	_smoother.push_person(0, p_tick, p_arrival_s, Vector3.ZERO, turns)


func _show(p_time_s: float) -> void:
	var at: int = Limbs.LEFT_HAND * WorldReplica.FLOATS + 5
	var floats: PackedFloat32Array = _smoother.person_transforms(0)
	var part: float = 2.0 * atan2(floats[at], floats[at + 1]) / STEP_RAD
	overshoot = maxf(overshoot, maxf(part - 1.0, -part))
	@warning_ignore("integer_division")
	var step: int = int((p_time_s + Display.LEAD_S) * Display.TICK_RATE) / EVERY
	if step != _step:
		# The first one may be half over when watching begins.
		_waits_for_first = _step >= 0
		_waits_for_half = _step >= 0
		_step = step
	var moved: float = absf(part - _target((step - 1) * EVERY))
	var since_ms: float = (p_time_s - Display.sampled_s(step * EVERY)) * 1000.0
	if _waits_for_first and moved > 0.1:
		_waits_for_first = false
		first.add(since_ms)
	if _waits_for_half and moved > 0.5:
		_waits_for_half = false
		half.add(since_ms)


## Where the hand is at a tick, as a fraction of the step.
static func _target(p_tick: int) -> float:
	@warning_ignore("integer_division")
	return float(posmod(p_tick / EVERY, 2))
