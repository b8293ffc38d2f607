class_name CalibrationGuide
extends RefCounted
## The steps of each kind of calibration, as the wearer is guided through them.

## Kinds of calibration.
enum Kind {
	## Hold the T-pose.
	T_POSE,
	## Hold the N-pose.
	N_POSE,
	## T-pose, arms down, N-pose: the arms show which way the wearer faces.
	T_TO_N,
	## As T_TO_N, then a bow, a squat, a reach and rising on the toes, and both poses once more: finds
	## each sensor's own north, and evens out how exactly poses are held.
	FULL,
	## Hold the reset pose for a second, now: sets heading and pose anew, keeping what is known.
	QUICK,
	## One part of the body after the other: finds sensors that are exchanged. Calibrates nothing.
	FIT_CHECK,
}

## Time to get ready, s.
const COUNTDOWN_S: float = 3.0
## How long a pose is held, s.
const HOLD_S: float = 2.0
## How long it is held in a quick reset, s.
const QUICK_S: float = 1.0
## Time for moving both arms down, s.
const ARMS_S: float = 3.0
## Time for each of the other movements, s.
const MOVE_S: float = 4.0
## Time for each movement of a fit check, s.
const CHECK_S: float = 2.5

## Names of the kinds for people, by [enum Kind].
const NAMES: PackedStringArray = ["T-pose", "N-pose", "T to N", "full", "quick reset", "fit check"]


## One step.
class Step:
	## What is moved; NONE if a pose is held.
	var movement: GuideMovements.Movement = GuideMovements.Movement.NONE
	## The pose that is held, or from which the movement starts.
	var pose: ResetPose.Kind = ResetPose.Kind.T
	## How long it takes, s.
	var duration_s: float = 0.0
	## Whether it is the time to get ready for the pose.
	var is_countdown: bool = false

	## The instruction to the wearer.
	func text() -> String:
		if movement != GuideMovements.Movement.NONE:
			return GuideMovements.TEXTS[movement]
		return ResetPose.instruction(pose)

	## Where a mount is at a part (0 to 1) of the step: its rotation from the reset pose, for
	## somebody who faces +Z. People do not move at once, and stand before the end.
	func rotation_at(p_part: float, p_mount: int) -> Quaternion:
		var stands: Quaternion = ResetPose.rotation(pose, p_mount)
		var turn: Vector3 = GuideMovements.turn_deg(movement, p_mount) * (PI / 180.0)
		if turn == Vector3.ZERO:
			return stands
		var eased: float = smoothstep(0.2, 0.8, p_part)
		if not GuideMovements.is_passage(movement):
			eased = sin(PI * eased)
		return Rotations.from_vector(turn * eased) * stands

	## The whole pose at a part (0 to 1) of the step, facing +Z, its root at the origin.
	func pose_at(p_part: float) -> PoseSample:
		var found: PoseSample = PoseSample.new()
		for mount: int in BodyMounts.COUNT:
			if mount != BodyMounts.LEFT_SHOULDER and mount != BodyMounts.RIGHT_SHOULDER:
				found.set_orientation(BodyMounts.LIMBS[mount], rotation_at(p_part, mount))
		var spine: Quaternion = found.orientation(Limbs.HIPS)
		found.set_orientation(Limbs.SPINE, spine.slerp(found.orientation(Limbs.CHEST), 0.5))
		return found


## The steps of a kind; [param p_pose] is the pose of a quick reset, [param p_mounts] are the worn
## mounts, for a fit check.
static func steps(
	p_kind: Kind,
	p_pose: ResetPose.Kind = ResetPose.Kind.T,
	p_mounts: PackedInt32Array = PackedInt32Array()
) -> Array[Step]:
	var found: Array[Step] = []
	match p_kind:
		Kind.QUICK:
			found.append(_hold(p_pose, QUICK_S))
		Kind.FIT_CHECK:
			found.append(countdown(ResetPose.Kind.N))
			for movement: GuideMovements.Movement in GuideMovements.informative(p_mounts):
				found.append(_move(movement, CHECK_S))
		Kind.N_POSE:
			found.append(countdown(ResetPose.Kind.N))
			found.append(_hold(ResetPose.Kind.N, HOLD_S))
		_:
			found.append(countdown(ResetPose.Kind.T))
			found.append(_hold(ResetPose.Kind.T, HOLD_S))
	if p_kind == Kind.T_TO_N or p_kind == Kind.FULL:
		found.append(_move(GuideMovements.Movement.ARMS, ARMS_S))
		found.append(_hold(ResetPose.Kind.N, HOLD_S))
	if p_kind == Kind.FULL:
		found.append(_move(GuideMovements.Movement.BOW, MOVE_S))
		found.append(_move(GuideMovements.Movement.SQUAT, MOVE_S))
		found.append(_move(GuideMovements.Movement.REACH, MOVE_S))
		found.append(_move(GuideMovements.Movement.RISE, MOVE_S))
		found.append(_hold(ResetPose.Kind.N, HOLD_S))
		found.append(_move(GuideMovements.Movement.ARMS_UP, ARMS_S))
		found.append(_hold(ResetPose.Kind.T, HOLD_S))
	return found


## How long a kind takes, s; the mounts are for a fit check.
static func duration_s(
	p_kind: Kind, p_mounts: PackedInt32Array = PackedInt32Array(range(BodyMounts.COUNT))
) -> float:
	var sum: float = 0.0
	for step: Step in steps(p_kind, ResetPose.Kind.T, p_mounts):
		sum += step.duration_s
	return sum


## Time to get ready for a pose.
static func countdown(p_pose: ResetPose.Kind) -> Step:
	var step: Step = _hold(p_pose, COUNTDOWN_S)
	step.is_countdown = true
	return step


static func _hold(p_pose: ResetPose.Kind, p_duration: float) -> Step:
	var step: Step = Step.new()
	step.pose = p_pose
	step.duration_s = p_duration
	return step


static func _move(p_movement: GuideMovements.Movement, p_duration: float) -> Step:
	var step: Step = Step.new()
	step.movement = p_movement
	step.duration_s = p_duration
	if p_movement != GuideMovements.Movement.ARMS:
		step.pose = ResetPose.Kind.N
	return step
