class_name WalkedLegs
extends MotionSource
## One body of two: trunk, head and arms of a wearer's source, legs and travel of somebody who walks
## by keys or a stick. So a small room, or a chair, is enough to go far.
##
## While nothing is wished the wearer's own motion is passed on, moved and turned by the travel so
## far. While something is, legs, feet and hips are a walker's ([WalkerPose]); both are blended over
## in [constant BLEND_S]. It is sent as any worn motion: the server knows of no walker here.
##
## Only while somebody walks are samples taken in physics frames; at rest they have the exact times
## of the [MotionSampler]'s thread.

## Time in which the walker's legs take over, and the own ones again, s.
const BLEND_S: float = 0.3
## Speed of the hips in the middle of a blend, at most, m/s: who lies takes longer to stand.
const _RISE: float = 2.0
## Speed beyond which it goes on with the walker's legs, which slow down by steps, m/s.
const _WALKS: float = 1.7
## Speed below which it stands, m/s.
const _STANDS: float = 0.05
## How long a turn counts as wished after it was, s: a mouse turns by fits.
const _TURN_S: float = 0.15
## Time constant with which the walker's heading follows the wearer's hips, s.
const _FACING_S: float = 0.6
## Longest time that a sample is after the last one, and of a tick, s.
const _MAX_S: float = 0.1
const _TICK_S: float = 1.0 / 40.0
## Two samples that are closer are one, s.
const _MIN_S: float = 0.002
const _WALKED: Array[int] = [
	Limbs.HIPS,
	Limbs.LEFT_UPPER_LEG,
	Limbs.LEFT_LOWER_LEG,
	Limbs.RIGHT_UPPER_LEG,
	Limbs.RIGHT_LOWER_LEG,
	Limbs.LEFT_FOOT,
	Limbs.RIGHT_FOOT,
]

## Where trunk, head and arms come from.
var first: MotionSource = null
## What hands wish: [code]func(delta_s: float) -> WalkerInput[/code]; not valid: nothing.
var read_input: Callable = Callable()
## Where the mover is.
var ground: TravelFrame = TravelFrame.new()
## The person's own frame in the world, as the server has the body now.
var frame: Transform3D = Transform3D.IDENTITY
## Whether [member frame] is known: without it nobody walks.
var has_frame: bool = false
## Where ahead is for the stick in the wearer's own frame, such as where the head looks: the angle
## about +Y, rad, 0 towards +Z; NAN: where the hips face.
var ahead: float = NAN
## Whether who sits on a real chair stands on the walker's legs; not in a seat of the world.
var raises_seated: bool = true

var _pose: WalkerPose = WalkerPose.new()
var _sitting: SittingLegs = SittingLegs.new()
# From the wearer's motion to what is passed on: turned, rad, then moved, m.
var _turned: float = 0.0
var _moved: Vector3 = Vector3.ZERO
# How much of the legs is the walker's, 0 to 1.
var _share: float = 0.0
# Whether the mover goes, be it only to a stop.
var _goes: bool = false
var _turning_s: float = 0.0
# Somebody wants to walk, or has not stopped: the main thread is to sample.
var _is_called: bool = false
# Where the wearer's hips face in their own frame, rad; NAN before the first sample.
var _facing: float = NAN
# The heading that the last input had, rad.
var _heading: float = NAN
var _last_usec: int = -1
var _sits: bool = false
# From the wearer's motion to the last sample: for who looks out of it.
var _travel: Transform3D = Transform3D.IDENTITY
# Samples are taken in either thread, all else is the main thread's.
var _mutex: Mutex = Mutex.new()


## Takes the source that is carried.
func _init(p_first: MotionSource) -> void:
	first = p_first
	error = p_first.error


func needs_world() -> bool:
	return _is_called or first.needs_world()


func get_hip_height() -> float:
	return first.get_hip_height()


func get_limb_lengths() -> PackedFloat32Array:
	return first.get_limb_lengths()


func get_body() -> BodySize:
	return first.get_body()


func describe() -> String:
	return first.describe() + ", legs by keys or a stick"


## The body that the server has made: height of its hips, m, and its joints.
func embody(p_hip_height: float, p_joints: PersonSkeleton) -> void:
	_mutex.lock()
	ground.scale = p_hip_height / get_hip_height() if p_hip_height > 0.0 else 1.0
	_pose.set_body(p_hip_height, p_joints)
	_mutex.unlock()


## The legs go on by a set of the person's own; null: by that of everybody.
func use_set(p_set: WalkerSet) -> void:
	_mutex.lock()
	_pose.use_set(p_set)
	_mutex.unlock()


