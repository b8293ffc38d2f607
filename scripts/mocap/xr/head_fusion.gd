class_name HeadFusion
extends RefCounted
## Moves and turns the body that a suit measures so that it fits the headset (and controllers) of
## its wearer: sample by sample, slowly where it is seen.
##
## The view is the headset's and is never touched. Of an inertial suit only heading and position
## drift: the whole body is turned about the vertical ([HeadingCorrection]), its head takes the
## headset's rotation, and its hips are where the chain of limbs below the headset puts them. What
## the headset does not know goes on from where it was. Frame: the tracking space (see [XrFrame]).

## Where the head's rotation, or the body's position, comes from.
enum Source {
	## From the headset; the suit's heading is corrected by the chest, for suits without a sensor on
	## the head.
	HMD,
	## From the suit alone: for a headset without a tracker of its own.
	SUIT,
	## From the headset, the suit's heading corrected by its head; the position from the headset,
	## quick motion from the suit where that knows it.
	BOTH,
}

## Names of [enum Source] for options.
const SOURCES: Dictionary[String, Source] = {
	"hmd": Source.HMD, "suit": Source.SUIT, "both": Source.BOTH
}
## Pitch beyond which a gaze has no heading, rad.
const STEEP: float = deg_to_rad(60.0)
## Greatest turn of a head on its chest, rad; beyond it neck and chest go along.
const NECK_RANGE: float = deg_to_rad(75.0)
## Time constant of the heading of a suit that does not measure the head, s.
const CHEST_FILTER_S: float = 60.0
## Longest step between samples, s: after a longer break all is taken at once.
const MAX_STEP_S: float = 1.0
# Moments for the mount: one in this time, s, while the chest turns by no more than, rad/s.
const _MOUNT_S: float = 0.1
const _STILL: float = 0.35
# It is tried each so many moments.
const _SOLVE_MOMENTS: int = 30

## Where the head's rotation comes from.
var orientation: Source = Source.BOTH
## Where the body's position comes from.
var position: Source = Source.BOTH
## Whether arms reach for tracked controllers.
var reaches: bool = true
## Whether nods and turns of the head are used to find how the headset is worn.
var finds_mount: bool = true
## How the headset is worn.
var mount: HeadMount = HeadMount.new()
## The turn of the whole body.
var heading: HeadingCorrection = HeadingCorrection.new()

var _joints: PackedVector3Array = PackedVector3Array()
var _neck_m: float = 0.08
var _lengths: Vector2 = Vector2(0.3, 0.26)
var _arms: Array[ArmReach] = [ArmReach.new(0), ArmReach.new(1)]
var _steady: SteadyVector = SteadyVector.new()
var _soft: SoftChange = SoftChange.new()
var _time_usec: int = 0
var _step_s: float = 0.0
var _had_place: bool = false
var _had_head: bool = false
var _had_pivot: bool = false
var _raw_root: Vector3 = Vector3.ZERO
var _travel: Vector3 = Vector3.ZERO
var _place: Vector3 = Vector3.ZERO
var _head: Quaternion = Quaternion.IDENTITY
var _last_eyes: Vector3 = Vector3.ZERO
var _last_head: Quaternion = Quaternion.IDENTITY
var _last_chest: Quaternion = Quaternion.IDENTITY
var _next_mount_s: float = 0.0
var _solve_in: int = _SOLVE_MOMENTS
var _hips: Transform3D = Transform3D.IDENTITY
var _has_hips: bool = false


## Takes the wearer's size.
func _init(p_size: BodySize = BodySize.new()) -> void:
	set_figure(ShownFigure.of_size(p_size))


## Takes the body that is shown.
func set_figure(p_figure: ShownFigure) -> void:
	_joints = p_figure.joints
	var pivot: float = p_figure.eye_height + HeadMount.USUAL_LEVER.y
	_neck_m = clampf(pivot - _joints[Limbs.HEAD].y, 0.0, 0.15)
	_lengths.x = _joints[Limbs.LEFT_UPPER_ARM].distance_to(_joints[Limbs.LEFT_LOWER_ARM])
	_lengths.y = _joints[Limbs.LEFT_LOWER_ARM].distance_to(_joints[Limbs.LEFT_HAND])


