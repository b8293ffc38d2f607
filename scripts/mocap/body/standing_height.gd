class_name StandingHeight
extends RefCounted
## Height of the hips above the ground, from rotations alone: the lower foot stands on the ground.
## So a squat lowers the hips; a jump is not seen (the server's
## [code]--root=inertial[/code] sees it).

## Indices of the legs' limbs in [Limbs]: thigh, shank, foot.
const _LEGS: Array[Array] = [
	[Limbs.LEFT_UPPER_LEG, Limbs.LEFT_LOWER_LEG, Limbs.LEFT_FOOT],
	[Limbs.RIGHT_UPPER_LEG, Limbs.RIGHT_LOWER_LEG, Limbs.RIGHT_FOOT]
]

## From the hips' middle to each hip joint in the hips' frame, then along each limb in its own: m.
var _hip_joints: PackedVector3Array = PackedVector3Array()
var _thighs: PackedVector3Array = PackedVector3Array()
var _shanks: PackedVector3Array = PackedVector3Array()
## From the ankles to the soles under heel and ball of the foot.
var _heels: PackedVector3Array = PackedVector3Array()
var _balls: PackedVector3Array = PackedVector3Array()


func _init(p_size: BodySize) -> void:
	var joints: PackedVector3Array = p_size.joints()
	var tails: PackedVector3Array = p_size.tails()
	for leg: Array in _LEGS:
		var ankle: Vector3 = joints[leg[2]]
		_hip_joints.append(joints[leg[0]] - joints[Limbs.ROOT])
		_thighs.append(joints[leg[1]] - joints[leg[0]])
		_shanks.append(ankle - joints[leg[1]])
		_heels.append(Vector3(0.0, -ankle.y, 0.0))
		var toes: Vector3 = tails[leg[2]] - ankle
		_balls.append(Vector3(toes.x, -ankle.y, toes.z))


## Height of the hips' middle above the ground in a pose, m.
func of(p_pose: PoseSample) -> float:
	var lowest: float = INF
	for side: int in _LEGS.size():
		var leg: Array = _LEGS[side]
		var foot: Quaternion = p_pose.orientation(leg[2])
		var ankle: Vector3 = p_pose.orientation(Limbs.ROOT) * _hip_joints[side]
		ankle += p_pose.orientation(leg[0]) * _thighs[side]
		ankle += p_pose.orientation(leg[1]) * _shanks[side]
		var sole: float = minf((foot * _heels[side]).y, (foot * _balls[side]).y)
		lowest = minf(lowest, ankle.y + sole)
	return maxf(-lowest, 0.0)
