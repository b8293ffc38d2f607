class_name PredictedVehicle
extends Node3D
## A driver's own vehicle, simulated ahead at the driver's client, so that it obeys at once.
##
## A second body of the vehicle drives in this machine's physics space, by the same parameters and
## over the same ground, as many ticks ahead of the server's newest state as a command takes to
## arrive. What the server says of a tick is compared with what was predicted for that tick; the
## difference moves the body gradually, and what is shown even more so. Only static things are solid
## for it: what is pushed or rammed becomes true when the server says so.

## Share of the error in position that each state of the server corrects.
const CORRECTION: float = 0.2
## Share of the error in velocity that each state of the server corrects.
const SPEED_CORRECTION: float = 0.1
## Error beyond which the prediction begins anew at the server's state, m and rad.
const MAX_ERROR_M: float = 2.0
const MAX_ERROR_RAD: float = 0.35
## Error that is ignored, as the rounding on the wire causes it, m and rad.
const _NOISE_M: float = 0.003
const _NOISE_RAD: float = 0.002
## Time constant with which a correction fades out of the picture, s.
const _FADE_S: float = 0.12
## Number of ticks that are remembered.
const _MEMORY: int = 128

## The body that drives ahead.
var ghost: Vehicle = null
## The tick that the body has reached, or -1.
var tick: int = -1
## How far the prediction was from the truth at the last news, m.
var error_m: float = 0.0
## How often it began anew.
var restarts: int = 0

## What was predicted, by tick: transform, velocity, angular velocity.
var _places: Dictionary[int, Transform3D] = {}
var _speeds: Dictionary[int, Vector3] = {}
var _spins: Dictionary[int, Vector3] = {}
## Offset of what is shown from the body: in the world, m, and about the body's own middle.
var _offset: Vector3 = Vector3.ZERO
var _turn: Quaternion = Quaternion.IDENTITY


## Begins for a vehicle that is here and shown: its scene once more, without all that is not solid.
## Returns null where its scene cannot be made again.
static func create(p_vehicle: Vehicle, p_input: VehicleInput) -> PredictedVehicle:
	if p_vehicle.scene_file_path == "":
		return null
	var made: PredictedVehicle = PredictedVehicle.new()
	made.ghost = (load(p_vehicle.scene_file_path) as PackedScene).instantiate() as Vehicle
	for child: Node in made.ghost.get_children():
		if not child is CollisionShape3D:
			child.free()
	made.ghost.parameters = p_vehicle.parameters
	made.ghost.input = p_input
	made.ghost.freeze = false
	made.ghost.can_sleep = false
	made.ghost.collision_layer = 0
	made.ghost.collision_mask = PhysicsLayers.STATIC
	made.ghost.set_gear_kind(p_vehicle.gear_kind())
	made.ghost.process_physics_priority = 2
	made.ghost.transform = p_vehicle.global_transform
	made.add_child(made.ghost)
	return made


## Begins where the server has the vehicle at a past tick, carried on to the present one.
func begin_at(p_tick: int, p_place: Transform3D, p_speed: Vector3, p_spin: Vector3) -> void:
	var ahead_s: float = float(tick - p_tick) / Engine.physics_ticks_per_second
	var place: Transform3D = p_place
	place.origin += p_speed * ahead_s
	if not p_spin.is_zero_approx():
		place.basis = Basis(p_spin.normalized(), p_spin.length() * ahead_s) * place.basis
	restart(place, p_speed, p_spin, tick)


## Begins at a tick, with a transform and a velocity.
func restart(p_place: Transform3D, p_speed: Vector3, p_spin: Vector3, p_tick: int) -> void:
	var shown: Transform3D = get_shown(0.0)
	ghost.teleport(p_place)
	ghost.set_motion(p_speed, p_spin)
	_places.clear()
	_speeds.clear()
	_spins.clear()
	tick = p_tick
	_offset = Vector3.ZERO
	_turn = Quaternion.IDENTITY
	if shown.origin.distance_to(p_place.origin) < 2.0 * MAX_ERROR_M:
		_keep_shown(shown, p_place)


## Whether vehicle and wheels can be moved: not before the first step.
func has_wheels() -> bool:
	return not ghost.stats().contacts.is_empty()


