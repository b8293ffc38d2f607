class_name LoopBlend
extends RefCounted
## Which of several loops to hear at a value (revolutions, a speed), how loud and at which pitch.
##
## Each loop was made at a value of its own. It is pitched within [constant MIN_PITCH] and
## [constant MAX_PITCH], and where two fit, one fades into the other with equal power.

## The least and the greatest pitch of a loop.
const MIN_PITCH: float = 0.75
const MAX_PITCH: float = 1.35

## Gain of each loop, 0 to 1.
var gains: PackedFloat32Array = []
## Pitch of each loop.
var pitches: PackedFloat32Array = []

var _values: PackedFloat32Array = []


## Takes the values at which the loops were made, rising.
func _init(p_values: PackedFloat32Array) -> void:
	_values = p_values
	gains.resize(p_values.size())
	pitches.resize(p_values.size())
	pitches.fill(1.0)


## Works out gains and pitches for a value.
func set_value(p_value: float) -> void:
	gains.fill(0.0)
	var upper: int = 0
	while upper < _values.size() - 1 and p_value >= _values[upper] * MAX_PITCH:
		upper += 1
	# The first loop that need not be pitched beyond its limit, and the one above, where it fits.
	for loop: int in _values.size():
		pitches[loop] = clampf(p_value / _values[loop], MIN_PITCH, MAX_PITCH)
	var next: int = upper + 1
	if next >= _values.size() or p_value <= _values[next] * MIN_PITCH:
		gains[upper] = 1.0
		return
	var begin: float = _values[next] * MIN_PITCH
	var share: float = (p_value - begin) / maxf(_values[upper] * MAX_PITCH - begin, 1e-6)
	gains[upper] = cos(share * PI / 2.0)
	gains[next] = sin(share * PI / 2.0)


## How many loops there are.
func size() -> int:
	return _values.size()
