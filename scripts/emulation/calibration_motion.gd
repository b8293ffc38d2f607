class_name CalibrationMotion
extends MotionSource
## A simulated wearer who follows [CalibrationGuide], perfectly or not: for tests, and for suits
## that itself do. By default movements are about the axes of a wearer who does all as asked.

const _SWAY_HZ: float = 0.7

## Which guide is followed.
var kind: CalibrationGuide.Kind = CalibrationGuide.Kind.T_TO_N
## Which way the wearer faces: 0 is +Z, rad about the vertical.
var facing: float = 0.0
## How much of each movement is made, 1: as asked. Arms that come down to 80 degrees: 0.89.
var effort: float = 1.0
## The pose of a quick reset.
var pose_kind: ResetPose.Kind = ResetPose.Kind.T
## Mounts that are worn, for a fit check.
var mounts: PackedInt32Array = PackedInt32Array(range(BodyMounts.COUNT))
## How far both arms point ahead in the T-pose instead of to the side, degrees.
var ahead_deg: float = 0.0
## Movements of which more or less is made than of the others: 1 is as asked.
var efforts: Dictionary[GuideMovements.Movement, float] = {}
## By how much the axes of movements are turned from where they should be.
var askew: Dictionary[GuideMovements.Movement, Quaternion] = {}
## How far mounts are off in every pose, by mount of [BodyMounts].
var faults: Dictionary[int, Quaternion] = {}
## How far mounts are off in each hold and in the movements after it: for each hold of the guide, in
## its order, by mount.
var hold_faults: Array[Dictionary] = []
## Whether a mount that is off in a pose also moves about an axis that is off, as hinges of the limb
## itself do. Otherwise movements are about the axes of who does all as asked.
var is_hinged: bool = false
## How far mounts sway during everything, degrees to either side, by mount.
var sways_deg: Dictionary[int, float] = {}

## How much longer than usual the time to get ready is, s.
var lead_s: float = 0.0

var _start_usec: int = -1


func describe() -> String:
	return "the motion of a calibration (%s)" % CalibrationGuide.NAMES[kind]


## The pose after so many seconds; behind the last step the last pose stays.
func pose_at(p_time_s: float) -> PoseSample:
	var time: float = maxf(p_time_s - lead_s, 0.0)
	var at: CalibrationGuide.Step = null
	var part: float = 1.0
	var holds: int = -1
	for step: CalibrationGuide.Step in CalibrationGuide.steps(kind, pose_kind, mounts):
		at = step
		if step.movement == GuideMovements.Movement.NONE and not step.is_countdown:
			holds += 1
		part = clampf(time / step.duration_s, 0.0, 1.0)
		if time < step.duration_s:
			break
		time -= step.duration_s
	var pose: PoseSample = PoseSample.new()
	pose.root = Vector3(0.0, get_hip_height(), 0.0)
	pose.details = MotionDetails.new()
	for mount: int in BodyMounts.COUNT:
		var turned: Quaternion = Rotations.yaw(facing) * _rotation(at, part, mount, maxi(holds, 0))
		turned *= faults.get(mount, Quaternion.IDENTITY)
		if sways_deg.has(mount):
			var sway: float = sin(TAU * _SWAY_HZ * p_time_s) * deg_to_rad(sways_deg[mount])
			turned *= Quaternion(Vector3.RIGHT, sway)
		if mount == 3 or mount == 7:
			# The shoulder blades are no limbs.
			pose.details.joints[WornSensorFeed.BLADES[mount]] = turned
		else:
			pose.set_orientation(BodyMounts.LIMBS[mount], turned)
	pose.set_orientation(1, pose.orientation(0).slerp(pose.orientation(2), 0.5))
	return pose


func _read(p_time_usec: int) -> PoseSample:
	if _start_usec < 0:
		_start_usec = p_time_usec
	return pose_at((p_time_usec - _start_usec) / 1e6)


func _rotation(
	p_step: CalibrationGuide.Step, p_part: float, p_mount: int, p_hold: int
) -> Quaternion:
	var asked: Quaternion = ResetPose.rotation(p_step.pose, p_mount)
	var stretched: Quaternion = Quaternion.IDENTITY
	if ResetPose.hangs(p_mount):
		stretched = Rotations.yaw(deg_to_rad(-ahead_deg) * BodyMounts.side(p_mount))
	var fault: Quaternion = _fault(p_hold, p_mount)
	var down: Quaternion = ResetPose.rotation(ResetPose.Kind.N, p_mount)
	# People do not move at once, and stand before the end.
	var eased: float = smoothstep(0.2, 0.8, p_part)
	var part: float = efforts.get(p_step.movement, effort)
	if GuideMovements.is_passage(p_step.movement):
		down = stretched.slerp(down, part)
		var next: Quaternion = _fault(p_hold + 1, p_mount)
		if p_step.movement == GuideMovements.Movement.ARMS_UP:
			return (down * fault).slerp(stretched * next, eased)
		return (stretched * fault).slerp(down * next, eased)
	var pose: Quaternion = stretched
	if p_step.pose == ResetPose.Kind.N:
		pose = stretched.slerp(down, minf(effort, 1.0))
	pose *= fault
	var turn: Vector3 = GuideMovements.turn_deg(p_step.movement, p_mount) * (PI / 180.0)
	if turn == Vector3.ZERO:
		return pose
	turn = askew.get(p_step.movement, Quaternion.IDENTITY) * turn
	if is_hinged:
		turn = asked * fault * asked.inverse() * turn
	return Rotations.from_vector(turn * sin(PI * eased) * part) * pose


func _fault(p_hold: int, p_mount: int) -> Quaternion:
	if hold_faults.is_empty():
		return Quaternion.IDENTITY
	return hold_faults[mini(p_hold, hold_faults.size() - 1)].get(p_mount, Quaternion.IDENTITY)
