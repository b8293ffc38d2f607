class_name StartBody
extends RefCounted
## A body that begins in mid-motion, or pauses, in the benchmark of beginnings: when its samples
## come, and how far its limbs are off from then on.

## When it is looked at first, s after its beginning.
const LOOK_S: float = 0.1
## How far a limb may be off, deg.
const LIMIT_DEG: float = 8.0
## Feet do not touch down at the same moment in two runs: a body that has never paused is looked at
## for so long before and after, s.
const _AROUND_S: float = 0.25

## Moments of the motion, s: when the body begins, and when its samples stop and go on. The last is
## that from which it is judged.
var begins_s: float = 0.0
var stops_s: float = INF
var goes_on_s: float = 0.0
## Who it is.
var person: ContactPerson = null
## Where its motion's origin is, m.
var origin: Vector3 = Vector3.ZERO
## How far its limbs were off after each step of the world from [member first_step] on, deg.
var errors: Array[PackedFloat64Array] = []
var first_step: int = -1
## The limb that was furthest off when it was looked at first.
var first_limb: int = 0
var first_deg: float = 0.0
## That of a body that has never paused at that moment, deg.
var usual_deg: float = 0.0
## The limb that was off by more than [constant LIMIT_DEG], and furthest beyond what it is in a body
## that has never paused, deg, and when, s after the beginning.
var later_limb: int = 0
var later_deg: float = 0.0
var later_s: float = 0.0


## Whether a sample of a moment of the motion comes, s.
func hears(p_time_s: float) -> bool:
	return p_time_s < stops_s - 1e-6 or p_time_s > goes_on_s - 1e-6


## Notes how far the limbs are off in a step of the world.
func note(p_step: int, p_targets: Array[Transform3D]) -> void:
	var bodies: Array[Transform3D] = person.bodies()
	var off: PackedFloat64Array = PackedFloat64Array()
	for limb: int in person.count:
		off.append(ContactPerson.angle_deg(bodies[limb].basis, p_targets[limb].basis))
	first_step = p_step if first_step < 0 else first_step
	errors.append(off)


## Compares what was noted with a body that has never paused.
func judge(p_usual: StartBody, p_delta_s: float) -> void:
	var around: int = roundi(_AROUND_S / p_delta_s)
	for i: int in errors.size():
		var usual: PackedFloat64Array = p_usual.most(
			first_step + i - around, first_step + i + around
		)
		for limb: int in errors[i].size():
			var off: float = errors[i][limb]
			if i == 0 and off > first_deg:
				first_deg = off
				first_limb = limb
			if off > LIMIT_DEG and off - usual[limb] > later_deg:
				later_deg = off - usual[limb]
				later_limb = limb
				later_s = LOOK_S + i * p_delta_s
	usual_deg = Array(p_usual.most(first_step, first_step)).max()


## The most that each limb was off from one step to another, deg.
func most(p_from: int, p_to: int) -> PackedFloat64Array:
	var result: PackedFloat64Array = errors[0].duplicate()
	result.fill(0.0)
	for step: int in range(
		maxi(p_from, first_step), mini(p_to, first_step + errors.size() - 1) + 1
	):
		for limb: int in result.size():
			result[limb] = maxf(result[limb], errors[step - first_step][limb])
	return result