## The tracking space or the suit's heading was reset: the next sample is taken at once.
func recentre() -> void:
	heading.restart()
	_restart_place()


## The tracking space was turned by an angle about +Y, rad: what is known of the suit stays known.
func turn(p_angle: float) -> void:
	heading.turn(p_angle)
	_restart_place()


## Corrects a sample, in place, by what the headset says of the same moment.
func apply(p_sample: PoseSample, p_frame: XrFrame) -> void:
	_begin(p_sample)
	var head: Quaternion = p_frame.head_turn() if p_frame.has_head else _last_head
	_note_motion(p_frame, head)
	_correct_heading(p_sample, p_frame, head)
	_turn_body(p_sample)
	_set_head(p_sample, p_frame, head)
	_set_place(p_sample, p_frame, head)
	if reaches:
		for side: int in 2:
			_reach(p_sample, p_frame, side)
	_time_usec = p_sample.time_usec


## The turn of the body about the vertical, rad.
func correction() -> float:
	return heading.angle if orientation != Source.SUIT else 0.0


func _restart_place() -> void:
	_steady.restart()
	_soft.clear()
	_had_place = false
	_had_head = false
	_has_hips = false
	_time_usec = 0
	for arm: ArmReach in _arms:
		arm.restart()


func _begin(p_sample: PoseSample) -> void:
	_step_s = (p_sample.time_usec - _time_usec) / 1e6
	if _time_usec == 0 or _step_s < 0.0 or _step_s > MAX_STEP_S:
		_step_s = 0.0
		# The suit may have been put on anew meanwhile: its position has no history.
		_raw_root = p_sample.root
		_travel = Rotations.yaw(correction()) * Vector3(p_sample.root.x, 0.0, p_sample.root.z)
	_soft.advance(_step_s)


func _note_motion(p_frame: XrFrame, p_head: Quaternion) -> void:
	if p_frame.has_head and _had_head and _step_s > 0.0:
		var turn: float = Rotations.yaw_of(p_head * _last_head.inverse()) / _step_s
		var moved: Vector3 = p_frame.head.origin - _last_eyes
		var speed: float = (
			Vector2(moved.x, moved.z).length() / _step_s if p_frame.has_place else 0.0
		)
		heading.note_motion(speed, turn, _step_s)
	if p_frame.has_head:
		_last_head = p_head
		_last_eyes = p_frame.head.origin


func _correct_heading(p_sample: PoseSample, p_frame: XrFrame, p_head: Quaternion) -> void:
	if orientation == Source.SUIT:
		return
	var measured: float = NAN
	if p_frame.has_head and absf((p_head * Vector3.BACK).y) < sin(STEEP):
		var limb: Quaternion = mount.head_of(p_head)
		if orientation == Source.BOTH and _knows_head(p_sample):
			heading.filter_s = HeadingCorrection.FILTER_S
			measured = Rotations.yaw_of(limb * p_sample.orientation(Limbs.HEAD).inverse())
		else:
			# A head looks where the chest does only on the whole.
			heading.filter_s = CHEST_FILTER_S
			var chest: Quaternion = p_sample.orientation(Limbs.CHEST)
			measured = angle_difference(Rotations.facing_of(chest), Rotations.facing_of(limb))
		if finds_mount and not mount.is_solved and p_frame.has_place:
			_collect(p_sample, p_frame, p_head)
	heading.advance(measured, _step_s)


static func _knows_head(p_sample: PoseSample) -> bool:
	if p_sample.details == null or p_sample.details.measured.size() != Limbs.COUNT:
		return true
	return p_sample.details.measured[Limbs.HEAD] != 0


