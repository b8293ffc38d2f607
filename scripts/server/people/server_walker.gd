class_name ServerWalker
extends RefCounted
## Somebody who walks without a suit, at the server: makes a tick of each of the client's inputs,
## and drives the person's body by the pose that comes of it. What the client says of its own state
## is only compared.
##
## While physics has the body, which has fallen or is thrown, the walker follows the body, and goes
## on when that stands.

## How far the body may be behind, m, while the walker stands, and how much further for each m/s of
## its speed. From there on the walker gets slower away from the body; when that is so much further
## behind, m, it goes no further; beyond the last distance it is put back.
const FREE_M: float = 0.15
const FREE_S: float = 0.06
const HOLD_M: float = 0.25
const MAX_TETHER_M: float = 0.8
## By how much of itself the hold changes at once: a client hears of each change.
const _HOLD_STEP: float = 0.25
## How much longer than it is a standing leg of the body is to be at most, m
## ([member RagdollMotor.leg_push]).
const LEG_PUSH: float = 0.01
## Height of hips above the feet's ground below which somebody lies, m, and by how much they are
## raised in crawling: a belly on the ground holds the body.
const LYING_M: float = 0.4
const CRAWL_M: float = 0.05
## Speed with which the motion comes to where a walker was put, m/s.
const GLIDE: float = 5.0
## Time without an input after which the walker stands still, s.
const PATIENCE_S: float = 0.5

## The person.
var person: ServerPerson = null
## What is moved.
var mover: WalkerMover = WalkerMover.new()
## Inputs that were used, and corrections that were sent.
var inputs: int = 0
var corrections: int = 0
## Ticks in which the walker waited for the body.
var waits: int = 0
## The motion set that it goes by, see [member WalkerSet.id].
var set_id: String = WalkerSet.SHIPPED

var _pose: WalkerPose = WalkerPose.new()
var _lead: WalkerLead = WalkerLead.new()
var _input: WalkerInput = WalkerInput.new()
var _is_fresh: bool = false
var _silent_s: float = 0.0
## Number of the newest correction.
var _number: int = 0
# The last sample that the body has taken from here.
var _sample: PoseSample = null
var _crawls: bool = false
## Where the pose of the last tick had the hips, m.
var _hips: Vector3 = Vector3.ZERO
## What holds the walker back, see [method WalkerMover.set_hold].
var _hold: Vector2 = Vector2.ZERO
## From where the walker is to where the motion still is, m.
var _behind: Vector3 = Vector3.ZERO
var _root_mode: RagdollMotor.RootMode = RagdollMotor.ROOT_GROUNDED


## Begins where the person's body stands.
func _init(p_person: ServerPerson) -> void:
	person = p_person
	_root_mode = person.ragdoll.motor.root_mode
	person.ragdoll.motor.leg_push = LEG_PUSH
	_pose.set_body(person.ragdoll.get_hip_height(), person.joints)
	var frame: Transform3D = person.ragdoll.motor.get_frame()
	mover.place(frame * person.origin, frame.basis.get_euler().y)
	_pose.restart(mover)
	_hips = person.hips()


## Goes on by a set of the person's own; null: by that of everybody.
func use_set(p_set: WalkerSet) -> void:
	_pose.use_set(p_set)
	set_id = p_set.id if p_set != null else WalkerSet.SHIPPED


## Takes the values of a command.
func take(p_values: PackedFloat32Array) -> void:
	_input = WalkerInput.of_values(p_values)
	if inputs == 0:
		_number = _input.correction
	_is_fresh = true
	inputs += 1


## Whether the client moves the person by worn motion now.
func is_over() -> bool:
	return _sample != null and person.newest != null and person.newest != _sample


## Leaves the body to whatever moves it now.
func end() -> void:
	person.ragdoll.motor.leg_push = 0.0
	person.ragdoll.motor.root_mode = _root_mode


## Makes a tick, before the motors are set. Returns a [WalkMessage] for the client, or no bytes.
func advance(p_tick: int, p_now_s: float, p_delta_s: float) -> PackedByteArray:
	_silent_s = 0.0 if _is_fresh else _silent_s + p_delta_s
	if _silent_s > PATIENCE_S:
		_input.wish = Vector2.ZERO
		_input.jumps = false
	_follow_body()
	var differs: bool = _is_fresh and _input.check != mover.get_check()
	_input.apply(mover, p_delta_s)
	_push(p_tick, p_now_s, p_delta_s)
	var is_due: bool = differs and _input.correction == _number
	_is_fresh = false
	if not is_due:
		return PackedByteArray()
	_number = (_number + 1) % WalkerInput.CORRECTIONS
	corrections += 1
	var message: WalkMessage = WalkMessage.new()
	message.person = person.id
	message.tick = p_tick
	message.number = _number
	message.state = mover.get_state()
	return message.encode()


