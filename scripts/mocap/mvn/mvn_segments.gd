class_name MvnSegments
extends RefCounted
## MVN's 23 body segments and 40 finger segments: which limb, joint and place of a sensor each is.

## How many segments a body has.
const COUNT: int = 23
## How many segments two hands have, and how many props there can be between body and hands.
const FINGERS: int = 40

## The segment nearer to the pelvis, in the order of types 01 and 02; -1 for the pelvis.
const PARENTS: Array[int] = [
	-1, 0, 1, 2, 3, 4, 5, 4, 7, 8, 9, 4, 11, 12, 13, 0, 15, 16, 17, 0, 19, 20, 21
]
## The segment of each limb of [Limbs]: the spine is L3, the chest T8.
const OF_LIMBS: Array[int] = [0, 2, 4, 6, 12, 13, 14, 8, 9, 10, 19, 20, 21, 15, 16, 17]
## Segments that are no limb of their own, and their joints.
const JOINTS: Dictionary[int, int] = {
	5: XRBodyTracker.JOINT_NECK,
	7: XRBodyTracker.JOINT_RIGHT_SHOULDER,
	11: XRBodyTracker.JOINT_LEFT_SHOULDER,
	18: XRBodyTracker.JOINT_RIGHT_TOES,
	22: XRBodyTracker.JOINT_LEFT_TOES,
}
## Segments that can bear a tracker, and the place of [BodyPlaces] that it is.
const SENSOR_PLACES: Dictionary[int, StringName] = {
	0: &"pelvis",
	4: &"sternum",
	6: &"head",
	7: &"right_shoulder",
	8: &"right_upper_arm",
	9: &"right_forearm",
	10: &"right_hand",
	11: &"left_shoulder",
	12: &"left_upper_arm",
	13: &"left_forearm",
	14: &"left_hand",
	15: &"right_thigh",
	16: &"right_shank",
	17: &"right_foot",
	19: &"left_thigh",
	20: &"left_shank",
	21: &"left_foot",
}
## Joints of one hand in the order of its segments, as steps from the first joint of the thumb; the
## carpus, which comes before them, goes with the hand.
const _FINGER_STEPS: Array[int] = [0, 1, 2, 4, 5, 6, 7, 9, 10, 11, 12, 14, 15, 16, 17, 19, 20, 21, 22]


## The joint of a finger segment, counted from the left carpus; -1 for the two carpi.
static func finger_joint(p_finger: int) -> int:
	@warning_ignore("integer_division")
	var of_hand: int = p_finger % (FINGERS / 2) - 1
	if of_hand < 0:
		return -1
	@warning_ignore("integer_division")
	var is_left: bool = p_finger < FINGERS / 2
	var thumb: int = XRBodyTracker.JOINT_LEFT_THUMB_METACARPAL
	if not is_left:
		thumb = XRBodyTracker.JOINT_RIGHT_THUMB_METACARPAL
	return thumb + _FINGER_STEPS[of_hand]
