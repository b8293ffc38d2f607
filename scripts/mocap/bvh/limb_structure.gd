class_name LimbStructure
extends RefCounted
## Finds arms and legs by the structure of a skeleton alone, for names in any language and for no
## names at all.
##
## A person is a tree with two forks, and at each of them two chains of bones that are equally long:
## legs at the fork nearer to the root, arms at the other. A chain's upper and
## lower limb are bones that stay straight while the joint between them bends, as long as a person's
## are by each other. Sides are those that names say, or else those that make toes point forward and
## knees bend backwards ([LegFacing]).

## How long a lower arm is by its upper arm, and a shank by its thigh (de Leva 1996, males: 268.9 by
## 281.7 mm, 434.0 by 422.2 mm).
const FOREARM_BY_UPPER_ARM: float = 0.955
const SHANK_BY_THIGH: float = 1.028
## Most by which the bones of a pair of chains differ in length, bone by bone, as a share of all.
const PAIR: float = 0.15
## Least length of a chain, as a share of the longest one; shorter ones are fingers, skirts, ears.
const LONG: float = 0.4
## Most bend of a limb made of several bones (twist helpers) over nine tenths of the poses, deg.
const STRAIGHT_DEG: float = 20.0
## What a bone more in a limb costs, as a share of the chain: a stiff hand is no part of the
## forearm.
const _BONE: float = 0.2
## What a limb costs that reaches to the end of the chain, where a hand or foot should be.
const _END_SITE: float = 0.5
## What it costs a limb to point sideways all the time, as collar bones do.
const _SIDEWAYS: float = 0.4
## Maximum of bones of a chain that are tried.
const MAX_BONES: int = 12

## The joints of the left and the right upper leg, lower leg and foot, then of the left and the
## right upper arm, lower arm and hand. Empty if there is no person.
var chains: Array[PackedInt32Array] = []

var _parents: PackedInt32Array = PackedInt32Array()
var _is_end: Array[bool] = []
var _poses: Array[PackedVector3Array] = []
var _known: JointNames = null
# Length of the bone that ends at each joint.
var _lengths: PackedFloat32Array = PackedFloat32Array()
# Length of the longest chain from each joint's parent to a leaf, and the next joint in it.
var _reach: PackedFloat32Array = PackedFloat32Array()
var _next: PackedInt32Array = PackedInt32Array()


## Looks for arms and legs in a skeleton whose joints come after their parents; [param p_names] says
## what their names tell.
func _init(p_clip: BvhClip, p_names: JointNames) -> void:
	for joint: BvhJoint in p_clip.joints:
		_parents.append(joint.parent)
		_is_end.append(joint.is_end_site)
	_poses = BvhPoses.spread(p_clip)
	_known = p_names
	_measure()
	var pairs: Array[Vector2i] = _find_forks()
	if pairs.size() != 2:
		return
	var legs: Array[PackedInt32Array] = []
	var arms: Array[PackedInt32Array] = []
	for first: int in [pairs[0].x, pairs[0].y]:
		legs.append(_limb(first, pairs[0], SHANK_BY_THIGH))
	for first: int in [pairs[1].x, pairs[1].y]:
		arms.append(_limb(first, pairs[1], FOREARM_BY_UPPER_ARM))
	for limb: PackedInt32Array in legs + arms:
		if limb.is_empty():
			return
	if _is_first_right(legs, _toes_say_right(legs)):
		legs.reverse()
	if _is_first_right(arms, _legs_say_right(arms, legs)):
		arms.reverse()
	chains = legs + arms


func _measure() -> void:
	_lengths.resize(_parents.size())
	_reach.resize(_parents.size())
	_next.resize(_parents.size())
	_next.fill(-1)
	for joint: int in range(_parents.size() - 1, 0, -1):
		var parent: int = _parents[joint]
		var lengths: PackedFloat32Array = []
		for pose: PackedVector3Array in _poses:
			lengths.append(pose[joint].distance_to(pose[parent]))
		lengths.sort()
		_lengths[joint] = lengths[lengths.size() / 2]
		_reach[joint] += _lengths[joint]
		if _reach[joint] > _reach[parent]:
			_reach[parent] = _reach[joint]
			_next[parent] = joint


## The first joints of the two legs and those of the two arms; fewer or more pairs are no person's.
func _find_forks() -> Array[Vector2i]:
	var found: Array[Vector2i] = []
	for second: int in range(1, _parents.size()):
		for first: int in range(1, second):
			if _parents[first] == _parents[second] and _is_pair(first, second):
				found.append(Vector2i(first, second))
	var longest: float = 0.0
	for pair: Vector2i in found:
		longest = maxf(longest, _reach[pair.x])
	found.assign(
		found.filter(func(p_pair: Vector2i) -> bool: return _reach[p_pair.x] > LONG * longest)
	)
	if found.size() != 2:
		return found
	if _depth(found[0].x) > _depth(found[1].x):
		found.reverse()
	# One pair does not hang on the other, nor both on one joint.
	for pairs: Array in [[found[0], found[1]], [found[1], found[0]]]:
		var joint: int = _parents[pairs[0].x]
		if joint == _parents[pairs[1].x]:
			found.clear()
		while joint >= 0:
			if joint in [pairs[1].x, pairs[1].y]:
				found.clear()
			joint = _parents[joint]
	return found


