class_name StepPlanner
extends RefCounted
## Plans the feet of a person of whom only the hips' path is known: planted until the weight has
## moved, then one step at a time, never across the other foot, never sliding.
##
## Frame: the wearer's, metres; a yaw of 0 faces +Z. Positions are on the ground below the ankles.

## Distance from where it should be at which a foot begins a step, m; after a pause the second value
## is enough.
const STEP_M: float = 0.2
const SETTLE_M: float = 0.07
## Turn from where it should be at which a foot begins a step, rad.
const STEP_TURN: float = deg_to_rad(38.0)
const SETTLE_TURN: float = deg_to_rad(14.0)
## The pause, s.
const SETTLE_S: float = 0.5
## Duration of a step while the hips hardly move and at 2 m/s, s.
const SLOW_STEP_S: float = 0.42
const QUICK_STEP_S: float = 0.26
## Height of a step, m.
const LIFT_M: float = 0.07
## Least distance between the feet across, m.
const APART_M: float = 0.13
## Feet in the air come below the hips in this time, s.
const HANG_S: float = 0.25
## Toes point outwards, rad.
const TOE_OUT: float = deg_to_rad(6.0)

## Positions of the left and the right foot, and how high each is lifted, m.
var places: PackedVector3Array = [Vector3.ZERO, Vector3.ZERO]
var lifts: PackedFloat32Array = [0.0, 0.0]
## Yaw of each foot, rad.
var yaws: PackedFloat64Array = [0.0, 0.0]
## How much of its step each has done; 1 while it stands.
var parts: PackedFloat32Array = [1.0, 1.0]

var _from: PackedVector3Array = [Vector3.ZERO, Vector3.ZERO]
var _to: PackedVector3Array = [Vector3.ZERO, Vector3.ZERO]
var _from_yaw: PackedFloat64Array = [0.0, 0.0]
var _to_yaw: PackedFloat64Array = [0.0, 0.0]
var _duration: float = SLOW_STEP_S
var _last: int = 1
var _rest_s: float = 0.0
var _half: float = 0.09


## Takes how far from the middle each foot stands, m.
func _init(p_half: float = 0.09) -> void:
	_half = maxf(p_half, APART_M / 2.0)


## Puts both feet below the hips.
func restart(p_hips: Vector3, p_yaw: float) -> void:
	for side: int in 2:
		places[side] = home(side, p_hips, p_yaw)
		yaws[side] = p_yaw + _out(side) * TOE_OUT
		parts[side] = 1.0
		lifts[side] = 0.0


## Whether a foot stands.
func stands(p_side: int) -> bool:
	return parts[p_side] >= 1.0


## The middle of the feet, on the ground, weight on those that stand.
func middle() -> Vector3:
	return (places[0] + places[1]) / 2.0


## Position of a foot at ease.
func home(p_side: int, p_hips: Vector3, p_yaw: float) -> Vector3:
	var across: Vector3 = Rotations.yaw(p_yaw) * Vector3(_out(p_side) * _half, 0.0, 0.0)
	return Vector3(p_hips.x, 0.0, p_hips.z) + across


## Goes on by a time, s: hips over a position, facing a yaw, at a velocity, m/s.
func advance(p_hips: Vector3, p_yaw: float, p_velocity: Vector3, p_step_s: float) -> void:
	var velocity: Vector3 = Vector3(p_velocity.x, 0.0, p_velocity.z).limit_length(4.0)
	for side: int in 2:
		if not stands(side):
			_swing(side, p_hips, p_yaw, velocity, p_step_s)
	if stands(0) and stands(1):
		_begin(p_hips, p_yaw, velocity, p_step_s)


## Lets the feet hang below the hips: in a jump, on a ladder.
func hang(p_hips: Vector3, p_yaw: float, p_velocity: Vector3, p_step_s: float) -> void:
	for side: int in 2:
		places[side] += Vector3(p_velocity.x, 0.0, p_velocity.z) * p_step_s
		var part: float = 1.0 - exp(-p_step_s / HANG_S)
		places[side] = places[side].lerp(home(side, p_hips, p_yaw), part)
		yaws[side] = lerp_angle(yaws[side], p_yaw + _out(side) * TOE_OUT, part)
		parts[side] = 1.0
		lifts[side] = 0.0


