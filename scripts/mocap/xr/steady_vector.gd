class_name SteadyVector
extends RefCounted
## A vector without its noise: low-passed while it rests, followed while it moves.
##
## The time constant shrinks as the speed grows (the idea of the "one euro" filter, Casiez et al.
## 2012), so that the lag has a bound: [constant FILTER_S] times [constant SLOW_M_S], 1 cm.

## Time constant at rest, s.
const FILTER_S: float = 0.2
## Speed at which it has halved, m/s.
const SLOW_M_S: float = 0.05
## Time constant of the speed's own filter, s.
const _SPEED_S: float = 0.08

## The value.
var value: Vector3 = Vector3.ZERO

var _last: Vector3 = Vector3.ZERO
var _velocity: Vector3 = Vector3.ZERO
var _is_known: bool = false


## Forgets all: the next value is taken as it is.
func restart() -> void:
	_is_known = false


## Takes a value after a time, s.
func advance(p_value: Vector3, p_step_s: float) -> void:
	if not _is_known:
		value = p_value
		_velocity = Vector3.ZERO
		_is_known = true
	elif p_step_s > 0.0:
		var velocity: Vector3 = (p_value - _last) / p_step_s
		_velocity += (velocity - _velocity) * (p_step_s / (_SPEED_S + p_step_s))
		var filter_s: float = FILTER_S / (1.0 + _velocity.length() / SLOW_M_S)
		value += (p_value - value) * (1.0 - exp(-p_step_s / filter_s))
	_last = p_value