func _depth(p_joint: int) -> int:
	return 0 if p_joint < 0 else 1 + _depth(_parents[p_joint])


func _is_pair(p_first: int, p_second: int) -> bool:
	var first: int = p_first
	var second: int = p_second
	var apart: float = 0.0
	while first >= 0 or second >= 0:
		apart += absf(_joint_length(first) - _joint_length(second))
		first = _next[first] if first >= 0 else -1
		second = _next[second] if second >= 0 else -1
	return apart < PAIR * maxf(_reach[p_first], _reach[p_second])


## Length of the bone that ends at a joint; 0 for none and for an end site, which programs put
## anywhere.
func _joint_length(p_joint: int) -> float:
	return 0.0 if p_joint < 0 or _is_end[p_joint] else _lengths[p_joint]


## Upper and lower limb and its end in a chain: of all that stay straight those that are long, a
## person's by each other, and whose upper one hangs.
func _limb(p_first: int, p_pair: Vector2i, p_ratio: float) -> PackedInt32Array:
	var bones: PackedInt32Array = [p_first]
	while _next[bones[-1]] >= 0 and bones.size() < MAX_BONES:
		bones.append(_next[bones[-1]])
	var best: float = -INF
	var found: PackedInt32Array = []
	for middle: int in range(1, bones.size() - 1):
		for upper: int in range(middle - 1, -1, -1):
			if not _is_straight(bones, upper, middle):
				break
			var above: float = _between(bones, upper, middle)
			var sideways: float = _SIDEWAYS * _sideways(bones[upper], bones[middle], p_pair)
			for end: int in range(middle + 1, bones.size()):
				if not _is_straight(bones, middle, end):
					break
				var below: float = _between(bones, middle, end)
				if minf(above, below) <= 0.0:
					continue
				var score: float = (above + below) / _reach[p_first] - sideways
				score -= absf(log(below / above / p_ratio))
				score -= _BONE * (end - upper - 2)
				score -= _END_SITE if _is_end[bones[end]] else 0.0
				if score > best:
					best = score
					found = [bones[upper], bones[middle], bones[end]]
	return found


## How much a limb points along the line between the chains of a pair, 0 to 1 (median).
func _sideways(p_from: int, p_to: int, p_pair: Vector2i) -> float:
	var first: int = p_pair.x
	var second: int = p_pair.y
	while _poses[0][first].distance_to(_poses[0][second]) <= 0.0 and _next[first] >= 0:
		first = _next[first]
		second = maxi(_next[second], second)
	var shares: PackedFloat32Array = []
	for pose: PackedVector3Array in _poses:
		var across: Vector3 = (pose[first] - pose[second]).normalized()
		shares.append(absf(across.dot((pose[p_to] - pose[p_from]).normalized())))
	shares.sort()
	return shares[shares.size() / 2]


func _between(p_bones: PackedInt32Array, p_from: int, p_to: int) -> float:
	var length: float = 0.0
	for bone: int in range(p_from + 1, p_to + 1):
		length += _lengths[p_bones[bone]]
	return length


## Whether the bones from one joint of a chain to another are one limb: none of them bends.
func _is_straight(p_bones: PackedInt32Array, p_from: int, p_to: int) -> bool:
	for bone: int in range(p_from + 1, p_to):
		var bends: PackedFloat32Array = []
		for pose: PackedVector3Array in _poses:
			var above: Vector3 = pose[p_bones[bone]] - pose[p_bones[bone - 1]]
			var below: Vector3 = pose[p_bones[bone + 1]] - pose[p_bones[bone]]
			bends.append(above.angle_to(below) if above.length() * below.length() > 0.0 else 0.0)
		bends.sort()
		if bends[bends.size() * 9 / 10] > deg_to_rad(STRAIGHT_DEG):
			return false
	return true


## Whether the first limb of a pair is the right one, by the names of its joints, or else as said.
func _is_first_right(p_pair: Array[PackedInt32Array], p_or_else: bool) -> bool:
	for part: int in 3:
		var first: JointNames.BodySide = _known.side(p_pair[0][part])
		var second: JointNames.BodySide = _known.side(p_pair[1][part])
		if first != second and JointNames.BodySide.MIDDLE not in [first, second]:
			return first == JointNames.BodySide.RIGHT
	return p_or_else


func _toes_say_right(p_legs: Array[PackedInt32Array]) -> bool:
	var with_toes: Array[PackedInt32Array] = []
	for limb: PackedInt32Array in p_legs:
		with_toes.append(limb + PackedInt32Array([_tip(limb[2])]))
	return LegFacing.evidence(_poses, with_toes[0], with_toes[1]) < 0.0


## The last joint of the chain below a joint, or an end site where there is no other; -1 if the
## chain ends at the joint.
func _tip(p_joint: int) -> int:
	var tip: int = -1
	var joint: int = _next[p_joint]
	while joint >= 0:
		if _lengths[joint] > 0.0 and (tip < 0 or not _is_end[joint]):
			tip = joint
		joint = _next[joint]
	return tip


func _legs_say_right(p_arms: Array[PackedInt32Array], p_legs: Array[PackedInt32Array]) -> bool:
	var same: float = 0.0
	for pose: PackedVector3Array in _poses:
		var hips: Vector3 = pose[p_legs[0][0]] - pose[p_legs[1][0]]
		same += hips.dot(pose[p_arms[0][0]] - pose[p_arms[1][0]])
	return same < 0.0
