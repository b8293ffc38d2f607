class_name ArmReach
extends RefCounted
## Brings the hand of a body to the controller that the wearer holds: the elbow's side and the turns
## of the arm about itself stay as the suit has them.

## Distance from its controller beyond which a hand does not hold it, and below which it does again,
## m.
const LET_GO_M: float = 0.6
const TAKE_M: float = 0.45
## Time in which an arm begins or ceases to follow, s.
const FADE_S: float = 0.4

## How far the arm follows: 0 not at all, 1 fully.
var weight: float = 0.0

var _side: int = 0
var _holds: bool = false
var _gap: Vector3 = Vector3.ZERO


## The arm of a side: 0 left, 1 right.
func _init(p_side: int) -> void:
	_side = p_side


## Forgets all: the next controller is followed at once.
func restart() -> void:
	weight = 0.0
	_holds = false
	_gap = Vector3.ZERO


## Moves the arm in a pose. [param p_shoulder] is where the upper arm begins, [param p_wrist] where
## the wrist has to be, m; lengths of upper arm and forearm, m; the time since the last call, s.
func apply(
	p_pose: PoseSample,
	p_shoulder: Vector3,
	p_wrist: Vector3,
	p_is_tracked: bool,
	p_lengths: Vector2,
	p_step_s: float
) -> void:
	var upper: int = Limbs.LEFT_UPPER_ARM + 3 * _side
	var out: Vector3 = Vector3.RIGHT if _side == 0 else Vector3.LEFT
	var arm: Quaternion = p_pose.orientation(upper)
	var fore: Quaternion = p_pose.orientation(upper + 1)
	var elbow: Vector3 = p_shoulder + arm * out * p_lengths.x
	var wrist: Vector3 = elbow + fore * out * p_lengths.y
	var far: float = wrist.distance_to(p_wrist)
	_holds = p_is_tracked and far < (LET_GO_M if _holds else TAKE_M)
	weight = move_toward(weight, 1.0 if _holds else 0.0, p_step_s / FADE_S)
	if _holds:
		_gap = p_wrist - wrist
	if weight <= 0.0:
		return
	# A gap that is no longer known fades as it was last: no jump.
	var goal: Vector3 = wrist + _gap * smoothstep(0.0, 1.0, weight)
	var along: Vector3 = TwoBone.direction(p_shoulder, goal)
	var new_elbow: Vector3 = TwoBone.middle(
		p_shoulder, goal, p_lengths.x, p_lengths.y, _pole(elbow - p_shoulder, arm, along)
	)
	var reached: float = TwoBone.reach(p_shoulder.distance_to(goal), p_lengths.x, p_lengths.y)
	var new_wrist: Vector3 = p_shoulder + along * reached
	_turn(p_pose, upper, arm * out, TwoBone.direction(p_shoulder, new_elbow))
	_turn(p_pose, upper + 1, fore * out, TwoBone.direction(new_elbow, new_wrist))


## The side to which the elbow is out; of an arm that is nearly straight that of its hinge.
func _pole(p_elbow: Vector3, p_arm: Quaternion, p_along: Vector3) -> Vector3:
	var out: Vector3 = p_elbow - p_along * p_elbow.dot(p_along)
	# In the reset pose forearms bend to the front, so that the elbow is behind.
	var hinge: Vector3 = p_arm * Vector3.FORWARD
	var sure: float = clampf((out.length() - 0.02) / 0.05, 0.0, 1.0)
	return out.normalized() * sure + hinge * (1.0 - sure)


static func _turn(p_pose: PoseSample, p_limb: int, p_from: Vector3, p_to: Vector3) -> void:
	var turned: Quaternion = TwoBone.turn_between(p_from, p_to) * p_pose.orientation(p_limb)
	p_pose.set_orientation(p_limb, turned.normalized())
