class_name BvhRig
extends RefCounted
## A clip as the motion of a person: the joint of each limb, and its rotation in the reset pose.
##
## The rest pose of a file (all rotations zero) may be a T-pose or not. Where it is not, the limbs
## that the reset pose prescribes are turned into it; what is left is the calibration of thesis
## section 6.1, exact because a file needs nobody to stand still. A rest pose that does not even
## stand (some files stretch all bones along one axis) is replaced by the frame of the motion in
## which the person stands best. Frames: Godot's, metres; the person faces +Z in the reset pose, so
## files that face elsewhere are turned about the vertical.

## How far ankles are above toes at least, as a share of the leg: less means that toes are missing.
const _ANKLE_ABOVE_TOES: float = 0.02
## Hip joints that are nearer to each other are one, m.
const _MIN_ACROSS: float = 0.01

## Why the clip shows no person, or an empty text.
var error: String = ""
## The motion.
var clip: BvhClip = null
## Which joint is which limb.
var map: HumanoidMap = null
## Height of the hips above the soles in the rest pose, m.
var hip_height: float = 0.95

var _heading: Quaternion = Quaternion.IDENTITY
var _calibration: Array[Quaternion] = []
var _rest: PackedVector3Array = PackedVector3Array()
var _rest_floor: float = 0.0
# Rotations of the joints in that pose; empty where it is the file's, in which they have none.
var _rest_turns: Array[Quaternion] = []


## The rig of a clip.
static func from_clip(p_clip: BvhClip) -> BvhRig:
	var rig: BvhRig = BvhRig.new()
	rig.clip = p_clip
	rig.map = HumanoidMap.from_clip(p_clip)
	rig.error = rig.map.error
	if rig.error == "":
		var fault: String = BvhNoise.find_fault(p_clip, rig.map)
		if fault == "":
			fault = BvhAnatomy.new(p_clip, rig.map).find_fault()
		rig.error = "" if fault == "" else "%s: %s" % [p_clip.source_name, fault]
	if rig.error == "" and p_clip.frame_count == 0:
		rig.error = "%s: the clip has no frames" % p_clip.source_name
	if rig.error == "":
		rig._measure()
	return rig


## Rotation of a limb in the world from the reset pose, at a time of the clip, s.
func limb_rotation(p_limb: int, p_time_s: float) -> Quaternion:
	return _heading * _orientation(map.joints[p_limb], p_time_s) * _calibration[p_limb]


## Where the hips are at a time of the clip, m.
func hips_position(p_time_s: float) -> Vector3:
	var at: float = clampf(p_time_s / clip.frame_time, 0.0, maxf(clip.frame_count - 1, 0.0))
	var first: int = int(at)
	var second: int = mini(first + 1, clip.frame_count - 1)
	return _heading * _hips(first).lerp(_hips(second), at - first)


## Where a limb begins in the rest pose, m, relative to the root of the file.
func rest_base(p_limb: int) -> Vector3:
	return _heading * _rest[map.bases[p_limb]]


## Where a limb ends in the rest pose, m; where it begins if that is not known.
func rest_tail(p_limb: int) -> Vector3:
	var tail: int = map.tails[p_limb]
	return rest_base(p_limb) if tail < 0 else _heading * _rest[tail]


## Height of the soles in the rest pose, m, in the frame of [method rest_base].
func rest_floor() -> float:
	return _rest_floor


## Height of a joint above the soles in the rest pose, m.
func rest_height(p_joint: int) -> float:
	return _rest[p_joint].y - _rest_floor


func _measure() -> void:
	_rest = clip.rest_positions()
	if not _stands(_rest):
		_stand_up()
	var across: Vector3 = _across(_rest)
	if across.length() > _MIN_ACROSS:
		_heading = Quaternion(Vector3.UP, -atan2(-across.z, across.x))
	_rest_floor = _find_rest_floor()
	hip_height = clampf(_rest[map.joints[Limbs.HIPS]].y - _rest_floor, 0.3, 1.8)
	_calibration.clear()
	for limb: int in Limbs.COUNT:
		var turn: Quaternion = Limbs.rest_to_reset(limb, rest_tail(limb) - rest_base(limb))
		var rest: Quaternion = Quaternion.IDENTITY
		if not _rest_turns.is_empty():
			rest = _rest_turns[map.joints[limb]]
		_calibration.append((turn * _heading * rest).inverse())


## The level line from the right to the left hip joint; from the right to the left shoulder where
## the hip joints are one.
func _across(p_positions: PackedVector3Array) -> Vector3:
	for pair: Vector2i in [
		Vector2i(Limbs.LEFT_UPPER_LEG, Limbs.RIGHT_UPPER_LEG),
		Vector2i(Limbs.LEFT_UPPER_ARM, Limbs.RIGHT_UPPER_ARM),
	]:
		var across: Vector3 = p_positions[map.bases[pair.x]] - p_positions[map.bases[pair.y]]
		across.y = 0.0
		if across.length() > _MIN_ACROSS:
			return across
	return Vector3.ZERO


