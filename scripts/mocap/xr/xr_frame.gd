class_name XrFrame
extends RefCounted
## What a wearer's headset, controllers and trackers say of one moment.
##
## Frame: the tracking space (right-handed, Y up, the floor at 0, metres), which is the frame of the
## wearer's [PoseSample]s too. The headset is as the runtime gives it: it looks along its -Z. Hands
## are as [Limbs] have them: rotations from the reset pose, placed at the wrist.

## Trackers on the body and on a prop.
enum Pin {
	WAIST,
	CHEST,
	LEFT_FOOT,
	RIGHT_FOOT,
	LEFT_KNEE,
	RIGHT_KNEE,
	LEFT_ELBOW,
	RIGHT_ELBOW,
	LEFT_SHOULDER,
	RIGHT_SHOULDER,
	HANDHELD,
}

## How many kinds of trackers there are.
const PINS: int = 11

## When it was, µs of Unix time.
var time_usec: int = 0
## The headset: between the eyes.
var head: Transform3D = Transform3D.IDENTITY
## Whether the headset's rotation is known.
var has_head: bool = false
## Whether its position is known too.
var has_place: bool = false
## Wrists of the left and the right hand.
var hands: Array[Transform3D] = [Transform3D.IDENTITY, Transform3D.IDENTITY]
## Whether each is tracked: 1 or 0.
var has_hands: PackedByteArray = [0, 0]
## Trackers, by [enum Pin], with the axes that the runtime gives them.
var pins: Array[Transform3D] = []
## Whether each is tracked: 1 or 0.
var has_pins: PackedByteArray = PackedByteArray()
## Rotations of the fingers from the reset pose by [enum XRBodyTracker.Joint]. It is replaced as a
## whole, never changed.
var fingers: Dictionary[int, Quaternion] = {}


func _init() -> void:
	pins.resize(PINS)
	pins.fill(Transform3D.IDENTITY)
	has_pins.resize(PINS)


## Takes the values of another.
func copy(p_other: XrFrame) -> void:
	time_usec = p_other.time_usec
	head = p_other.head
	has_head = p_other.has_head
	has_place = p_other.has_place
	for hand: int in 2:
		hands[hand] = p_other.hands[hand]
		has_hands[hand] = p_other.has_hands[hand]
	for pin: int in PINS:
		pins[pin] = p_other.pins[pin]
		has_pins[pin] = p_other.has_pins[pin]
	fingers = p_other.fingers


## Becomes what lies between two others. What only one of them knows is taken from it if it is the
## nearer one, else it is unknown.
func blend(p_from: XrFrame, p_to: XrFrame, p_part: float) -> void:
	copy(p_to if p_part >= 0.5 else p_from)
	time_usec = p_from.time_usec + roundi((p_to.time_usec - p_from.time_usec) * p_part)
	if p_from.has_head and p_to.has_head:
		head = p_from.head.interpolate_with(p_to.head, p_part)
	for hand: int in 2:
		if p_from.has_hands[hand] != 0 and p_to.has_hands[hand] != 0:
			hands[hand] = p_from.hands[hand].interpolate_with(p_to.hands[hand], p_part)
	for pin: int in PINS:
		if p_from.has_pins[pin] != 0 and p_to.has_pins[pin] != 0:
			pins[pin] = p_from.pins[pin].interpolate_with(p_to.pins[pin], p_part)


## Goes into another frame of the same size, in which this one lies somewhere.
func move(p_into: Transform3D) -> void:
	head = p_into * head
	for hand: int in 2:
		hands[hand] = p_into * hands[hand]
	for pin: int in PINS:
		pins[pin] = p_into * pins[pin]
	var turn: Quaternion = p_into.basis.get_rotation_quaternion()
	var turned: Dictionary[int, Quaternion] = {}
	for joint: int in fingers:
		turned[joint] = turn * fingers[joint]
	fingers = turned


## Nothing is tracked any more.
func lose_all() -> void:
	has_head = false
	has_place = false
	has_hands.fill(0)
	has_pins.fill(0)


## Takes out what is no number or no rotation: a runtime may say anything.
func drop_faults() -> void:
	has_head = has_head and is_pose(head)
	has_place = has_place and has_head
	for hand: int in 2:
		has_hands[hand] = 1 if has_hands[hand] != 0 and is_pose(hands[hand]) else 0
	for pin: int in PINS:
		has_pins[pin] = 1 if has_pins[pin] != 0 and is_pose(pins[pin]) else 0


## The rotation of the head's limb from the reset pose: somebody who looks along the headset's -Z.
func head_turn() -> Quaternion:
	return head.basis.get_rotation_quaternion() * Quaternion(Vector3.UP, PI)


## Whether this is a pose at all: numbers, no scale, within a kilometre.
static func is_pose(p_pose: Transform3D) -> bool:
	if not p_pose.is_finite() or p_pose.origin.length_squared() > 1e6:
		return false
	return absf(p_pose.basis.determinant() - 1.0) < 0.1
