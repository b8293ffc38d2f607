extends RefCounted
## Lets simulated time pass faster than real time, with the same steps of 1/60 s.

## Length of a step in simulated time, s.
const DELTA: float = 1.0 / 60.0
const _TIMES: int = 10


## From now on, as many steps as the machine can, up to ten times as many per real second.
static func start() -> void:
	Engine.physics_ticks_per_second = 60 * _TIMES
	Engine.time_scale = _TIMES


## Back to normal.
static func stop() -> void:
	Engine.physics_ticks_per_second = 60
	Engine.time_scale = 1.0
