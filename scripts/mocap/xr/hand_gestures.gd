class_name HandGestures
extends RefCounted
## Recognises gestures of a tracked hand: pinch, fist, pointing, thumb up, from the joints of an
## [XRHandTracker]. A gesture begins and ends at different bends, and has to last a little, so that
## a hand at the limit does not flicker.

## A gesture has begun.
signal began(p_gesture: Gesture)
## A gesture has ended, also because the hand is no longer seen.
signal ended(p_gesture: Gesture)

## What is recognised.
enum Gesture {
	## Nothing of it.
	OPEN,
	## Tip of the thumb at the tip of the index finger.
	PINCH,
	## All fingers bent: holding something.
	FIST,
	## Only the index finger is stretched.
	POINT,
	## A fist, the thumb stretched and up.
	THUMB_UP,
}

## Distances of the tips of a pinch, part of the hand's length: below the first it begins, above the
## second it ends.
const PINCH_ON: float = 0.13
const PINCH_OFF: float = 0.24
## Bends of a finger, the sum of its joints, rad: beyond the first it is bent, below the second it
## is stretched.
const BENT: float = 2.4
const STRETCHED: float = 1.4
## Least duration of a gesture, s.
const HOLD_S: float = 0.06
## A thumb is up within this angle, rad.
const UP: float = deg_to_rad(40.0)
# The first joint of each finger in XRHandTracker's order, and how many it has.
const _FINGERS: PackedInt32Array = [6, 11, 16, 21]

## The gesture now.
var gesture: Gesture = Gesture.OPEN
## How far the thumb's and the index finger's tip are from a pinch: 0 open, 1 closed.
var pinch: float = 0.0
## How far the fingers are bent: 0 stretched, 1 a fist.
var grip: float = 0.0

var _wanted: Gesture = Gesture.OPEN
var _wanted_s: float = 0.0
var _bent: PackedByteArray = [0, 0, 0, 0]


## Looks at a hand after a time, s. One that is not tracked makes no gesture.
func advance(p_hand: XRHandTracker, p_step_s: float) -> void:
	var seen: Gesture = Gesture.OPEN
	if p_hand != null and p_hand.has_tracking_data:
		seen = _recognise(p_hand)
	else:
		pinch = 0.0
		grip = 0.0
	if seen == gesture:
		_wanted = seen
		_wanted_s = 0.0
		return
	_wanted_s = _wanted_s + p_step_s if seen == _wanted else p_step_s
	_wanted = seen
	if _wanted_s >= HOLD_S:
		var before: Gesture = gesture
		gesture = seen
		_wanted_s = 0.0
		if before != Gesture.OPEN:
			ended.emit(before)
		if seen != Gesture.OPEN:
			began.emit(seen)


func _recognise(p_hand: XRHandTracker) -> Gesture:
	var sum: float = 0.0
	for finger: int in 4:
		var bend: float = _bend(p_hand, _FINGERS[finger])
		_bent[finger] = 1 if bend > (STRETCHED if _bent[finger] != 0 else BENT) else 0
		sum += clampf(bend / 3.6, 0.0, 1.0) / 4.0
	grip = sum
	var gap: float = _place(p_hand, 5).distance_to(_place(p_hand, 10)) / _length(p_hand)
	pinch = clampf(1.0 - (gap - PINCH_ON) / (2.0 * PINCH_OFF), 0.0, 1.0)
	var others: int = _bent[1] + _bent[2] + _bent[3]
	if _bent[0] != 0 and others == 3:
		return Gesture.THUMB_UP if _is_thumb_up(p_hand) else Gesture.FIST
	if gap < (PINCH_OFF if gesture == Gesture.PINCH else PINCH_ON):
		return Gesture.PINCH
	if _bent[0] == 0 and others == 3:
		return Gesture.POINT
	return Gesture.OPEN


func _is_thumb_up(p_hand: XRHandTracker) -> bool:
	var thumb: Vector3 = _place(p_hand, 5) - _place(p_hand, 3)
	var knuckle: Vector3 = _place(p_hand, 7)
	var apart: float = _place(p_hand, 5).distance_to(knuckle)
	var limit: float = UP * (1.3 if gesture == Gesture.THUMB_UP else 1.0)
	return thumb.angle_to(Vector3.UP) < limit and apart > 0.3 * _length(p_hand)


## Sum of the bends of a finger's joints, rad.
static func _bend(p_hand: XRHandTracker, p_first: int) -> float:
	var sum: float = 0.0
	for joint: int in range(p_first, p_first + 3):
		var before: Vector3 = _place(p_hand, joint + 1) - _place(p_hand, joint)
		var after: Vector3 = _place(p_hand, joint + 2) - _place(p_hand, joint + 1)
		if before.length() > 1e-4 and after.length() > 1e-4:
			sum += before.angle_to(after)
	return sum


## Length of a stretched hand by the bones of its middle finger, m.
static func _length(p_hand: XRHandTracker) -> float:
	var sum: float = _place(p_hand, 1).distance_to(_place(p_hand, 12))
	for joint: int in range(12, 15):
		sum += _place(p_hand, joint).distance_to(_place(p_hand, joint + 1))
	return maxf(sum, 0.05)


static func _place(p_hand: XRHandTracker, p_joint: int) -> Vector3:
	return p_hand.get_hand_joint_transform(p_joint as XRHandTracker.HandJoint).origin