## Gives the walker up to the body where physics has that, or where it is held back.
func _follow_body() -> void:
	var motor: RagdollMotor = person.ragdoll.motor
	var is_down: bool = (
		person.sitting != null
		or motor.get_balance().get("phase", 0) != RagdollMotor.BALANCE_STANDING
	)
	if is_down:
		mover.follow_body(_feet(), mover.get_heading())
		_lead.clear()
	elif mover.get_mode() == WalkerMover.BODY:
		mover.place(_feet(), mover.get_heading())
		_pose.restart(mover)
	elif mover.get_mode() == WalkerMover.WALK:
		_hold_back(_find_off())
	if person.sitting != null:
		return
	# Hands climb where feet find nothing, and elbows and knees crawl.
	_crawls = _is_crawling()
	var is_climbing: bool = mover.get_mode() in [WalkerMover.VAULT, WalkerMover.LADDER]
	motor.root_mode = RagdollMotor.ROOT_SOFT if is_climbing or _crawls else _root_mode


## Lets the walker wait for a body that something holds. It goes by steps, as each change of the
## state is a message, and a walker that is held for long costs none.
func _hold_back(p_off: Vector3) -> void:
	var off: Vector2 = Vector2(p_off.x, p_off.z)
	var free: float = FREE_M + FREE_S * mover.get_velocity().length()
	var share: float = clampf((off.length() - free) / HOLD_M, 0.0, 1.0)
	var hold: Vector2 = off.normalized() * share
	if hold.distance_to(_hold) > _HOLD_STEP or (share == 0.0 and off.length() < 0.8 * free):
		_hold = hold
	mover.set_hold(_hold)
	_lead.held = _hold.length()
	if off.length() > MAX_TETHER_M:
		mover.push(p_off.limit_length(off.length() - MAX_TETHER_M))
		waits += 1


## From where the walker has the hips to where they are, level, m.
func _find_off() -> Vector3:
	var off: Vector3 = person.hips() - _hips + _lead.lead
	off.y = 0.0
	return off


## Whether somebody who lies wants to get on.
func _is_crawling() -> bool:
	if mover.get_stance() != WalkerMover.PRONE or _input.wish.is_zero_approx():
		return false
	return person.hips().y - mover.get_position().y < LYING_M


## What is below the hips, m.
func _feet() -> Vector3:
	var hips: Vector3 = person.hips()
	var otherwise: Vector3 = hips + Vector3.DOWN * _pose.hip_height
	return WalkerBodies.find_ground(person.ragdoll.get_world_3d(), hips, otherwise)


## Lets the motion come along at a person's speed where the walker is put elsewhere, as to where a
## body has fallen: a motion that jumps would put the body there, upright.
func _glide(r_sample: PoseSample, p_delta_s: float) -> void:
	var most: float = GLIDE * p_delta_s
	_behind = _behind.move_toward(Vector3.ZERO, most)
	var jump: Vector3 = r_sample.root + _behind - _hips
	if jump.length() > 2.0 * most:
		_behind -= jump
	r_sample.root += _behind


## Gives the body the pose of the tick's end, in the person's own frame.
func _push(p_tick: int, p_now_s: float, p_delta_s: float) -> void:
	if mover.get_mode() == WalkerMover.WALK and mover.is_grounded():
		var speed: float = mover.get_velocity().length()
		_lead.advance(_find_off(), speed, _input.wish.is_zero_approx(), p_delta_s)
	else:
		_lead.rest()
	var lead: Vector3 = _lead.lead
	var sample: PoseSample = _pose.advance(mover, _input, p_delta_s, -lead, _lead.velocity)
	_glide(sample, p_delta_s)
	_hips = sample.root
	if _crawls:
		sample.root.y += CRAWL_M
	sample.id = inputs & 0xFFFFFFFF
	sample.time_usec = roundi((p_tick + 1) * p_delta_s * 1e6)
	var frame: Transform3D = person.ragdoll.motor.get_frame()
	if person.sitting != null:
		# In a seat the motion goes nowhere.
		frame = Transform3D(Rotations.yaw(mover.get_heading()), mover.get_position())
	sample.root = (frame.affine_inverse() * sample.root - person.origin) / person.scale
	if not frame.basis.is_equal_approx(Basis.IDENTITY):
		sample.turn_limbs(frame.basis.get_rotation_quaternion().inverse())
	person.push_sample(sample, p_now_s, p_delta_s)
	if person.newest == sample:
		_sample = sample
