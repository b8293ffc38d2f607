class_name BvhNoise
extends RefCounted
## Tells noise from motion, in any frame rate.
##
## Motion goes on: from one frame to the next a limb turns much as it did before, so that the
## difference of two such steps is smaller than a step. In noise it is sqrt(2) times as large (a
## random walk) or sqrt(3) times (frames that have nothing to do with each other). Steps of a lively
## dance at 6 frames a second are as unlike each other, but they are slow: its limbs change their
## speed by less than 4000 deg/s in a second. Of smooth noise knees and elbows give notice: a
## person's bend about one axis only.

## Maximum of places in the clip that are looked at, three frames each.
const MAX_PLACES: int = 200
## Fewest frames that are judged.
const MIN_FRAMES: int = 8
## Difference of two steps, as a share of a step, from which on they are unlike each other (medians
## over limbs and places). 177 clips of other people: 0.05 to 0.9, at 10 frames a second up to 1.45;
## noise of ten kinds: 1.29 to 2.5.
const UNLIKE: float = 1.25
## And this change of speed, deg/s^2. The clips at 6 and 10 frames a second have up to 3400, noise
## of 1 degree at 24 frames a second has 4300.
const MIN_CHANGE: float = 4000.0
## And this step, deg, or this speed, deg/s: less is a sensor's or a camera's noise on a motion.
const MIN_STEP: float = 2.5
const MIN_SPEED: float = 250.0
## Median speed of limbs that nobody has, deg/s: the liveliest clip, a sprint, has 403.
const MAX_SPEED: float = 600.0
## A way of hips in one frame that nobody makes, m, and most such leaps in a clip: frames before and
## after a motion may be elsewhere.
const LEAP: float = 10.0
const MAX_LEAPS: int = 2
## Median speed of hips that nobody has, m/s, and the least one at which unlike steps count.
const MAX_HIPS: float = 15.0
const MIN_HIPS: float = 2.0
## How much knees and elbows keep to one axis, 0 to 1, and the least mean sine of their angles at
## which that counts. Smooth noise has 0.02 to 0.3, people 0.66 and more, bodies guessed from video
## by a network 0.3 to 0.6.
const MIN_HINGE: float = 0.4
const MIN_BEND: float = 0.3

var _steps: PackedFloat32Array = PackedFloat32Array()
var _changes: PackedFloat32Array = PackedFloat32Array()
var _hip_steps: PackedFloat32Array = PackedFloat32Array()
var _hip_changes: PackedFloat32Array = PackedFloat32Array()
# For each knee and elbow the sum of its axes in the frame of the limb above.
var _axes: PackedVector3Array = PackedVector3Array()
var _bend: float = 0.0
var _places: int = 0


## Why the clip is noise, or an empty text. Its unit must be known.
static func find_fault(p_clip: BvhClip, p_map: HumanoidMap) -> String:
	if p_clip.frame_count < MIN_FRAMES:
		return ""
	var noise: BvhNoise = BvhNoise.new()
	noise._look(p_clip, p_map)
	var rate: float = 1.0 / p_clip.frame_time
	var step: float = rad_to_deg(_median(noise._steps))
	var change: float = rad_to_deg(_median(noise._changes))
	var is_rough: bool = change > UNLIKE * step and change * rate * rate > MIN_CHANGE
	if is_rough and (step > MIN_STEP or step * rate > MIN_SPEED):
		return "poses jump by %.0f deg a frame: this is not motion" % step
	if noise._bend / (noise._places * Limbs.LEGS.size()) > MIN_BEND and noise._hinge() < MIN_HINGE:
		return "knees and elbows bend every way: this is no person's motion"
	if step * rate > MAX_SPEED:
		return "limbs turn by %.0f deg/s all the time: the frame time is wrong" % (step * rate)
	step = _median(noise._hip_steps) * p_clip.unit_metres
	change = _median(noise._hip_changes) * p_clip.unit_metres
	is_rough = change > UNLIKE * step and step * rate > MIN_HIPS
	if is_rough or step * rate > MAX_HIPS:
		return "the hips jump by %.2f m a frame: this is not motion" % step
	if _count_leaps(p_clip) > MAX_LEAPS:
		return "the hips jump by %.0f m and more: the file is damaged" % LEAP
	return ""


