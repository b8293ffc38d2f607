class_name BvhRig
extends RefCounted
## A clip as the motion of a person: which joint is which limb, and how it stands in the reset pose.
##
## The rest pose of a file (all rotations zero) may be a T-pose or not. Where it is not, the limbs
## that the reset pose prescribes are turned into it; what is left is the calibration of thesis
## section 6.1, exact because a file needs nobody to stand still. Frames: Godot's, metres; the
## person
## faces +Z in the reset pose, so files that face elsewhere are turned about the vertical.

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


## The rig of a clip.
static func from_clip(p_clip: BvhClip) -> BvhRig:
	var rig: BvhRig = BvhRig.new()
	rig.clip = p_clip
	rig.map = HumanoidMap.from_clip(p_clip)
	rig.error = rig.map.error
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


## Height of the lowest point of the rest pose, m, in the frame of [method rest_base].
func rest_floor() -> float:
	var lowest: float = INF
	for place: Vector3 in _rest:
		lowest = minf(lowest, place.y)
	return lowest


func _measure() -> void:
	_rest = clip.rest_positions()
	var left: Vector3 = _rest[map.bases[Limbs.find(&"LeftUpperLeg")]]
	var across: Vector3 = left - _rest[map.bases[Limbs.find(&"RightUpperLeg")]]
	across.y = 0.0
	if across.length() > 0.01:
		_heading = Quaternion(Vector3.UP, -atan2(-across.z, across.x))
	hip_height = clampf(_rest[map.joints[0]].y - rest_floor(), 0.3, 1.8)
	_calibration.clear()
	for limb: int in Limbs.COUNT:
		var turn: Quaternion = Limbs.rest_to_reset(limb, rest_tail(limb) - rest_base(limb))
		_calibration.append((turn * _heading).inverse())


func _orientation(p_joint: int, p_time_s: float) -> Quaternion:
	var at: float = clampf(p_time_s / clip.frame_time, 0.0, maxf(clip.frame_count - 1, 0.0))
	var first: int = int(at)
	var second: int = mini(first + 1, clip.frame_count - 1)
	var from: Quaternion = clip.global_orientation(first, p_joint)
	return from.slerp(clip.global_orientation(second, p_joint), at - first)


func _hips(p_frame: int) -> Vector3:
	if map.joints[0] == 0:
		return clip.root_position(p_frame)
	return clip.sample_global(p_frame).positions[map.joints[0]]
