class_name LimbLimits
extends RefCounted
## What joints of people can do, for limbs whose depth is poorly seen.

## How far a knee's axis is turned from across the pelvis, about the thigh, rad.
const LEG_TURN: float = deg_to_rad(50.0)
## The same of an elbow's axis from where a hanging arm has it.
const ARM_TURN: float = deg_to_rad(110.0)
## Greatest bend of a knee, rad.
const KNEE: float = deg_to_rad(150.0)
## How far a foot is turned from its shank at most, rad.
const FOOT: float = deg_to_rad(60.0)


## Directions of a thigh and a shank that a leg can have, by where they are seen to point: a knee
## bends backwards only, about an axis that is not too far from the pelvis' own.
static func leg(p_pelvis: Quaternion, p_thigh: Vector3, p_shank: Vector3) -> Array[Vector3]:
	var thigh: Vector3 = p_thigh.normalized()
	var straight: Quaternion = _shortest(p_pelvis * Vector3.DOWN, thigh)
	var across: Vector3 = straight * (p_pelvis * Vector3.RIGHT)
	var seen: Vector3 = thigh.cross(p_shank)
	if thigh.length() < 0.5 or seen.length() < 1e-6:
		return [p_thigh, p_shank]
	var turn: float = across.signed_angle_to(seen, thigh)
	if absf(turn) <= LEG_TURN:
		return [p_thigh, p_shank]
	# The axis turns to the limit; of the bend that part is kept that is about it.
	var axis: Vector3 = across.rotated(thigh, clampf(turn, -LEG_TURN, LEG_TURN))
	var bend: float = thigh.angle_to(p_shank) * cos(absf(turn) - LEG_TURN)
	if bend > 0.0:
		return [p_thigh, thigh.rotated(axis, minf(bend, KNEE)) * p_shank.length()]
	# It seems to bend forward: then it is straight, from the hip to the ankle.
	var whole: Vector3 = (p_thigh + p_shank).normalized()
	return [whole * p_thigh.length(), whole * p_shank.length()]


## The axis of an elbow as an arm can have it; rest is the direction of the arm in the reset pose.
static func arm_axis(
	p_chest: Quaternion, p_rest: Vector3, p_upper: Vector3, p_axis: Vector3
) -> Vector3:
	var upper: Vector3 = p_upper.normalized()
	if upper.length() < 0.5 or p_axis.length() < 1e-6:
		return p_axis
	var swing: Quaternion = _shortest(p_chest * p_rest, upper)
	var usual: Vector3 = swing * (p_chest * Vector3.UP)
	var turn: float = usual.signed_angle_to(p_axis, upper)
	if absf(turn) <= ARM_TURN:
		return p_axis
	return usual.rotated(upper, clampf(turn, -ARM_TURN, ARM_TURN)) * p_axis.length()


## A foot's rotation within what its ankle allows.
static func foot(p_shank: Quaternion, p_foot: Quaternion) -> Quaternion:
	var turn: Quaternion = p_shank.inverse() * p_foot
	var angle: float = Rotations.angle(turn)
	if angle <= FOOT:
		return p_foot
	return (p_shank * Quaternion.IDENTITY.slerp(turn, FOOT / angle)).normalized()


static func _shortest(p_from: Vector3, p_to: Vector3) -> Quaternion:
	if p_to.length() < 0.5 or p_from.dot(p_to) < -0.999:
		return Quaternion.IDENTITY
	return Quaternion(p_from, p_to)
