class_name TwoBone
extends RefCounted
## Two limbs in a row, from a shoulder to a wrist or from a hip to an ankle: where the joint between
## them is.

## Part of the whole length beyond which a limb is not stretched: a straight elbow or knee would
## flip.
const STRETCH: float = 0.998
## Angle between the two limbs when they are folded up, rad.
const FOLDED: float = deg_to_rad(27.0)


## Where the middle joint is if the ends are there, m; [param p_pole] points to the side to which it
## bends. An end that is out of reach is taken as near as it can be.
static func middle(
	p_base: Vector3, p_end: Vector3, p_upper: float, p_lower: float, p_pole: Vector3
) -> Vector3:
	var along: Vector3 = direction(p_base, p_end)
	var far: float = reach(p_base.distance_to(p_end), p_upper, p_lower)
	var on: float = (p_upper * p_upper - p_lower * p_lower + far * far) / (2.0 * far)
	var off: float = sqrt(maxf(p_upper * p_upper - on * on, 0.0))
	return p_base + along * on + across(p_pole, along) * off


## The distance from end to end that two limbs can have, the nearest to one that is wanted, m.
static func reach(p_wanted: float, p_upper: float, p_lower: float) -> float:
	var least: float = sqrt(
		p_upper * p_upper + p_lower * p_lower - 2.0 * p_upper * p_lower * cos(FOLDED)
	)
	return clampf(p_wanted, least, maxf((p_upper + p_lower) * STRETCH, least))


## The part of a vector across a direction, of length 1; any one where it has none.
static func across(p_vector: Vector3, p_along: Vector3) -> Vector3:
	var part: Vector3 = p_vector - p_along * p_vector.dot(p_along)
	if part.length_squared() > 1e-10:
		return part.normalized()
	var other: Vector3 = Vector3.BACK if absf(p_along.z) < 0.9 else Vector3.UP
	return (other - p_along * other.dot(p_along)).normalized()


## The direction from one position to another, of length 1; down where they are one.
static func direction(p_from: Vector3, p_to: Vector3) -> Vector3:
	var offset: Vector3 = p_to - p_from
	return offset.normalized() if offset.length_squared() > 1e-12 else Vector3.DOWN


## The least turn from one direction to another.
static func turn_between(p_from: Vector3, p_to: Vector3) -> Quaternion:
	if p_from.dot(p_to) < -0.9999:
		return Quaternion(across(Vector3.UP, p_from), PI)
	return Quaternion(p_from, p_to).normalized()
