class_name BvhTrim
extends RefCounted
## Finds the frames at the beginning and the end of a clip that are no motion.
##
## Some programs write one or more frames of the rest pose before the motion, often at another
## place: the person stands still there and is somewhere else, in another pose, in the next frame.
## Played, a body would be flung there. Such frames are still, and what parts them from the motion
## is a jump that nobody can make: hips that from standing still are faster than 4 m/s within a
## frame, or a limb that turns by more than 25 degrees and at once stops. A person who stands in a
## T-pose and then begins to move is left alone.

## Longest time that is looked at, s.
const MAX_S: float = 10.0
## Least length that is left of a clip, s.
const MIN_REST_S: float = 0.5
## How far the hips of somebody still may be from where they were, m, and a limb's turn, rad.
const _STILL_M: float = 0.02
const _STILL_RAD: float = 0.07
## Speed of hips, m/s, and their distance in a frame, m, that make a jump.
const _JUMP_M_S: float = 4.0
const _JUMP_M: float = 0.08
## Turn of a limb in a frame that makes a jump, rad, if it is this many times that of the frame
## after.
const _JUMP_RAD: float = 0.436
const _JUMP_BY_NEXT: float = 3.0
## Least step of a transition of several frames, as a share of its first, and longest transition, s.
const _TRANSITION: float = 0.5
const _MAX_TRANSITION_S: float = 0.5

var _rig: BvhRig = null
var _backwards: bool = false


## Number of frames to leave out at the beginning.
static func leading(p_rig: BvhRig) -> int:
	return _count(p_rig, false)


## Number of frames to leave out at the end.
static func trailing(p_rig: BvhRig) -> int:
	return _count(p_rig, true)


static func _count(p_rig: BvhRig, p_backwards: bool) -> int:
	var trim: BvhTrim = BvhTrim.new()
	trim._rig = p_rig
	trim._backwards = p_backwards
	var frames: int = p_rig.clip.frame_count
	var frame_time: float = p_rig.clip.frame_time
	var last: int = mini(frames - 1 - int(MIN_REST_S / frame_time), int(MAX_S / frame_time))
	if frames <= 3:
		return 0
	for frame: int in range(1, maxi(last, 1) + 1):
		var step: float = trim._distance(frame - 1, frame)
		var is_jump: bool = step > _JUMP_M and step > _JUMP_M_S * frame_time
		# A single frame may be still or not: the person may be running already.
		if is_jump and (frame > 1 or step > _JUMP_BY_NEXT * trim._distance(1, 2)):
			return trim._after_transition(frame, step)
		if trim._turns_at_once(frame):
			return frame
		if trim._distance(0, frame) > _STILL_M or trim._turn(0, frame) > _STILL_RAD:
			return 0
	return 0


## The first frame after a jump, which may be spread over some frames.
func _after_transition(p_frame: int, p_step: float) -> int:
	var frame: int = p_frame
	var end: int = mini(
		p_frame + int(_MAX_TRANSITION_S / _rig.clip.frame_time), _rig.clip.frame_count - 2
	)
	while frame < end and _distance(frame, frame + 1) > _TRANSITION * p_step:
		frame += 1
	# A person who goes on as fast as that has not jumped.
	return frame if frame < end or end <= p_frame else p_frame


## Whether a limb jumps from the frame before to this one, and hardly moves then.
func _turns_at_once(p_frame: int) -> bool:
	var turn: float = _turn(p_frame - 1, p_frame)
	return turn > _JUMP_RAD and turn > _JUMP_BY_NEXT * _turn(p_frame, p_frame + 1)


## How far the hips are apart in two frames, m.
func _distance(p_first: int, p_second: int) -> float:
	return _rig.hips_position(_time(p_first)).distance_to(_rig.hips_position(_time(p_second)))


## Largest turn of a limb between two frames, rad.
func _turn(p_first: int, p_second: int) -> float:
	var largest: float = 0.0
	for limb: int in Limbs.COUNT:
		var from: Quaternion = _rig.limb_rotation(limb, _time(p_first))
		largest = maxf(largest, from.angle_to(_rig.limb_rotation(limb, _time(p_second))))
	return largest


func _time(p_frame: int) -> float:
	var frame: int = _rig.clip.frame_count - 1 - p_frame if _backwards else p_frame
	return frame * _rig.clip.frame_time
