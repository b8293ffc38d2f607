class_name SeatControls
extends Node
## Lets this machine's user drive, aim and shoot from the seat of a vehicle that the session has
## taken, by keys, mouse, gamepad, wheel and pedals, and look out of it.
##
## It finds the seat by itself. Commands go to the vehicle's entity; the server decides.

## Another view is looked through from now on; null: none, as nobody sits any more.
signal view_changed(p_view: SeatView)
## A text that the screen shows for a while.
signal notified(p_text: String)
## Another seat, or none (null).
signal seat_changed(p_seat: Seat)

## Time between two commands of a driver or of a gunner who aims, s: they tell the server that the
## user is still there.
const REPEAT_S: float = 0.1
## Time between two commands of a held trigger, s: the server releases a trigger that it hears
## nothing of.
const TRIGGER_S: float = 1.0
## How far a drag turns the view or the aim, rad for each pixel at magnification 1.
const MOUSE: float = 0.003
## Aiming rates, as shares of the gunner's greatest rate, per rad/s of the mouse.
const MOUSE_AIM: float = 1.4
const _LOOK_S: float = 0.1

## What driver's hands and feet do.
var reader: DriveReader = DriveReader.new(ControlSettings.new())
## Whether the user has a body in the world, whose eyes are the first view.
var has_body: bool = false
## Whether keys and sticks are used by something else now, such as a menu.
var hands_off: bool = false
## A list that drives instead of hands and feet; null: none.
var list: DriveScript = null
## What the driver does now, as it was sent last.
var input: VehicleInput = VehicleInput.new()
## The seat, or null.
var seat: Seat = null
## The vehicle that it is in, or null.
var vehicle: Vehicle = null
## The view that is looked through, or null.
var view: SeatView = null
## The server's tick that a driver's commands are meant for; -1: the one that is displayed.
var command_tick: int = -1

var _entity: Entity = null
## Whether a seat was taken, even if it has been freed since.
var _sits: bool = false
var _looked_s: float = 0.0
var _sent: PackedFloat32Array = []
var _sent_aim: Vector2 = Vector2.ZERO
var _aimed_s: float = 0.0
var _sent_s: float = 0.0
var _mouse: Vector2 = Vector2.ZERO
var _ammunition: int = 0
var _trigger_s: float = 0.0


func _process(p_delta: float) -> void:
	_looked_s += p_delta
	var is_lost: bool = _sits and not (is_instance_valid(seat) and is_instance_valid(vehicle))
	if _looked_s >= _LOOK_S or is_lost:
		_looked_s = 0.0
		var found: Seat = find_seat(get_tree())
		if is_lost or found != seat:
			_take(found)


func _physics_process(p_delta: float) -> void:
	if not is_instance_valid(vehicle) or not is_instance_valid(seat) or not seat.is_mine():
		return
	_sent_s += p_delta
	if has_command(&"drive"):
		if list != null:
			list.advance(p_delta)
			list.read(input)
		elif hands_off:
			input.clear()
		else:
			reader.read(input, p_delta)
		_send_drive()
	if has_command(&"aim"):
		_send_aim(p_delta)
	_trigger_s += p_delta
	if _trigger_s > TRIGGER_S and Input.is_action_pressed(&"fire_coax") and not hands_off:
		_trigger_s = 0.0
		_order(&"fire_coax", [1.0])


func _unhandled_input(p_event: InputEvent) -> void:
	if not is_instance_valid(vehicle) or not is_instance_valid(seat):
		return
	var is_taken: bool = true
	if p_event is InputEventMouseMotion:
		is_taken = _take_motion(p_event as InputEventMouseMotion)
	elif p_event.is_action_pressed(&"change_view"):
		change_view()
	elif p_event.is_action_pressed(&"next_seat"):
		change_seat()
	elif p_event.is_action_pressed(&"next_magnification") and view != null:
		view.change_magnification()
	else:
		is_taken = _take_key(p_event)
	if is_taken:
		get_viewport().set_input_as_handled()


## The seat that this machine's session has taken in a vehicle, or null.
static func find_seat(p_tree: SceneTree) -> Seat:
	for node: Node in p_tree.get_nodes_in_group(Interactable.GROUP):
		var found: Seat = node as Seat
		if found != null and found.entity != null and found.is_mine():
			return found if Vehicle.find_above(found) != null else null
	return null


## Whether the seat that is taken may give a command.
func has_command(p_name: StringName) -> bool:
	var index: int = _entity.type.find_command(p_name)
	if index < 0:
		return false
	# Which seat a command belongs to is the server's business; the scene has it here too.
	var wanted: StringName = _entity.type.commands[index].seat
	return wanted == &"" or wanted == seat.occupant_field


## The next view of the seat.
func change_view() -> void:
	var views: Array[SeatView] = views_of(seat)
	if has_body:
		# Between the last and the first one: the own body's view.
		views.append(null)
	if views.is_empty():
		return
	_look_through(views[(views.find(view) + 1) % views.size()])
	notified.emit(view.get_title() if view != null else "Your own view")


