class_name ResetPose
extends RefCounted
## Poses for calibrating sensors: the rotation of each mount in them from the reset pose (a T-pose,
## see [Limbs]), for somebody who faces +Z.

## The poses.
enum Kind {
	## Upright, arms stretched out sideways, palms down, feet parallel: the reset pose itself.
	T,
	## Upright, arms hanging, palms to the thighs, feet parallel.
	N,
}

## Names for people and files, by [enum Kind].
const NAMES: PackedStringArray = ["T", "N"]


## Rotation of a mount of [BodyMounts] in a pose, from the reset pose.
static func rotation(p_kind: Kind, p_mount: int) -> Quaternion:
	if p_kind == Kind.T or not hangs(p_mount):
		return Quaternion.IDENTITY
	return Quaternion(Vector3.BACK, -PI / 2.0 * BodyMounts.side(p_mount))


## Whether a mount goes down with the arm from T to N: the arms, without the shoulder blades.
static func hangs(p_mount: int) -> bool:
	return BodyMounts.is_arm(p_mount) and p_mount != 3 and p_mount != 7


## The pose in words, as an instruction to the wearer.
static func instruction(p_kind: Kind) -> String:
	if p_kind == Kind.T:
		return "Stand upright, arms straight out to the sides, palms down, feet parallel."
	return "Stand upright, arms hanging straight down, palms to the thighs, feet parallel."
