class_name VehicleInput
extends RefCounted
## What the driver of a vehicle does. What is not a number counts as nothing.

## Direction that the driver has selected.
enum Selector {
	## Forward or back as the throttle says, once the vehicle stands still.
	AUTOMATIC,
	## F: forward; a throttle below zero brakes.
	FORWARD,
	## N: the engine drives nothing.
	NEUTRAL,
	## R: back; a throttle below zero brakes.
	REVERSE,
}

## Accelerator, -1 to 1. Below zero it brakes, and with the automatic selector it drives back.
var throttle: float = 0.0
## Steering, -1 (right) to 1 (left).
var steer: float = 0.0
## Service brake, 0 to 1.
var brake: float = 0.0
## Parking brake, 0 to 1.
var handbrake: float = 0.0
## The selected direction.
var gear: Selector = Selector.AUTOMATIC


## Lets go of everything.
func clear() -> void:
	throttle = 0.0
	steer = 0.0
	brake = 0.0
	handbrake = 0.0
	gear = Selector.AUTOMATIC


## As a list: throttle, steering, brake, parking brake, gear.
func to_values() -> PackedFloat32Array:
	return [throttle, steer, brake, handbrake, gear]


## Takes such a list.
func take_values(p_values: PackedFloat32Array) -> void:
	throttle = p_values[0]
	steer = p_values[1]
	brake = p_values[2]
	handbrake = p_values[3]
	gear = roundi(p_values[4]) as Selector