func _begin(p_hips: Vector3, p_yaw: float, p_velocity: Vector3, p_step_s: float) -> void:
	var worst: int = -1
	var most: float = 1.0
	var is_still: bool = p_velocity.length() < 0.12
	_rest_s = _rest_s + p_step_s if is_still else 0.0
	var far: float = SETTLE_M if _rest_s > SETTLE_S else STEP_M
	var wide: float = SETTLE_TURN if _rest_s > SETTLE_S else STEP_TURN
	for side: int in 2:
		var off: Vector3 = home(side, p_hips, p_yaw) - places[side]
		var turn: float = angle_difference(yaws[side], p_yaw + _out(side) * TOE_OUT)
		# A foot that lies ahead of a walker waits for the weight to come.
		var ahead: float = -off.dot(p_velocity.normalized())
		var need: float = maxf(off.length() / far, absf(turn) / wide)
		if not is_still and ahead > 0.0:
			need *= 0.6
		# Feet take turns.
		need *= 0.8 if side == _last else 1.0
		if need > most:
			most = need
			worst = side
	if worst < 0:
		return
	_last = worst
	parts[worst] = 0.0
	_from[worst] = places[worst]
	_from_yaw[worst] = yaws[worst]
	_duration = lerpf(SLOW_STEP_S, QUICK_STEP_S, clampf(p_velocity.length() / 2.0, 0.0, 1.0))
	_aim(worst, p_hips, p_yaw, p_velocity)


func _swing(
	p_side: int, p_hips: Vector3, p_yaw: float, p_velocity: Vector3, p_step_s: float
) -> void:
	parts[p_side] = minf(parts[p_side] + p_step_s / _duration, 1.0)
	if parts[p_side] < 0.7:
		_aim(p_side, p_hips, p_yaw, p_velocity)
	var part: float = smoothstep(0.0, 1.0, parts[p_side])
	var place: Vector3 = _from[p_side].lerp(_to[p_side], part)
	# A goal that moves must not make the foot jump.
	var most: float = (3.0 + 2.5 * p_velocity.length()) * p_step_s
	places[p_side] = places[p_side].move_toward(_past(p_side, place), most)
	yaws[p_side] = lerp_angle(_from_yaw[p_side], _to_yaw[p_side], part)
	lifts[p_side] = LIFT_M * sin(PI * parts[p_side])


## The goal of a step: ahead of where the hips will be, so that the weight passes over it.
func _aim(p_side: int, p_hips: Vector3, p_yaw: float, p_velocity: Vector3) -> void:
	var left_s: float = _duration * (1.0 - parts[p_side])
	var lead: Vector3 = p_velocity * (left_s + _duration * 0.5)
	_to[p_side] = home(p_side, p_hips + lead, p_yaw)
	_to_yaw[p_side] = p_yaw + _out(p_side) * TOE_OUT
	var across: Vector3 = Rotations.yaw(p_yaw) * Vector3(_out(p_side), 0.0, 0.0)
	var apart: float = (_to[p_side] - places[1 - p_side]).dot(across)
	if apart < APART_M:
		_to[p_side] += across * (APART_M - apart)


## A path past the other foot.
func _past(p_side: int, p_place: Vector3) -> Vector3:
	var other: Vector3 = places[1 - p_side]
	var across: Vector3 = Rotations.yaw(_to_yaw[p_side]) * Vector3(_out(p_side), 0.0, 0.0)
	var off: Vector3 = p_place - other
	var along: Vector3 = off - across * off.dot(across)
	if along.length() > 0.25 or off.dot(across) >= APART_M * 0.8:
		return p_place
	return p_place + across * (APART_M * 0.8 - off.dot(across)) * (1.0 - along.length() / 0.25)


static func _out(p_side: int) -> float:
	return 1.0 - 2.0 * p_side
