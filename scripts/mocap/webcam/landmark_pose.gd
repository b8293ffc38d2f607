class_name LandmarkPose
extends RefCounted
## Rotations of limbs from points on the body: each limb points along its bone (aim), and is turned
## about itself as the hinge of its elbow or knee has it (pole). A straight limb shows no hinge: it
## keeps the one that it had last, carried along with the limb. Joints stay within what people can:
## elbows and knees bend one way only, legs turn about themselves only so far ([LimbLimits]). Limbs
## that are not seen ease from where they were last to where they rest ([LimbMemory]).

## Points as MediaPipe numbers them; of pairs the left one, the right one has the next number.
const NOSE: int = 0
const EAR: int = 7
const SHOULDER: int = 11
const ELBOW: int = 13
const WRIST: int = 15
const PINKY: int = 17
const INDEX: int = 19
const HIP: int = 23
const KNEE: int = 25
const ANKLE: int = 27
const HEEL: int = 29
const TOE: int = 31
## Visibility below which a point is not used, 0 to 1.
const MIN_VISIBILITY: float = 0.2
## Bend below which a joint shows no hinge axis, rad; from twice that on the axis counts fully.
const STRAIGHT: float = deg_to_rad(8.0)
## How far the nose is below the ears, seen from the side, for a head that is level, rad.
const NOSE_PITCH: float = deg_to_rad(14.0)
## A pelvis goes a part of the way from the spine to the thighs, and the chest as much less the
## other way: who crouches or bends rounds his back. And how far the hips' joints are pitched from a
## pelvis, rad. All three by the joints of skeletons that play clips, not by landmarks.
const PELVIS_SHARE: float = 0.4
const CHEST_SHARE: float = -0.2
const PELVIS_PITCH: float = deg_to_rad(-5.0)

var _filler: LimbFiller = LimbFiller.new()
var _memory: LimbMemory = LimbMemory.new()
var _standing: StandingHeight = StandingHeight.new(BodySize.new())
var _places: PackedVector3Array = PackedVector3Array()
var _seen: PackedFloat32Array = PackedFloat32Array()
# Last rotation of each mount, used while it cannot be seen.
var _last: Dictionary[int, Quaternion] = {}


## The pose of points (m, Godot's frame) and how well each is seen, a time, s, after the last one;
## null without shoulders.
func make(
	p_places: PackedVector3Array, p_seen: PackedFloat32Array, p_step_s: float = 0.0
) -> PoseSample:
	_places = p_places
	_seen = p_seen
	_filler.clear()
	if not _sees([SHOULDER, SHOULDER + 1]):
		return null
	_make_trunk()
	if _filler.known[BodyMounts.PELVIS] == 0 or _filler.known[BodyMounts.STERNUM] == 0:
		return null
	_make_head()
	for side: int in 2:
		_make_arm(side)
		_make_leg(side)
	var known: PackedByteArray = _filler.known.duplicate()
	if not _sees([HIP, HIP + 1]):
		known[BodyMounts.PELVIS] = 0
	_filler.fill()
	_memory.ease(_filler, known, p_step_s)
	_filler.fill()
	var pose: PoseSample = _filler.pose()
	for mount: int in BodyMounts.COUNT:
		var is_blade: bool = BodyMounts.LIMBS[mount] == Limbs.CHEST and mount != BodyMounts.STERNUM
		if not is_blade:
			pose.details.measured[BodyMounts.LIMBS[mount]] = known[mount]
	pose.root = Vector3(0.0, _standing.of(pose), 0.0)
	return pose


## Who sits at a desk shows no hips: the trunk is upright then.
func _make_trunk() -> void:
	var across: Vector3 = _places[SHOULDER] - _places[SHOULDER + 1]
	if not _sees([HIP, HIP + 1]):
		var level: Vector3 = Vector3(across.x, 0.0, across.z)
		_set_mount(BodyMounts.PELVIS, _frame(level, Vector3.UP))
		_set_mount(BodyMounts.STERNUM, _frame(across, Vector3.UP))
		return
	var hips: Vector3 = (_places[HIP] + _places[HIP + 1]) / 2.0
	var spine: Vector3 = (_places[SHOULDER] + _places[SHOULDER + 1]) / 2.0 - hips
	spine = spine.normalized()
	var legs: Vector3 = Vector3.ZERO
	if _sees([KNEE, KNEE + 1]):
		legs = (hips - (_places[KNEE] + _places[KNEE + 1]) / 2.0).normalized()
	var pelvis: Quaternion = _frame(_places[HIP] - _places[HIP + 1], spine + PELVIS_SHARE * legs)
	_set_mount(BodyMounts.PELVIS, pelvis * Quaternion(Vector3.RIGHT, PELVIS_PITCH))
	_set_mount(BodyMounts.STERNUM, _frame(across, spine + CHEST_SHARE * legs))


func _make_head() -> void:
	if not _sees([EAR, EAR + 1, NOSE]):
		return
	var left: Vector3 = _places[EAR] - _places[EAR + 1]
	var ahead: Vector3 = _places[NOSE] - (_places[EAR] + _places[EAR + 1]) / 2.0
	# Turned up by as much as noses are below ears.
	ahead = ahead.rotated(left.normalized(), -NOSE_PITCH) if left.length() > 1e-4 else ahead
	_set_mount(BodyMounts.HEAD, _frame(left, ahead.cross(left)))


