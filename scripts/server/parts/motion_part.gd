class_name MotionPart
extends ServerPart
## Sets the motors of all people's bodies before each physics step, and measures after it how well
## the bodies followed.


func advance(p_now_usec: int, p_delta_s: float) -> void:
	if not context.level.is_between:
		context.people.drive(p_now_usec / 1e6, p_delta_s)


func measure() -> void:
	if not context.level.is_between:
		context.people.measure()
