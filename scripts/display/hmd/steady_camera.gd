class_name SteadyCamera
extends Camera3D
## What a wearer sees, for those who look on: calm and level, see [SteadyEye].

var _eye: SteadyEye = SteadyEye.new()


## A frame: where the head is in the world.
func follow(p_head: Transform3D, p_delta: float) -> void:
	if p_head.is_finite() and p_delta >= 0.0:
		transform = _eye.advance(p_head, p_delta)


## The next frame is a cut.
func cut() -> void:
	_eye.restart()
