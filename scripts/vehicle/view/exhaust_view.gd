class_name ExhaustView
extends RefCounted
## The flaps on the exhausts, which the gas lifts and the engine's beat lets bounce.

## A flap fell shut (0 left, 1 right); for a sound.
signal flap_shut(p_side: int)

## Farthest that a flap opens, rad.
const FARTHEST: float = deg_to_rad(78.0)
## Acceleration of a falling flap, rad/s^2, and its damping, 1/s.
const _FALL: float = 40.0
const _DRAG: float = 9.0
## Acceleration of a shut flap at full gas, rad/s^2.
const _LIFT: float = 240.0
## Share of its speed that a flap keeps when it bounces off the pipe or the stop.
const _BOUNCE: float = 0.35
## Beat of the flaps at idle and at the greatest speed of the engine, Hz: the beat of the cylinders
## themselves is faster than pictures.
const _BEAT_HZ: Vector2 = Vector2(7.0, 14.0)

## How far each flap is open, rad.
var angles: PackedFloat32Array = [0.0, 0.0]

var _flaps: Array[Node3D] = []
var _speeds: PackedFloat32Array = [0.0, 0.0]
var _beats: PackedFloat32Array = [0.0, 0.37]
var _most_rpm: float = 2600.0
var _dice: RandomNumberGenerator = RandomNumberGenerator.new()
var _kicks: PackedFloat32Array = [1.0, 1.0]


## Finds the flaps of a model; [param p_most_rpm] is the engine's greatest speed, 1/min.
func configure(p_model: Node3D, p_most_rpm: float) -> void:
	_most_rpm = maxf(p_most_rpm, 1.0)
	_dice.seed = 7
	for name: String in ["FlapLeft", "FlapRight"]:
		var flap: Node3D = p_model.find_child(name, true, false) as Node3D
		if flap != null:
			_flaps.append(flap)


## How strongly an engine blows, 0 to 1.
static func gas_of(p_state: VehicleState, p_most_rpm: float) -> float:
	if not p_state.engine_on:
		return 0.0
	var speed: float = clampf(p_state.rpm / p_most_rpm, 0.0, 1.2)
	return clampf(speed * (0.35 + 0.65 * clampf(p_state.load, 0.0, 1.0)), 0.0, 1.0)


## Moves the flaps on.
func advance(p_state: VehicleState, p_delta: float) -> void:
	var gas: float = gas_of(p_state, _most_rpm)
	var speed: float = clampf(p_state.rpm / _most_rpm, 0.0, 1.0)
	var delta: float = minf(p_delta, 0.05)
	for side: int in _flaps.size():
		_beats[side] += lerpf(_BEAT_HZ.x, _BEAT_HZ.y, speed) * delta
		if _beats[side] >= 1.0:
			_beats[side] = fmod(_beats[side], 1.0)
			_kicks[side] = _dice.randf_range(0.45, 1.6)
		# A puff in the first half of each beat; its pull falls as the flap gets out of the way.
		var puff: float = _kicks[side] if _beats[side] < 0.5 else 0.35
		var lift: float = _LIFT * pow(gas, 0.6) * puff * cos(minf(angles[side], 1.5))
		_step(side, lift - _FALL, delta)
		_flaps[side].rotation.x = angles[side]


func _step(p_side: int, p_pull: float, p_delta: float) -> void:
	_speeds[p_side] += (p_pull - _DRAG * _speeds[p_side]) * p_delta
	angles[p_side] += _speeds[p_side] * p_delta
	if angles[p_side] < 0.0:
		angles[p_side] = 0.0
		if _speeds[p_side] < -1.0:
			flap_shut.emit(p_side)
		_speeds[p_side] = -_speeds[p_side] * _BOUNCE if _speeds[p_side] < -0.4 else 0.0
	elif angles[p_side] > FARTHEST:
		angles[p_side] = FARTHEST
		_speeds[p_side] *= -_BOUNCE
