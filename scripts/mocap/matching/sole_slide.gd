class_name SoleSlide
extends RefCounted
## How fast the soles of a walker slide on level ground.

## A point of a sole that is lower is on the ground, m.
const GROUND_M: float = 0.02

## Speeds of soles on the ground, m/s, each of the point that moves least.
var speeds: PackedFloat64Array = PackedFloat64Array()
## How deep a sole was below the ground at worst, m.
var deepest: float = 0.0

var _before: PackedVector3Array = PackedVector3Array()


## Forgets where the soles were: somebody else comes.
func begin() -> void:
	_before.clear()


## Looks at the soles after a tick of so many seconds, the ground being at 0: as many points of the
## left one as of the right one, which follow ([method MotionMatcher.get_soles]). Returns whether
## one is on the ground.
func look(p_soles: PackedVector3Array, p_delta: float) -> bool:
	var stands: bool = false
	var each: int = p_soles.size() / 2
	for side: int in 2 if not _before.is_empty() else 0:
		var slowest: float = INF
		for point: int in range(each * side, each * (side + 1)):
			if p_soles[point].y < GROUND_M and _before[point].y < GROUND_M:
				var step: Vector3 = p_soles[point] - _before[point]
				slowest = minf(slowest, Vector2(step.x, step.z).length() / p_delta)
			deepest = maxf(deepest, -p_soles[point].y)
		if is_finite(slowest):
			speeds.append(slowest)
			stands = true
	_before = p_soles
	return stands


## The mean of all speeds, m/s.
func mean() -> float:
	var sum: float = 0.0
	for speed: float in speeds:
		sum += speed
	return sum / maxi(speeds.size(), 1)
