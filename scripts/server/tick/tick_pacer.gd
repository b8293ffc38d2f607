class_name TickPacer
extends RefCounted
## Makes a server's ticks begin when they are due.
##
## Of a program that draws nothing Godot begins a frame every 6.9 ms, and ticks begin with frames:
## each tick would be late by up to that, and clients would have to wait for the latest. This class
## spreads frames evenly over the time to the next tick, so that one begins with it.

## Longest time between frames, µs: questions that arrive between ticks wait no longer.
const MAX_FRAME_USEC: float = 4200.0
## Time after a tick is due at which its frame begins, µs: no frame must begin just before.
const MARGIN_USEC: float = 50.0

## Time before the next tick until which other work may begin, µs.
const IDLE_USEC: float = 4000.0


## Says when the next frame begins. Call it in every frame, with the ticks per second.
func pace(p_tick_rate: float) -> void:
	var fraction: float = Engine.get_physics_interpolation_fraction()
	OS.low_processor_usage_mode_sleep_usec = frame_usec(fraction, p_tick_rate)


## Whether something of a millisecond's length that no tick waits for can be done now.
static func is_idle(p_tick_rate: float) -> bool:
	var fraction: float = Engine.get_physics_interpolation_fraction()
	return (1.0 - fraction) * 1e6 / p_tick_rate > IDLE_USEC


## How long a frame lasts that begins at a fraction of the time between two ticks, µs.
static func frame_usec(p_fraction: float, p_tick_rate: float) -> int:
	var left: float = (1.0 - clampf(p_fraction, 0.0, 1.0)) * 1e6 / p_tick_rate + MARGIN_USEC
	return ceili(left / ceilf(left / MAX_FRAME_USEC))
