class_name XrBody
extends RefCounted
## A plausible whole body of somebody who wears a headset and holds controllers, and no suit.
##
## From the headset: head, the lean of the trunk, the height of the hips. From the hands: arms, and
## where the chest faces. Feet take steps ([StepPlanner]). Trackers on the body pin what they are
## worn on: waist, chest and feet after they were seen once on somebody who stands upright, knees
## and elbows by the side to which they are. Frame: the wearer's, see [XrFrame].

## Time constants, s: of the heading of the body, of lean, of the velocity, of an arm that begins or
## ceases to be tracked.
const YAW_S: float = 0.25
const LEAN_S: float = 0.15
const VELOCITY_S: float = 0.15
const ARM_S: float = 0.3
## Turn of the head from which on the body goes along, rad.
const FREE_YAW: float = deg_to_rad(25.0)
## Distance of the head ahead of the feet from which on it is a lean, m.
const FREE_LEAN_M: float = 0.1
## How far the hips go back in a lean: the part of the head's movement that remains.
const LEAN_REACH: float = 0.65
## Part of the lean that a head which comes down makes at least.
const CROUCH_LEAN: float = 0.42
## Where a wrist hangs, seen from the chest of somebody of a height of 1 m, on the left.
const HANGING: Vector3 = Vector3(0.155, -0.31, 0.045)
## Shares of the lean: hips, spine, chest.
const SHARES: Vector3 = Vector3(0.75, 1.0, 1.1)
## Height of the hips' middle of somebody who lies, m.
const LYING_M: float = 0.12
## Range of an ankle, rad, about the axes of the reset pose.
const ANKLE_MIN: Vector3 = Vector3(-0.7, -0.8, -0.5)
const ANKLE_MAX: Vector3 = Vector3(0.9, 0.8, 0.5)
## Height above standing from which on a head is in the air, m.
const JUMP_M: float = 0.04

## Whether the wearer sits on a chair.
var is_seated: bool = false
## Where the eyes are on the head.
var mount: HeadMount = HeadMount.new()
## The feet.
var steps: StepPlanner = null
## What trackers say.
var pins: XrPins = XrPins.new()

var _size: BodySize = null
var _joints: PackedVector3Array = PackedVector3Array()
var _neck_m: float = 0.08
var _trunk_m: float = 0.5
var _is_placed: bool = false
var _yaw: float = 0.0
var _lean: Vector2 = Vector2.ZERO
var _velocity: Vector3 = Vector3.ZERO
var _base: Vector3 = Vector3.ZERO
var _chest: Quaternion = Quaternion.IDENTITY
var _weights: PackedFloat32Array = [0.0, 0.0]
var _wrists: PackedVector3Array = [Vector3.ZERO, Vector3.ZERO]
var _turns: Array[Quaternion] = [Quaternion.IDENTITY, Quaternion.IDENTITY]
var _legs_usec: int = 0
var _poles: PackedVector3Array = [Vector3.DOWN, Vector3.DOWN]


## Takes the wearer's size.
func _init(p_size: BodySize) -> void:
	set_size(p_size)


## Changes the wearer's size.
func set_size(p_size: BodySize) -> void:
	_size = p_size
	set_figure(ShownFigure.of_size(p_size))


## Takes the body that is shown.
func set_figure(p_figure: ShownFigure) -> void:
	_joints = p_figure.joints
	_neck_m = maxf(p_figure.eye_height + HeadMount.USUAL_LEVER.y - _joints[Limbs.HEAD].y, 0.0)
	_trunk_m = _joints[Limbs.HEAD].y - _joints[Limbs.HIPS].y
	if steps == null:
		steps = StepPlanner.new(_joints[Limbs.LEFT_UPPER_LEG].x)


## Forgets where everything was: the tracking space was moved.
func restart() -> void:
	_is_placed = false
	_weights.fill(0.0)


## The pose under a frame, whose head has to be tracked, a time after the last one, s.
func solve(p_frame: XrFrame, p_step_s: float) -> PoseSample:
	var head: Quaternion = mount.head_of(p_frame.head_turn())
	_follow(p_frame, head, p_step_s)
	var pose: PoseSample = PoseSample.new()
	pose.time_usec = p_frame.time_usec
	pose.set_orientation(Limbs.HEAD, head)
	_set_trunk(pose, p_frame, head, p_step_s)
	for side: int in 2:
		_set_arm(pose, p_frame, side, p_step_s)
	_set_legs(pose, p_frame)
	pins.learn(p_frame, pose, _yaw, _joints)
	return pose


