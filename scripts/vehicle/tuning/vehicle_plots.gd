class_name VehiclePlots
extends VBoxContainer
## Live plots of a vehicle: revolutions, gear, track speeds, springs, slip, attitude.

## The vehicle that is watched; null pauses the plots.
var vehicle: Vehicle = null

var _strips: Dictionary[StringName, PlotStrip] = {}
var _wheels: int = -1


func _physics_process(_delta: float) -> void:
	if vehicle == null or not is_instance_valid(vehicle):
		return
	var stats: VehicleStats = vehicle.stats()
	if stats.wheel_speeds.is_empty():
		return
	if stats.wheel_speeds.size() != _wheels:
		_wheels = stats.wheel_speeds.size()
		_build()
	var state: VehicleState = vehicle.state
	_strips[&"rpm"].push([state.rpm])
	_strips[&"gear"].push([state.gear])
	_strips[&"torque"].push([stats.torque])
	var speed: float = -vehicle.linear_velocity.dot(vehicle.global_basis.z)
	_strips[&"speed"].push([state.left_speed, state.right_speed, speed])
	_strips[&"drive"].push([0.001 * stats.left_force, 0.001 * stats.right_force])
	var half: int = _wheels / 2
	_strips[&"springs_left"].push(_scaled(stats.spring_forces.slice(0, half)))
	_strips[&"springs_right"].push(_scaled(stats.spring_forces.slice(half)))
	_strips[&"slip"].push([_largest(stats.slips.slice(0, half)), _largest(stats.slips.slice(half))])
	var attitude: Vector3 = vehicle.rotation
	_strips[&"attitude"].push([rad_to_deg(attitude.x), rad_to_deg(attitude.z)])
	_strips[&"turning"].push([rad_to_deg(vehicle.angular_velocity.y)])


## A strip by its name: rpm, gear, torque, speed, drive, springs_left, springs_right, slip,
## attitude, turning; null before there is any.
func strip(p_name: StringName) -> PlotStrip:
	return _strips.get(p_name)


func _build() -> void:
	for old: PlotStrip in _strips.values():
		old.queue_free()
	_strips.clear()
	var numbers: PackedStringArray = PackedStringArray()
	for wheel: int in maxi(_wheels - _wheels / 2, _wheels / 2):
		numbers.append(str(wheel + 1))
	_add(&"rpm", "engine, 1/min", [""], 0.0, 1000.0)
	_add(&"gear", "gear", [""], -1.0, 4.0)
	_add(&"torque", "engine, N m", [""], 0.0, 1.0)
	_add(&"speed", "speed, m/s", ["left", "right", "hull"], 0.0, 1.0)
	_add(&"drive", "drive, kN", ["left", "right"], 0.0, 1.0)
	_add(&"springs_left", "springs left, kN", numbers, 0.0, 1.0)
	_add(&"springs_right", "springs right, kN", numbers, 0.0, 1.0)
	_add(&"slip", "most slip, m/s", ["left", "right"], 0.0, 1.0)
	_add(&"attitude", "attitude, deg", ["pitch", "roll"], -5.0, 5.0)
	_add(&"turning", "turning, deg/s", [""], -10.0, 10.0)


func _add(
	p_name: StringName, p_title: String, p_names: PackedStringArray, p_from: float, p_to: float
) -> void:
	var made: PlotStrip = PlotStrip.create(p_title, p_names, p_from, p_to)
	_strips[p_name] = made
	add_child(made)


func _scaled(p_forces: PackedFloat32Array) -> PackedFloat32Array:
	for index: int in p_forces.size():
		p_forces[index] *= 0.001
	return p_forces


func _largest(p_values: PackedFloat32Array) -> float:
	var found: float = 0.0
	for value: float in p_values:
		found = maxf(found, value)
	return found
