class_name SnapTurn
extends RefCounted
## Turns by steps: a push of the thumbstick to a side is one step, until it comes back.
##
## Steps are seen as cuts, which make nobody sick, where a smooth turn of the view does.

## Deflection at which a push begins, and below which it ends, as shares of the stick's travel.
const _PUSHED: float = 0.7
const _BACK: float = 0.4

## A step, rad; 0: no turning.
var angle: float = deg_to_rad(30.0)

var _is_pushed: bool = false


## A frame. Takes how far the stick is pushed: x right, y up, -1 to 1. Returns the turn about +Y in
## this frame, rad: left is positive.
func step(p_stick: Vector2) -> float:
	if not p_stick.is_finite():
		return 0.0
	if _is_pushed:
		_is_pushed = absf(p_stick.x) > _BACK
		return 0.0
	# A push ahead that strays to a side is no turn.
	if absf(p_stick.x) < _PUSHED or absf(p_stick.x) < absf(p_stick.y):
		return 0.0
	_is_pushed = true
	return -signf(p_stick.x) * angle
