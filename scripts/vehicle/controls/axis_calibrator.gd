class_name AxisCalibrator
extends RefCounted
## Finds out which axis of which device a wheel or pedal is, and its ends: the user moves one
## control after the other through its whole travel while all axes are watched.

## What is calibrated.
enum Kind {
	## A steering wheel, a handlebar or a stick.
	STEER,
	## The accelerator.
	THROTTLE,
	## The brake.
	BRAKE,
}

## What the user has to do for each.
const INSTRUCTIONS: Dictionary[Kind, String] = {
	Kind.STEER: "Turn the wheel fully to the left, then fully to the right, then to the middle.",
	Kind.THROTTLE: "Press the accelerator fully, then let it go.",
	Kind.BRAKE: "Press the brake fully, then let it go.",
}

## What is watched.
var kind: Kind = Kind.STEER
## Name of the device whose axis has moved farthest; empty before anything has moved.
var device: String = ""

var _watched: Dictionary[String, Way] = {}


## The travel of an axis since the calibration began.
class Way:
	## Device and axis.
	var device: String = ""
	var axis: int = 0
	## What it said first, says now, and its extremes.
	var first: float = 0.0
	var now: float = 0.0
	var highest: float = 0.0
	var lowest: float = 0.0
	## The extreme that was reached first, once it is clear.
	var towards: float = 0.0

	func take(p_raw: float) -> void:
		now = p_raw
		highest = maxf(highest, p_raw)
		lowest = minf(lowest, p_raw)
		if towards == 0.0 and absf(p_raw - first) >= AxisCalibration.MIN_WAY:
			towards = signf(p_raw - first)


## Begins with a control.
func begin(p_kind: Kind) -> void:
	kind = p_kind
	device = ""
	_watched.clear()


## Takes what an axis says now.
func take(p_device: String, p_axis: int, p_raw: float) -> void:
	if not is_finite(p_raw):
		return
	var key: String = "%s %d" % [p_device, p_axis]
	if not _watched.has(key):
		var fresh: Way = Way.new()
		fresh.device = p_device
		fresh.axis = p_axis
		fresh.first = p_raw
		fresh.highest = p_raw
		fresh.lowest = p_raw
		_watched[key] = fresh
	_watched[key].take(p_raw)
	var found: Way = _farthest()
	device = found.device if found != null else ""


## The calibration of the axis that went farthest, or null while none has gone far enough.
func result() -> AxisCalibration:
	var found: Way = _farthest()
	if found == null:
		return null
	var made: AxisCalibration = AxisCalibration.new()
	made.axis = found.axis
	var begins_high: bool = found.towards > 0.0
	if kind == Kind.STEER:
		# A wheel may have been turned when it began: the middle is where it was left.
		made.rest = found.now
		made.high = found.highest if begins_high else found.lowest
		made.low = found.lowest if begins_high else found.highest
	else:
		made.rest = found.now
		made.high = found.highest if begins_high else found.lowest
		made.low = made.rest
	return made if made.is_sound() else null


func _farthest() -> Way:
	var best: Way = null
	for way: Way in _watched.values():
		var length: float = way.highest - way.lowest
		if length >= AxisCalibration.MIN_WAY and (best == null or length > _length_of(best)):
			best = way
	return best


static func _length_of(p_way: Way) -> float:
	return p_way.highest - p_way.lowest
