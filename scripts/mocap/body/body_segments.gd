class_name BodySegments
extends RefCounted
## Positions of the limbs of a person of a given size in a pose: forward kinematics from the hips.

## Where each limb begins, m, after [method solve].
var bases: PackedVector3Array = PackedVector3Array()
## Where each limb ends, m.
var tails: PackedVector3Array = PackedVector3Array()

var _rest_bases: PackedVector3Array = PackedVector3Array()
var _rest_tails: PackedVector3Array = PackedVector3Array()


func _init(p_size: BodySize) -> void:
	_rest_bases = p_size.joints()
	_rest_tails = p_size.tails()
	bases = _rest_bases.duplicate()
	tails = _rest_tails.duplicate()


## Takes a pose. Positions that the source knows are used as they are.
func solve(p_pose: PoseSample) -> void:
	var known: bool = p_pose.details != null and p_pose.details.positions.size() == Limbs.COUNT
	for limb: int in Limbs.COUNT:
		var parent: int = Limbs.PARENTS[limb]
		if known:
			bases[limb] = p_pose.details.positions[limb]
		elif parent < 0:
			bases[limb] = p_pose.root
		else:
			var offset: Vector3 = _rest_bases[limb] - _rest_bases[parent]
			bases[limb] = bases[parent] + p_pose.orientation(parent) * offset
		var along: Vector3 = _rest_tails[limb] - _rest_bases[limb]
		tails[limb] = bases[limb] + p_pose.orientation(limb) * along


## Position of a joint that hangs on a limb, m, from its position in the reset pose.
func attached(p_limb: int, p_rest: Vector3, p_pose: PoseSample) -> Vector3:
	return bases[p_limb] + p_pose.orientation(p_limb) * (p_rest - _rest_bases[p_limb])


## Where a limb begins in the reset pose, m.
func rest_base(p_limb: int) -> Vector3:
	return _rest_bases[p_limb]


## Where a joint of the body is in the reset pose, m. Those that are no limb's hang between limbs;
## fingers aren't known here.
func rest_of(p_joint: int) -> Vector3:
	var limb: int = HumanoidAxes.JOINTS.find(p_joint)
	if limb >= 0:
		return _rest_bases[limb]
	var top: Vector3 = _rest_tails[Limbs.CHEST]
	match p_joint:
		XRBodyTracker.JOINT_UPPER_CHEST:
			return _rest_bases[Limbs.CHEST].lerp(top, 0.5)
		XRBodyTracker.JOINT_LEFT_SHOULDER:
			return top.lerp(_rest_bases[Limbs.LEFT_UPPER_ARM], 0.2)
		XRBodyTracker.JOINT_RIGHT_SHOULDER:
			return top.lerp(_rest_bases[Limbs.RIGHT_UPPER_ARM], 0.2)
		XRBodyTracker.JOINT_LEFT_TOES:
			return _rest_tails[Limbs.LEFT_FOOT]
		XRBodyTracker.JOINT_RIGHT_TOES:
			return _rest_tails[Limbs.RIGHT_FOOT]
	return top


## Where a limb ends in the reset pose, m.
func rest_tail(p_limb: int) -> Vector3:
	return _rest_tails[p_limb]
