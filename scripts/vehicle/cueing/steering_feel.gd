class_name SteeringFeel
extends Resource
## What a driver feels in the steering wheel: a small model of where its forces come from.
##
## All forces are shares of the most that the wheel's motor can. With v the speed (m/s), x the
## wheel's position (-1 to 1), f the specific force to the right (m/s²):
## spring = from [member spring_at_rest] to [member spring_at_speed] by v² / (v² + spring_speed²):
## the tyres' or tracks' self-aligning torque grows with speed and levels off;
## damper = from [member damper_at_rest] to [member damper_at_speed] by v / (v + damper_speed): what
## stands on the ground must be scrubbed round;
## constant = - cornering f / g - end stop - jolts: cornering pulls the wheel back;
## periodic = bumps and the engine, with the frequency of [member bump_length] at this speed.

## Standard gravity, m/s².
const _GRAVITY: float = 9.81

@export_group("Spring", "spring_")
## Steepness of the spring at rest.
@export_range(0.0, 1.0, 0.01) var spring_at_rest: float = 0.08
## Steepness of the spring well above [member spring_speed].
@export_range(0.0, 1.0, 0.01) var spring_at_speed: float = 0.55
## Speed at which the spring is half way.
@export_range(0.1, 50.0, 0.1, "suffix:m/s") var spring_speed: float = 6.0
## Play in the steering: share of the wheel's travel around the middle without a spring.
@export_range(0.0, 0.5, 0.01) var spring_dead_band: float = 0.02
@export_group("Damper", "damper_")
## Resistance to being turned at rest.
@export_range(0.0, 1.0, 0.01) var damper_at_rest: float = 0.6
## Resistance well above [member damper_speed].
@export_range(0.0, 1.0, 0.01) var damper_at_speed: float = 0.2
## Speed at which it is half way.
@export_range(0.1, 50.0, 0.1, "suffix:m/s") var damper_speed: float = 1.5
@export_group("Constant")
## Force per g of sideways specific force.
@export_range(0.0, 2.0, 0.01) var cornering: float = 0.4
## Where the end stops begin, as a share of the wheel's travel.
@export_range(0.5, 1.0, 0.01) var end_stop: float = 0.95
## Force at the very end.
@export_range(0.0, 1.0, 0.01) var end_stop_force: float = 0.9
## Force of a jolt of 1 g, such as the gun's recoil.
@export_range(0.0, 1.0, 0.01) var jolt: float = 0.3
@export_group("Vibration")
## Strength per m/s² of shaking.
@export_range(0.0, 0.5, 0.001, "suffix:s²/m") var bump: float = 0.06
## Distance from bump to bump, such as a track's links: speed over it is the frequency.
@export_range(0.01, 5.0, 0.01, "suffix:m") var bump_length: float = 0.16
## Strength of the engine's shaking at idle.
@export_range(0.0, 0.5, 0.01) var engine: float = 0.03
## Lowest and highest frequency.
@export_custom(PROPERTY_HINT_NONE, "suffix:Hz") var frequencies: Vector2 = Vector2(8.0, 45.0)


## Steepness of the spring at a speed.
func spring(p_speed: float) -> float:
	var square: float = p_speed * p_speed
	var part: float = square / (square + spring_speed * spring_speed)
	return lerpf(spring_at_rest, spring_at_speed, part)


## Strength of the damper at a speed.
func damper(p_speed: float) -> float:
	var part: float = absf(p_speed) / (absf(p_speed) + damper_speed)
	return lerpf(damper_at_rest, damper_at_speed, part)


## The constant force, positive to the right, for a wheel's position, the specific force to the
## right (m/s²) and a jolt to the right (m/s²).
func constant(p_position: float, p_sideways: float, p_jolt: float) -> float:
	var force: float = (p_jolt * jolt - p_sideways * cornering) / _GRAVITY
	var beyond: float = absf(p_position) - end_stop
	if beyond > 0.0:
		force -= signf(p_position) * end_stop_force * beyond / maxf(1.0 - end_stop, 0.01)
	return clampf(force, -1.0, 1.0)


## Strength of the vibration for shaking (m/s²), with the engine or without.
func vibration(p_shaking: float, p_engine_on: bool) -> float:
	return clampf(p_shaking * bump + (engine if p_engine_on else 0.0), 0.0, 1.0)


## Frequency of the vibration at a speed, Hz.
func frequency(p_speed: float) -> float:
	return clampf(absf(p_speed) / bump_length, frequencies.x, frequencies.y)
