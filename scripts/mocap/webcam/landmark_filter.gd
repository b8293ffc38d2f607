class_name LandmarkFilter
extends RefCounted
## Smooths landmarks: the slower a point moves, the more; and the more, the worse it is seen
## (Casiez, Roussel, Vogel 2012, "1 euro filter"). A point that moves at 1 m/s is late by about
## 20 ms.

## Cutoff of a point that rests, Hz.
const REST_HZ: float = 1.5
## By how much a moving one's cutoff is higher, Hz per m/s.
const HZ_PER_SPEED: float = 8.0
## Cutoff of the speed, Hz.
const SPEED_HZ: float = 2.0
## A point that is seen worse than the first is not believed at all, better than the second fully.
const BELIEVED: Vector2 = Vector2(0.05, 0.5)
## After a pause of this length it begins anew, s.
const PAUSE_S: float = 0.5

var _hz_at_rest: float = REST_HZ
var _places: PackedVector3Array = PackedVector3Array()
var _speeds: PackedVector3Array = PackedVector3Array()
var _usec: int = 0


func _init(p_hz_at_rest: float = REST_HZ) -> void:
	_hz_at_rest = p_hz_at_rest


## Smoothed points of a moment, µs; how well each is seen is 0 to 1.
func smooth(
	p_places: PackedVector3Array, p_seen: PackedFloat32Array, p_usec: int
) -> PackedVector3Array:
	var step_s: float = (p_usec - _usec) / 1e6
	_usec = p_usec
	if _places.size() != p_places.size() or step_s <= 0.0 or step_s > PAUSE_S:
		_places = p_places.duplicate()
		_speeds.resize(p_places.size())
		_speeds.fill(Vector3.ZERO)
		return p_places
	var speed_share: float = _share(SPEED_HZ, step_s)
	for point: int in p_places.size():
		var speed: Vector3 = (p_places[point] - _places[point]) / step_s
		var believed: float = speed_share if p_seen[point] > BELIEVED.x else 0.0
		_speeds[point] = _speeds[point].lerp(speed, believed)
		var cutoff: float = _hz_at_rest + HZ_PER_SPEED * _speeds[point].length()
		cutoff *= clampf(inverse_lerp(BELIEVED.x, BELIEVED.y, p_seen[point]), 0.0, 1.0)
		_places[point] = _places[point].lerp(p_places[point], _share(cutoff, step_s))
	return _places.duplicate()


## How far a low-pass filter of a cutoff, Hz, goes in a step, s.
static func _share(p_hz: float, p_step_s: float) -> float:
	var turn: float = TAU * p_hz * p_step_s
	return turn / (1.0 + turn)
