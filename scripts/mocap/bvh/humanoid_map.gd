class_name HumanoidMap
extends RefCounted
## Finds the limbs of [Limbs] among the joints of somebody's skeleton, by names and by structure.
##
## Legs and arms are found by the names of their joints, or where those do not tell, by structure
## ([LimbStructure]); the trunk is the chain of joints
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

## Maximum of joints of a side that are considered for a part. People's skeletons have at most ten;
## all pairs of them are tried.
const _MAX_CANDIDATES: int = 32

## Why the skeleton is no person, or an empty text.
var error: String = ""
## For each limb the joint whose orientation it has.
var joints: PackedInt32Array = PackedInt32Array()
## For each limb the joint at which it begins.
var bases: PackedInt32Array = PackedInt32Array()
## For each limb the joint or end site at which it ends, or -1.
var tails: PackedInt32Array = PackedInt32Array()

var _names: PackedStringArray = PackedStringArray()
var _known: JointNames = null
var _parents: PackedInt32Array = PackedInt32Array()
var _offsets: PackedVector3Array = PackedVector3Array()
var _is_end: Array[bool] = []


## The map of a clip's skeleton.
static func from_clip(p_clip: BvhClip) -> HumanoidMap:
	var map: HumanoidMap = HumanoidMap.new()
	for joint: BvhJoint in p_clip.joints:
		map._names.append("" if joint.is_end_site else joint.name)
		map._parents.append(joint.parent)
		map._offsets.append(joint.offset)
		map._is_end.append(joint.is_end_site)
	map._known = JointNames.new(map._names)
	map._find_all(p_clip)
	if map.error != "":
		map.error = "%s: %s" % [p_clip.source_name, map.error]
	return map


## All joints and end sites below a joint.
func joints_below(p_joint: int) -> PackedInt32Array:
	var found: PackedInt32Array = []
	for joint: int in range(p_joint + 1, _parents.size()):
		if _parents[joint] == p_joint or _parents[joint] in found:
			found.append(joint)
	return found


## Hip joint, knee, ankle and a point in front of the ankle, or -1, of the leg with that upper leg.
func leg(p_upper_leg: int) -> PackedInt32Array:
	var ankle: int = bases[p_upper_leg + 2]
	var toes: int = tails[p_upper_leg + 2]
	return [bases[p_upper_leg], bases[p_upper_leg + 1], ankle, -1 if toes == ankle else toes]


func _find_all(p_clip: BvhClip) -> void:
	joints.resize(Limbs.COUNT)
	joints.fill(-1)
	for side: String in ["Left", "Right"]:
		_find_chain(side, [&"UpperLeg", &"LowerLeg", &"Foot"], LimbStructure.SHANK_BY_THIGH)
		_find_chain(side, [&"UpperArm", &"LowerArm", &"Hand"], LimbStructure.FOREARM_BY_UPPER_ARM)
	var missing: PackedStringArray = _find_missing()
	if not missing.is_empty():
		_find_by_structure(p_clip)
		missing = _find_missing()
	if not missing.is_empty():
		var named: PackedStringArray = []
		for joint: int in _names.size():
			if not _is_end[joint]:
				named.append(_names[joint])
		var seen: String = ", ".join(named).left(300)
		error = "no joint is recognised as %s among: %s" % [", ".join(missing), seen]
		return
	error = _find_tangle()
	if error != "":
		return
	bases = joints.duplicate()
	_find_trunk()
	_fill_missing()
	_find_tails()


func _find_missing() -> PackedStringArray:
	var missing: PackedStringArray = []
	for bone: StringName in NEEDED:
		if joints[Limbs.find(bone)] < 0:
			missing.append(bone)
	return missing


## Takes arms and legs from the structure, if it is a person's.
func _find_by_structure(p_clip: BvhClip) -> void:
	var structure: LimbStructure = LimbStructure.new(p_clip, _known)
	var uppers: PackedInt32Array = [
		Limbs.LEFT_UPPER_LEG, Limbs.RIGHT_UPPER_LEG, Limbs.LEFT_UPPER_ARM, Limbs.RIGHT_UPPER_ARM
	]
	for chain: int in structure.chains.size():
		for part: int in 3:
			var joint: int = structure.chains[chain][part]
			joints[uppers[chain] + part] = -1 if _is_end[joint] else joint


