class_name ResetPose
extends RefCounted
## Poses that a wearer can take so that sensors learn how they sit: how each place is turned in
## them from the reset pose (a T-pose, see [Limbs]), for somebody who faces +Z.

## The poses.
enum Kind {
	## Upright, arms stretched out sideways, palms down, feet parallel: the reset pose itself.
	T,
	## Upright, arms hanging, palms to the thighs, feet parallel.
	N,
}

## Names for people and files, by [enum Kind].
const NAMES: PackedStringArray = ["T", "N"]


## Rotation of a place of [BodyMounts] in a pose, from the reset pose.
static func rotation(p_kind: Kind, p_place: int) -> Quaternion:
	if p_kind == Kind.T or not hangs(p_place):
		return Quaternion.IDENTITY
	return Quaternion(Vector3.BACK, -PI / 2.0 * BodyMounts.side(p_place))


## Whether a place goes down with the arm from T to N: the arms, without the shoulder blades.
static func hangs(p_place: int) -> bool:
	return BodyMounts.is_arm(p_place) and p_place != 3 and p_place != 7


## The pose in words, as somebody is told to take it.
static func instruction(p_kind: Kind) -> String:
	if p_kind == Kind.T:
		return "Stand upright, arms straight out to the sides, palms down, feet parallel."
	return "Stand upright, arms hanging straight down, palms to the thighs, feet parallel."