## Looks whether hands wish something, while nobody walks: call it in each frame of a length, s.
func listen(p_delta_s: float) -> void:
	if _is_called or not read_input.is_valid():
		return
	var read: WalkerInput = read_input.call(p_delta_s) as WalkerInput
	var turns: bool = not is_nan(_heading) and read.heading != _heading
	var wishes: bool = read.wish.length() > _STANDS or read.stance != WalkerMover.STAND
	if has_frame and ground.is_entered():
		_is_called = turns or wishes or (raises_seated and _sits)
	if not _is_called:
		_heading = read.heading


## Begins anew, without any travel: another server.
func restart() -> void:
	_mutex.lock()
	has_frame = false
	_is_called = false
	_turned = 0.0
	_moved = Vector3.ZERO
	_share = 0.0
	_goes = false
	_travel = Transform3D.IDENTITY
	_mutex.unlock()


## From the space that the wearer is in to the person's own frame in the world's size, m.
func travel() -> Transform3D:
	_mutex.lock()
	var moved: Transform3D = Transform3D(_travel.basis, _travel.origin * ground.scale)
	_mutex.unlock()
	return moved


## How fast the stick carries the wearer in the world, m/s.
func velocity() -> Vector3:
	return ground.mover.get_velocity() if _goes else Vector3.ZERO


## How much of the legs is the walker's: 0 none, 1 all.
func share() -> float:
	return smoothstep(0.0, 1.0, _share)


func _read(p_time_usec: int) -> PoseSample:
	_mutex.lock()
	var own: PoseSample = first.sample(p_time_usec)
	error = first.error
	var made: PoseSample = _pass_on(own) if own != null else null
	_mutex.unlock()
	return made


func _pass_on(p_own: PoseSample) -> PoseSample:
	var moment: int = p_own.time_usec
	var passed_s: float = (moment - _last_usec) / 1e6 if _last_usec >= 0 else 0.0
	if _last_usec >= 0 and passed_s < _MIN_S and passed_s > -1.0:
		# Physics frames of a slow display, or the other thread had it.
		return null
	passed_s = clampf(passed_s, 0.0, _MAX_S)
	_last_usec = moment
	_face(p_own, passed_s)
	_sits = _sitting.advance(p_own, passed_s)
	var walked: PoseSample = null
	if _is_called and passed_s > 0.0 and OS.get_thread_caller_id() == OS.get_main_thread_id():
		walked = _walk(p_own, passed_s)
	var made: PoseSample = _carried(p_own)
	if walked != null:
		_set_on(made, p_own, walked)
	_travel = Transform3D(Basis(Vector3.UP, _turned), made.root - _turn() * p_own.root)
	return made


## Follows where the wearer's hips face.
func _face(p_own: PoseSample, p_passed_s: float) -> void:
	var now: float = Rotations.facing_of(p_own.orientation(Limbs.HIPS))
	if is_nan(_facing):
		_facing = now
	_facing += angle_difference(_facing, now) * (1.0 - exp(-p_passed_s / _FACING_S))


## Goes on by some time. Returns the walker's pose in the person's own frame, or null while the legs
## are the wearer's own.
func _walk(p_own: PoseSample, p_passed_s: float) -> PoseSample:
	if not has_frame or not ground.is_entered():
		_share = 0.0
		_goes = false
		_is_called = false
		return null
	var input: WalkerInput = _read_wish(p_own, p_passed_s)
	var asks: bool = _asks(input)
	if not _goes and not asks:
		_is_called = false
		return null
	if not _goes:
		var hips: Vector3 = _turn() * p_own.root + _moved
		_goes = ground.begin(frame, hips, _moved.y, input.heading)
		if not _goes:
			return null
		_pose.restart(ground.mover)
	else:
		ground.follow(frame)
		if ground.is_down:
			# Nobody walks who has fallen.
			input.wish = Vector2.ZERO
			asks = false
	input.heading = ground.heading() + _turned + _facing
	var before: Vector3 = ground.place()
	var walked: PoseSample = null
	var ticks: int = maxi(ceili(p_passed_s / _TICK_S), 1)
	for _tick: int in ticks:
		ground.tick(input, p_passed_s / ticks)
		walked = _pose.advance(ground.mover, input, p_passed_s / ticks, ground.shift)
	_bring_into_frame(walked)
	_moved += ground.place() - before
	var apart: float = (walked.root - _turn() * p_own.root - _moved).length()
	var blend_s: float = maxf(BLEND_S, 1.5 * apart / _RISE)
	_share = move_toward(_share, 1.0 if asks else 0.0, p_passed_s / blend_s)
	_goes = _share > 0.0 or ground.mover.get_velocity().length() > _STANDS
	if _share == 1.0:
		# The own legs will stand where the walker does.
		var hips: Vector3 = walked.root - _turn() * p_own.root
		_moved = Vector3(hips.x, ground.place().y, hips.z)
	return walked if _share > 0.0 else null


