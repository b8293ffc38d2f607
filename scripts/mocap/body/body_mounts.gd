class_name BodyMounts
extends RefCounted
## Where sensors are worn: 17 places, their names, and which limb of [Limbs] each moves with.

## How many places there are.
const COUNT: int = 17

## Names of the places as files have them. The order is the one of all arrays "per place".
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

## The limb that a sensor at the place is tied to. Shoulder blades are no limb of their own: they
## go with the chest.
const LIMBS: Array[int] = [0, 2, 3, 2, 4, 5, 6, 2, 7, 8, 9, 10, 11, 12, 13, 14, 15]

## The place one joint nearer to the pelvis, -1 for the pelvis.
const PARENTS: Array[int] = [-1, 0, 1, 1, 3, 4, 5, 1, 7, 8, 9, 0, 11, 12, 0, 14, 15]

## The same place on the other side; a place in the middle is its own mirror.
const MIRRORS: Array[int] = [0, 1, 2, 7, 8, 9, 10, 3, 4, 5, 6, 14, 15, 16, 11, 12, 13]

const PELVIS: int = 0
const STERNUM: int = 1
const HEAD: int = 2


## The number of a place, or -1.
static func find(p_name: StringName) -> int:
	return NAMES.find(p_name)


## A place for people: "left upper arm".
static func title(p_place: int) -> String:
	return String(NAMES[p_place]).replace("_", " ")


## 1 for the left side, -1 for the right one, 0 for the middle.
static func side(p_place: int) -> int:
	if p_place >= 3 and p_place <= 6 or p_place >= 11 and p_place <= 13:
		return 1
	return 0 if p_place < 3 else -1


## Whether a place is on an arm or its shoulder.
static func is_arm(p_place: int) -> bool:
	return p_place >= 3 and p_place <= 10


## Whether a place is on a leg.
static func is_leg(p_place: int) -> bool:
	return p_place >= 11