func _make_arm(p_side: int) -> void:
	var mirror: float = 1.0 - 2.0 * p_side
	var upper: int = BodyMounts.LEFT_UPPER_ARM + 4 * p_side
	if not _sees([SHOULDER + p_side, ELBOW + p_side]):
		return
	var first: Vector3 = _places[ELBOW + p_side] - _places[SHOULDER + p_side]
	var rest: Vector3 = Vector3.RIGHT * mirror
	if not _sees([WRIST + p_side]):
		_set_mount(upper, _carried(upper, rest, first))
		return
	var second: Vector3 = _places[WRIST + p_side] - _places[ELBOW + p_side]
	# An elbow bends a stretched arm forward: about -Y on the left.
	var axis: Vector3 = first.cross(second) * -mirror
	var chest: Quaternion = _filler.rotations[BodyMounts.STERNUM]
	axis = LimbLimits.arm_axis(chest, rest, first, axis)
	_hinge(upper, rest, Vector3.UP, [first, second], axis)
	var hand: int = upper + 2
	if _sees([PINKY + p_side, INDEX + p_side]):
		var knuckles: Vector3 = (_places[PINKY + p_side] + _places[INDEX + p_side]) / 2.0
		var along: Vector3 = (knuckles - _places[WRIST + p_side]) * mirror
		# Palms are down in the reset pose, the index finger ahead.
		var ahead: Vector3 = _places[INDEX + p_side] - _places[PINKY + p_side]
		_set_mount(hand, _frame(along, ahead.cross(along)))


func _make_leg(p_side: int) -> void:
	var thigh: int = BodyMounts.LEFT_THIGH + 3 * p_side
	if not _sees([HIP + p_side, KNEE + p_side]):
		return
	var first: Vector3 = _places[KNEE + p_side] - _places[HIP + p_side]
	if not _sees([ANKLE + p_side]):
		_set_mount(thigh, _carried(thigh, Vector3.DOWN, first))
		return
	var second: Vector3 = _places[ANKLE + p_side] - _places[KNEE + p_side]
	# A knee bends a shank back: about X.
	var pelvis: Quaternion = _filler.rotations[BodyMounts.PELVIS]
	var along: Array[Vector3] = LimbLimits.leg(pelvis, first, second)
	_hinge(thigh, Vector3.DOWN, Vector3.RIGHT, along, along[0].cross(along[1]))
	if _sees([HEEL + p_side, TOE + p_side]) and _filler.known[thigh + 1] != 0:
		var ahead: Vector3 = _places[TOE + p_side] - _places[HEEL + p_side]
		var left: Vector3 = _filler.rotations[thigh + 1] * Vector3.RIGHT
		left -= ahead * (left.dot(ahead) / maxf(ahead.length_squared(), 1e-9))
		var foot: Quaternion = _frame(left, ahead.cross(left))
		_set_mount(thigh + 2, LimbLimits.foot(_filler.rotations[thigh + 1], foot))


## Sets two limbs that a hinge joins: both are turned about themselves so that their axis is the
## hinge's. The nearer to straight they are, the more they keep the turn that they had.
func _hinge(
	p_mount: int, p_rest: Vector3, p_axis: Vector3, p_along: Array[Vector3], p_hinge: Vector3
) -> void:
	var size: float = p_along[0].length() * p_along[1].length()
	if size < 1e-6:
		return
	var bend: float = p_along[0].angle_to(p_along[1])
	var trust: float = clampf(bend / STRAIGHT - 1.0, 0.0, 1.0)
	for part: int in 2:
		var kept: Quaternion = _carried(p_mount + part, p_rest, p_along[part])
		var turn: Quaternion = kept
		if trust > 0.0:
			var seen: Quaternion = _aim(p_rest, p_axis, p_along[part], p_hinge)
			turn = kept.slerp(seen, trust).normalized()
		_set_mount(p_mount + part, turn)


## The last rotation of a mount, turned the shortest way so that it points along; for the first time
## that of what it hangs on.
func _carried(p_mount: int, p_rest: Vector3, p_along: Vector3) -> Quaternion:
	var above: int = BodyMounts.PARENTS[p_mount]
	while above >= 0 and _filler.known[above] == 0:
		above = BodyMounts.PARENTS[above]
	var start: Quaternion = _filler.rotations[above] if above >= 0 else Quaternion.IDENTITY
	start = _last.get(p_mount, start)
	var from: Vector3 = start * p_rest
	var to: Vector3 = p_along.normalized()
	if to.length() < 0.5 or from.dot(to) < -0.9999:
		return start
	return (Quaternion(from, to) * start).normalized()


## The rotation that takes one direction to another exactly, and an axis across as near to the hinge
## as that allows.
static func _aim(
	p_rest: Vector3, p_axis: Vector3, p_along: Vector3, p_hinge: Vector3
) -> Quaternion:
	var along: Vector3 = p_along.normalized()
	var across: Vector3 = (p_hinge - along * p_hinge.dot(along)).normalized()
	var rest: Basis = Basis(p_rest, p_axis, p_rest.cross(p_axis))
	var now: Basis = Basis(along, across, along.cross(across))
	return (now * rest.transposed()).get_rotation_quaternion()


## The rotation whose X is exactly the left and whose Y is as near to up as that allows.
static func _frame(p_left: Vector3, p_up: Vector3) -> Quaternion:
	var left: Vector3 = p_left.normalized()
	var ahead: Vector3 = left.cross(p_up).normalized()
	if left.length() < 0.5 or ahead.length() < 0.5:
		return Quaternion(0.0, 0.0, 0.0, 0.0)
	return Basis(left, ahead.cross(left), ahead).get_rotation_quaternion()


func _set_mount(p_mount: int, p_turn: Quaternion) -> void:
	if p_turn.length_squared() < 0.5:
		return
	_last[p_mount] = p_turn
	_filler.set_mount(p_mount, p_turn)


func _sees(p_points: PackedInt32Array) -> bool:
	for point: int in p_points:
		if _seen[point] < MIN_VISIBILITY:
			return false
	return true