## Which way a head faces, rad, also of somebody who looks at the ground or at the sky.
static func yaw_of(p_head: Quaternion) -> float:
	var ahead: Vector3 = p_head * Vector3.BACK
	var level: Vector3 = ahead - (p_head * Vector3.UP) * ahead.y
	return atan2(level.x, level.z)


## Heading, position and velocity of the wearer.
func _follow(p_frame: XrFrame, p_head: Quaternion, p_step_s: float) -> void:
	var pivot: Vector3 = mount.pivot_of(p_frame.head_turn(), p_frame.head.origin)
	var looks: float = yaw_of(p_head)
	if not _is_placed:
		_yaw = looks
		_chest = Rotations.yaw(_yaw)
	var neck: Quaternion = _chest.slerp(p_head, 0.5)
	var base: Vector3 = pivot - neck * Vector3(0.0, _neck_m, 0.0)
	if not _is_placed:
		_base = base
		_velocity = Vector3.ZERO
		_lean = Vector2.ZERO
		steps.restart(base, _yaw)
	if p_step_s > 0.0:
		var velocity: Vector3 = ((base - _base) / p_step_s).limit_length(6.0)
		_velocity += (velocity - _velocity) * _part(p_step_s, VELOCITY_S)
	_base = base
	_is_placed = true
	_turn(p_frame, looks, p_step_s)


func _turn(p_frame: XrFrame, p_looks: float, p_step_s: float) -> void:
	# Both hands to one side mean that the chest has turned there.
	var wanted: float = p_looks
	if p_frame.has_hands[0] != 0 and p_frame.has_hands[1] != 0:
		var hands: Vector3 = (p_frame.hands[0].origin + p_frame.hands[1].origin) / 2.0 - _base
		var ahead: Vector3 = Rotations.yaw(p_looks) * Vector3.BACK * 0.35
		var there: Vector3 = Vector3(hands.x, 0.0, hands.z).limit_length(0.5)
		if there.dot(ahead) > -0.03:
			wanted = atan2(ahead.x + there.x, ahead.z + there.z)
	var off: float = angle_difference(_yaw, wanted)
	# Small turns of the head are the neck's; a walker faces where the path leads.
	var free: float = FREE_YAW * clampf(1.0 - _velocity.length(), 0.0, 1.0)
	off = signf(off) * maxf(absf(off) - free, 0.0) + off * 0.15
	_yaw = wrapf(_yaw + off * _part(p_step_s, YAW_S), -PI, PI)
	var most: float = deg_to_rad(85.0)
	_yaw = p_looks - clampf(angle_difference(_yaw, p_looks), -most, most)


func _set_trunk(r_pose: PoseSample, p_frame: XrFrame, p_head: Quaternion, p_step_s: float) -> void:
	var wanted: Vector2 = _wanted_lean(p_head)
	_lean += (wanted - _lean) * (_part(p_step_s, LEAN_S) if p_step_s > 0.0 else 1.0)
	var facing: Quaternion = Rotations.yaw(_yaw)
	var parts: Array[float] = [SHARES.x, SHARES.y, SHARES.z]
	for limb: int in [Limbs.HIPS, Limbs.SPINE, Limbs.CHEST]:
		var tilt: Vector3 = Vector3(_lean.x, 0.0, -_lean.y) * parts[limb]
		r_pose.set_orientation(limb, facing * Rotations.from_vector(tilt))
	# A chest goes along with the head by a part.
	var turn: float = angle_difference(_yaw, yaw_of(p_head))
	var chest: Quaternion = Rotations.yaw(turn * 0.3) * r_pose.orientation(Limbs.CHEST)
	r_pose.set_orientation(Limbs.CHEST, pins.chest(p_frame, chest))
	r_pose.set_orientation(Limbs.SPINE, Rotations.yaw(turn * 0.15) * r_pose.orientation(1))
	r_pose.root = _base - _chain(r_pose)
	if pins.knows_hips(p_frame):
		_pin_hips(r_pose, p_frame)
	_chest = r_pose.orientation(Limbs.CHEST)
	_spare_neck(r_pose, p_head)


