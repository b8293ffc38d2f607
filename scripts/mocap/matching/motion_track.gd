class_name MotionTrack
extends RefCounted
## An uninterrupted stretch of somebody's motion, 60 frames a second, and what is done in each
## frame: how fast, whither and how the body is held.
##
## A frame's label needs what comes half a second later: the newest frames have none yet.

## Frames a second.
const RATE: float = 60.0
## Frames before and after one from which its speed is found.
const REACH: int = 15
## Frames before and after one from which its turn is found: about a stride, in which the chest
## turns to and fro.
const TURN_REACH: int = 30
## Speed below which somebody stands, heights of the hips a second, and turn, rad/s.
const STILL_SPEED: float = 0.2
const STILL_TURN: float = 0.4
## Speed above which somebody goes, heights of the hips a second.
const GOING_SPEED: float = 0.3
## Turns of who goes in a curve, rad/s; who turns faster turns round.
const CURVE_TURN: Vector2 = Vector2(0.35, 1.75)
## Hips that are lower are a crouched person's, then those of one who lies, heights of the hips.
const CROUCHED: float = 0.84
const LYING: float = 0.35

## Name of its file.
var name: String = ""
## The phase in which it was recorded.
var phase: GuidedPhase = null
## Height of the hips of who stands, m.
var hip_height: float = 0.95
## Places of the hips, m, and 64 numbers of rotations for each frame.
var hips: PackedVector3Array = PackedVector3Array()
var orientations: PackedFloat32Array = PackedFloat32Array()
## Of each frame that has a label: speed (heights of the hips a second), the angle from where the
## chest faces to where it goes (rad, positive to the left), turn rate (rad/s, positive to the left)
## and stance.
var speeds: PackedFloat32Array = PackedFloat32Array()
var directions: PackedFloat32Array = PackedFloat32Array()
var turns: PackedFloat32Array = PackedFloat32Array()
var stances: PackedByteArray = PackedByteArray()

# Headings of the chest, rad, without jumps.
var _headings: PackedFloat64Array = PackedFloat64Array()


## Adds a frame.
func add(p_pose: PoseSample) -> void:
	hips.append(p_pose.root)
	orientations.append_array(p_pose.orientations)
	var heading: float = Rotations.facing_of(p_pose.orientation(Limbs.CHEST))
	if not _headings.is_empty():
		heading = _headings[-1] + angle_difference(_headings[-1], heading)
	_headings.append(heading)
	if hips.size() > TURN_REACH:
		_label(hips.size() - 1 - TURN_REACH)


## How many frames there are.
func count() -> int:
	return hips.size()


## How many frames have a label.
func labelled() -> int:
	return speeds.size()


## Whether the wearer stands still in a frame.
func is_still(p_frame: int) -> bool:
	return speeds[p_frame] < STILL_SPEED and absf(turns[p_frame]) < STILL_TURN


## Whether the wearer goes somewhere in a frame, and does not turn round.
func goes(p_frame: int) -> bool:
	return speeds[p_frame] > GOING_SPEED and absf(turns[p_frame]) < CURVE_TURN.y


## Whether the wearer turns on the spot in a frame.
func turns_on_spot(p_frame: int) -> bool:
	return speeds[p_frame] < GOING_SPEED + 0.15 and absf(turns[p_frame]) >= STILL_TURN


## Which of eight directions the wearer goes in: 0 ahead, 2 left, 4 back, 6 right.
func sector(p_frame: int) -> int:
	return posmod(roundi(directions[p_frame] / (PI / 4.0)), 8)


## How much of what a phase wants there is, in its unit; [param p_any_speed]: however fast.
func amount(p_phase: GuidedPhase, p_any_speed: bool = false) -> float:
	if p_phase.want == GuidedPhase.Want.STARTS:
		return _count_starts(p_phase.stance)
	var sum: float = 0.0
	for frame: int in labelled():
		if stances[frame] != p_phase.stance:
			continue
		var is_in: bool = speeds[frame] >= p_phase.slowest and speeds[frame] <= p_phase.fastest
		if is_in or p_any_speed:
			sum += _of_frame(p_phase.want, frame)
	return sum


## What a frame adds.
func _of_frame(p_want: GuidedPhase.Want, p_frame: int) -> float:
	var turn: float = turns[p_frame]
	match p_want:
		GuidedPhase.Want.STILL:
			return 1.0 / RATE if is_still(p_frame) else 0.0
		GuidedPhase.Want.TURN_LEFT:
			return rad_to_deg(maxf(turn, 0.0)) / RATE if turns_on_spot(p_frame) else 0.0
		GuidedPhase.Want.TURN_RIGHT:
			return rad_to_deg(maxf(-turn, 0.0)) / RATE if turns_on_spot(p_frame) else 0.0
	if not goes(p_frame):
		return 0.0
	var whither: int = sector(p_frame)
	var wanted: bool = false
	match p_want:
		GuidedPhase.Want.AHEAD:
			wanted = whither == 0 and absf(turn) < CURVE_TURN.x
		GuidedPhase.Want.BACK:
			wanted = whither == 4
		GuidedPhase.Want.LEFT:
			wanted = whither == 2
		GuidedPhase.Want.RIGHT:
			wanted = whither == 6
		GuidedPhase.Want.CURVE_LEFT:
			wanted = whither in [7, 0, 1] and turn >= CURVE_TURN.x
		GuidedPhase.Want.CURVE_RIGHT:
			wanted = whither in [7, 0, 1] and turn <= -CURVE_TURN.x
	return 1.0 / RATE if wanted else 0.0


## Changes between standing still and going.
func _count_starts(p_stance: int) -> float:
	var count: int = 0
	var goes_now: int = -1
	for frame: int in labelled():
		if stances[frame] != p_stance:
			continue
		var now: int = 1 if goes(frame) else 0 if is_still(frame) else goes_now
		count += 1 if goes_now >= 0 and now != goes_now else 0
		goes_now = now
	return count


func _label(p_frame: int) -> void:
	var first: int = maxi(p_frame - REACH, 0)
	var last: int = p_frame + REACH
	var frames: float = last - first + 1
	var way: Vector3 = hips[last] - hips[first]
	# Of a whole step: hips of who runs go up and down, and the chest turns to and fro.
	var height: float = 0.0
	var heading: float = 0.0
	for frame: int in range(first, last + 1):
		height += hips[frame].y / frames
		heading += _headings[frame] / frames
	speeds.append(Vector2(way.x, way.z).length() * RATE / (last - first) / hip_height)
	directions.append(angle_difference(heading, atan2(way.x, way.z)))
	first = maxi(p_frame - TURN_REACH, 0)
	last = p_frame + TURN_REACH
	turns.append((_headings[last] - _headings[first]) * RATE / (last - first))
	var stance: int = MotionMatcher.STAND
	if height < CROUCHED * hip_height:
		stance = MotionMatcher.PRONE if height < LYING * hip_height else MotionMatcher.CROUCH
	stances.append(stance)
