class_name FootContacts
extends RefCounted
## Finds when a displayed person's feet come down: from their motion relative to the hips, so that
## people who sit in a vehicle or are carried make no steps.

## Speed upwards above which a foot is in the air, m/s.
const LIFT_SPEED: float = 0.25
## Speeds downwards between which a foot comes down: it was faster than the first and is now slower
## than the second, m/s.
const MIN_SPEED: float = 0.3
const _STILL_SPEED: float = 0.12
## Greatest speed that counts, m/s: more is a teleport.
const _MAX_SPEED: float = 9.0
## Least time between two steps of a foot, s.
const _MIN_STEP_S: float = 0.2
## Time constant of the speeds, s.
const _SMOOTHING_S: float = 0.02

## How fast each foot came down in [method advance], m/s; 0: it did not.
var landed: PackedFloat32Array = [0.0, 0.0]
## How fast the hips move, m/s.
var pace: float = 0.0

var _heights: PackedFloat32Array = [NAN, NAN]
var _speeds: PackedFloat32Array = [0.0, 0.0]
var _fastest: PackedFloat32Array = [0.0, 0.0]
var _since_s: PackedFloat32Array = [1.0, 1.0]
var _hips: Vector3 = Vector3.INF


## Takes where hips and feet (left, right) are after a time, s.
func advance(p_hips: Vector3, p_feet: PackedVector3Array, p_delta: float) -> void:
	landed.fill(0.0)
	if p_delta <= 0.0:
		return
	var share: float = 1.0 - exp(-p_delta / _SMOOTHING_S)
	if _hips.is_finite():
		pace = lerpf(pace, minf(p_hips.distance_to(_hips) / p_delta, 12.0), share * 0.2)
	_hips = p_hips
	for foot: int in 2:
		var height: float = p_feet[foot].y - p_hips.y
		var speed: float = (height - _heights[foot]) / p_delta
		_heights[foot] = height
		_since_s[foot] += p_delta
		if not is_finite(speed) or absf(speed) > _MAX_SPEED:
			_fastest[foot] = 0.0
			continue
		_speeds[foot] = lerpf(_speeds[foot], speed, share)
		_find_landing(foot)


func _find_landing(p_foot: int) -> void:
	var speed: float = _speeds[p_foot]
	if speed > LIFT_SPEED:
		_fastest[p_foot] = 0.0
	_fastest[p_foot] = minf(_fastest[p_foot], speed)
	if _fastest[p_foot] < -MIN_SPEED and speed > -_STILL_SPEED and _since_s[p_foot] > _MIN_STEP_S:
		landed[p_foot] = -_fastest[p_foot]
		_fastest[p_foot] = 0.0
		_since_s[p_foot] = 0.0