## Forward and to the left, rad.
func _wanted_lean(p_head: Quaternion) -> Vector2:
	var down: float = clampf(_joints[Limbs.HEAD].y - _base.y, 0.0, _trunk_m * 1.6)
	# With straight legs the head comes down by so much at this lean.
	var most: float = acos(clampf(1.0 - down / _trunk_m, -0.2, 1.0))
	var off: Vector3 = _base - steps.middle() - _velocity * 0.12
	var level: Vector3 = Rotations.yaw(-_yaw) * Vector3(off.x, 0.0, off.z)
	var ahead: float = signf(level.z) * maxf(absf(level.z) - FREE_LEAN_M, 0.0)
	var lean: float = asin(clampf(ahead / (LEAN_REACH * _trunk_m), -0.3, 0.97))
	# A head that comes down means a bend if it looks down, and a crouch if it looks ahead.
	var looks_down: float = clampf(-(p_head * Vector3.BACK).y, 0.0, 1.0)
	var least: float = most * (CROUCH_LEAN + 0.25 * looks_down)
	# Hips are not below the floor: who lies has the trunk level.
	var low: float = acos(clampf((_base.y - LYING_M) / _trunk_m, 0.0, 1.0))
	if low > most * 0.8 and (p_head * Vector3.BACK).y > 0.5:
		return Vector2(-low, 0.0)
	least = maxf(least, low)
	most = maxf(most, low)
	if is_seated:
		return Vector2(clampf(lean, -0.2, 0.9), 0.0)
	var side: float = signf(level.x) * maxf(absf(level.x) - FREE_LEAN_M, 0.0)
	var tilt: float = asin(clampf(side / (LEAN_REACH * _trunk_m), -0.5, 0.5))
	return Vector2(clampf(lean, least if lean > -0.05 else -0.25, maxf(most, 0.05)), tilt)


## Hips at their tracker; the trunk reaches from there to the head.
func _pin_hips(r_pose: PoseSample, p_frame: XrFrame) -> void:
	var hips: Transform3D = pins.hips(p_frame)
	r_pose.root = hips.origin
	r_pose.set_orientation(Limbs.HIPS, hips.basis.get_rotation_quaternion())
	for _round: int in 3:
		var off: Quaternion = TwoBone.turn_between(
			TwoBone.direction(r_pose.root, r_pose.root + _chain(r_pose)),
			TwoBone.direction(r_pose.root, _base)
		)
		for limb: int in [Limbs.SPINE, Limbs.CHEST]:
			r_pose.set_orientation(limb, (off * r_pose.orientation(limb)).normalized())
	r_pose.root = _base - _chain(r_pose)


func _spare_neck(r_pose: PoseSample, p_head: Quaternion) -> void:
	var bend: Vector3 = Rotations.vector(_chest.inverse() * p_head)
	var excess: float = bend.length() - HeadFusion.NECK_RANGE
	if excess > 0.0:
		_chest = (_chest * Quaternion(bend.normalized(), excess)).normalized()
		r_pose.set_orientation(Limbs.CHEST, _chest)
		r_pose.root = _base - _chain(r_pose)


func _set_arm(r_pose: PoseSample, p_frame: XrFrame, p_side: int, p_step_s: float) -> void:
	var out: float = 1.0 - 2.0 * p_side
	var limb: int = Limbs.LEFT_UPPER_ARM + 3 * p_side
	var shoulder: Vector3 = _place_of(r_pose, limb)
	var mirror: Vector3 = Vector3(out, 1.0, 1.0)
	var is_tracked: bool = p_frame.has_hands[p_side] != 0
	var rest: Vector3 = _chest * (HANGING * mirror * _size.height) + shoulder
	rest -= _chest * Vector3(out * 0.13 * _size.height, 0.0, 0.0)
	if is_tracked:
		_wrists[p_side] = p_frame.hands[p_side].origin
		_turns[p_side] = p_frame.hands[p_side].basis.get_rotation_quaternion()
	if p_step_s <= 0.0:
		_weights[p_side] = 1.0 if is_tracked else 0.0
	_weights[p_side] = move_toward(_weights[p_side], 1.0 if is_tracked else 0.0, p_step_s / ARM_S)
	var weight: float = smoothstep(0.0, 1.0, _weights[p_side])
	var hang: Quaternion = _chest * Quaternion(Vector3.BACK, -1.45 * out)
	var wrist: Vector3 = rest.lerp(_wrists[p_side], weight)
	var hand: Quaternion = hang.slerp(_turns[p_side], weight)
	var lengths: Vector2 = Vector2(_length(limb), _length(limb + 1))
	var pole: Vector3 = _elbow_side(p_side, shoulder, wrist, hand, lengths.y)
	pole = pins.pole(p_frame, XrFrame.Pin.LEFT_ELBOW + p_side, shoulder, wrist, pole)
	# Elbows swing over, they do not flip.
	_poles[p_side] = _poles[p_side].slerp(pole, _part(p_step_s, 0.06) if p_step_s > 0.0 else 1.0)
	var reached: float = TwoBone.reach(shoulder.distance_to(wrist), lengths.x, lengths.y)
	wrist = shoulder + TwoBone.direction(shoulder, wrist) * reached
	var elbow: Vector3 = TwoBone.middle(shoulder, wrist, lengths.x, lengths.y, _poles[p_side])
	LimbAxes.set_arm(r_pose, p_side, shoulder, elbow, wrist, _poles[p_side], hand)


