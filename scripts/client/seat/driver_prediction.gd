class_name DriverPrediction
extends Node
## Lets the vehicle that this client's user drives obey at once: see [PredictedVehicle]. Decides
## which tick of the server each of the client's steps is, and takes what snapshots say.

## Margin with which commands arrive before their tick, ticks: the variation of the network.
const MARGIN_TICKS: float = 3.0
## Error beyond which the tick of a step is set anew, ticks.
const MAX_DRIFT: float = 1.5
## Frames per second below which nothing is predicted: the physics could not keep up.
const MIN_FPS: float = 20.0
## Sum of the tracks' speeds below which a vehicle is at rest, m/s.
const _REST_SPEED: float = 0.1
## Ticks without a state of the server after which the vehicle counts as lost.
const MAX_AGE_TICKS: int = 90
## Wait before the next attempt, s.
const _PATIENCE_S: float = 2.0

## What is predicted, or null.
var predicted: PredictedVehicle = null

var _controls: SeatControls = null
var _replica: WorldReplica = null
## How long a command and its outcome take there and back, µs: [code]func() -> int[/code].
var _round_trip: Callable = Callable()
## The stream's clock, s.
var _now_s: Callable = Callable()
var _entity: int = -1
var _slow_s: float = 0.0
## Whether the vehicle was put where the server has it.
var _has_begun: bool = false


func _init() -> void:
	process_physics_priority = -1


## Begins to watch what the user drives. [param p_now_s] is the clock of the replica's arrivals, s;
## [param p_round_trip] how long a datagram takes there and back, µs.
func follow(
	p_controls: SeatControls, p_replica: WorldReplica, p_now_s: Callable, p_round_trip: Callable
) -> void:
	_controls = p_controls
	_replica = p_replica
	_now_s = p_now_s
	_round_trip = p_round_trip
	_controls.seat_changed.connect(_on_seat_changed)
	_replica.snapshot_taken.connect(_on_snapshot)


func _exit_tree() -> void:
	_end()


func _process(p_delta: float) -> void:
	var is_slow: bool = Engine.get_frames_per_second() < MIN_FPS
	_slow_s = _PATIENCE_S if is_slow else maxf(_slow_s - p_delta, 0.0)
	if predicted == null:
		return
	if _slow_s > 0.0 or not is_instance_valid(_controls.vehicle):
		_end()
		return
	predicted.fade(p_delta)


func _physics_process(_delta: float) -> void:
	if not is_instance_valid(_controls) or not is_instance_valid(_controls.vehicle):
		_end()
	elif predicted != null and _is_stale():
		_end()
	if predicted == null and not _begin():
		return
	var wanted: float = _wanted_tick()
	var next: int = predicted.tick + 1
	if absf(wanted - next) > MAX_DRIFT:
		next = roundi(wanted)
	predicted.begin_step(next)
	predicted.ghost.set_engine_on(_controls.vehicle.state.engine_on)
	_controls.command_tick = next


## Makes the replica show the vehicle where it is predicted: call it before the replica is
## evaluated.
func apply() -> void:
	if predicted != null:
		var share: float = Engine.get_physics_interpolation_fraction()
		_replica.smoother.predict_body(_entity, predicted.get_shown(share))


## For a report: whether the vehicle is predicted, how far it was off at the last news, m, and how
## often the prediction began anew.
func report() -> Dictionary:
	if predicted == null:
		return {"is_active": false}
	var ahead: float = predicted.tick - _replica.newest_tick
	return {
		"is_active": true,
		"error_m": predicted.error_m,
		"restarts": predicted.restarts,
		"ahead_ticks": ahead,
	}


func _begin() -> bool:
	var is_driving: bool = (
		_controls != null
		and is_instance_valid(_controls.seat)
		and is_instance_valid(_controls.vehicle)
		and _controls.seat.is_mine()
		and _controls.has_command(&"drive")
	)
	if not is_driving or _slow_s > 0.0 or _is_stale():
		return false
	_entity = _controls.seat.entity.id
	if not _replica.has_body(_entity) or _replica.tick_rate() <= 0.0:
		return false
	var state: VehicleState = _controls.vehicle.state
	predicted = PredictedVehicle.create(_controls.vehicle, _controls.input)
	if predicted == null:
		return false
	ClientPhysics.hold()
	# Of a vehicle at rest there may be no news; one that moves waits for some.
	_has_begun = absf(state.left_speed) + absf(state.right_speed) < _REST_SPEED
	add_child(predicted)
	predicted.tick = roundi(_wanted_tick()) - 1
	return true


## Whether nothing has come from the server for a while.
func _is_stale() -> bool:
	return _wanted_tick() - _replica.newest_tick > MAX_AGE_TICKS


func _end() -> void:
	if predicted == null:
		return
	ClientPhysics.release()
	_replica.smoother.forget_prediction(_entity)
	predicted.queue_free()
	predicted = null
	if _controls != null:
		_controls.command_tick = -1


## The server's tick that a command reaches which leaves now, with its fraction.
func _wanted_tick() -> float:
	return CommandTick.reached(_replica, _now_s.call(), _round_trip.call()) + MARGIN_TICKS


func _on_seat_changed(_seat: Seat) -> void:
	_end()


func _on_snapshot(p_tick: int) -> void:
	if predicted == null or not _replica.decoder.has_body(_entity):
		return
	var place: Transform3D = _replica.decoder.get_body_transform(_entity)
	var speed: Vector3 = _replica.decoder.get_body_velocity(_entity)
	var spin: Vector3 = _replica.decoder.get_body_spin(_entity)
	if _has_begun:
		predicted.correct(p_tick, place, speed, spin)
	elif predicted.has_wheels():
		_has_begun = true
		predicted.begin_at(p_tick, place, speed, spin)
