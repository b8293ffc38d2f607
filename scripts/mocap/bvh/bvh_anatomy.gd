class_name BvhAnatomy
extends RefCounted
## What the body in a clip is like, in the file's own axes and units: how long its limbs are, and in
## each of some frames which way trunk and legs point and how far it reaches along each axis.
##
## Only joints of the body count, so that a static joint far from it, a prop or a camera says
## nothing. Lengths are taken from the motion where there is one, as position channels can replace
## what the file says about the rest pose.

## People's legs are 1.0 (a small child) to 2.8 times as long as the trunk, with files that lack
## vertebrae; those of dogs, elephants and horses 0.6 to 1.0.
const MIN_LEG_BY_TRUNK: float = 0.5
const MAX_LEG_BY_TRUNK: float = 5.0
const FOUR_LEGS_BY_TRUNK: float = 1.15
## People's arms without hands are 0.54 to 0.75 times as long as the legs without feet; the front
## legs of the animals 0.85 and more.
const MAX_ARM_BY_LEG: float = 1.8
const FOUR_LEGS_ARM_BY_LEG: float = 0.8
## Limbs that are as an animal's in both ways are one's, unless the body is upright: cartoons
## with a large head and short legs have such limbs too.
const ANIMAL_BY_TRUNK: float = 0.85
const ANIMAL_ARM_BY_LEG: float = 0.9
## A trunk that makes less than 70 degrees with the legs, most of the time, lies across them; one
## that makes more than 135 degrees with them is upright.
const ACROSS: float = 0.35
const UPRIGHT: float = 0.7

## Length of thigh and shank together, hip joint to ankle, file units.
var leg: float = 0.0
## Length of upper and lower arm together, shoulder to wrist, file units.
var arm: float = 0.0
## From the middle of the hip joints to the middle of the shoulder joints, file units.
var trunk: float = 0.0
## In the rest pose the direction from the hip joints' middle to the shoulders'; zero if unknown.
var rest_trunk: Vector3 = Vector3.ZERO
## In the rest pose the direction from the ankles' middle to the hip joints'; zero if unknown.
var rest_legs: Vector3 = Vector3.ZERO
## As [member rest_trunk], in each frame that was looked at.
var trunks: PackedVector3Array = PackedVector3Array()
## As [member rest_legs], in each frame that was looked at.
var legs: PackedVector3Array = PackedVector3Array()
## Least coordinates of the body in each of these frames, file units.
var lows: PackedVector3Array = PackedVector3Array()
## Greatest coordinates of the body in each of these frames, file units.
var highs: PackedVector3Array = PackedVector3Array()

var _map: HumanoidMap = null
var _body: PackedInt32Array = PackedInt32Array()


## The anatomy of a clip; the map has found all limbs.
func _init(p_clip: BvhClip, p_map: HumanoidMap) -> void:
	_map = p_map
	for table: PackedInt32Array in [p_map.bases, p_map.tails]:
		for joint: int in table:
			if joint >= 0 and not joint in _body:
				_body.append(joint)
	var rest: PackedVector3Array = BvhPoses.rest(p_clip)
	rest_trunk = _trunk(rest).normalized()
	rest_legs = _legs(rest).normalized()
	var poses: Array[PackedVector3Array] = BvhPoses.spread(p_clip)
	_measure(poses)
	if p_clip.frame_count > 0:
		for pose: PackedVector3Array in poses:
			_look(pose)


## Whether the rest pose stands: trunk and legs in one line. Some files stretch all bones along one
## axis, or have a rest pose that is no pose at all.
func rest_stands() -> bool:
	return rest_trunk.dot(rest_legs) > UPRIGHT


## How upright a body is, the same whatever its axes: the cosine between trunk and legs, 1 standing,
## about 0 sitting or on all fours. The median over the frames.
func straightness() -> float:
	var all: PackedFloat32Array = []
	for frame: int in trunks.size():
		all.append(trunks[frame].dot(legs[frame]))
	return _median(all) if not all.is_empty() else rest_trunk.dot(rest_legs)


