class_name GuidedPhase
extends RefCounted
## One thing that a wearer is asked to do while a motion set is recorded of him
## ([GuidedRecording]), and what must be seen of it.

## What is counted.
enum Want {
	## Seconds in which the wearer stands still.
	STILL,
	## Seconds of going straight ahead.
	AHEAD,
	## Seconds of going backwards.
	BACK,
	## Seconds of going sideways to the left.
	LEFT,
	## Seconds of going sideways to the right.
	RIGHT,
	## Seconds of going ahead in a curve to the left.
	CURVE_LEFT,
	## Seconds of going ahead in a curve to the right.
	CURVE_RIGHT,
	## Degrees turned to the left on the spot.
	TURN_LEFT,
	## Degrees turned to the right on the spot.
	TURN_RIGHT,
	## How often the wearer starts or stops.
	STARTS,
}

## For how long a phase is announced before it counts, s.
const READY_S: float = 3.0
## How often a phase is asked for again.
const REPEATS: int = 2

## Of each phase: name, what is counted, how much of it, the longest time of an attempt (s), slowest
## and fastest (heights of the hips a second), stance, and the words for the wearer.
const ROWS: Array[Array] = [
	["stand", Want.STILL, 4.0, 12.0, 0.0, 9.0, MotionMatcher.STAND, "Stand at ease, look ahead"],
	[
		"walk",
		Want.AHEAD,
		10.0,
		30.0,
		0.7,
		2.1,
		MotionMatcher.STAND,
		"Walk as you usually do; where the room ends turn round and walk on",
	],
	["slow-walk", Want.AHEAD, 6.0, 20.0, 0.35, 1.1, MotionMatcher.STAND, "Walk slowly"],
	["fast-walk", Want.AHEAD, 4.0, 20.0, 1.4, 2.7, MotionMatcher.STAND, "Walk fast"],
	[
		"starts",
		Want.STARTS,
		4.0,
		24.0,
		0.0,
		9.0,
		MotionMatcher.STAND,
		"Stand, walk four steps, stop and stand; then once more",
	],
	[
		"turn-left",
		Want.TURN_LEFT,
		330.0,
		16.0,
		0.0,
		9.0,
		MotionMatcher.STAND,
		"Turn left on the spot"
	],
	[
		"turn-right",
		Want.TURN_RIGHT,
		330.0,
		16.0,
		0.0,
		9.0,
		MotionMatcher.STAND,
		"Turn right on the spot",
	],
	[
		"curve-left",
		Want.CURVE_LEFT,
		4.0,
		16.0,
		0.35,
		2.7,
		MotionMatcher.STAND,
		"Walk in a circle to the left, three steps wide",
	],
	[
		"curve-right",
		Want.CURVE_RIGHT,
		4.0,
		16.0,
		0.35,
		2.7,
		MotionMatcher.STAND,
		"Walk in a circle to the right, three steps wide",
	],
	["back", Want.BACK, 4.0, 20.0, 0.3, 2.7, MotionMatcher.STAND, "Walk backwards"],
	["left", Want.LEFT, 3.0, 20.0, 0.3, 2.7, MotionMatcher.STAND, "Walk sideways to the left"],
	["right", Want.RIGHT, 3.0, 20.0, 0.3, 2.7, MotionMatcher.STAND, "Walk sideways to the right"],
	["run", Want.AHEAD, 3.0, 20.0, 2.1, 9.0, MotionMatcher.STAND, "Run across the room and back"],
	["crouch", Want.STILL, 3.0, 12.0, 0.0, 9.0, MotionMatcher.CROUCH, "Crouch, and stay so"],
	["crouched-walk", Want.AHEAD, 4.0, 20.0, 0.3, 2.7, MotionMatcher.CROUCH, "Walk ahead crouched"],
]

const _SECONDS: Dictionary[Want, String] = {
	Want.STILL: "stood still",
	Want.AHEAD: "went straight ahead",
	Want.BACK: "went backwards",
	Want.LEFT: "went sideways to the left",
	Want.RIGHT: "went sideways to the right",
	Want.CURVE_LEFT: "went in a curve to the left",
	Want.CURVE_RIGHT: "went in a curve to the right",
}

## Its name, also of its files.
var name: String = ""
## What is counted.
var want: Want = Want.STILL
## How much of it there must be: s, degrees or times.
var need: float = 0.0
## The longest time of an attempt, s.
var limit_s: float = 0.0
## The slowest and the fastest that counts, heights of the hips a second.
var slowest: float = 0.0
var fastest: float = 0.0
## How the body is held: one of [enum MotionMatcher.Stance].
var stance: MotionMatcher.Stance = MotionMatcher.STAND
## The words for the wearer: what to do.
var words: String = ""


## All phases, but for those that are left out by name.
static func all(p_skipped: PackedStringArray = []) -> Array[GuidedPhase]:
	var phases: Array[GuidedPhase] = []
	for row: Array in ROWS:
		if not p_skipped.has(row[0]):
			phases.append(_of(row))
	return phases


## The names of all phases.
static func names() -> PackedStringArray:
	var found: PackedStringArray = []
	for row: Array in ROWS:
		found.append(row[0])
	return found


## Says what there was of it, for the wearer; [param p_any] is how much there was at any speed.
func describe(p_amount: float, p_any: float) -> String:
	var text: String = ""
	match want:
		Want.TURN_LEFT, Want.TURN_RIGHT:
			text = "you turned by %d of %d degrees" % [roundi(p_amount), roundi(need)]
		Want.STARTS:
			text = "you started and stopped %d times, not %d" % [roundi(p_amount), roundi(need)]
		_:
			text = "you %s for %.1f of %.0f s" % [_SECONDS[want], p_amount, need]
	if stance == MotionMatcher.CROUCH:
		text += " crouched"
	if p_any > p_amount + 1.0 and want == Want.AHEAD:
		text += ", more of it too fast or too slow"
	return text


static func _of(p_row: Array) -> GuidedPhase:
	var phase: GuidedPhase = GuidedPhase.new()
	phase.name = p_row[0]
	phase.want = p_row[1]
	phase.need = p_row[2]
	phase.limit_s = p_row[3]
	phase.slowest = p_row[4]
	phase.fastest = p_row[5]
	phase.stance = p_row[6]
	phase.words = p_row[7]
	return phase
