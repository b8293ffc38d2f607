class_name HeadingCorrection
extends RefCounted
## By how much a suit has to be turned about the vertical so that it agrees with a headset: slowly,
## so that the wearer sees nothing of it.
##
## What is low-passed is the angle between headset and *raw* suit, not what is left of it after the
## correction: so the correction's own motion is not delayed by the filter, does not overshoot, and
## an error of 30 degrees is gone in the time that the rate allows.

## Usual time constant of the angle's filter, s.
const FILTER_S: float = 10.0
## Greatest rate of the correction while the wearer stands, rad/s.
const STANDING_RATE: float = deg_to_rad(0.5)
## While the wearer walks: 6 % of a quick turn goes unnoticed (Steinicke et al. 2010).
const WALKING_RATE: float = deg_to_rad(2.0)
## Greatest rate while the wearer turns.
const TURNING_RATE: float = deg_to_rad(5.0)
## Part of the wearer's own turn that is used while turning: people do not notice 20 %.
const TURNING_SHARE: float = 0.1
## Speed above which the wearer walks, m/s.
const WALKING_SPEED: float = 0.4
## How fast the rate may change, rad/s².
const _RATE_CHANGE: float = deg_to_rad(4.0)
## Time constant in which the last of an error goes, s.
const _EASE_S: float = 0.5

## Time constant of the angle's filter, s. Longer where the angle is no measure of a moment, but
## only right on the whole.
var filter_s: float = FILTER_S
## The correction, rad about +Y.
var angle: float = 0.0

var _wanted: float = 0.0
var _seen_s: float = 0.0
var _rate: float = 0.0
var _speed: float = 0.0
var _turn: float = 0.0


## Takes the next measured angle at once: the first one, or the one after the tracking space was
## moved.
func restart() -> void:
	_seen_s = 0.0
	_rate = 0.0


## The tracking space was turned by an angle about +Y, rad: the correction turns with it.
func turn(p_angle: float) -> void:
	_wanted = wrapf(_wanted + p_angle, -PI, PI)
	angle = wrapf(angle + p_angle, -PI, PI)


## Whether there is a correction.
func is_known() -> bool:
	return _seen_s > 0.0


## The wearer's speed (m/s) and rate of turn (rad/s), as the headset measures them.
func note_motion(p_speed: float, p_turn: float, p_step_s: float) -> void:
	var part: float = p_step_s / (0.4 + p_step_s)
	_speed += (p_speed - _speed) * part
	_turn += (absf(p_turn) - _turn) * part


## Takes the angle from raw suit to headset, rad. Without one (NAN) it goes on to what is known.
func advance(p_measured: float, p_step_s: float) -> void:
	if is_finite(p_measured):
		if _seen_s <= 0.0:
			_wanted = p_measured
			angle = p_measured
		# At first a mean of what there is, so that the first sample's noise does not last.
		var part: float = p_step_s / (minf(_seen_s, filter_s) + p_step_s) if p_step_s > 0.0 else 0.0
		_wanted = wrapf(_wanted + angle_difference(_wanted, p_measured) * part, -PI, PI)
		_seen_s += maxf(p_step_s, 1e-6)
	if _seen_s <= 0.0:
		return
	var left: float = angle_difference(angle, _wanted)
	var most: float = limit()
	var wanted_rate: float = clampf(left / _EASE_S, -most, most)
	_rate = move_toward(_rate, wanted_rate, _RATE_CHANGE * p_step_s)
	_rate = clampf(_rate, -most, most)
	angle = wrapf(angle + _rate * p_step_s, -PI, PI)


## Greatest rate now, rad/s.
func limit() -> float:
	var most: float = STANDING_RATE if _speed < WALKING_SPEED else WALKING_RATE
	return clampf(TURNING_SHARE * _turn, most, TURNING_RATE)