## Why the body is no person's, or an empty text. A person on all fours has a person's limbs, and an
## animal with a person's names has not.
func find_fault() -> String:
	if leg <= 0.0 or trunk <= 0.0:
		return "this is no person: the legs or the trunk have no length"
	var by_trunk: float = leg / trunk
	var by_leg: float = arm / leg
	var is_animal: bool = by_trunk < ANIMAL_BY_TRUNK and by_leg > ANIMAL_ARM_BY_LEG
	is_animal = is_animal and straightness() < UPRIGHT and not rest_stands()
	if straightness() < ACROSS and not rest_stands():
		is_animal = is_animal or by_trunk < FOUR_LEGS_BY_TRUNK or by_leg > FOUR_LEGS_ARM_BY_LEG
	if is_animal:
		return (
			"this is no person: it goes on four legs (%.2f of the trunk, front by hind %.2f)"
			% [by_trunk, by_leg]
		)
	if by_trunk < MIN_LEG_BY_TRUNK or by_trunk > MAX_LEG_BY_TRUNK:
		return "this is no person: the legs are %.2f times as long as the trunk" % by_trunk
	if by_leg > MAX_ARM_BY_LEG:
		return "this is no person: the arms are %.2f times as long as the legs" % by_leg
	return ""


## Height by the lengths of legs and trunk, file units. Thigh and shank are 0.491, the trunk 0.288
## of the height ([constant BodySize.RATIOS]).
func stature() -> float:
	var ratios: Dictionary[StringName, float] = BodySize.RATIOS
	return (leg + trunk) / (ratios[&"thigh"] + ratios[&"shank"] + ratios[&"trunk"])


func _look(p_positions: PackedVector3Array) -> void:
	trunks.append(_trunk(p_positions).normalized())
	legs.append(_legs(p_positions).normalized())
	var low: Vector3 = p_positions[_body[0]]
	var high: Vector3 = low
	for joint: int in _body:
		low = low.min(p_positions[joint])
		high = high.max(p_positions[joint])
	lows.append(low)
	highs.append(high)


func _measure(p_poses: Array[PackedVector3Array]) -> void:
	var of_legs: PackedFloat32Array = []
	var of_arms: PackedFloat32Array = []
	var of_trunk: PackedFloat32Array = []
	for pose: PackedVector3Array in p_poses:
		of_legs.append(_mean_path(pose, Limbs.LEFT_UPPER_LEG, Limbs.RIGHT_UPPER_LEG))
		of_arms.append(_mean_path(pose, Limbs.LEFT_UPPER_ARM, Limbs.RIGHT_UPPER_ARM))
		of_trunk.append(_trunk(pose).length())
	leg = _median(of_legs)
	arm = _median(of_arms)
	trunk = _median(of_trunk)


func _mean_path(p_positions: PackedVector3Array, p_left: int, p_right: int) -> float:
	return (_path(p_positions, p_left) + _path(p_positions, p_right)) / 2.0


## From where a limb of three begins to where its third begins, along the bones.
func _path(p_positions: PackedVector3Array, p_limb: int) -> float:
	var first: Vector3 = p_positions[_map.bases[p_limb]]
	var second: Vector3 = p_positions[_map.bases[p_limb + 1]]
	return first.distance_to(second) + second.distance_to(p_positions[_map.bases[p_limb + 2]])


func _trunk(p_positions: PackedVector3Array) -> Vector3:
	return (
		_middle(p_positions, Limbs.LEFT_UPPER_ARM, Limbs.RIGHT_UPPER_ARM)
		- _middle(p_positions, Limbs.LEFT_UPPER_LEG, Limbs.RIGHT_UPPER_LEG)
	)


func _legs(p_positions: PackedVector3Array) -> Vector3:
	return (
		_middle(p_positions, Limbs.LEFT_UPPER_LEG, Limbs.RIGHT_UPPER_LEG)
		- _middle(p_positions, Limbs.LEFT_FOOT, Limbs.RIGHT_FOOT)
	)


func _middle(p_positions: PackedVector3Array, p_left: int, p_right: int) -> Vector3:
	return (p_positions[_map.bases[p_left]] + p_positions[_map.bases[p_right]]) / 2.0


static func _median(p_values: PackedFloat32Array) -> float:
	var sorted: PackedFloat32Array = p_values.duplicate()
	sorted.sort()
	return sorted[sorted.size() / 2]
