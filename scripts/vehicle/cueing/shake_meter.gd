class_name ShakeMeter
extends RefCounted
## How hard a seat shakes, and jolts that fade, from the specific force in it.

# Time constant of the high-pass: slower changes are hills and turns, s.
const _MEAN_S: float = 0.4
# Time constants with which shaking rises and falls, s.
const _SHAKE_S: float = 0.12
const _JOLT_S: float = 0.1
# Changes beyond this from the mean are a jolt: a gun fires, something is hit, m/s².
const _JOLT_FROM: float = 20.0

## Root mean square of the quick part of specific force up and down, m/s².
var shaking: float = 0.0
## The jolt that fades now, in the seat's frame, m/s².
var jolt: Vector3 = Vector3.ZERO

var _mean: Vector3 = Vector3.ZERO
var _square: float = 0.0
var _has_begun: bool = false


## Takes the specific force in the seat (m/s²), so long after the one before (s).
func advance(p_seconds: float, p_specific_force: Vector3) -> void:
	if not p_specific_force.is_finite() or p_seconds <= 0.0:
		return
	if not _has_begun:
		_has_begun = true
		_mean = p_specific_force
	_mean = _mean.lerp(p_specific_force, 1.0 - exp(-p_seconds / _MEAN_S))
	var quick: Vector3 = p_specific_force - _mean
	_square = lerpf(_square, quick.y * quick.y, 1.0 - exp(-p_seconds / _SHAKE_S))
	shaking = sqrt(_square)
	jolt *= exp(-p_seconds / _JOLT_S)
	if quick.length() > _JOLT_FROM and quick.length() > jolt.length():
		jolt = quick


## A jolt from outside, such as a gun's recoil, in the seat's frame, m/s².
func kick(p_jolt: Vector3) -> void:
	if p_jolt.is_finite():
		jolt += p_jolt


## Forgets everything.
func clear() -> void:
	shaking = 0.0
	jolt = Vector3.ZERO
	_square = 0.0
	_has_begun = false