## Remembers what the last step has led to and begins the step of a tick. Call it once a physics
## frame, before the vehicle's own.
func begin_step(p_tick: int) -> void:
	if tick >= 0:
		_places[tick] = _place()
		_speeds[tick] = ghost.linear_velocity
		_spins[tick] = ghost.angular_velocity
		for old: int in [tick - _MEMORY, tick - _MEMORY - 1]:
			_places.erase(old)
			_speeds.erase(old)
			_spins.erase(old)
	tick = p_tick


## Takes what the server says of a tick: where the vehicle is (m), its velocity (m/s) and angular
## velocity (rad/s) in the world. Returns whether it was compared.
func correct(p_tick: int, p_place: Transform3D, p_speed: Vector3, p_spin: Vector3) -> bool:
	if not _places.has(p_tick):
		return false
	var was: Transform3D = _places[p_tick]
	var moved: Vector3 = p_place.origin - was.origin
	var turned: Quaternion = Quaternion(p_place.basis) * Quaternion(was.basis).inverse()
	# Of the two quaternions of a turn, the one that goes the short way.
	turned = -turned if turned.w < 0.0 else turned
	error_m = moved.length()
	if error_m > MAX_ERROR_M or turned.get_angle() > MAX_ERROR_RAD:
		restarts += 1
		begin_at(p_tick, p_place, p_speed, p_spin)
		return true
	var speed: Vector3 = (p_speed - _speeds[p_tick]) * SPEED_CORRECTION
	var spin: Vector3 = (p_spin - _spins[p_tick]) * SPEED_CORRECTION
	if error_m < _NOISE_M:
		moved = Vector3.ZERO
	if turned.get_angle() < _NOISE_RAD:
		turned = Quaternion.IDENTITY
	moved *= CORRECTION
	_shift(moved, Quaternion.IDENTITY.slerp(turned, CORRECTION), speed, spin, p_tick)
	return true


## Where the vehicle is to be shown at a share of the next step (0 to 1).
func get_shown(p_share: float) -> Transform3D:
	var place: Transform3D = _place()
	var step_s: float = p_share / Engine.physics_ticks_per_second
	place.origin += ghost.linear_velocity * step_s
	var spin: Vector3 = ghost.angular_velocity
	if not spin.is_zero_approx():
		place.basis = Basis(spin.normalized(), spin.length() * step_s) * place.basis
	place.origin += _offset
	place.basis = Basis(_turn) * place.basis
	return place.orthonormalized()


## Distance by which the picture still differs because of corrections, m.
func get_pull() -> float:
	return _offset.length()


## Lets what was corrected fade out of the picture, after a time, s.
func fade(p_delta: float) -> void:
	var left: float = exp(-p_delta / _FADE_S)
	_offset *= left
	_turn = Quaternion.IDENTITY.slerp(_turn, left)


## Moves the body, and what is remembered since a tick, without what is shown.
func _shift(
	p_by: Vector3, p_turn: Quaternion, p_speed: Vector3, p_spin: Vector3, p_since: int
) -> void:
	var place: Transform3D = _place()
	# About the body's own middle: a turn moves it nowhere.
	var by: Transform3D = Transform3D(Basis(p_turn), Vector3.ZERO)
	by.origin = p_by + place.origin - by.basis * place.origin
	ghost.shift(by, p_speed, p_spin)
	_offset -= p_by
	_turn = (_turn * p_turn.inverse()).normalized()
	for known: int in _places:
		if known >= p_since:
			var old: Transform3D = _places[known]
			_places[known] = Transform3D(Basis(p_turn) * old.basis, old.origin + p_by)
			_speeds[known] += p_speed
			_spins[known] += p_spin


## Shows it where it was shown, although the body is elsewhere.
func _keep_shown(p_shown: Transform3D, p_place: Transform3D) -> void:
	_offset = p_shown.origin - p_place.origin
	_turn = (Quaternion(p_shown.basis) * Quaternion(p_place.basis).inverse()).normalized()


## Transform of the body after the last step: its node has it only a frame later.
func _place() -> Transform3D:
	if not ghost.is_inside_tree():
		return ghost.transform
	return PhysicsServer3D.body_get_state(ghost.get_rid(), PhysicsServer3D.BODY_STATE_TRANSFORM)
