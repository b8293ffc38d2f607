class_name SeatedPose
extends RefCounted
## Replaces the legs, and the arms, of a wearer's motion by those of a person who stands in a hatch
## or sits: the vehicle has no room for what the wearer does.

## Angles of thighs and shins of a sitting person from hanging down, rad.
const _THIGH: float = 1.45
const _SHIN: float = 0.05
## Angles of resting arms: upper arms to the side, lower arms forward, rad.
const _ARM_DOWN: float = 1.25
const _ELBOW: float = 1.1
## Least bend of a leg: legs are never quite straight.
const _MIN_BEND: float = 0.995


## A copy of a sample with the limbs that a hold names. [param p_height] is the height of the hips
## above the soles, m; [param p_lengths] are those of [method lengths_of].
static func fit(
	p_sample: PoseSample, p_hold: SeatHold, p_height: float, p_lengths: Vector3
) -> PoseSample:
	if p_hold.legs == SeatHold.Legs.FREE and not p_hold.rests_arms:
		return p_sample
	var fitted: PoseSample = PoseSample.new()
	fitted.person = p_sample.person
	fitted.id = p_sample.id
	fitted.time_usec = p_sample.time_usec
	fitted.root = p_sample.root
	fitted.orientations = p_sample.orientations.duplicate()
	var facing: Quaternion = facing_of(p_sample.orientation(Limbs.HIPS))
	if p_hold.legs == SeatHold.Legs.STANDING:
		_bend(fitted, facing, _bent(p_height, p_lengths))
	elif p_hold.legs == SeatHold.Legs.SITTING:
		_bend(fitted, facing, Vector2(_THIGH, _SHIN))
	if p_hold.rests_arms:
		_rest(fitted, facing_of(p_sample.orientation(Limbs.CHEST)))
	return fitted


## Heading of a limb of the trunk: the part of its rotation about the vertical.
static func facing_of(p_turn: Quaternion) -> Quaternion:
	var ahead: Vector3 = p_turn * Vector3.BACK
	if Vector2(ahead.x, ahead.z).length() < 0.3:
		# The trunk is bent over or lies: the end of the head gives the heading.
		ahead = (p_turn * Vector3.UP) * -signf(ahead.y)
	return Quaternion(Vector3.UP, atan2(ahead.x, ahead.z))


## Lengths of a body's thigh and shin, and the height of what remains between hips and soles, m.
static func lengths_of(p_profile: RagdollProfile) -> Vector3:
	var upper: int = p_profile.find_index(Limbs.BONES[Limbs.LEFT_UPPER_LEG])
	var lower: int = p_profile.find_index(Limbs.BONES[Limbs.LEFT_LOWER_LEG])
	var foot: int = p_profile.find_index(Limbs.BONES[Limbs.LEFT_FOOT])
	if upper < 0 or lower < 0 or foot < 0:
		return Vector3(0.42, 0.42, 0.15)
	var limbs: Array[RagdollLimb] = p_profile.limbs
	var thigh: float = limbs[upper].anchor.distance_to(limbs[lower].anchor)
	var shin: float = limbs[lower].anchor.distance_to(limbs[foot].anchor)
	var rest: float = limbs[0].anchor.y - limbs[upper].anchor.y + limbs[foot].anchor.y
	return Vector3(thigh, shin, rest)


## How far thigh and shin are bent so that hips of a height stand on their feet, rad.
static func _bent(p_height: float, p_lengths: Vector3) -> Vector2:
	var thigh: float = p_lengths.x
	var shin: float = p_lengths.y
	var reach: float = clampf(
		p_height - p_lengths.z, 0.35 * (thigh + shin), _MIN_BEND * (thigh + shin)
	)
	var up: float = (thigh * thigh + reach * reach - shin * shin) / (2.0 * thigh * reach)
	var down: float = (shin * shin + reach * reach - thigh * thigh) / (2.0 * shin * reach)
	return Vector2(acos(clampf(up, -1.0, 1.0)), -acos(clampf(down, -1.0, 1.0)))


static func _bend(p_sample: PoseSample, p_facing: Quaternion, p_bent: Vector2) -> void:
	var thigh: Quaternion = p_facing * Quaternion(Vector3.RIGHT, -p_bent.x)
	var shin: Quaternion = p_facing * Quaternion(Vector3.RIGHT, -p_bent.y)
	for limb: int in [Limbs.LEFT_UPPER_LEG, Limbs.RIGHT_UPPER_LEG]:
		p_sample.set_orientation(limb, thigh)
	for limb: int in [Limbs.LEFT_LOWER_LEG, Limbs.RIGHT_LOWER_LEG]:
		p_sample.set_orientation(limb, shin)
	for limb: int in Limbs.FEET:
		p_sample.set_orientation(limb, p_facing)


## Upper arms hang, lower arms point ahead. In the reset pose arms point to the sides.
static func _rest(p_sample: PoseSample, p_facing: Quaternion) -> void:
	for side: int in 2:
		var turned: float = -_ARM_DOWN if side == 0 else _ARM_DOWN
		var upper: Quaternion = p_facing * Quaternion(Vector3.BACK, turned)
		var lower: Quaternion = p_facing * Quaternion(Vector3.RIGHT, -_ELBOW)
		lower = lower * Quaternion(Vector3.BACK, turned)
		var first: int = Limbs.LEFT_UPPER_ARM if side == 0 else Limbs.RIGHT_UPPER_ARM
		p_sample.set_orientation(first, upper)
		p_sample.set_orientation(first + 1, lower)
		p_sample.set_orientation(first + 2, lower)
