@tool
@icon("res://scenes/vehicle/icons/vehicle.svg")
class_name VehicleSound
extends Node
## Plays the sounds of a [Vehicle]: its engine by revolutions and load, tracks or tyres by their
## speed, the turret, hatches, and its guns. All of it follows from what every client knows anyway:
## it needs no bytes of its own.
##
## It does nothing where there is no [SoundVoices], as on a server.

## What drives it.
enum Drive {
	## A diesel of 12 cylinders.
	DIESEL_12,
	## One of 6 cylinders.
	DIESEL_6,
	## An electric motor.
	ELECTRIC,
}
## What it rolls on.
enum Running {
	TRACKS,
	TYRES,
}

## Revolutions and speeds (m/s) of the loops, and how their files name them.
const RPMS: PackedFloat32Array = [700.0, 1200.0, 1800.0, 2600.0]
const _RPM_NAMES: PackedStringArray = ["700", "1200", "1800", "2600"]
const SPEEDS: PackedFloat32Array = [2.2, 3.4, 5.2, 8.0, 12.3]
const _SPEED_NAMES: PackedStringArray = ["22", "34", "52", "80", "123"]
## Distance from the listener beyond which nothing but guns is computed, m.
const AWAY_M: float = 700.0
## Speed at which tyres sound as made, m/s, and revolutions of an electric motor, 1/min.
const _TYRE_SPEED: float = 8.0
const _MOTOR_RPM: float = 2000.0
## Angular speed at which the turret's loop has its original pitch, and below which it is silent,
## rad/s.
const _TURRET_RATE: float = 0.5
const _TURRET_MIN: float = 0.02
## Speed from which on a hatch counts as moving, 1/s.
const _HATCH_RATE: float = 0.2
## Time between two searches for the voices to play on, s.
const _SEARCH_S: float = 0.5
## Time constant with which the heard revolutions and load follow, s: the engine has no jumps.
const _FOLLOW_S: float = 0.08

## The vehicle.
@export var vehicle: Vehicle = null:
	set(p_value):
		vehicle = p_value
		update_configuration_warnings()
## One of its guns, which leads to the shots of all; empty for vehicles without.
@export var gun: VehicleGun = null
## What drives it.
@export var engine: Drive = Drive.DIESEL_12
## What it rolls on.
@export var running: Running = Running.TRACKS
## Where the exhaust is in the vehicle's frame.
@export_custom(PROPERTY_HINT_NONE, "suffix:m") var exhaust: Vector3 = Vector3(0.0, 1.4, 3.0)
## How much louder it is than a tank, dB.
@export_range(-40.0, 20.0, 0.5, "suffix:dB") var gain_db: float = 0.0

var _voices: SoundVoices = null
var _firing: FiringSound = null
var _engine: BlendedLoops = null
var _load: BlendedLoops = null
var _sides: Array[BlendedLoops] = []
var _motor: SoundVoice = null
var _tyres: SoundVoice = null
var _turret: SoundVoice = null
var _fire: SoundVoice = null
var _rpm: float = 0.0
var _effort: float = 0.0
var _yaw: float = 0.0
var _turret_rate: float = 0.0
var _hatches: Vector2 = Vector2.ZERO
var _until_search_s: float = 0.0
var _loaded: float = 1.0
var _hatch_moves: PackedByteArray = [0, 0]


func _ready() -> void:
	set_process(not Engine.is_editor_hint() and vehicle != null)


func _process(p_delta: float) -> void:
	if _voices == null:
		_until_search_s -= p_delta
		if _until_search_s > 0.0:
			return
		_until_search_s = _SEARCH_S
		var found: SoundVoices = SoundVoices.find(self)
		if found == null:
			return
		start(found)
	advance(p_delta)


func _exit_tree() -> void:
	stop()


func _get_configuration_warnings() -> PackedStringArray:
	if vehicle == null:
		return ["It needs the Vehicle that sounds: choose one in the inspector."]
	return []


## Begins to play on these voices.
func start(p_voices: SoundVoices) -> void:
	stop()
	set_process(true)
	_voices = p_voices
	_yaw = vehicle.state.turret_yaw
	_hatches = Vector2(vehicle.state.hatch, vehicle.state.loader_hatch)
	if gun != null and gun.shells != null:
		_firing = FiringSound.new(p_voices, gun.shells)
	if engine == Drive.ELECTRIC:
		_motor = p_voices.start_loop(&"motor_loop", vehicle, exhaust)
	else:
		var name: String = "engine12" if engine == Drive.DIESEL_12 else "engine6"
		_engine = BlendedLoops.new(p_voices, name, _RPM_NAMES, RPMS, vehicle, exhaust)
		_load = BlendedLoops.new(p_voices, name + "_load", _RPM_NAMES, RPMS, vehicle, exhaust)
	if running == Running.TYRES:
		_tyres = p_voices.start_loop(&"tyres_loop", vehicle)
	else:
		for side: float in [-1.0, 1.0]:
			_sides.append(
				BlendedLoops.new(
					p_voices, "tracks", _SPEED_NAMES, SPEEDS, vehicle, Vector3(side * 1.4, 0.4, 0.0)
				)
			)
	_turret = p_voices.start_loop(&"turret_loop", vehicle, Vector3(0.0, 1.8, 0.0))
	_fire = p_voices.start_loop(&"fire_loop", vehicle, Vector3(0.0, 1.5, 0.0))