## Keeps moments in which only the head moves; when they suffice, the mount is solved.
func _collect(p_sample: PoseSample, p_frame: XrFrame, p_head: Quaternion) -> void:
	if not _knows_head(p_sample):
		return
	var chest: Quaternion = p_sample.orientation(Limbs.CHEST)
	_next_mount_s -= _step_s
	if _next_mount_s > 0.0:
		return
	_next_mount_s = _MOUNT_S
	if Rotations.between(chest, _last_chest) > _STILL * _MOUNT_S:
		mount.clear()
	_last_chest = chest
	mount.add(p_head, p_frame.head.origin, p_sample.orientation(Limbs.HEAD))
	_solve_in -= 1
	if _solve_in <= 0:
		_solve_in = _SOLVE_MOMENTS
		mount.solve()


func _turn_body(p_sample: PoseSample) -> void:
	var angle: float = correction()
	# The way goes on in the new heading from where the wearer is: about the wearer's own vertical.
	var step: Vector3 = p_sample.root - _raw_root
	_raw_root = p_sample.root
	_travel += Rotations.yaw(angle) * Vector3(step.x, 0.0, step.z)
	p_sample.root = Vector3(_travel.x, p_sample.root.y, _travel.z)
	var turn: Quaternion = Rotations.yaw(angle)
	if p_sample.details != null:
		p_sample.details = _turned_details(p_sample.details, turn)
	if angle == 0.0:
		return
	p_sample.turn_limbs(turn)


## Details of a turned body, without positions, which change. They are new: a source may still use
## its own.
static func _turned_details(p_details: MotionDetails, p_turn: Quaternion) -> MotionDetails:
	var turned: MotionDetails = MotionDetails.new()
	turned.counter = p_details.counter
	turned.contacts = p_details.contacts
	turned.measured = p_details.measured
	turned.rates = p_details.rates.duplicate()
	for at: int in turned.rates.size():
		turned.rates[at] = p_turn * turned.rates[at]
	for joint: int in p_details.joints:
		turned.joints[joint] = p_turn * p_details.joints[joint]
	return turned


func _set_head(p_sample: PoseSample, p_frame: XrFrame, p_head: Quaternion) -> void:
	if orientation == Source.SUIT:
		return
	var wanted: Quaternion = p_sample.orientation(Limbs.HEAD)
	if p_frame.has_head:
		wanted = mount.head_of(p_head)
	if p_frame.has_head != _had_head and _step_s > 0.0:
		_soft.add_turn(_head, wanted)
	_had_head = p_frame.has_head
	if not p_frame.has_head and _soft.turn == Quaternion.IDENTITY:
		_head = wanted
		return
	_head = (_soft.turn * wanted).normalized()
	p_sample.set_orientation(Limbs.HEAD, _head)
	_spare_neck(p_sample)
	if p_sample.details != null and p_sample.details.joints.has(XRBodyTracker.JOINT_NECK):
		var neck: Quaternion = p_sample.orientation(Limbs.CHEST).slerp(_head, 0.5)
		p_sample.details.joints[XRBodyTracker.JOINT_NECK] = neck


## A head that is turned further than a neck goes takes chest and spine along.
func _spare_neck(p_sample: PoseSample) -> void:
	var chest: Quaternion = p_sample.orientation(Limbs.CHEST)
	var bend: Vector3 = Rotations.vector(_head * chest.inverse())
	var excess: float = bend.length() - NECK_RANGE
	if excess <= 0.0:
		return
	var axis: Vector3 = bend.normalized()
	p_sample.set_orientation(Limbs.CHEST, Quaternion(axis, excess) * chest)
	var spine: Quaternion = p_sample.orientation(Limbs.SPINE)
	p_sample.set_orientation(Limbs.SPINE, Quaternion(axis, excess / 2.0) * spine)


