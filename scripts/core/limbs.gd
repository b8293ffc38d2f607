class_name Limbs
extends RefCounted
## The limbs that Dismount tracks, simulates and sends: names, hierarchy and reset pose.
##
## One table for all features, in one order: motion sources fill it, the ragdoll has a body for
## each, the wire carries them. Names are those of [SkeletonProfileHumanoid]. Parents come first.
## Frame: Godot's (right-handed, Y up, metres); in the reset pose the person faces +Z, as Godot's
## humanoid profile and glTF avatars do.

## Index of each limb in all tables and arrays "by limb".
enum {
	HIPS,
	SPINE,
	CHEST,
	HEAD,
	LEFT_UPPER_ARM,
	LEFT_LOWER_ARM,
	LEFT_HAND,
	RIGHT_UPPER_ARM,
	RIGHT_LOWER_ARM,
	RIGHT_HAND,
	LEFT_UPPER_LEG,
	LEFT_LOWER_LEG,
	LEFT_FOOT,
	RIGHT_UPPER_LEG,
	RIGHT_LOWER_LEG,
	RIGHT_FOOT,
}

## How many limbs there are.
const COUNT: int = 16
## Index of the limb that has no parent.
const ROOT: int = HIPS
## The legs without their feet.
const LEGS: Array[int] = [LEFT_UPPER_LEG, LEFT_LOWER_LEG, RIGHT_UPPER_LEG, RIGHT_LOWER_LEG]
## The arms without their hands.
const ARMS: Array[int] = [LEFT_UPPER_ARM, LEFT_LOWER_ARM, RIGHT_UPPER_ARM, RIGHT_LOWER_ARM]
## The feet.
const FEET: Array[int] = [LEFT_FOOT, RIGHT_FOOT]

## Humanoid bone whose orientation stands for the limb.
const BONES: Array[StringName] = [
	&"Hips",
	&"Spine",
	&"Chest",
	&"Head",
	&"LeftUpperArm",
	&"LeftLowerArm",
	&"LeftHand",
	&"RightUpperArm",
	&"RightLowerArm",
	&"RightHand",
	&"LeftUpperLeg",
	&"LeftLowerLeg",
	&"LeftFoot",
	&"RightUpperLeg",
	&"RightLowerLeg",
	&"RightFoot",
]

## Index of each limb's parent, -1 for the root.
const PARENTS: Array[int] = [
	-1,
	HIPS,
	SPINE,
	CHEST,
	CHEST,
	LEFT_UPPER_ARM,
	LEFT_LOWER_ARM,
	CHEST,
	RIGHT_UPPER_ARM,
	RIGHT_LOWER_ARM,
	HIPS,
	LEFT_UPPER_LEG,
	LEFT_LOWER_LEG,
	HIPS,
	RIGHT_UPPER_LEG,
	RIGHT_LOWER_LEG,
]

## Humanoid bones, best first, that mark where a limb ends.
const TAILS: Array[Array] = [
	[&"Spine"],
	[&"Chest"],
	[&"Neck", &"Head"],
	[&"HeadTip"],
	[&"LeftLowerArm"],
	[&"LeftHand"],
	[&"LeftMiddleProximal", &"LeftHandTip"],
	[&"RightLowerArm"],
	[&"RightHand"],
	[&"RightMiddleProximal", &"RightHandTip"],
	[&"LeftLowerLeg"],
	[&"LeftFoot"],
	[&"LeftToes"],
	[&"RightLowerLeg"],
	[&"RightFoot"],
	[&"RightToes"],
]

## Share of the body's mass (de Leva 1996, table 4, males; head with neck, trunk in three parts).
const MASS_FRACTIONS: Array[float] = [
	0.1117,
	0.1633,
	0.1596,
	0.0694,
	0.0271,
	0.0162,
	0.0061,
	0.0271,
	0.0162,
	0.0061,
	0.1416,
	0.0433,
	0.0137,
	0.1416,
	0.0433,
	0.0137,
]

## Greatest torque of the joint that holds each limb, N·m: a strong adult. The root has none.
const TORQUES: Array[float] = [
	0.0,
	500.0,
	500.0,
	160.0,
	120.0,
	80.0,
	20.0,
	120.0,
	80.0,
	20.0,
	350.0,
	300.0,
	150.0,
	350.0,
	300.0,
	150.0,
]

## Limbs whose direction the reset pose (a T-pose) prescribes, and that direction in the world.
## A limb that is missing here stands in the reset pose as it does at rest.
const RESET_DIRECTIONS: Dictionary[int, Vector3] = {
	LEFT_UPPER_ARM: Vector3.RIGHT,
	LEFT_LOWER_ARM: Vector3.RIGHT,
	LEFT_HAND: Vector3.RIGHT,
	RIGHT_UPPER_ARM: Vector3.LEFT,
	RIGHT_LOWER_ARM: Vector3.LEFT,
	RIGHT_HAND: Vector3.LEFT,
	LEFT_UPPER_LEG: Vector3.DOWN,
	LEFT_LOWER_LEG: Vector3.DOWN,
	RIGHT_UPPER_LEG: Vector3.DOWN,
	RIGHT_LOWER_LEG: Vector3.DOWN,
}


## The rotation in the world that takes a limb from its rest pose to the reset pose.
## [param p_direction] points along the limb at rest; a hand follows its lower arm.
static func rest_to_reset(p_limb: int, p_direction: Vector3) -> Quaternion:
	if not RESET_DIRECTIONS.has(p_limb) or p_direction.is_zero_approx():
		return Quaternion.IDENTITY
	var from: Vector3 = p_direction.normalized()
	var to: Vector3 = RESET_DIRECTIONS[p_limb]
	if from.dot(to) < -0.999:
		return Quaternion(Vector3.BACK, PI)
	return Quaternion(from, to)


## The index of the limb that a bone stands for, or -1.
static func find(p_bone: StringName) -> int:
	return BONES.find(p_bone)
