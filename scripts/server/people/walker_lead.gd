class_name WalkerLead
extends RefCounted
## How far a walker's motion goes ahead of the walker, so that the body is where the walker is: feet
## slip and land late, so that a body in physics goes less far than its motion does. No force holds
## it; longer or shorter strides bring it there.

## What each metre that the body is off adds to the motion's speed, 1/s, and the most that it adds,
## m/s: legs cannot change their strides at once.
const GAIN: float = 1.5
const MAX_SPEED: float = 0.5
## The most that the motion is ahead, m: beyond that something holds the body.
const MAX_LEAD: float = 0.45

## From the walker to where the motion is, m, level.
var lead: Vector3 = Vector3.ZERO
## How fast that changes, m/s.
var velocity: Vector3 = Vector3.ZERO


## Begins anew, without a lead.
func clear() -> void:
	lead = Vector3.ZERO
	velocity = Vector3.ZERO


## Goes on by a tick, by where the body is from the walker, m.
func advance(p_off: Vector3, p_delta_s: float) -> void:
	var off: Vector3 = Vector3(p_off.x, 0.0, p_off.z)
	var wanted: Vector3 = (off * -GAIN).limit_length(MAX_SPEED)
	var next: Vector3 = (lead + wanted * p_delta_s).limit_length(MAX_LEAD)
	velocity = (next - lead) / p_delta_s
	lead = next