## How often the root leaps.
static func _count_leaps(p_clip: BvhClip) -> int:
	var count: int = 0
	for frame: int in range(1, p_clip.frame_count):
		var way: Vector3 = p_clip.root_position(frame) - p_clip.root_position(frame - 1)
		count += 1 if way.length() > LEAP else 0
	return count


func _look(p_clip: BvhClip, p_map: HumanoidMap) -> void:
	var kinematics: BvhKinematics = BvhKinematics.new(p_clip.joints, p_clip.positions_add_offset)
	_axes.resize(Limbs.LEGS.size())
	_places = mini(MAX_PLACES, p_clip.frame_count - 2)
	for place: int in _places:
		var first: int = place * (p_clip.frame_count - 3) / maxi(_places - 1, 1)
		var rotations: Array[Array] = []
		var hips: PackedVector3Array = []
		for frame: int in 3:
			kinematics.solve(p_clip.values, (first + frame) * p_clip.channel_count)
			var positions: PackedVector3Array = kinematics.positions()
			rotations.append(kinematics.rotations.duplicate())
			hips.append(positions[p_map.joints[Limbs.HIPS]])
			if frame == 0:
				_look_at_hinges(positions, kinematics.rotations, p_map)
		_hip_steps.append(hips[0].distance_to(hips[1]))
		_hip_changes.append((hips[2] - 2.0 * hips[1] + hips[0]).length())
		for limb: int in Limbs.COUNT:
			var joint: int = p_map.joints[limb]
			var before: Vector3 = _turn(rotations[0][joint], rotations[1][joint])
			var after: Vector3 = _turn(rotations[1][joint], rotations[2][joint])
			# A frame that is written twice says nothing.
			if before.length() > 1e-5 and after.length() > 1e-5:
				_steps.append(before.length())
				_changes.append((after - before).length())


func _look_at_hinges(
	p_positions: PackedVector3Array, p_rotations: Array[Quaternion], p_map: HumanoidMap
) -> void:
	var uppers: PackedInt32Array = [
		Limbs.LEFT_UPPER_LEG, Limbs.RIGHT_UPPER_LEG, Limbs.LEFT_UPPER_ARM, Limbs.RIGHT_UPPER_ARM
	]
	for i: int in uppers.size():
		var limb: int = uppers[i]
		var middle: Vector3 = p_positions[p_map.bases[limb + 1]]
		var above: Vector3 = (middle - p_positions[p_map.bases[limb]]).normalized()
		var below: Vector3 = (p_positions[p_map.bases[limb + 2]] - middle).normalized()
		var axis: Vector3 = above.cross(below)
		_axes[i] += p_rotations[p_map.joints[limb]].inverse() * axis
		_bend += axis.length()


func _hinge() -> float:
	var kept: float = 0.0
	for axis: Vector3 in _axes:
		kept += axis.length()
	return kept / maxf(_bend, 1e-6)


## The turn from one rotation to another, as an axis times rad.
static func _turn(p_from: Quaternion, p_to: Quaternion) -> Vector3:
	var turn: Quaternion = p_to * p_from.inverse()
	turn = -turn if turn.w < 0.0 else turn
	var sine: Vector3 = Vector3(turn.x, turn.y, turn.z)
	return sine.normalized() * 2.0 * atan2(sine.length(), turn.w)


static func _median(p_values: PackedFloat32Array) -> float:
	if p_values.is_empty():
		return 0.0
	var sorted: PackedFloat32Array = p_values.duplicate()
	sorted.sort()
	return sorted[sorted.size() / 2]