## The next seat of the vehicle that is free.
func change_seat() -> void:
	var seats: Array[Seat] = []
	for node: Node in vehicle.find_children("*", "", true, false):
		if node is Seat:
			seats.append(node)
	seats.sort_custom(func(a: Seat, b: Seat) -> bool: return a.index < b.index)
	var at: int = seats.find(seat)
	for offset: int in range(1, seats.size()):
		var next: Seat = seats[(at + offset) % seats.size()]
		if next.occupant() == 0:
			next.interact()
			return
	notified.emit("No other seat is free")


## The views of a seat: its own, then those of all seats of its vehicle.
static func views_of(p_seat: Seat) -> Array[SeatView]:
	var own: Array[SeatView] = []
	var shared: Array[SeatView] = []
	var within: Vehicle = Vehicle.find_above(p_seat)
	for node: Node in p_seat.get_tree().get_nodes_in_group(SeatView.GROUP):
		var each: SeatView = node as SeatView
		if each.seat == p_seat:
			own.append(each)
		elif each.seat == null and within.is_ancestor_of(each):
			shared.append(each)
	return own + shared


## Turns the aim by the mouse, or the view where there is nothing to aim.
func _take_motion(p_event: InputEventMouseMotion) -> bool:
	var is_held: bool = (
		p_event.button_mask & (MOUSE_BUTTON_MASK_LEFT | MOUSE_BUTTON_MASK_RIGHT) != 0
	)
	if not is_held or view == null:
		return false
	var by: Vector2 = -p_event.relative * MOUSE / view.magnification()
	if view.kind == SeatView.Kind.SIGHT:
		_mouse += by
	else:
		view.turn(by)
	return true


func _take_key(p_event: InputEvent) -> bool:
	var state: VehicleState = vehicle.state
	if p_event.is_action_pressed(&"drive_gear"):
		reader.change_gear()
		notified.emit("Gear: %s" % VehicleInput.Selector.find_key(reader.gear).to_lower())
	elif p_event.is_action_pressed(&"drive_engine"):
		_order(&"engine", [0.0 if state.engine_on else 1.0])
	elif p_event.is_action_pressed(&"drive_lamps"):
		_order(&"lamps", [0.0 if state.lamps else 1.0])
	elif p_event.is_action_pressed(&"toggle_hatch"):
		_order(&"open_hatch", [0.0 if state.hatch > 0.5 else 1.0])
		_order(&"open_loader_hatch", [0.0 if state.loader_hatch > 0.5 else 1.0])
	elif p_event.is_action_pressed(&"toggle_stabiliser"):
		_order(&"stabilise", [0.0 if state.stabilised else 1.0])
	elif p_event.is_action_pressed(&"next_ammunition"):
		_change_ammunition()
	elif p_event.is_action_pressed(&"fire"):
		_order(&"fire", [])
	elif p_event.is_action(&"fire_coax") and not p_event.is_echo():
		_order(&"fire_coax", [1.0 if p_event.is_action_pressed(&"fire_coax") else 0.0])
	else:
		return false
	return true


func _change_ammunition() -> void:
	if _entity.type.find_field(&"ammunition") < 0:
		return
	var field: EntityField = _entity.type.fields[_entity.type.find_field(&"ammunition")]
	var kinds: int = int(field.max_value) + 1
	_ammunition = (int(_entity.get_value(&"ammunition")) + 1) % kinds
	_order(&"load", [_ammunition])


## Sends a command if the seat that is taken has it.
func _order(p_command: StringName, p_values: PackedFloat32Array) -> void:
	if has_command(p_command):
		_entity.send_command(p_command, p_values)


func _send_drive() -> void:
	var values: PackedFloat32Array = input.to_values()
	if values != _sent or _sent_s >= REPEAT_S:
		_sent = values
		_sent_s = 0.0
		_entity.send_command(&"drive", values, command_tick)


## Keys and sticks ask for a rate; the mouse asks for an angle, which becomes the rate that covers
## it in this frame.
func _send_aim(p_delta: float) -> void:
	var aim: Vector2 = Vector2(
		Input.get_axis(&"aim_right", &"aim_left"), Input.get_axis(&"aim_down", &"aim_up")
	)
	if view != null and view.kind == SeatView.Kind.SIGHT:
		# What is magnified is aimed at more finely.
		aim = aim * aim.abs() / sqrt(view.magnification())
	if hands_off:
		aim = Vector2.ZERO
	aim += _mouse / p_delta * MOUSE_AIM
	_mouse = Vector2.ZERO
	aim = aim.clampf(-1.0, 1.0)
	_aimed_s += p_delta
	if aim != _sent_aim or (aim != Vector2.ZERO and _aimed_s > REPEAT_S):
		_sent_aim = aim
		_aimed_s = 0.0
		_entity.send_command(&"aim", [aim.x, aim.y])


func _take(p_seat: Seat) -> void:
	seat = p_seat
	_sits = seat != null
	vehicle = null if seat == null else Vehicle.find_above(seat)
	_entity = null if seat == null else seat.entity
	reader.clear()
	if list != null:
		list.restart()
	_sent = []
	_sent_aim = Vector2.ZERO
	_mouse = Vector2.ZERO
	var views: Array[SeatView] = []
	if seat != null:
		views = views_of(seat)
	_look_through(views[0] if not views.is_empty() and not has_body else null)
	seat_changed.emit(seat)


func _look_through(p_view: SeatView) -> void:
	if is_instance_valid(view):
		view.set_active(false)
	view = p_view
	if view != null:
		view.set_active(true)
	view_changed.emit(view)