## The side to which an elbow goes: down, out and back, and where the hand's own back points.
func _elbow_side(
	p_side: int, p_shoulder: Vector3, p_wrist: Vector3, p_hand: Quaternion, p_fore: float
) -> Vector3:
	var out: float = 1.0 - 2.0 * p_side
	var along: Vector3 = TwoBone.direction(p_shoulder, p_wrist)
	var usual: Vector3 = _chest * Vector3(out * 0.5, -0.8, -0.4)
	var behind: Vector3 = p_wrist - p_hand * Vector3(out * p_fore, 0.0, 0.0) - p_shoulder
	behind -= along * behind.dot(along)
	var pole: Vector3 = TwoBone.across(usual, along) * 0.12 + behind
	return TwoBone.across(pole, along)


func _set_legs(r_pose: PoseSample, p_frame: XrFrame) -> void:
	var step_s: float = clampf((p_frame.time_usec - _legs_usec) / 1e6, 0.0, 0.1)
	_legs_usec = p_frame.time_usec
	var up: float = maxf(r_pose.root.y - _joints[Limbs.HIPS].y - JUMP_M, 0.0)
	if up > 0.03 and not is_seated:
		steps.hang(_base, _yaw, _velocity, step_s)
	elif not is_seated:
		# Feet stand below the weight: in a lean the hips are behind it and the head before it.
		var weight: Vector3 = r_pose.root.lerp(_base, 0.5)
		steps.advance(weight + _stretched(r_pose), _yaw, _velocity, step_s)
	for side: int in 2:
		_set_leg(r_pose, p_frame, side, up)


## How far the feet of somebody who lies are from below the hips: in line with the trunk.
func _stretched(p_pose: PoseSample) -> Vector3:
	var up: Vector3 = p_pose.orientation(Limbs.HIPS) * Vector3.UP
	var stand: float = _joints[Limbs.HIPS].y
	var lies: float = smoothstep(0.5, 0.2, p_pose.root.y / stand) * smoothstep(0.5, 0.9, 1.0 - up.y)
	return Vector3(-up.x, 0.0, -up.z) * stand * 0.9 * lies


func _set_leg(r_pose: PoseSample, p_frame: XrFrame, p_side: int, p_up: float) -> void:
	var limb: int = Limbs.LEFT_UPPER_LEG + 3 * p_side
	var hip: Vector3 = _place_of(r_pose, limb)
	var yaw: float = steps.yaws[p_side]
	var foot: Quaternion = Rotations.yaw(yaw)
	var ankle: Vector3 = steps.places[p_side]
	if is_seated:
		foot = Rotations.yaw(_yaw)
		ankle = Vector3(hip.x, 0.0, hip.z) + foot * Vector3(0.0, 0.0, _length(limb) * 0.95)
	ankle.y = _joints[limb + 2].y + steps.lifts[p_side] + p_up
	var lengths: Vector2 = Vector2(_length(limb), _length(limb + 1))
	if pins.knows_foot(p_frame, p_side):
		var pinned: Transform3D = pins.foot(p_frame, p_side)
		foot = pinned.basis.get_rotation_quaternion()
		ankle = pinned.origin
	else:
		# What the leg does not reach lifts the heel; the ball stays.
		var lifted: Transform3D = _lift_heel(Transform3D(Basis(foot), ankle), hip, lengths, limb)
		foot = lifted.basis.get_rotation_quaternion()
		ankle = lifted.origin
	for _round: int in 3:
		_bend_leg(r_pose, p_frame, p_side, hip, Transform3D(Basis(foot), ankle), lengths)
		var shank: Quaternion = r_pose.orientation(limb + 1)
		var bend: Vector3 = Rotations.vector(shank.inverse() * foot)
		if bend == bend.clamp(ANKLE_MIN, ANKLE_MAX) or pins.knows_foot(p_frame, p_side):
			break
		# What the ankle does not bend lifts the heel, too: the ball stays.
		var turned: Quaternion = shank * Rotations.from_vector(bend.clamp(ANKLE_MIN, ANKLE_MAX))
		ankle += foot * _ball(limb) - turned * _ball(limb)
		foot = turned
	r_pose.set_orientation(limb + 2, foot)


