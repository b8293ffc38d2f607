class_name VehicleTuning
extends Node3D
## Drives a preset over ground to try it on, with live plots and sliders for what matters most.
## Start the scene scenes/vehicle/tuning.tscn (F6 in the editor).
##
## W and S accelerate and brake, A and D steer, Space brakes, Backspace puts the vehicle upright,
## R fires a recoil, 1 to 4 choose the preset, G the running gear.

## The presets, in the order of their keys.
const PRESETS: Array[String] = ["tank", "carrier", "truck", "scootmobile"]
## Where they are.
const SCENES: String = "res://scenes/vehicle"
## Camera behind the vehicle as multiples of its length.
const CAMERA: Vector3 = Vector3(0.0, 0.7, 1.9)
## Properties of the parameters that have sliders, and their range as factors of the preset's.
const SLIDERS: Array[StringName] = [
	&"engine_inertia",
	&"gearbox_shift_time",
	&"brake_force",
	&"rolling_resistance",
	&"steering_most_sideways",
	&"steering_pivot_speed",
	&"steering_response",
]

## The vehicle that is driven now.
var vehicle: Vehicle = null

var _kind: VehicleParameters.GearKind = VehicleParameters.GearKind.SPHERES

@onready var _plots: VehiclePlots = $Overlay/Plots
@onready var _sliders: VBoxContainer = $Overlay/Board/Sliders
@onready var _sketch: VehicleSketch = $Sketch
@onready var _camera: Camera3D = $Camera


func _ready() -> void:
	choose(PRESETS[0])


func _physics_process(_delta: float) -> void:
	if not DisplayServer.get_name() == "headless":
		_drive()


func _process(p_delta: float) -> void:
	var length: float = vehicle.parameters.inertia_box.z
	var back: Vector3 = vehicle.global_basis.z
	back.y = 0.0
	var wanted: Vector3 = vehicle.global_position + back.normalized() * CAMERA.z * length
	wanted.y += CAMERA.y * length
	_camera.global_position = _camera.global_position.lerp(wanted, 1.0 - exp(-4.0 * p_delta))
	_camera.look_at(vehicle.global_position + Vector3.UP * 0.2 * length)


func _unhandled_key_input(p_event: InputEvent) -> void:
	var key: InputEventKey = p_event as InputEventKey
	if key == null or not key.pressed or key.echo:
		return
	match key.physical_keycode:
		KEY_BACKSPACE:
			vehicle.reset_upright()
		KEY_R:
			var muzzle: Vector3 = vehicle.to_global(Vector3(0.0, 2.0, -1.0))
			vehicle.apply_recoil(vehicle.global_basis.z * 0.45 * vehicle.parameters.mass, muzzle)
		KEY_G:
			_change_gear()
		KEY_1, KEY_2, KEY_3, KEY_4:
			choose(PRESETS[key.physical_keycode - KEY_1])


## Takes another preset.
func choose(p_preset: String) -> void:
	var at: Transform3D = Transform3D(Basis.IDENTITY, Vector3(0.0, 0.1, 0.0))
	if vehicle != null:
		vehicle.queue_free()
	var path: String = SCENES.path_join(p_preset).path_join(p_preset + ".tscn")
	vehicle = (load(path) as PackedScene).instantiate()
	# The sliders change these: the preset's own stay as they are.
	vehicle.parameters = vehicle.parameters.duplicate_deep(Resource.DEEP_DUPLICATE_ALL)
	vehicle.transform = at
	_kind = vehicle.parameters.gear_kind
	add_child(vehicle)
	_plots.vehicle = vehicle
	_sketch.vehicle = vehicle
	_fill_sliders()


## Changes a parameter of the vehicle that is driven: it gets new wheels.
func change(p_property: StringName, p_value: float) -> void:
	vehicle.parameters.set(p_property, p_value)
	vehicle.fault = ""
	vehicle.release()


func _drive() -> void:
	var input: VehicleInput = vehicle.input
	input.throttle = Input.get_axis(&"ui_down", &"ui_up")
	input.steer = Input.get_axis(&"steer_right", &"steer_left")
	if Input.is_physical_key_pressed(KEY_W):
		input.throttle = 1.0
	elif Input.is_physical_key_pressed(KEY_S):
		input.throttle = -1.0
	input.brake = 1.0 if Input.is_physical_key_pressed(KEY_SPACE) else 0.0


func _change_gear() -> void:
	var other: VehicleParameters.GearKind = (1 - _kind) as VehicleParameters.GearKind
	if not vehicle.parameters.wheels_of(other).is_empty():
		_kind = other
		vehicle.set_gear_kind(other)


func _fill_sliders() -> void:
	for child: Node in _sliders.get_children():
		child.queue_free()
	for property: StringName in SLIDERS:
		var value: float = vehicle.parameters.get(property)
		var row: UiSlider = UiSlider.new(property, Vector3(0.25, 4.0, 0.01) * value, "", "", 170.0)
		row.show_value(value)
		# Keys drive.
		row.slider.focus_mode = Control.FOCUS_NONE
		row.moved.connect(func(p_value: float) -> void: change(property, p_value))
		_sliders.add_child(row)
