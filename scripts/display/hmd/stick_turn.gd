class_name StickTurn
extends RefCounted
## Turns the wearer of a headset by a thumbstick: by steps (snap turns), smoothly, or not at all.
##
## A push to a side is one step, until the stick comes back. Steps are seen as cuts, which make
## nobody sick, where a smooth turn of the view does.

## What the option is.
const FORM: String = "snap[:DEGREES]|smooth[:DEGREES_A_SECOND]|none"
## Steps, and rates of smooth turns, that can be chosen, degrees and degrees/s.
const STEPS: Vector2 = Vector2(15.0, 90.0)
const RATES: Vector2 = Vector2(15.0, 180.0)
## Deflection at which a push begins, and below which it ends, as shares of the stick's travel.
const _PUSHED: float = 0.7
const _BACK: float = 0.4
## Deflection from which on a smooth turn begins.
const _RESTS: float = 0.2

## A step, rad; 0: no steps.
var angle: float = deg_to_rad(30.0)
## The full stick's rate where it turns smoothly, rad/s; 0: it does not.
var rate: float = 0.0
## Whether the stick turns at all.
var is_on: bool = true
## What is wrong with the text that it was read from; empty where nothing is.
var error: String = ""

var _is_pushed: bool = false


## Reads the option.
static func parse(p_text: String) -> StickTurn:
	var turn: StickTurn = StickTurn.new()
	var parts: PackedStringArray = p_text.split(":")
	var limits: Vector2 = STEPS if parts[0] == "snap" else RATES
	var value: float = 30.0 if parts[0] == "snap" else 90.0
	if parts.size() == 2:
		value = parts[1].to_float() if parts[1].is_valid_float() else NAN
	var is_known: bool = parts[0] in ["snap", "smooth"] and parts.size() <= 2
	if p_text == "none":
		turn.is_on = false
	elif not is_known:
		turn.error = "--turn is %s, found '%s'" % [FORM, p_text.left(60)]
	elif not (value >= limits.x and value <= limits.y):
		turn.error = (
			"--turn=%s is from %d to %d degrees, found '%s'"
			% [parts[0], limits.x, limits.y, p_text.left(60)]
		)
	elif parts[0] == "snap":
		turn.angle = deg_to_rad(value)
	else:
		turn.angle = 0.0
		turn.rate = deg_to_rad(value)
	return turn


## A frame of a length, s. Takes how far the stick is pushed: x right, y up, -1 to 1. Returns the
## turn about +Y in this frame, rad: left is positive.
func advance(p_stick: Vector2, p_delta_s: float) -> float:
	if not p_stick.is_finite() or not is_on:
		return 0.0
	# A push ahead that strays to a side is no turn.
	var is_aside: bool = absf(p_stick.x) >= absf(p_stick.y)
	if rate > 0.0:
		var share: float = clampf((absf(p_stick.x) - _RESTS) / (1.0 - _RESTS), 0.0, 1.0)
		return -signf(p_stick.x) * share * rate * maxf(p_delta_s, 0.0) if is_aside else 0.0
	if _is_pushed:
		_is_pushed = absf(p_stick.x) > _BACK
		return 0.0
	if absf(p_stick.x) < _PUSHED or not is_aside:
		return 0.0
	_is_pushed = true
	return -signf(p_stick.x) * angle
