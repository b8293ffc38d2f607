class_name SittingLegs
extends RefCounted
## Whether somebody sits on a real chair, by the legs: they are ahead of the hips, where nobody
## could stand on them.

## How far both feet are ahead of the hips, as a part of the leg's length: from the first on
## somebody sits, below the second no longer. Who squats has the feet below the hips.
const SITS: float = 0.36
const STANDS: float = 0.25
## Time for which it has to be so, s.
const PATIENCE_S: float = 0.3
## Of the leg's length, the part above the knee.
const _THIGH: float = 0.53
## Greatest share of upright that a thigh of somebody has who sits, and the least of a shank and of
## the hips.
const _THIGH_DOWN: float = 0.65
const _SHANK_DOWN: float = 0.4
const _HIPS_UP: float = 0.5
const _LEGS: Array[Array] = [
	[Limbs.LEFT_UPPER_LEG, Limbs.LEFT_LOWER_LEG], [Limbs.RIGHT_UPPER_LEG, Limbs.RIGHT_LOWER_LEG]
]

var _sits: bool = false
var _other_s: float = 0.0


## Looks at a pose some time after the last one, s. Returns whether the person sits.
func advance(p_pose: PoseSample, p_passed_s: float) -> bool:
	var seems: bool = ahead_of(p_pose) > (STANDS if _sits else SITS)
	_other_s = _other_s + p_passed_s if seems != _sits else 0.0
	if _other_s > PATIENCE_S:
		_sits = seems
		_other_s = 0.0
	return _sits


## How far the feet are ahead of the hips, as a part of the leg's length: the less of both; 0 where
## the legs are not those of somebody who sits.
static func ahead_of(p_pose: PoseSample) -> float:
	var hips: Quaternion = p_pose.orientation(Limbs.HIPS)
	if (hips * Vector3.UP).y < _HIPS_UP:
		return 0.0
	var ahead: Vector3 = hips * Vector3.BACK
	ahead.y = 0.0
	ahead = ahead.normalized()
	var least: float = 1.0
	for leg: Array in _LEGS:
		var thigh: Vector3 = p_pose.orientation(leg[0]) * Vector3.DOWN
		var shank: Vector3 = p_pose.orientation(leg[1]) * Vector3.DOWN
		if -thigh.y > _THIGH_DOWN or -shank.y < _SHANK_DOWN:
			return 0.0
		var foot: Vector3 = thigh * _THIGH + shank * (1.0 - _THIGH)
		least = minf(least, foot.dot(ahead))
	return least
