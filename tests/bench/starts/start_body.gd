class_name StartBody
extends RefCounted
## A body that begins in mid-motion, or pauses, in the benchmark of beginnings: when its samples
## come, and how far its limbs are off from then on.

## When it is looked at first, s after its beginning.
const LOOK_S: float = 0.1

## Moments of the motion, s: when the body begins, and when its samples stop and go on. The last is
## that from which it is judged.
var begins_s: float = 0.0
var stops_s: float = INF
var goes_on_s: float = 0.0
## Who it is.
var person: ContactPerson = null
## Where its motion's origin is, m.
var origin: Vector3 = Vector3.ZERO
## Its limb that was furthest off when it was looked at first, and how far, deg.
var first_limb: StringName = &""
var first_deg: float = 0.0
## How much further a limb was off than that of a body that has never paused, at most, deg, where it
## was off by more than what is allowed, and when, s after the beginning.
var later_limb: StringName = &""
var later_deg: float = 0.0
var later_s: float = 0.0


## Whether a sample of a moment of the motion comes, s.
func hears(p_time_s: float) -> bool:
	return p_time_s < stops_s - 1e-6 or p_time_s > goes_on_s - 1e-6


## Compares the limbs with the motion and with the errors of a body that has never paused, deg.
func judge(
	p_since_s: float, p_targets: Array[Transform3D], p_usual: PackedFloat64Array, p_limit_deg: float
) -> void:
	var is_first: bool = first_limb == &""
	var off_by: PackedFloat64Array = errors(p_targets)
	for limb: int in person.count:
		var off: float = off_by[limb]
		var more: float = off - p_usual[limb]
		if is_first and off > first_deg:
			first_deg = off
			first_limb = person.shape_of(limb).bone
		if off > p_limit_deg and more > later_deg:
			later_deg = more
			later_limb = person.shape_of(limb).bone
			later_s = p_since_s


## How far all limbs are off, deg.
func errors(p_targets: Array[Transform3D]) -> PackedFloat64Array:
	var bodies: Array[Transform3D] = person.bodies()
	var result: PackedFloat64Array = PackedFloat64Array()
	for limb: int in person.count:
		result.append(ContactPerson.angle_deg(bodies[limb].basis, p_targets[limb].basis))
	return result