func _set_place(p_sample: PoseSample, p_frame: XrFrame, p_head: Quaternion) -> void:
	var from_suit: Vector3 = p_sample.root
	var is_placed: bool = p_frame.has_place and position != Source.SUIT
	var hips_known: bool = p_frame.has_pins[XrFrame.Pin.WAIST] != 0 and position != Source.SUIT
	var wanted: Vector3 = from_suit
	if is_placed:
		wanted = mount.pivot_of(p_head, p_frame.head.origin) - _chain(p_sample)
		if hips_known:
			_learn_hips(p_sample, p_frame, wanted)
	elif hips_known:
		if not _has_hips:
			# Never seen together with a headset's position: the tracker is as high as the hips.
			var pin: Vector3 = p_frame.pins[XrFrame.Pin.WAIST].origin
			_learn_hips(p_sample, p_frame, Vector3(pin.x, from_suit.y, pin.z))
		wanted = p_frame.pins[XrFrame.Pin.WAIST] * _hips.origin
		is_placed = true
	if is_placed:
		_settle(p_frame, p_head, p_sample, wanted, from_suit)
	elif _had_place:
		# Lost: the suit goes on from here.
		_travel += Vector3(_place.x - from_suit.x, 0.0, _place.z - from_suit.z)
		_soft.clear()
		_soft.add_jump(Vector3(0.0, _place.y, 0.0), Vector3(0.0, from_suit.y, 0.0))
		p_sample.root = Vector3(_travel.x, from_suit.y, _travel.z) + _soft.offset
	else:
		p_sample.root = from_suit + _soft.offset
	_had_place = is_placed
	_place = p_sample.root


## Puts the hips below the headset, without the noise of the suit.
func _settle(
	p_frame: XrFrame, p_head: Quaternion, p_sample: PoseSample, p_wanted: Vector3, p_suit: Vector3
) -> void:
	var base: Vector3 = p_suit
	if position == Source.HMD and p_frame.has_place:
		base = mount.pivot_of(p_head, p_frame.head.origin)
	elif position == Source.HMD:
		base = Vector3.ZERO
	var changes: bool = not _had_place or p_frame.has_place != _had_pivot
	_had_pivot = p_frame.has_place
	if changes:
		_steady.restart()
	_steady.advance(p_wanted - base, _step_s)
	var place: Vector3 = base + _steady.value
	if changes and _step_s > 0.0 and _time_usec != 0:
		_soft.add_jump(_place, place)
	p_sample.root = place + _soft.offset


## Where a tracker at the waist has the hips, while the headset knows them.
func _learn_hips(p_sample: PoseSample, p_frame: XrFrame, p_hips: Vector3) -> void:
	var local: Vector3 = p_frame.pins[XrFrame.Pin.WAIST].affine_inverse() * p_hips
	if not _has_hips:
		_hips = Transform3D(Basis(p_sample.orientation(Limbs.ROOT)), local)
		_has_hips = true
	else:
		_hips.origin = _hips.origin.lerp(local, clampf(_step_s / 2.0, 0.0, 1.0))


## From the hips to the pivot of the neck, m.
func _chain(p_sample: PoseSample) -> Vector3:
	var chain: Vector3 = _link(p_sample, Limbs.ROOT, Limbs.SPINE)
	chain += _link(p_sample, Limbs.SPINE, Limbs.CHEST)
	chain += _link(p_sample, Limbs.CHEST, Limbs.HEAD)
	var chest: Quaternion = p_sample.orientation(Limbs.CHEST)
	var neck: Quaternion = chest.slerp(p_sample.orientation(Limbs.HEAD), 0.5)
	return chain + neck * Vector3(0.0, _neck_m, 0.0)


func _link(p_sample: PoseSample, p_limb: int, p_next: int) -> Vector3:
	return p_sample.orientation(p_limb) * (_joints[p_next] - _joints[p_limb])


func _reach(p_sample: PoseSample, p_frame: XrFrame, p_side: int) -> void:
	var arm: int = Limbs.LEFT_UPPER_ARM + 3 * p_side
	var shoulder: Vector3 = p_sample.root + _link(p_sample, Limbs.ROOT, Limbs.SPINE)
	shoulder += _link(p_sample, Limbs.SPINE, Limbs.CHEST)
	shoulder += _link(p_sample, Limbs.CHEST, arm)
	var is_tracked: bool = p_frame.has_hands[p_side] != 0 and _had_place
	_arms[p_side].apply(
		p_sample, shoulder, p_frame.hands[p_side].origin, is_tracked, _lengths, _step_s
	)
