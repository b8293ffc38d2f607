class_name WalkerLead
extends RefCounted
## How far a walker's motion goes ahead of the walker, so that the body is where the walker is: feet
## slip and land late, so that a body in physics goes less far than its motion does. No force brings
## it there; longer or shorter strides do, and steps of who stands.

## What each metre that the body is off adds to the motion's speed, 1/s.
const GAIN: float = 1.5
## The most that this adds, m/s, and for each m/s of the walker: strides change a little at once.
const MAX_SPEED: float = 0.2
const MAX_SHARE: float = 0.15
## The most that the motion is ahead, m: beyond that something holds the body.
const MAX_LEAD: float = 0.6
## How fast a motion comes back that is further ahead than it may be, m/s.
const RETURN_SPEED: float = 1.0
## Speed below which a walker stands, m/s.
const STANDING_SPEED: float = 0.2
## Time after which a body has come to rest, s. Then, where it is off by more than the first
## distance, m, it steps until it is off by the second one, by a speed, m/s, and for a time, s.
const REST_S: float = 0.4
const OFF_FROM: float = 0.12
const OFF_TO: float = 0.05
const STEPPING_SPEED: float = 0.35
const STEPPING_S: float = 3.0

## Share of [constant MAX_LEAD] that is not to be used, as something holds the body: pressing harder
## would throw it back.
var held: float = 0.0
## From the walker to where the motion is, m, level.
var lead: Vector3 = Vector3.ZERO
## How fast that changes, m/s.
var velocity: Vector3 = Vector3.ZERO

var _stood_s: float = 0.0
var _steps: bool = false


## Begins anew, without a lead.
func clear() -> void:
	lead = Vector3.ZERO
	rest()


## Stays as it is.
func rest() -> void:
	velocity = Vector3.ZERO
	_stood_s = 0.0
	_steps = false


## Goes on by a tick, by where the body is from the walker, m, the walker's speed, m/s, and whether
## it is to stop.
func advance(p_off: Vector3, p_speed: float, p_stops: bool, p_delta_s: float) -> void:
	var off: Vector3 = Vector3(p_off.x, 0.0, p_off.z)
	var wanted: Vector3 = Vector3.ZERO
	_stood_s = _stood_s + p_delta_s if p_speed < STANDING_SPEED else 0.0
	if _stood_s > REST_S:
		_steps = _stood_s < REST_S + STEPPING_S and off.length() > (OFF_TO if _steps else OFF_FROM)
		wanted = off.normalized() * -STEPPING_SPEED if _steps else Vector3.ZERO
	elif not p_stops:
		_steps = false
		wanted = (off * -GAIN).limit_length(MAX_SPEED + MAX_SHARE * p_speed)
	var next: Vector3 = lead + wanted * p_delta_s
	var most: Vector3 = next.limit_length(MAX_LEAD * (1.0 - held))
	next = next.move_toward(most, RETURN_SPEED * p_delta_s)
	velocity = (next - lead) / p_delta_s
	lead = next