## What is wished now, of what the samples can carry: in the world, ahead being where the wearer's
## hips face. A turn turns the wearer about the own hips.
func _read_wish(p_own: PoseSample, p_passed_s: float) -> WalkerInput:
	var wish: WalkerInput = WalkerInput.new()
	if not read_input.is_valid():
		return wish
	var read: WalkerInput = read_input.call(p_passed_s) as WalkerInput
	if is_nan(_heading):
		_heading = read.heading
	var turn: float = angle_difference(_heading, read.heading)
	_heading = read.heading
	_turning_s = _TURN_S if turn != 0.0 else maxf(_turning_s - p_passed_s, 0.0)
	var hips: Vector3 = _turn() * p_own.root
	_turned = wrapf(_turned + turn, -PI, PI)
	_moved += hips - _turn() * p_own.root
	var base: float = (ground.heading() if _goes else _heading_of(frame)) + _turned + _facing
	wish.heading = base
	# From the input's heading to the wearer's: both are angles from +Z to +X.
	var towards: float = base if is_nan(ahead) else base - _facing + ahead
	wish.wish = read.wish.rotated(read.heading - towards)
	wish.stance = mini(read.stance, WalkerMover.CROUCH) as WalkerMover.Stance
	return wish


## Whether the walker's legs are asked for.
func _asks(p_wish: WalkerInput) -> bool:
	if p_wish.wish.length() > _STANDS or _turning_s > 0.0 or p_wish.stance != WalkerMover.STAND:
		return true
	if _sits and raises_seated:
		return true
	if not _goes:
		return false
	var mover: WalkerMover = ground.mover
	var is_up: bool = mover.is_grounded() and mover.get_stance() == WalkerMover.STAND
	return not is_up or mover.get_velocity().length() > _WALKS


## The wearer's motion, turned and moved by the travel so far.
func _carried(p_own: PoseSample) -> PoseSample:
	var made: PoseSample = PoseSample.new()
	made.time_usec = p_own.time_usec
	if _turned == 0.0 and _moved == Vector3.ZERO and _share == 0.0:
		made.orientations = p_own.orientations.duplicate()
		made.root = p_own.root
		made.details = p_own.details
		return made
	var turn: Quaternion = _turn()
	for limb: int in Limbs.COUNT:
		made.set_orientation(limb, (turn * p_own.orientation(limb)).normalized())
	made.root = turn * p_own.root + _moved
	if p_own.details != null:
		made.details = MotionDetails.new()
		made.details.counter = p_own.details.counter
		made.details.measured = p_own.details.measured
		if _share == 0.0:
			made.details.contacts = p_own.details.contacts
		for joint: int in p_own.details.joints:
			made.details.joints[joint] = (turn * p_own.details.joints[joint]).normalized()
	return made


## Puts a carried motion onto the walker's legs, as far as they are in charge.
func _set_on(r_made: PoseSample, p_own: PoseSample, p_walked: PoseSample) -> void:
	var part: float = share()
	r_made.root = r_made.root.lerp(p_walked.root, part)
	for limb: int in _WALKED:
		var own: Quaternion = r_made.orientation(limb)
		r_made.set_orientation(limb, own.slerp(p_walked.orientation(limb), part).normalized())
	if p_own.details != null:
		r_made.details.joints.erase(XRBodyTracker.JOINT_LEFT_TOES)
		r_made.details.joints.erase(XRBodyTracker.JOINT_RIGHT_TOES)


## From the world to the person's own frame.
func _bring_into_frame(r_pose: PoseSample) -> void:
	r_pose.root = ground.to_frame(r_pose.root + ground.shift)
	var back: Quaternion = ground.frame.basis.get_rotation_quaternion().inverse()
	for limb: int in _WALKED:
		r_pose.set_orientation(limb, (back * r_pose.orientation(limb)).normalized())


func _turn() -> Quaternion:
	return Rotations.yaw(_turned)


static func _heading_of(p_frame: Transform3D) -> float:
	return Rotations.yaw_of(p_frame.basis.get_rotation_quaternion())