func _bend_leg(
	r_pose: PoseSample,
	p_frame: XrFrame,
	p_side: int,
	p_hip: Vector3,
	p_foot: Transform3D,
	p_lengths: Vector2
) -> void:
	var along: Vector3 = TwoBone.direction(p_hip, p_foot.origin)
	var reached: float = TwoBone.reach(p_hip.distance_to(p_foot.origin), p_lengths.x, p_lengths.y)
	var ankle: Vector3 = p_hip + along * reached
	# Knees point where the hips do once these are turned in line with the leg.
	var hips: Quaternion = r_pose.orientation(Limbs.HIPS)
	var front: Vector3 = TwoBone.turn_between(hips * Vector3.DOWN, along) * (hips * Vector3.BACK)
	front += p_foot.basis.z * 0.5
	front = pins.pole(p_frame, XrFrame.Pin.LEFT_KNEE + p_side, p_hip, ankle, front)
	var knee: Vector3 = TwoBone.middle(p_hip, ankle, p_lengths.x, p_lengths.y, front)
	LimbAxes.set_leg(r_pose, p_side, p_hip, knee, ankle, front)
	LimbAxes.spare_leg(r_pose, p_side)


## From the ankle to the ball of the foot, m.
func _ball(p_limb: int) -> Vector3:
	return Vector3(0.0, -_joints[p_limb + 2].y, _size.length(&"foot_length") * 0.7)


func _lift_heel(
	p_foot: Transform3D, p_hip: Vector3, p_lengths: Vector2, p_limb: int
) -> Transform3D:
	var most: float = (p_lengths.x + p_lengths.y) * TwoBone.STRETCH
	var ball: Vector3 = _ball(p_limb)
	var found: Transform3D = p_foot
	var low: float = 0.0
	var high: float = deg_to_rad(60.0)
	if p_foot.origin.distance_to(p_hip) <= most:
		return p_foot
	for _round: int in 7:
		var pitch: float = (low + high) / 2.0
		var turned: Basis = p_foot.basis * Basis(Vector3.RIGHT, pitch)
		found = Transform3D(turned, p_foot * ball - turned * ball)
		if found.origin.distance_to(p_hip) > most:
			low = pitch
		else:
			high = pitch
	return found


## From the hips to the joint of the head, m.
func _chain(p_pose: PoseSample) -> Vector3:
	var chain: Vector3 = p_pose.orientation(0) * (_joints[1] - _joints[0])
	chain += p_pose.orientation(1) * (_joints[2] - _joints[1])
	return chain + p_pose.orientation(2) * (_joints[Limbs.HEAD] - _joints[2])


## Where a limb begins that hangs on hips or chest, m.
func _place_of(p_pose: PoseSample, p_limb: int) -> Vector3:
	if Limbs.PARENTS[p_limb] == Limbs.ROOT:
		return p_pose.root + p_pose.orientation(0) * (_joints[p_limb] - _joints[0])
	var chest: Vector3 = p_pose.root + _chain(p_pose)
	return chest + p_pose.orientation(2) * (_joints[p_limb] - _joints[Limbs.HEAD])


func _length(p_limb: int) -> float:
	return _joints[p_limb].distance_to(_joints[p_limb + 1])


static func _part(p_step_s: float, p_time_s: float) -> float:
	return 1.0 - exp(-p_step_s / p_time_s)
