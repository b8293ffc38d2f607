class_name LimbAxes
extends RefCounted
## Rotations of limbs from the reset pose, from where their joints are.

## Range of a left hip and knee, rad, about the axes of the reset pose.
const _HIP_MIN: Vector3 = Vector3(-2.2, -1.1, -0.9)
const _HIP_MAX: Vector3 = Vector3(0.95, 1.1, 1.4)
const _KNEE_MIN: Vector3 = Vector3(-0.2, -0.9, -0.5)
const _KNEE_MAX: Vector3 = Vector3(2.58, 0.9, 0.5)
## Range of a wrist, rad: about the axes of the reset pose, of a left hand.
const _WRIST_MIN: Vector3 = Vector3(-0.9, -0.8, -1.3)
const _WRIST_MAX: Vector3 = Vector3(0.9, 0.8, 1.3)
## Part of a hand's turn about the forearm that the forearm takes, and its most, rad.
const _TWIST_SHARE: float = 0.7
const _TWIST_MAX: float = 1.2
## And its most with a folded elbow: more would not look like the same joint.
const _FOLDED_TWIST_MAX: float = 0.6


## Sets upper arm, forearm and hand of a side (0 left, 1 right) of a pose: shoulder, elbow and wrist
## in the world; the hand's rotation is kept as far as a wrist can.
static func set_arm(
	r_pose: PoseSample,
	p_side: int,
	p_shoulder: Vector3,
	p_elbow: Vector3,
	p_wrist: Vector3,
	p_pole: Vector3,
	p_hand: Quaternion
) -> void:
	var out: float = 1.0 - 2.0 * p_side
	var upper: Vector3 = TwoBone.direction(p_shoulder, p_elbow)
	var fore: Vector3 = TwoBone.direction(p_elbow, p_wrist)
	# In the reset pose elbows bend to the front, about the vertical. The pole has the elbow's side.
	var hinge: Vector3 = upper.cross(fore) * -out
	if hinge.length() < 0.05:
		hinge = upper.cross(-p_pole) * -out
	var up: Vector3 = TwoBone.across(hinge, upper)
	var arm: Quaternion = _basis(upper * out, up)
	var lower: Quaternion = _basis(fore * out, TwoBone.across(up, fore))
	var turn: Quaternion = lower.inverse() * p_hand
	var twist: float = 2.0 * atan2(turn.x, turn.w)
	var most: float = lerpf(_TWIST_MAX, _FOLDED_TWIST_MAX, upper.angle_to(fore) / PI)
	twist = clampf(wrapf(twist, -PI, PI) * _TWIST_SHARE, -most, most)
	lower = lower * Quaternion(Vector3.RIGHT, twist)
	var limb: int = Limbs.LEFT_UPPER_ARM + 3 * p_side
	r_pose.set_orientation(limb, arm)
	r_pose.set_orientation(limb + 1, lower.normalized())
	r_pose.set_orientation(limb + 2, _hand(lower, p_hand, out))


## Sets thigh and shank of a side: hip, knee and ankle in the world; [param p_front] is where the
## knee points.
static func set_leg(
	r_pose: PoseSample,
	p_side: int,
	p_hip: Vector3,
	p_knee: Vector3,
	p_ankle: Vector3,
	p_front: Vector3
) -> void:
	var thigh: Vector3 = TwoBone.direction(p_hip, p_knee)
	var shank: Vector3 = TwoBone.direction(p_knee, p_ankle)
	var limb: int = Limbs.LEFT_UPPER_LEG + 3 * p_side
	# Of a bent leg the hinge is exact, of a straight one the front decides.
	var hinge: Vector3 = thigh.cross(shank)
	var straight: Vector3 = (-thigh).cross(p_front)
	if hinge.length() < 0.05 or hinge.dot(straight) < 0.0:
		hinge = straight
	var side: Vector3 = TwoBone.across(hinge, thigh)
	r_pose.set_orientation(limb, _leg(thigh, side))
	r_pose.set_orientation(limb + 1, _leg(shank, TwoBone.across(side, shank)))


## Turns a leg back into the range of its joints, where the foot is where no foot can be.
static func spare_leg(r_pose: PoseSample, p_side: int) -> void:
	var limb: int = Limbs.LEFT_UPPER_LEG + 3 * p_side
	var mirror: Vector3 = Vector3(1.0, 1.0 - 2.0 * p_side, 1.0 - 2.0 * p_side)
	var hips: Quaternion = r_pose.orientation(Limbs.HIPS)
	var thigh: Quaternion = r_pose.orientation(limb)
	var shank: Quaternion = r_pose.orientation(limb + 1)
	var bend: Vector3 = Rotations.vector(hips.inverse() * thigh) * mirror
	var knee: Vector3 = Rotations.vector(thigh.inverse() * shank) * mirror
	if bend == bend.clamp(_HIP_MIN, _HIP_MAX) and knee == knee.clamp(_KNEE_MIN, _KNEE_MAX):
		return
	thigh = hips * Rotations.from_vector(bend.clamp(_HIP_MIN, _HIP_MAX) * mirror)
	shank = thigh * Rotations.from_vector(knee.clamp(_KNEE_MIN, _KNEE_MAX) * mirror)
	r_pose.set_orientation(limb, thigh.normalized())
	r_pose.set_orientation(limb + 1, shank.normalized())


## A hand that a wrist can bear.
static func _hand(p_lower: Quaternion, p_hand: Quaternion, p_out: float) -> Quaternion:
	var bend: Vector3 = Rotations.vector(p_lower.inverse() * p_hand)
	bend *= Vector3(1.0, p_out, p_out)
	bend = bend.clamp(_WRIST_MIN, _WRIST_MAX) * Vector3(1.0, p_out, p_out)
	return (p_lower * Rotations.from_vector(bend)).normalized()


static func _basis(p_x: Vector3, p_y: Vector3) -> Quaternion:
	return Basis(p_x, p_y, p_x.cross(p_y)).orthonormalized().get_rotation_quaternion()


static func _leg(p_along: Vector3, p_x: Vector3) -> Quaternion:
	var basis: Basis = Basis(p_x, -p_along, p_x.cross(-p_along))
	return basis.orthonormalized().get_rotation_quaternion()
