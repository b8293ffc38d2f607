class_name XrPins
extends RefCounted
## Trackers on a body: how each sits on its limb, and where the limb is by it.
##
## How one sits is learned when it is seen for the first time, and anew after [method restart]: the
## wearer has to stand upright then, feet parallel. Knees and elbows need nothing.

## An ankle is so far behind a tracker on the instep, m.
const INSTEP_M: float = 0.06

var _hips: Transform3D = Transform3D.IDENTITY
var _chest: Quaternion = Quaternion.IDENTITY
var _feet: Array[Transform3D] = [Transform3D.IDENTITY, Transform3D.IDENTITY]
var _learned: PackedByteArray = PackedByteArray()


func _init() -> void:
	_learned.resize(XrFrame.PINS)


## Learns all anew: the wearer stands upright.
func restart() -> void:
	_learned.fill(0)


## Learns those that were not seen before, on somebody who stands as a pose says.
func learn(
	p_frame: XrFrame, p_pose: PoseSample, p_yaw: float, p_joints: PackedVector3Array
) -> void:
	var facing: Quaternion = Rotations.yaw(p_yaw)
	if _is_new(p_frame, XrFrame.Pin.WAIST):
		var hips: Transform3D = Transform3D(Basis(facing), p_pose.root)
		_hips = p_frame.pins[XrFrame.Pin.WAIST].affine_inverse() * hips
	if _is_new(p_frame, XrFrame.Pin.CHEST):
		var worn: Quaternion = p_frame.pins[XrFrame.Pin.CHEST].basis.get_rotation_quaternion()
		_chest = worn.inverse() * p_pose.orientation(Limbs.CHEST)
	for side: int in 2:
		if _is_new(p_frame, XrFrame.Pin.LEFT_FOOT + side):
			var worn: Transform3D = p_frame.pins[XrFrame.Pin.LEFT_FOOT + side]
			var ankle: Vector3 = worn.origin - facing * Vector3(0.0, 0.0, INSTEP_M)
			ankle.y = p_joints[Limbs.FEET[side]].y
			_feet[side] = worn.affine_inverse() * Transform3D(Basis(facing), ankle)


## Whether the hips are known.
func knows_hips(p_frame: XrFrame) -> bool:
	return _knows(p_frame, XrFrame.Pin.WAIST)


## The hips.
func hips(p_frame: XrFrame) -> Transform3D:
	return p_frame.pins[XrFrame.Pin.WAIST] * _hips


## Whether a foot is known.
func knows_foot(p_frame: XrFrame, p_side: int) -> bool:
	return _knows(p_frame, XrFrame.Pin.LEFT_FOOT + p_side)


## A foot at its ankle.
func foot(p_frame: XrFrame, p_side: int) -> Transform3D:
	return p_frame.pins[XrFrame.Pin.LEFT_FOOT + p_side] * _feet[p_side]


## The chest's rotation, or another where it is not known.
func chest(p_frame: XrFrame, p_other: Quaternion) -> Quaternion:
	if not _knows(p_frame, XrFrame.Pin.CHEST):
		return p_other
	var worn: Quaternion = p_frame.pins[XrFrame.Pin.CHEST].basis.get_rotation_quaternion()
	return (worn * _chest).normalized()


## The side to which a joint between two ends bends by its tracker, or another.
func pole(
	p_frame: XrFrame, p_pin: int, p_from: Vector3, p_to: Vector3, p_other: Vector3
) -> Vector3:
	if p_frame.has_pins[p_pin] == 0:
		return p_other
	var along: Vector3 = TwoBone.direction(p_from, p_to)
	var side: Vector3 = p_frame.pins[p_pin].origin - p_from
	side -= along * side.dot(along)
	return side.normalized() if side.length() > 0.03 else p_other


func _knows(p_frame: XrFrame, p_pin: int) -> bool:
	return p_frame.has_pins[p_pin] != 0 and _learned[p_pin] != 0


func _is_new(p_frame: XrFrame, p_pin: int) -> bool:
	var is_new: bool = p_frame.has_pins[p_pin] != 0 and _learned[p_pin] == 0
	if is_new:
		_learned[p_pin] = 1
	return is_new
