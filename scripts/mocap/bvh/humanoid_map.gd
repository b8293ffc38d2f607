class_name HumanoidMap
extends RefCounted
## Finds the limbs of [Limbs] among the joints of somebody's skeleton, by names and by structure.
##
## Legs and arms are found by the names of their joints; the trunk is the chain of joints
## between the hips and the joint where the arms branch off, whatever those are called. What a
## skeleton lacks (hands, a waist) is filled from its neighbour.

## Limbs without which there is no person, by [constant Limbs.BONES].
const NEEDED: Array[StringName] = [
	&"LeftUpperArm",
	&"LeftLowerArm",
	&"RightUpperArm",
	&"RightLowerArm",
	&"LeftUpperLeg",
	&"LeftLowerLeg",
	&"RightUpperLeg",
	&"RightLowerLeg",
]

## Why the skeleton is no person, or an empty text.
var error: String = ""
## For each limb the joint whose orientation it has.
var joints: PackedInt32Array = PackedInt32Array()
## For each limb the joint at which it begins.
var bases: PackedInt32Array = PackedInt32Array()
## For each limb the joint or end site at which it ends, or -1.
var tails: PackedInt32Array = PackedInt32Array()

var _names: PackedStringArray = PackedStringArray()
var _parents: PackedInt32Array = PackedInt32Array()
var _is_end: Array[bool] = []


## The map of a clip's skeleton.
static func from_clip(p_clip: BvhClip) -> HumanoidMap:
	var map: HumanoidMap = HumanoidMap.new()
	for joint: BvhJoint in p_clip.joints:
		map._names.append(joint.name)
		map._parents.append(joint.parent)
		map._is_end.append(joint.is_end_site)
	map._find_all()
	if map.error != "":
		map.error = "%s: %s" % [p_clip.source_name, map.error]
	return map


func _find_all() -> void:
	joints.resize(Limbs.COUNT)
	joints.fill(-1)
	for side: String in ["Left", "Right"]:
		_find_chain(side, [&"UpperLeg", &"LowerLeg", &"Foot"])
		_find_chain(side, [&"UpperArm", &"LowerArm", &"Hand"])
	var missing: PackedStringArray = []
	for bone: StringName in NEEDED:
		if joints[Limbs.find(bone)] < 0:
			missing.append(bone)
	if not missing.is_empty():
		var seen: String = ", ".join(_names).left(300)
		error = "no joint is recognised as %s among: %s" % [", ".join(missing), seen]
		return
	bases = joints.duplicate()
	_find_trunk()
	_fill_missing()
	_find_tails()


func _find_chain(p_side: String, p_parts: Array[StringName]) -> void:
	var above: int = -1
	for part: StringName in p_parts:
		var limb: int = Limbs.find(StringName(p_side + part))
		var found: int = _find_part(p_side, part, above)
		if found < 0:
			return
		joints[limb] = found
		above = found


## The best joint for a part on a side, below another joint (or anywhere if that is -1).
func _find_part(p_side: String, p_part: StringName, p_above: int) -> int:
	var side: JointNames.BodySide = (
		JointNames.BodySide.LEFT if p_side == "Left" else JointNames.BodySide.RIGHT
	)
	var best: int = -1
	var best_rank: int = 1000
	for joint: int in _names.size():
		if _is_end[joint] or JointNames.side(_names[joint]) != side:
			continue
		if p_above >= 0 and not _is_below(joint, p_above):
			continue
		var rank: int = JointNames.rank(_names[joint], p_part)
		if rank >= 0 and rank < best_rank:
			best = joint
			best_rank = rank
	return best


func _find_trunk() -> void:
	var left: int = joints[Limbs.find(&"LeftUpperLeg")]
	var right: int = joints[Limbs.find(&"RightUpperLeg")]
	var hips: int = _common_ancestor(left, right)
	var left_arm: int = joints[Limbs.find(&"LeftUpperArm")]
	var branch: int = _common_ancestor(left_arm, joints[Limbs.find(&"RightUpperArm")])
	joints[0] = hips
	bases[0] = hips
	var spine: PackedInt32Array = _chain(branch, hips)
	if spine.is_empty():
		spine = [branch]
	joints[1] = spine[0]
	bases[1] = spine[0]
	joints[2] = branch
	bases[2] = spine[mini(1, spine.size() - 1)]
	var head: int = -1
	for joint: int in _names.size():
		if not _is_end[joint] and JointNames.core(_names[joint]) == "head":
			if head < 0 and _is_below(joint, branch):
				head = joint
	var neck: PackedInt32Array = _chain(head, branch) if head >= 0 else _find_neck(branch)
	if neck.is_empty():
		neck = [branch]
	joints[3] = neck[neck.size() - 1]
	bases[3] = neck[0]


## The joints of a neck without a joint called head.
func _find_neck(p_branch: int) -> PackedInt32Array:
	for joint: int in _names.size():
		if not _is_end[joint] and JointNames.rank(_names[joint], &"Neck") >= 0:
			return _chain(joint, p_branch)
	return PackedInt32Array()


func _fill_missing() -> void:
	for limb: int in Limbs.COUNT:
		if joints[limb] < 0:
			joints[limb] = joints[Limbs.PARENTS[limb]]
			bases[limb] = -1
			# A hand or foot that is no joint begins where the limb above ends.
			for joint: int in _names.size():
				if _parents[joint] == joints[limb] and bases[limb] < 0:
					bases[limb] = joint
			if bases[limb] < 0:
				bases[limb] = joints[limb]


func _find_tails() -> void:
	tails.resize(Limbs.COUNT)
	tails.fill(-1)
	for limb: int in Limbs.COUNT:
		var child_limb: int = Limbs.PARENTS.find(limb)
		if limb == 2:
			tails[limb] = bases[3]
		elif child_limb >= 0 and limb != 0:
			tails[limb] = bases[child_limb]
		elif limb == 0:
			tails[limb] = bases[1]
		else:
			tails[limb] = _last_below(joints[limb], bases[limb])


## The end of the longest chain below a joint, at most two joints away: a toe or a middle finger,
## not its tip's tip.
func _last_below(p_joint: int, p_base: int) -> int:
	var found: int = p_base if p_base != p_joint else -1
	var level: PackedInt32Array = [p_joint]
	for step: int in 2:
		var next: PackedInt32Array = []
		for joint: int in _names.size():
			if level.has(_parents[joint]):
				next.append(joint)
		if next.is_empty():
			return found
		found = next[next.size() / 2]
		level = next
	return found


func _is_below(p_joint: int, p_above: int) -> bool:
	var joint: int = p_joint
	while joint > p_above:
		joint = _parents[joint]
	return joint == p_above and p_joint != p_above


func _common_ancestor(p_first: int, p_second: int) -> int:
	var first: int = p_first
	var second: int = p_second
	while first != second:
		if first > second:
			first = _parents[first]
		else:
			second = _parents[second]
	return first


## The joints from below an ancestor down to a joint.
func _chain(p_joint: int, p_ancestor: int) -> PackedInt32Array:
	var found: PackedInt32Array = []
	var joint: int = p_joint
	while joint > p_ancestor:
		found.insert(0, joint)
		joint = _parents[joint]
	return found
