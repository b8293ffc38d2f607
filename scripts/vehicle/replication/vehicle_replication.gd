@tool
@icon("res://scenes/vehicle/icons/vehicle.svg")
class_name VehicleReplication
extends Node
## Makes a [Vehicle] part of a session: its state goes to all clients as fields of its [Entity], and
## what its crew commands comes from them.
##
## Fields and commands that the entity's type does not have are left out, so that a truck needs no
## turret. Where there is a display it adds the view below the vehicle.

## Fields of the type that are properties of [VehicleState] of the same name.
const NUMBERS: Array[StringName] = [
	&"rpm",
	&"load",
	&"left_speed",
	&"right_speed",
	&"turret_yaw",
	&"gun_pitch",
	&"hatch",
	&"loader_hatch",
	&"steer",
	&"brake",
]
## The same that are whole numbers: 0 and 1 are no and yes.
const COUNTS: Array[StringName] = [&"gear", &"lamps", &"damage", &"engine_on", &"stabilised"]
## Time without a command after which a driver, or a gunner who aims, has let go of everything, s.
const DEAD_MAN_S: float = 0.5
## Commands that open and shut hatches: of the commander and of the loader.
const HATCHES: Array[StringName] = [&"open_hatch", &"open_loader_hatch"]
## How fast hatches open and shut, 1/s.
const HATCH_RATE: float = 1.0 / 0.7

## The vehicle.
@export var vehicle: Vehicle = null:
	set(p_value):
		vehicle = p_value
		update_configuration_warnings()
## Its entity.
@export var entity: Entity = null:
	set(p_value):
		entity = p_value
		update_configuration_warnings()
## Its turret, if it has one.
@export var turret: VehicleTurret = null
## The seat of the driver: who leaves it lets go of everything.
@export var driver_seat: Seat = null
## The seat of whoever aims.
@export var gunner_seat: Seat = null
## Scene with the [VehicleView].
@export_file("*.tscn") var view_scene: String = ""

## What is seen of the vehicle; null where there is no display.
var view: VehicleView = null

var _sent: Dictionary[StringName, float] = {}
var _hatch_wanted: float = 0.0
var _loader_hatch_wanted: float = 0.0
var _silent_s: float = 0.0
var _aim_silent_s: float = 0.0


func _ready() -> void:
	if vehicle == null or entity == null:
		return
	if Engine.is_editor_hint():
		_show_in_editor()
		return
	entity.commanded.connect(_on_commanded)
	entity.field_changed.connect(_on_field_changed)
	entity.started.connect(_on_started)
	if driver_seat != null:
		driver_seat.occupied.connect(_on_driver_changed)
	if gunner_seat != null:
		gunner_seat.occupied.connect(_on_gunner_changed)
	if view_scene != "" and DisplayServer.get_name() != "headless":
		view = (load(view_scene) as PackedScene).instantiate() as VehicleView
		view.state = vehicle.state
		vehicle.add_child.call_deferred(view)


func _physics_process(p_delta: float) -> void:
	if Engine.is_editor_hint() or entity == null or not entity.is_authority():
		return
	var state: VehicleState = vehicle.state
	state.hatch = move_toward(state.hatch, _hatch_wanted, HATCH_RATE * p_delta)
	state.loader_hatch = move_toward(state.loader_hatch, _loader_hatch_wanted, HATCH_RATE * p_delta)
	_silent_s += p_delta
	if _silent_s > DEAD_MAN_S and driver_seat != null and driver_seat.occupant() != 0:
		_let_go()
	_aim_silent_s += p_delta
	if _aim_silent_s > DEAD_MAN_S and _has_gunner():
		turret.aim = Vector2.ZERO
	for name: StringName in _sent:
		var value: float = float(state.get(name))
		if value != _sent[name]:
			_sent[name] = value
			entity.set_value(name, value)


func _get_configuration_warnings() -> PackedStringArray:
	if vehicle == null:
		return ["It needs the Vehicle that it tells of: choose one in the inspector."]
	if entity == null:
		return ["It needs the Entity of the vehicle: choose one in the inspector."]
	return []


func _on_started() -> void:
	_sent.clear()
	for name: StringName in NUMBERS + COUNTS:
		if entity.type.find_field(name) < 0:
			continue
		if entity.is_authority():
			_sent[name] = NAN
		else:
			_on_field_changed(name, entity.get_value(name))


func _on_field_changed(p_field: StringName, p_value: float) -> void:
	if entity.is_authority():
		_open_for(p_field, p_value)
		return
	var state: VehicleState = vehicle.state
	match p_field:
		&"gear":
			state.gear = roundi(p_value)
		&"damage":
			state.damage = clampi(roundi(p_value), 0, 2) as VehicleState.Damage
		&"lamps":
			state.lamps = p_value > 0.5
		&"engine_on":
			state.engine_on = p_value > 0.5
		&"stabilised":
			state.stabilised = p_value > 0.5
		_:
			if NUMBERS.has(p_field):
				state.set(p_field, p_value)


func _on_commanded(p_session: int, p_command: StringName, p_values: PackedFloat32Array) -> void:
	match p_command:
		&"drive":
			_drive(p_values)
		&"engine":
			vehicle.set_engine_on(p_values[0] > 0.5)
		&"lamps":
			vehicle.state.lamps = p_values[0] > 0.5
		&"aim":
			if turret != null:
				turret.aim = Vector2(p_values[0], p_values[1])
				_aim_silent_s = 0.0
		&"stabilise":
			if turret != null:
				turret.set_stabilised(p_values[0] > 0.5)
		&"open_hatch", &"open_loader_hatch":
			_open(p_session, p_command, p_values[0] > 0.5)
		&"upright":
			vehicle.reset_upright()


func _drive(p_values: PackedFloat32Array) -> void:
	vehicle.input.take_values(p_values)
	_silent_s = 0.0


func _on_driver_changed(_session: int) -> void:
	if entity.is_authority():
		_let_go()


func _on_gunner_changed(_session: int) -> void:
	if entity.is_authority() and turret != null:
		turret.aim = Vector2.ZERO


## The driver lets go of everything; the brake holds the vehicle.
func _let_go() -> void:
	vehicle.input.clear()
	vehicle.input.brake = 1.0 if driver_seat.occupant() != 0 else 0.0


## Opens a hatch for whoever takes its seat: nobody stands in a shut one.
func _open_for(p_field: StringName, p_session: float) -> void:
	for name: StringName in HATCHES:
		var index: int = entity.type.find_command(name)
		if p_session != 0.0 and index >= 0 and entity.type.commands[index].seat == p_field:
			_open(int(p_session), name, true)


func _open(p_session: int, p_command: StringName, p_is_open: bool) -> void:
	var possession: Possession = (entity.get_authority() as SeatAuthority).possession()
	if not p_is_open and possession.has_people.call(p_session):
		possession.refused.emit(p_session, "cannot shut the hatch that its own body stands in")
	elif p_command == HATCHES[0]:
		_hatch_wanted = float(p_is_open)
	else:
		_loader_hatch_wanted = float(p_is_open)


func _has_gunner() -> bool:
	return turret != null and gunner_seat != null and gunner_seat.occupant() != 0


func _show_in_editor() -> void:
	if view_scene == "" or not ResourceLoader.exists(view_scene):
		return
	var shown: Node = (load(view_scene) as PackedScene).instantiate()
	shown.process_mode = Node.PROCESS_MODE_DISABLED
	vehicle.add_child.call_deferred(shown, false, Node.INTERNAL_MODE_BACK)
