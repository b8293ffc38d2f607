class_name CalibrationMotion
extends MotionSource
## Somebody who does what [CalibrationGuide] says, perfectly or not: for tests, and for suits that
## are made up.

# How far places turn in the middle of a movement, degrees, [thigh, shank] for the squat.
const _BOW_DEG: PackedFloat32Array = [30.0, 50.0, 55.0]
const _SQUAT_DEG: PackedFloat32Array = [60.0, 35.0]
const _RISE_DEG: float = 30.0
const _SWAY_HZ: float = 0.7

## Which guide is followed.
var kind: CalibrationGuide.Kind = CalibrationGuide.Kind.T_TO_N
## Which way the wearer faces: 0 is +Z, rad about the vertical.
var facing: float = 0.0
## How much of each movement is made, 1: as asked. Arms that come down to 80 degrees: 0.89.
var effort: float = 1.0
## How far places are off in every pose, by place of [BodyPlaces].
var faults: Dictionary[int, Quaternion] = {}
## How far places sway during everything, degrees to either side, by place.
var sways_deg: Dictionary[int, float] = {}

var _start_usec: int = -1


func describe() -> String:
	return "the motion of a calibration (%s)" % CalibrationGuide.NAMES[kind]


func _read(p_time_usec: int) -> PoseSample:
	if _start_usec < 0:
		_start_usec = p_time_usec
	return pose_at((p_time_usec - _start_usec) / 1e6)


## The pose after so many seconds; behind the last step the last pose stays.
func pose_at(p_time_s: float) -> PoseSample:
	var time: float = p_time_s
	var at: CalibrationGuide.Step = null
	var part: float = 1.0
	for step: CalibrationGuide.Step in CalibrationGuide.steps(kind):
		at = step
		part = clampf(time / step.duration_s, 0.0, 1.0)
		if time < step.duration_s:
			break
		time -= step.duration_s
	var pose: PoseSample = PoseSample.new()
	pose.root = Vector3(0.0, get_hip_height(), 0.0)
	for place: int in BodyPlaces.COUNT:
		var turned: Quaternion = Rotations.yaw(facing) * _rotation(at, part, place)
		turned *= faults.get(place, Quaternion.IDENTITY)
		if sways_deg.has(place):
			var sway: float = sin(TAU * _SWAY_HZ * p_time_s) * deg_to_rad(sways_deg[place])
			turned *= Quaternion(Vector3.RIGHT, sway)
		# The shoulder blades stand behind the chest, whose limb they share.
		if place != 3 and place != 7:
			pose.set_orientation(BodyPlaces.LIMBS[place], turned)
	return pose


func _rotation(p_step: CalibrationGuide.Step, p_part: float, p_place: int) -> Quaternion:
	var pose: Quaternion = ResetPose.rotation(p_step.pose, p_place)
	var axis: Vector3 = CalibrationGuide.axis(p_step.movement, p_place)
	if p_step.pose == ResetPose.Kind.N:
		pose = Quaternion.IDENTITY.slerp(pose, effort)
	if axis == Vector3.ZERO:
		return pose
	# A third to get going, a third to move: people do not move at once, and stand before the end.
	var eased: float = smoothstep(0.2, 0.8, p_part)
	var angle: float = 0.0
	match p_step.movement:
		CalibrationGuide.Movement.ARMS:
			return Quaternion(axis, PI / 2.0 * eased * effort)
		CalibrationGuide.Movement.BOW:
			angle = _BOW_DEG[mini(p_place, 2) if p_place < 3 else 1]
		CalibrationGuide.Movement.SQUAT:
			angle = _SQUAT_DEG[0 if p_place == 11 or p_place == 14 else 1]
		CalibrationGuide.Movement.RISE:
			angle = _RISE_DEG
	return Quaternion(axis, deg_to_rad(angle) * sin(PI * eased) * effort) * pose