## Finds an arm or a leg: of all pairs of joints, one below the other, that with the best names (a
## helper of no length, or to which no hand or foot is attached, comes last); then its hand or foot,
## which where there are several candidates (wrist and hand) is the one that makes the limb above
## nearest to a person's, by its length over that of the limb above it.
func _find_chain(p_side: String, p_parts: Array[StringName], p_ratio: float) -> void:
	var best: int = 10000
	var upper: int = -1
	var lower: int = -1
	var ends: PackedInt32Array = _named(p_side, p_parts[2])
	for second: int in _named(p_side, p_parts[1]):
		var helper: int = 0 if _carries(second, ends) else 100
		for first: int in _named(p_side, p_parts[0]):
			var rank: int = (
				_known.rank(first, p_parts[0]) + _known.rank(second, p_parts[1]) + helper
			)
			if not _is_below(second, first):
				continue
			rank += 100 if _distance(second, first) <= 0.0 else 0
			# Of names that are equally good that of a helper at the joint above comes last:
			# "LHipJoint" at the hips, before "LeftHip".
			rank = 2 * rank + (1 if _offsets[first].length() <= 0.0 else 0)
			if rank < best:
				best = rank
				upper = first
				lower = second
	if upper < 0:
		# Which of the two is missing is for the message.
		var alone: PackedInt32Array = _named(p_side, p_parts[0])
		joints[Limbs.find(StringName(p_side + p_parts[0]))] = -1 if alone.is_empty() else alone[0]
		return
	joints[Limbs.find(StringName(p_side + p_parts[0]))] = upper
	joints[Limbs.find(StringName(p_side + p_parts[1]))] = lower
	var above: float = _distance(lower, upper)
	var end: int = -1
	var misfit: float = INF
	for joint: int in ends:
		if _is_below(joint, lower):
			var length: float = _distance(joint, lower)
			# Unknown lengths leave the first.
			var fit: float = absf(log(length / above / p_ratio)) if length * above > 0.0 else 99.0
			if fit < misfit:
				misfit = fit
				end = joint
	joints[Limbs.find(StringName(p_side + p_parts[2]))] = end


## Whether one of some joints is below a joint.
func _carries(p_joint: int, p_ends: PackedInt32Array) -> bool:
	for end: int in p_ends:
		if _is_below(end, p_joint):
			return true
	return false


## The first joints of a side whose names fit a part.
func _named(p_side: String, p_part: StringName) -> PackedInt32Array:
	var side: JointNames.BodySide = (
		JointNames.BodySide.LEFT if p_side == "Left" else JointNames.BodySide.RIGHT
	)
	var found: PackedInt32Array = []
	for joint: int in _names.size():
		if not _is_end[joint] and _known.side(joint) == side and _known.rank(joint, p_part) >= 0:
			found.append(joint)
		if found.size() >= _MAX_CANDIDATES:
			break
	return found


## Why arms and legs that were found by name cannot be those of one person, or an empty text.
func _find_tangle() -> String:
	var tops: PackedInt32Array = []
	for bone: StringName in [&"LeftUpperArm", &"RightUpperArm", &"LeftUpperLeg", &"RightUpperLeg"]:
		tops.append(joints[Limbs.find(bone)])
	for first: int in tops:
		for second: int in tops:
			if first != second and _is_below(second, first):
				var pair: Array = [_names[second], _names[first]]
				return "this is no person: limb '%s' hangs on limb '%s'" % pair
	var legs: int = _common_ancestor(tops[2], tops[3])
	var arms: int = _common_ancestor(tops[0], tops[1])
	for leg: int in [tops[2], tops[3]]:
		if _is_below(leg, arms) and _is_below(arms, legs):
			return "this is no person: legs and arms share the joint '%s'" % _names[arms]
	return ""


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
	var neck: PackedInt32Array = _find_head(branch)
	if neck.is_empty():
		neck = [branch]
	joints[3] = neck[neck.size() - 1]
	bases[3] = neck[0]


## The joints from the first of the neck to the head: by the head's name, or else the neck's, or
## else whatever hangs beside the arms.
func _find_head(p_branch: int) -> PackedInt32Array:
	for part: StringName in [&"Head", &"Neck"]:
		for joint: int in _names.size():
			var fits: bool = not _is_end[joint] and _known.side(joint) == JointNames.BodySide.MIDDLE
			if fits and _known.rank(joint, part) >= 0 and not joint in joints:
				var above: int = _common_ancestor(joint, p_branch)
				if above != joint:
					return _chain(joint, above)
	for joint: int in _names.size():
		if _parents[joint] == p_branch and not _is_end[joint] and not _has_limb(joint):
			return _chain(_end_of_chain(joint), p_branch)
	return PackedInt32Array()


## The last of the joints that follow a joint, each alone.
func _end_of_chain(p_joint: int) -> int:
	var children: PackedInt32Array = []
	for joint: int in _names.size():
		if _parents[joint] == p_joint and not _is_end[joint]:
			children.append(joint)
	return _end_of_chain(children[0]) if children.size() == 1 else p_joint


## Whether a joint is an arm or a leg, or carries one.
func _has_limb(p_joint: int) -> bool:
	for limb: int in Limbs.ARMS + Limbs.LEGS:
		if joints[limb] == p_joint or _is_below(joints[limb], p_joint):
			return true
	return false


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


## Length of the bones between a joint and one above it, file units.
func _distance(p_joint: int, p_above: int) -> float:
	var length: float = 0.0
	for joint: int in _chain(p_joint, p_above):
		length += _offsets[joint].length()
	return length


## The joints from below an ancestor down to a joint.
func _chain(p_joint: int, p_ancestor: int) -> PackedInt32Array:
	var found: PackedInt32Array = []
	var joint: int = p_joint
	while joint > p_ancestor:
		found.insert(0, joint)
		joint = _parents[joint]
	return found