## Ends all.
func stop() -> void:
	set_process(false)
	for loops: BlendedLoops in [_engine, _load] + _sides:
		if loops != null:
			loops.stop()
	_sides.clear()
	for voice: SoundVoice in [_motor, _tyres, _turret, _fire]:
		if voice != null:
			voice.stop()
	_engine = null
	_load = null
	_motor = null
	_tyres = null
	_turret = null
	_fire = null
	_firing = null
	_voices = null


## Follows the vehicle's state for a time, s.
func advance(p_delta: float) -> void:
	var state: VehicleState = vehicle.state
	if _voices.ear().distance_to(vehicle.global_position) > AWAY_M:
		_silence()
		return
	var share: float = 1.0 - exp(-p_delta / _FOLLOW_S)
	_rpm = lerpf(_rpm, state.rpm if state.engine_on else 0.0, share)
	_effort = lerpf(_effort, clampf(state.load, 0.0, 1.0), share)
	_advance_engine()
	_advance_running(state)
	_advance_turret(state, p_delta)
	_advance_hatches(state, p_delta)
	_advance_gun()
	var burns: bool = state.damage == VehicleState.Damage.KNOCKED_OUT
	_set_gain(_fire, 0.0 if burns else -100.0)


## Revolutions that are heard, 1/min.
func heard_rpm() -> float:
	return _rpm


func _advance_engine() -> void:
	if _motor != null:
		var turns: float = _rpm / _MOTOR_RPM
		_set_gain(_motor, gain_db + linear_to_db(maxf(minf(turns, 1.5), 1e-5)))
		_motor.pitch = clampf(turns, 0.2, 3.0)
		return
	# An engine that dies gets quieter before its loops would be pitched too low.
	var alive: float = clampf((_rpm - 150.0) / 400.0, 0.0, 1.0)
	var base: float = gain_db + linear_to_db(maxf(alive, 1e-5))
	_engine.set_value(_rpm, base + lerpf(-4.0, 2.0, _effort))
	_load.set_value(_rpm, base - 10.0 + linear_to_db(maxf(_effort, 0.05)))


func _advance_running(p_state: VehicleState) -> void:
	var speeds: Vector2 = Vector2(absf(p_state.left_speed), absf(p_state.right_speed))
	if _tyres != null:
		var pace: float = (speeds.x + speeds.y) / 2.0 / _TYRE_SPEED
		_set_gain(_tyres, gain_db + 30.0 * log(maxf(pace, 1e-4)) / log(10.0))
		_tyres.pitch = clampf(0.7 + 0.3 * pace, 0.7, 1.6)
	for side: int in _sides.size():
		var speed: float = speeds[side]
		# Slow links clank more softly.
		var loud: float = linear_to_db(clampf(speed / 4.0, 1e-5, 2.0))
		_sides[side].set_value(speed, gain_db + loud)


func _advance_turret(p_state: VehicleState, p_delta: float) -> void:
	if p_delta <= 0.0:
		return
	var rate: float = absf(wrapf(p_state.turret_yaw - _yaw, -PI, PI)) / p_delta
	_yaw = p_state.turret_yaw
	_turret_rate = lerpf(_turret_rate, minf(rate, 3.0), 1.0 - exp(-p_delta / 0.1))
	if _turret_rate < _TURRET_MIN:
		_set_gain(_turret, -100.0)
		return
	var share: float = _turret_rate / _TURRET_RATE
	_set_gain(_turret, gain_db + linear_to_db(clampf(share, 0.01, 1.2)))
	if _turret != null:
		_turret.pitch = clampf(0.75 + 0.25 * share, 0.75, 1.35)


## A gun that has been loaded: its breech closes.
func _advance_gun() -> void:
	if gun == null:
		return
	if gun.loaded >= 1.0 and _loaded < 1.0:
		_voices.play(&"gun_loaded", gun.global_position + gun.global_basis.z * gun.barrel_length)
	_loaded = gun.loaded


## A lid that comes to rest falls into place.
func _advance_hatches(p_state: VehicleState, p_delta: float) -> void:
	if p_delta <= 0.0:
		return
	var now: Vector2 = Vector2(p_state.hatch, p_state.loader_hatch)
	for lid: int in 2:
		var moves: bool = absf(now[lid] - _hatches[lid]) / p_delta > _HATCH_RATE
		if _hatch_moves[lid] == 1 and not moves:
			var above: Vector3 = Vector3(0.4 if lid == 0 else -0.4, 2.4, 0.0)
			_voices.play(&"hatch", vehicle.global_transform * above)
		_hatch_moves[lid] = 1 if moves else 0
	_hatches = now


func _silence() -> void:
	for loops: BlendedLoops in [_engine, _load] + _sides:
		if loops != null:
			loops.set_value(RPMS[0], -100.0)
	for voice: SoundVoice in [_motor, _tyres, _turret, _fire]:
		_set_gain(voice, -100.0)


static func _set_gain(p_voice: SoundVoice, p_gain_db: float) -> void:
	if p_voice != null:
		p_voice.gain_db = p_gain_db
