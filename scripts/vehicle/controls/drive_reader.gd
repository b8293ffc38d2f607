class_name DriveReader
extends RefCounted
## What the driver's hands and feet do: keys, a gamepad, or a wheel with pedals that have been
## calibrated.
##
## Keys move the steering gradually, as nobody turns a wheel in an instant.

## How fast keys turn the steering, and how fast it returns, 1/s.
const KEY_STEER_RATE: float = 2.5
const KEY_RETURN_RATE: float = 5.0

## How wheels and pedals are calibrated; null: none are used.
var settings: ControlSettings = null
## Where the steering is, -1 (right) to 1 (left).
var steer: float = 0.0
## The gear that the driver has chosen.
var gear: VehicleInput.Selector = VehicleInput.Selector.AUTOMATIC


func _init(p_settings: ControlSettings = null) -> void:
	settings = p_settings


## Lets go of everything.
func clear() -> void:
	steer = 0.0
	gear = VehicleInput.Selector.AUTOMATIC


## The next gear: automatic, forward, neutral, reverse.
func change_gear() -> void:
	gear = ((gear + 1) % VehicleInput.Selector.size()) as VehicleInput.Selector


## Reads everything into an input, after a time, s.
func read(p_input: VehicleInput, p_delta: float) -> void:
	p_input.throttle = Input.get_axis(&"drive_back", &"drive_forward")
	p_input.brake = Input.get_action_strength(&"drive_brake")
	p_input.handbrake = Input.get_action_strength(&"drive_handbrake")
	p_input.gear = gear
	_steer_towards(Input.get_axis(&"steer_right", &"steer_left"), p_delta)
	if settings != null:
		for device: int in Input.get_connected_joypads():
			_read_device(device, p_input)
	p_input.steer = steer


func _steer_towards(p_wanted: float, p_delta: float) -> void:
	var is_pressed: bool = (
		Input.is_action_pressed(&"steer_left") or Input.is_action_pressed(&"steer_right")
	)
	# A stick is as gradual as the hand that moves it.
	var by_stick: bool = is_pressed and absf(p_wanted) < 0.999
	var rate: float = KEY_STEER_RATE if absf(p_wanted) > absf(steer) else KEY_RETURN_RATE
	steer = p_wanted if by_stick else move_toward(steer, p_wanted, rate * p_delta)


func _read_device(p_device: int, p_input: VehicleInput) -> void:
	var name: String = Input.get_joy_name(p_device)
	var wheel: AxisCalibration = settings.find(name, AxisCalibrator.Kind.STEER)
	if wheel != null:
		steer = wheel.value_of(Input.get_joy_axis(p_device, wheel.axis as JoyAxis))
	var pedal: AxisCalibration = settings.find(name, AxisCalibrator.Kind.THROTTLE)
	if pedal != null:
		var pressed: float = pedal.value_of(Input.get_joy_axis(p_device, pedal.axis as JoyAxis))
		# With pedals the driver reverses by the gear.
		p_input.throttle = maxf(p_input.throttle, pressed)
	var brake: AxisCalibration = settings.find(name, AxisCalibrator.Kind.BRAKE)
	if brake != null:
		var pressed: float = brake.value_of(Input.get_joy_axis(p_device, brake.axis as JoyAxis))
		p_input.brake = maxf(p_input.brake, pressed)
