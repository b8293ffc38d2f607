class_name CalibrationGuide
extends RefCounted
## What a wearer is led through: the steps of each kind of calibration.

## Kinds of calibration.
enum Kind {
	## Hold the T-pose.
	T_POSE,
	## Hold the N-pose.
	N_POSE,
	## T-pose, arms down, N-pose: the arms tell which way the wearer faces.
	T_TO_N,
	## As T_TO_N, then a bow, a squat and rising on the toes: aligns the headings of all sensors.
	FULL,
	## Hold the reset pose for a second, now: sets heading and pose anew, keeping what is known.
	QUICK,
}

## Movements, each about one known axis of the body.
enum Movement {
	## None: a pose is held.
	NONE,
	## From T to N, both arms.
	ARMS,
	## Forward from the hips and up again, back straight.
	BOW,
	## Down and up again, heels on the floor.
	SQUAT,
	## On the toes and down again.
	RISE,
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

## Names of the kinds for people, by [enum Kind].
const NAMES: PackedStringArray = ["T-pose", "N-pose", "T to N", "full", "quick reset"]

const _TEXTS: PackedStringArray = [
	"",
	"Bring both arms down to your thighs, straight, palms turning in.",
	"Bow forward with a straight back, then come up again.",
	"Squat halfway with the knees ahead, heels down, then come up again.",
	"Rise on your toes, then come down again.",
]


## One step.
class Step:
	## What is moved; NONE if a pose is held.
	var movement: Movement = Movement.NONE
	## The pose that is held, or from which the movement starts.
	var pose: ResetPose.Kind = ResetPose.Kind.T
	## How long it takes, s.
	var duration_s: float = 0.0
	## Whether it is the time to get ready for the pose.
	var is_countdown: bool = false

	## What the wearer is told.
	func text() -> String:
		if movement != Movement.NONE:
			return CalibrationGuide._TEXTS[movement]
		return ResetPose.instruction(pose)


## The steps of a kind; [param p_pose] is the pose of a quick reset.
static func steps(p_kind: Kind, p_pose: ResetPose.Kind = ResetPose.Kind.T) -> Array[Step]:
	var found: Array[Step] = []
	match p_kind:
		Kind.QUICK:
			found.append(_step(Movement.NONE, p_pose, QUICK_S))
		Kind.N_POSE:
			found.append(_countdown(ResetPose.Kind.N))
			found.append(_step(Movement.NONE, ResetPose.Kind.N, HOLD_S))
		_:
			found.append(_countdown(ResetPose.Kind.T))
			found.append(_step(Movement.NONE, ResetPose.Kind.T, HOLD_S))
	if p_kind == Kind.T_TO_N or p_kind == Kind.FULL:
		found.append(_step(Movement.ARMS, ResetPose.Kind.T, ARMS_S))
		found.append(_step(Movement.NONE, ResetPose.Kind.N, HOLD_S))
	if p_kind == Kind.FULL:
		for movement: Movement in [Movement.BOW, Movement.SQUAT, Movement.RISE]:
			found.append(_step(movement, ResetPose.Kind.N, MOVE_S))
	return found


## How long a kind takes, s.
static func duration_s(p_kind: Kind) -> float:
	var sum: float = 0.0
	for step: Step in steps(p_kind):
		sum += step.duration_s
	return sum


## The axis about which a movement turns a place, in the frame of somebody who faces +Z; zero if
## the movement leaves it, or turns it in more than one way.
static func axis(p_movement: Movement, p_place: int) -> Vector3:
	match p_movement:
		Movement.ARMS:
			if ResetPose.hangs(p_place):
				return Vector3.BACK * -BodyPlaces.side(p_place)
		Movement.BOW:
			if p_place <= 3 or p_place == 7:
				return Vector3.RIGHT
		Movement.SQUAT:
			if p_place == 11 or p_place == 14:
				return Vector3.LEFT
			if p_place == 12 or p_place == 15:
				return Vector3.RIGHT
		Movement.RISE:
			if p_place == 13 or p_place == 16:
				return Vector3.RIGHT
	return Vector3.ZERO


static func _countdown(p_pose: ResetPose.Kind) -> Step:
	var step: Step = _step(Movement.NONE, p_pose, COUNTDOWN_S)
	step.is_countdown = true
	return step


static func _step(p_movement: Movement, p_pose: ResetPose.Kind, p_duration: float) -> Step:
	var step: Step = Step.new()
	step.movement = p_movement
	step.pose = p_pose
	step.duration_s = p_duration
	return step
