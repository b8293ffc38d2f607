class_name LegFacing
extends RefCounted
## Tells the left leg from the right one by what legs can do: toes point forward and knees bend
## backwards, seen from the line between the hip joints.

## Bend of the knees, as the mean sine of their angle, from which on they count in full.
const FULL_BEND: float = 0.2


## How much toes and knees speak for what is called left being left: 2 all, -2 all against it, 0
## nothing. A leg is hip joint, knee, ankle and a point in front of the ankle, -1 if unknown.
static func evidence(
	p_poses: Array[PackedVector3Array], p_left: PackedInt32Array, p_right: PackedInt32Array
) -> float:
	var toes: float = 0.0
	var bend: float = 0.0
	var bends: float = 0.0
	var shares: float = 2.0 * p_poses.size()
	for pose: PackedVector3Array in p_poses:
		var across: Vector3 = (pose[p_left[0]] - pose[p_right[0]]).normalized()
		for leg: PackedInt32Array in [p_left, p_right]:
			var thigh: Vector3 = (pose[leg[1]] - pose[leg[0]]).normalized()
			var shank: Vector3 = (pose[leg[2]] - pose[leg[1]]).normalized()
			var axis: Vector3 = thigh.cross(shank)
			bend += axis.dot(across)
			bends += axis.length()
			if leg[3] >= 0:
				var forward: Vector3 = across.cross(-shank).normalized()
				toes += (pose[leg[3]] - pose[leg[2]]).normalized().dot(forward) / shares
	if bends <= 0.0:
		return toes
	return toes + bend / bends * minf(bends / shares / FULL_BEND, 1.0)
