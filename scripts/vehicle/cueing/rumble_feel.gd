class_name RumbleFeel
extends Resource
## How a gamepad's two motors shake: the weak, quick one with the engine, the strong, slow one with
## bumps and jolts.

## Strength of the weak motor while the engine idles.
@export_range(0.0, 1.0, 0.01) var idle: float = 0.06
## What is added at [member full_rpm].
@export_range(0.0, 1.0, 0.01) var revving: float = 0.12
## What is added at full load.
@export_range(0.0, 1.0, 0.01) var loaded: float = 0.14
## Speed of the engine at which [member revving] has its full strength.
@export_range(100.0, 20000.0, 10.0, "suffix:1/min") var full_rpm: float = 2600.0
## Shaking below which the strong motor is still: level ground.
@export_range(0.0, 20.0, 0.1, "suffix:m/s²") var smallest_bump: float = 0.6
## Shaking at which the strong motor is at its maximum.
@export_range(0.1, 100.0, 0.1, "suffix:m/s²") var greatest_bump: float = 9.0
## Jolt at which the strong motor is at its maximum.
@export_range(0.1, 500.0, 0.1, "suffix:m/s²") var greatest_jolt: float = 25.0


## Strength of the weak motor, 0 to 1.
func weak(p_state: VehicleState) -> float:
	if p_state == null or not p_state.engine_on:
		return 0.0
	var turning: float = clampf(p_state.rpm / full_rpm, 0.0, 1.0)
	return clampf(idle + revving * turning + loaded * clampf(p_state.load, 0.0, 1.0), 0.0, 1.0)


## Strength of the strong motor, 0 to 1, for shaking and for a jolt (m/s²).
func strong(p_shaking: float, p_jolt: float) -> float:
	var bumps: float = (p_shaking - smallest_bump) / (greatest_bump - smallest_bump)
	return clampf(maxf(bumps, absf(p_jolt) / greatest_jolt), 0.0, 1.0)
