class_name FistBlow
extends RefCounted
## A blow with the right fist: the motion, and where and when the fist is 4 m/s fast.

## Speed of the fist when it hits, m/s, where the blow is made up.
const SPEED: float = 4.0
## Time before the blow in which the body comes to rest, s.
const SETTLE_S: float = 0.3

## Shares of the arm's length at which the jab's fist starts, hits, begins to brake, and stops.
const _FROM: float = 0.3
const _HIT: float = 0.75
const _BRAKE: float = 0.76
const _TO: float = 0.92
## Angles of the swung arm, from pointing to the side, towards the front, rad.
const _SWING_FROM: float = -0.9
const _SWING_BRAKE: float = 0.1
const _SWING_TO: float = 0.5
## The clip begins so long before its fastest blow, s, in which the body walks up to its place.
const _LEAD_S: float = 1.0

## What the report calls it.
var name: String = ""
## As in [ContactPerson].
var pose: Callable = Callable()
## As in [ContactPerson].
var place: Callable = Callable()
## When the fist hits, s.
var hit_s: float = 0.0
## How fast the motion's fist is then, m/s.
var speed: float = SPEED
## Which way the fist goes then.
var direction: Vector3 = Vector3.BACK


## A jab straight ahead: the fist brakes within the last sixth of the arm's length and goes back as
## it came. The elbow opens with up to 24 rad/s.
static func jab(p_person: ContactPerson) -> FistBlow:
	var blow: FistBlow = FistBlow.new()
	var length: float = p_person.arm_length("Right")
	blow.name = "jab"
	blow.pose = func(time: float) -> PoseSample:
		var share: float = _travel(
			time - SETTLE_S, SPEED / length, [_FROM, _HIT - 0.05, _BRAKE, _TO]
		)
		return ContactPoses.fist_at(p_person, Vector3(0.0, 0.0, share * length))
	blow.place = _standing(p_person)
	var even: float = _HIT - 0.05
	blow.hit_s = SETTLE_S + (2.0 * (even - _FROM) + _HIT - even) * length / SPEED
	return blow


## The straight arm swings from behind to the side, evenly, and hits there.
static func swing(p_person: ContactPerson) -> FistBlow:
	var blow: FistBlow = FistBlow.new()
	var length: float = p_person.arm_length("Right")
	blow.name = "swing"
	blow.pose = func(time: float) -> PoseSample:
		var angle: float = _travel(
			time - SETTLE_S,
			SPEED / length,
			[_SWING_FROM, _SWING_FROM / 2.0, _SWING_BRAKE, _SWING_TO]
		)
		var turn: Quaternion = Quaternion(Vector3.UP, angle)
		var turns: Dictionary[StringName, Quaternion] = ContactPoses.hanging_arm(p_person, "Left")
		for part: String in ["UpperArm", "LowerArm", "Hand"]:
			turns[StringName("Right" + part)] = turn
		return ContactPoses.reset(turns)
	blow.place = _standing(p_person)
	blow.hit_s = SETTLE_S + absf(_SWING_FROM) * 1.5 * length / SPEED
	return blow


## The clip's fastest blow of the right fist away from the body.
static func of_clip(p_performer: ContactPerformer, p_person: ContactPerson) -> FistBlow:
	var blow: FistBlow = FistBlow.new()
	blow.name = "clip"
	var hand: int = p_person.find(&"RightHand")
	blow.speed = 0.0
	var moment: float = 0.0
	for step: int in range(60, int(p_performer.duration() * 60.0) - 30):
		var time: float = step / 60.0
		var before: Vector3 = _hand(p_performer, p_person, hand, time - 0.02)
		var after: Vector3 = _hand(p_performer, p_person, hand, time + 0.02)
		var hips: Vector3 = p_performer.hips_at(time, p_person)
		var away: Vector3 = ((before + after) / 2.0 - hips) * Vector3(1.0, 0.0, 1.0)
		var speed: float = ((after - before) / 0.04).dot(away.normalized())
		if away.length() > 0.35 and speed > blow.speed:
			blow.speed = speed
			moment = time
			blow.direction = away.normalized()
	var start: float = maxf(moment - _LEAD_S, 0.0)
	blow.hit_s = moment - start
	blow.pose = func(time: float) -> PoseSample: return p_performer.source.pose_at(start + time)
	blow.place = func(time: float) -> Vector3: return p_performer.hips_at(start + time, p_person)
	return blow


static func _hand(
	p_performer: ContactPerformer, p_person: ContactPerson, p_hand: int, p_time_s: float
) -> Vector3:
	var hips: Vector3 = p_performer.hips_at(p_time_s, p_person)
	return p_person.targets(p_performer.source.pose_at(p_time_s), hips)[p_hand].origin


static func _standing(p_person: ContactPerson) -> Callable:
	var hips: Vector3 = p_person.standing_hips()
	return func(_time: float) -> Vector3: return hips


## Even acceleration from the first to the second of four places, even speed to the third, even
## braking to the last. Then back as it came.
static func _travel(p_time_s: float, p_speed: float, p_at: Array[float]) -> float:
	var gather_s: float = 2.0 * (p_at[1] - p_at[0]) / p_speed
	var strike_s: float = (p_at[2] - p_at[1]) / p_speed
	var brake_s: float = 2.0 * (p_at[3] - p_at[2]) / p_speed
	var turn_s: float = gather_s + strike_s + brake_s
	var time: float = clampf(p_time_s, 0.0, turn_s)
	if p_time_s > turn_s:
		time = maxf(2.0 * turn_s - p_time_s, 0.0)
	if time < gather_s:
		return p_at[0] + (p_at[1] - p_at[0]) * (time / gather_s) ** 2
	time -= gather_s
	if time < strike_s:
		return p_at[1] + p_speed * time
	var left: float = 1.0 - (time - strike_s) / brake_s
	return p_at[3] - (p_at[3] - p_at[2]) * left * left
