extends RefCounted
## Poses of somebody who plays a clip, begun at some moment of it: finds that moment.

## Step of the coarse search, s, and how many poses it looks at.
const COARSE_S: float = 0.1
const LOOKS: int = 40

## When each pose was, s.
var times: PackedFloat64Array = PackedFloat64Array()
## The rotations of all limbs, pose by pose.
var poses: Array[Array] = []
## The clip.
var clip: BvhSource = BvhSource.new()
## Limbs that count in the search.
var limbs: PackedInt32Array = PackedInt32Array()


## The moment of the clip, s, at which the first pose agrees best: found coarsely, then exactly.
func best_offset() -> float:
	var best: float = 0.0
	var least: float = INF
	for step: int in ceili(clip.get_period() / COARSE_S):
		var error: float = _mean_error(step * COARSE_S, maxi(poses.size() / LOOKS, 1))
		if error < least:
			least = error
			best = step * COARSE_S
	var span: float = COARSE_S
	while span > 0.00002:
		for candidate: float in [best - span / 2.0, best + span / 2.0]:
			var error: float = _mean_error(candidate, maxi(poses.size() / (LOOKS * 4), 1))
			if error < least:
				least = error
				best = candidate
		span /= 2.0
	return best


## How far each limb of a pose is from the clip, deg, with the beginning at a moment of it, s.
func errors(p_at: int, p_offset_s: float) -> PackedFloat64Array:
	var truth: PoseSample = clip.pose_at(times[p_at] - times[0] + p_offset_s)
	var found: PackedFloat64Array = []
	for limb: int in Limbs.COUNT:
		var turn: Quaternion = poses[p_at][limb]
		found.append(Rotations.between_deg(turn.normalized(), truth.orientation(limb)))
	return found


func _mean_error(p_offset_s: float, p_every: int) -> float:
	var sum: float = 0.0
	var count: int = 0
	for at: int in range(0, poses.size(), p_every):
		var off: PackedFloat64Array = errors(at, p_offset_s)
		for limb: int in limbs:
			sum += off[limb]
			count += 1
	return sum / count