## Of the lowest point of the legs; where that is an ankle, or the rest pose was taken from the
## motion with knees that are never quite straight, a foot's height below the ankles of straight
## legs ([constant BodySize.RATIOS]).
func _find_rest_floor() -> float:
	var lowest: float = INF
	for upper: int in [Limbs.LEFT_UPPER_LEG, Limbs.RIGHT_UPPER_LEG]:
		for joint: int in map.joints_below(map.joints[upper]):
			lowest = minf(lowest, _rest[joint].y)
	var thigh: Vector3 = _rest[map.bases[Limbs.LEFT_UPPER_LEG]]
	var shank: Vector3 = _rest[map.bases[Limbs.LEFT_LOWER_LEG]]
	var ankle: Vector3 = _rest[map.bases[Limbs.LEFT_FOOT]]
	var leg: float = thigh.distance_to(shank) + shank.distance_to(ankle)
	var straight: float = ankle.y if _rest_turns.is_empty() else thigh.y - leg
	if _rest_turns.is_empty() and straight - lowest > _ANKLE_ABOVE_TOES * leg:
		return lowest
	var ratios: Dictionary[StringName, float] = BodySize.RATIOS
	return straight - leg * ratios[&"foot_height"] / (ratios[&"thigh"] + ratios[&"shank"])


## Whether somebody stands in a pose: the trunk up, the legs down.
func _stands(p_positions: PackedVector3Array) -> bool:
	return _uprightness(p_positions) > 0.6


## The least of how far trunk and legs point up and down, -1 to 1.
func _uprightness(p_positions: PackedVector3Array) -> float:
	var worst: float = 1.0
	for limb: int in [Limbs.SPINE, Limbs.CHEST] + Limbs.LEGS:
		if map.tails[limb] >= 0:
			var along: Vector3 = p_positions[map.tails[limb]] - p_positions[map.bases[limb]]
			var up: float = along.normalized().y
			worst = minf(worst, up if limb < 10 else -up)
	return worst


## Takes the frame in which the person stands best for the rest pose, turned to face +Z: upright,
## and both ankles as low as they ever are, as a heel that is raised raises its ankle.
func _stand_up() -> void:
	var best: float = -INF
	var pose: BvhClip.Pose = null
	var frames: Array = range(0, clip.frame_count, maxi(clip.frame_count / 300, 1))
	var lows: PackedFloat32Array = []
	for frame: int in frames:
		lows.append(_ankles(clip.sample_global(frame)).x)
	lows.sort()
	for frame: int in frames:
		var other: BvhClip.Pose = clip.sample_global(frame)
		var raised: Vector2 = _ankles(other) - Vector2.ONE * lows[lows.size() / 10]
		var score: float = _uprightness(other.positions) - 2.0 * (maxf(raised.x, 0.0) + raised.y)
		if score > best:
			best = score
			pose = other
	if pose == null or _uprightness(pose.positions) < 0.5:
		return  # Nobody ever stands: the file's rest pose is as good as any.
	var across: Vector3 = _across(pose.positions)
	var turn: Quaternion = Quaternion(Vector3.UP, -atan2(-across.z, across.x))
	var origin: Vector3 = pose.positions[map.joints[Limbs.HIPS]]
	_rest_turns.clear()
	for joint: int in pose.positions.size():
		_rest[joint] = turn * (pose.positions[joint] - origin)
		_rest_turns.append(turn * pose.orientations[joint])


## Heights of the lower and of the higher ankle, m.
func _ankles(p_pose: BvhClip.Pose) -> Vector2:
	var left: float = p_pose.positions[map.bases[Limbs.LEFT_FOOT]].y
	var right: float = p_pose.positions[map.bases[Limbs.RIGHT_FOOT]].y
	return Vector2(minf(left, right), maxf(left, right))


func _orientation(p_joint: int, p_time_s: float) -> Quaternion:
	var at: float = clampf(p_time_s / clip.frame_time, 0.0, maxf(clip.frame_count - 1, 0.0))
	var first: int = int(at)
	var second: int = mini(first + 1, clip.frame_count - 1)
	var from: Quaternion = clip.global_orientation(first, p_joint)
	return from.slerp(clip.global_orientation(second, p_joint), at - first)


func _hips(p_frame: int) -> Vector3:
	if map.joints[Limbs.HIPS] == 0:
		return clip.root_position(p_frame)
	return clip.sample_global(p_frame).positions[map.joints[Limbs.HIPS]]
