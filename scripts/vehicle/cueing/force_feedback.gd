@icon("res://scenes/vehicle/icons/force_feedback.svg")
class_name ForceFeedback
extends Node
## What a driver feels in the hands: rumble of a gamepad, forces of a steering wheel.
##
## Both follow the motion of [member seat] and the vehicle's [member state]. Without a seat, and
## while the tree is paused, everything is still and the wheel belongs to whoever wants it.

# Least time between two commands to a gamepad, and how long it shakes without a new one, s.
const _RUMBLE_PERIOD_S: float = 0.05
const _RUMBLE_LASTS_S: float = 0.2
# With states on both sides of the moment, its motion is steadier.
const _DELAY_S: float = 0.03

## What moves: its origin is the seat's reference point, its -Z looks ahead.
@export var seat: Node3D = null:
	set(p_value):
		if p_value != seat:
			seat = p_value
			_motion.clear()
			_meter.clear()
			update_configuration_warnings()
## How a gamepad shakes; null: not at all.
@export var rumble: RumbleFeel = RumbleFeel.new()
## What is felt in a wheel; null: nothing.
@export var steering: SteeringFeel = SteeringFeel.new()
## Number of the gamepad.
@export var gamepad: int = 0
## Device of the wheel, such as /dev/input/event5; empty: the first wheel that is there.
@export var wheel_path: String = ""
## Strength of the wheel's forces.
@export_range(0.0, 1.0, 0.01) var wheel_gain: float = 0.7
## The wheel turns the other way than others.
@export var wheel_is_reversed: bool = false

## What is known of the vehicle; null: the engine is not felt.
var state: VehicleState = null
## Where the wheel is turned to, -1 (left) to 1, for its end stops. Set by what reads the wheel.
var wheel_position: float = 0.0

var _motion: SeatMotion = SeatMotion.new()
var _meter: ShakeMeter = ShakeMeter.new()
var _wheel: ForceWheel = ForceWheel.new()
var _since_rumble_s: float = 0.0
var _shakes: bool = false
var _trouble: String = ""


func _init() -> void:
	process_mode = Node.PROCESS_MODE_ALWAYS
	process_priority = 1000


func _get_configuration_warnings() -> PackedStringArray:
	if seat == null:
		return ["It needs the seat whose motion is felt: choose a Node3D in the inspector."]
	return []


func _process(p_delta: float) -> void:
	var is_live: bool = is_instance_valid(seat) and seat.is_inside_tree()
	if not is_live or get_tree().paused:
		release()
		return
	var now_s: float = Time.get_ticks_usec() * 1e-6
	_motion.push_state(now_s, seat.global_transform)
	if _motion.estimate(now_s - _DELAY_S):
		_meter.advance(p_delta, _motion.get_specific_force())
	_shake(p_delta)
	_steer()


func _exit_tree() -> void:
	release()


## A jolt that no transform shows, such as a gun's recoil, in the seat's frame, m/s².
func kick(p_jolt: Vector3) -> void:
	_meter.kick(p_jolt)


## Lets gamepad and wheel go.
func release() -> void:
	if _shakes:
		_shakes = false
		Input.stop_joy_vibration(gamepad)
	if _wheel.is_open():
		_wheel.close()


## The wheel, for its name and its trouble.
func get_wheel() -> ForceWheel:
	return _wheel


## Shaking (m/s²) and jolts of the seat.
func get_meter() -> ShakeMeter:
	return _meter


func _shake(p_delta: float) -> void:
	_since_rumble_s += p_delta
	if rumble == null or _since_rumble_s < _RUMBLE_PERIOD_S:
		return
	_since_rumble_s = 0.0
	var weak: float = rumble.weak(state)
	var strong: float = rumble.strong(_meter.shaking, _meter.jolt.length())
	if weak > 0.0 or strong > 0.0:
		_shakes = true
		Input.start_joy_vibration(gamepad, weak, strong, _RUMBLE_LASTS_S)
	elif _shakes:
		_shakes = false
		Input.stop_joy_vibration(gamepad)


func _steer() -> void:
	if steering == null:
		return
	if not _wheel.is_open():
		_wheel.open(wheel_path)
	_wheel.set_gain(wheel_gain)
	var speed: float = _motion.get_velocity().length()
	var sign_of_wheel: float = -1.0 if wheel_is_reversed else 1.0
	var force: float = steering.constant(
		wheel_position, _motion.get_specific_force().x, _meter.jolt.x
	)
	_wheel.set_constant(force * sign_of_wheel)
	_wheel.set_spring(steering.spring(speed), 0.0, steering.spring_dead_band)
	_wheel.set_damper(steering.damper(speed))
	var engine_on: bool = state != null and state.engine_on
	_wheel.set_periodic(steering.vibration(_meter.shaking, engine_on), steering.frequency(speed))
	_wheel.apply()
	if _wheel.get_trouble() != _trouble:
		_trouble = _wheel.get_trouble()
		if _trouble != "" and not _trouble.begins_with("no wheel"):
			Log.warning("wheel", _trouble)
