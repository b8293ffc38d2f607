class_name SteadyCamera
extends Camera3D
## What a wearer sees, for those who look on: a head shakes and tilts more than anybody who sits
## before a screen can bear, so place and direction are smoothed and the horizon stays level.

## A head that goes this far in a frame was put there, m.
const _CUT_M: float = 2.0

## Time constants, s. Both are short: who points at something must be seen to look at it.
var position_time_s: float = 0.12
var turn_time_s: float = 0.25
## Share of the head's tilt that is kept.
var tilt: float = 0.0

var _has_begun: bool = false


## A frame: where the head is in the world.
func follow(p_head: Transform3D, p_delta: float) -> void:
	if not p_head.is_finite() or p_delta < 0.0:
		return
	var wanted: Quaternion = _level(p_head.basis.orthonormalized())
	if not _has_begun or p_head.origin.distance_to(position) > _CUT_M:
		_has_begun = true
		transform = Transform3D(Basis(wanted), p_head.origin)
		return
	var now: Quaternion = basis.get_rotation_quaternion()
	position = position.lerp(p_head.origin, 1.0 - exp(-p_delta / maxf(0.001, position_time_s)))
	basis = Basis(now.slerp(wanted, 1.0 - exp(-p_delta / maxf(0.001, turn_time_s))))


## The next frame is a cut.
func cut() -> void:
	_has_begun = false


## A rotation without its tilt, or with a share of it.
func _level(p_basis: Basis) -> Quaternion:
	var full: Quaternion = p_basis.get_rotation_quaternion()
	var ahead: Vector3 = -p_basis.z
	if absf(ahead.y) > 0.98:
		return full
	return Quaternion(Basis.looking_at(ahead, Vector3.UP)).slerp(full, clampf(tilt, 0.0, 1.0))
