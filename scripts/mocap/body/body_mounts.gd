class_name BodyMounts
extends RefCounted
## Where sensors are worn: 17 mounts, their names, and which limb of [Limbs] each moves with.

## Index of each mount in all arrays "by mount".
enum {
	PELVIS,
	STERNUM,
	HEAD,
	LEFT_SHOULDER,
	LEFT_UPPER_ARM,
	LEFT_FOREARM,
	LEFT_HAND,
	RIGHT_SHOULDER,
	RIGHT_UPPER_ARM,
	RIGHT_FOREARM,
	RIGHT_HAND,
	LEFT_THIGH,
	LEFT_SHANK,
	LEFT_FOOT,
	RIGHT_THIGH,
	RIGHT_SHANK,
	RIGHT_FOOT,
}

## How many mounts there are.
const COUNT: int = 17

## Names of the mounts as files have them. All arrays "per mount" have this order.
const NAMES: Array[StringName] = [
	&"pelvis",
	&"sternum",
	&"head",
	&"left_shoulder",
	&"left_upper_arm",
	&"left_forearm",
	&"left_hand",
	&"right_shoulder",
	&"right_upper_arm",
	&"right_forearm",
	&"right_hand",
	&"left_thigh",
	&"left_shank",
	&"left_foot",
	&"right_thigh",
	&"right_shank",
	&"right_foot",
]

## The limb that a sensor at the mount is tied to. Shoulder blades are no limb of their own: they
## go with the chest.
const LIMBS: Array[int] = [
	Limbs.HIPS,
	Limbs.CHEST,
	Limbs.HEAD,
	Limbs.CHEST,
	Limbs.LEFT_UPPER_ARM,
	Limbs.LEFT_LOWER_ARM,
	Limbs.LEFT_HAND,
	Limbs.CHEST,
	Limbs.RIGHT_UPPER_ARM,
	Limbs.RIGHT_LOWER_ARM,
	Limbs.RIGHT_HAND,
	Limbs.LEFT_UPPER_LEG,
	Limbs.LEFT_LOWER_LEG,
	Limbs.LEFT_FOOT,
	Limbs.RIGHT_UPPER_LEG,
	Limbs.RIGHT_LOWER_LEG,
	Limbs.RIGHT_FOOT,
]

## The mount one joint nearer to the pelvis, -1 for the pelvis.
const PARENTS: Array[int] = [
	-1,
	PELVIS,
	STERNUM,
	STERNUM,
	LEFT_SHOULDER,
	LEFT_UPPER_ARM,
	LEFT_FOREARM,
	STERNUM,
	RIGHT_SHOULDER,
	RIGHT_UPPER_ARM,
	RIGHT_FOREARM,
	PELVIS,
	LEFT_THIGH,
	LEFT_SHANK,
	PELVIS,
	RIGHT_THIGH,
	RIGHT_SHANK,
]

## The same mount on the other side; a mount in the middle is its own mirror.
const MIRRORS: Array[int] = [
	PELVIS,
	STERNUM,
	HEAD,
	RIGHT_SHOULDER,
	RIGHT_UPPER_ARM,
	RIGHT_FOREARM,
	RIGHT_HAND,
	LEFT_SHOULDER,
	LEFT_UPPER_ARM,
	LEFT_FOREARM,
	LEFT_HAND,
	RIGHT_THIGH,
	RIGHT_SHANK,
	RIGHT_FOOT,
	LEFT_THIGH,
	LEFT_SHANK,
	LEFT_FOOT,
]


## The number of a mount, or -1.
static func find(p_name: StringName) -> int:
	return NAMES.find(p_name)


## A mount for people: "left upper arm".
static func title(p_mount: int) -> String:
	return String(NAMES[p_mount]).replace("_", " ")


## 1 for the left side, -1 for the right one, 0 for the middle.
static func side(p_mount: int) -> int:
	if NAMES[p_mount].begins_with("left"):
		return 1
	return -1 if NAMES[p_mount].begins_with("right") else 0


## Whether a mount is on an arm or its shoulder.
static func is_arm(p_mount: int) -> bool:
	return p_mount >= LEFT_SHOULDER and p_mount <= RIGHT_HAND
