class_name ShownFigure
extends RefCounted
## The joints of the body that a wearer is shown as, in the wearer's own size: with them a hand is
## seen where the wearer has it, and not where it would be on another body.

## Eyes are at least so far above the joint of the head, m.
const MIN_EYES_M: float = 0.06

## Where each limb begins in the reset pose, m, by [Limbs]: facing +Z, the soles at 0.
var joints: PackedVector3Array = PackedVector3Array()
## Height of the eyes, m.
var eye_height: float = 0.0


## A wearer's own figure.
static func of_size(p_size: BodySize) -> ShownFigure:
	var figure: ShownFigure = ShownFigure.new()
	figure.joints = p_size.joints()
	figure.eye_height = p_size.height * BodySize.EYE_HEIGHT
	return figure


## A body with a skeleton whose hips are at a height, m, on which somebody is shown whose hips are
## at another. Null if the skeleton is no person's.
static func of_skeleton(
	p_skeleton: PersonSkeleton, p_hips: float, p_own_hips: float
) -> ShownFigure:
	if not p_skeleton.is_sound() or not (p_hips > 0.1 and p_own_hips > 0.1):
		return null
	var figure: ShownFigure = ShownFigure.new()
	var places: PackedVector3Array = PackedVector3Array()
	for limb: int in Limbs.COUNT:
		var joint: Vector3 = Vector3(0.0, p_hips, 0.0)
		if Limbs.PARENTS[limb] >= 0:
			joint = places[Limbs.PARENTS[limb]] + p_skeleton.joints_in_parent[limb]
		places.append(joint - p_skeleton.joints_in_limb[limb])
		figure.joints.append(joint * (p_own_hips / p_hips))
	var height: float = BodySize.of_hip_height(p_own_hips).height
	figure.eye_height = maxf(height * BodySize.EYE_HEIGHT, figure.joints[Limbs.HEAD].y + MIN_EYES_M)
	return figure


## Whether another has the same joints within a step, m.
func is_like(p_other: ShownFigure, p_step: float) -> bool:
	for limb: int in Limbs.COUNT:
		if joints[limb].distance_to(p_other.joints[limb]) > p_step:
			return false
	return true
