@tool
@icon("res://scenes/entity/icons/entity.svg")
class_name Entity
extends Node
## Makes something in a level part of the session: its fields go to all clients, its commands come
## from them, its events are seen by everybody at the same moment of the simulation.
##
## Put it below a body and give it an [EntityType]. A script beside it listens: on the server
## [signal commanded] says what somebody wants and [method set_value] changes what is true; on
## every machine [signal field_changed] and [signal happened] say what to show and play. The
## same scene runs on both sides; [method is_authority] distinguishes them.

## A field has another value: the server's at once, a client's at the moment that it displays.
signal field_changed(p_field: StringName, p_value: float)
## A session commands it. On the server only; the values are those of the command's schema.
signal commanded(p_session: int, p_command: StringName, p_values: PackedFloat32Array)
## An event: on the server at once, on a client when it displays the tick of the event.
signal happened(p_event: StringName, p_values: PackedFloat32Array)
## It has become part of a session (again after a change of level): fields can be read and set from
## now on.
signal started

## Group of all of them: in a large level the engine finds them at once.
const GROUP: StringName = &"entities"

## What kind of entity it is.
@export var type: EntityType:
	set(p_value):
		type = p_value
		update_configuration_warnings()
## The body that is simulated; needed where the type has a rigid body. Empty: the node above.
@export var body: PhysicsBody3D:
	set(p_value):
		body = p_value
		update_configuration_warnings()

## Number of the entity in the session, or -1 before it has started.
var id: int = -1
## Session that it belongs to, as a person does; 0 none.
var owner_session: int = 0

var _host: EntityHost = null
var _authority: EntityAuthority = null
var _values: PackedFloat32Array = PackedFloat32Array()


func _init() -> void:
	add_to_group(GROUP)


func _get_configuration_warnings() -> PackedStringArray:
	var warnings: PackedStringArray = []
	if type == null:
		warnings.append("It needs an EntityType: choose one for 'Type' in the inspector.")
	elif type.find_fault() != "":
		warnings.append("Its type cannot be used: %s." % type.find_fault())
	elif type.body == EntityType.Body.RIGID and get_body() == null:
		warnings.append("Its type has a rigid body: put it below one, or choose one for 'Body'.")
	return warnings


## The first [Entity] in a branch, or null.
static func find_in(p_branch: Node) -> Entity:
	if p_branch == null or p_branch is Entity:
		return p_branch as Entity
	for child: Node in p_branch.get_children():
		var found: Entity = find_in(child)
		if found != null:
			return found
	return null


## The body that is simulated, or null.
func get_body() -> PhysicsBody3D:
	return body if body != null else get_parent() as PhysicsBody3D


## Makes it part of a session. The program calls it, on the server and on each client.
func start(p_host: EntityHost, p_id: int, p_values: PackedFloat32Array) -> void:
	_host = p_host
	_authority = p_host as EntityAuthority
	id = p_id
	_values = p_values.duplicate()
	started.emit()


## Whether it is part of a session.
func is_started() -> bool:
	return _host != null


## Whether this is the server, which decides what is true.
func is_authority() -> bool:
	return _authority != null


## The program that it lives in; null before it has started.
func get_host() -> EntityHost:
	return _host


## The server that it lives in; null on a client, and before it has started.
func get_authority() -> EntityAuthority:
	return _authority


## The value of a field: on a client as shown.
func get_value(p_field: StringName) -> float:
	var index: int = type.find_field(p_field)
	if index < 0 or index >= _values.size():
		# A server of another version may have another type.
		Log.limited("entity", "field", "%s has no field '%s'" % [type.name, p_field])
		return 0.0
	return _values[index]


## Sets a field, on the server; everybody receives it within the field's range and resolution.
func set_value(p_field: StringName, p_value: float) -> void:
	var index: int = type.find_field(p_field)
	if index < 0 or not is_authority():
		push_error("%s: only the server sets fields, and '%s' must be one." % [type.name, p_field])
		return
	var field: EntityField = type.fields[index]
	var step: int = field.to_step(p_value)
	# Steps, not values: those are kept with fewer digits than they are computed with.
	if step != field.to_step(_values[index]):
		_values[index] = field.from_step(step)
		_authority.set_field(id, index, _values[index])
		field_changed.emit(p_field, _values[index])


## Sends everybody the event that something happens now: on the server.
func send_event(p_event: StringName, p_values: PackedFloat32Array = []) -> void:
	var index: int = type.find_event(p_event)
	if index < 0 or not is_authority():
		push_error("%s: only the server sends events, and '%s' must be one." % [type.name, p_event])
		return
	_authority.send_event(id, index, p_values)
	happened.emit(p_event, p_values)


## Asks the server for something, in the name of this client's session: at a tick of the server, or
## (-1) at the one that is displayed.
func send_command(
	p_command: StringName, p_values: PackedFloat32Array = [], p_tick: int = -1
) -> void:
	var index: int = type.find_command(p_command)
	if index < 0 or _host == null:
		push_error("%s has no command '%s', or is in no session." % [type.name, p_command])
		return
	_host.send_command(id, index, p_values, p_tick)


## Takes the value to display from now on: the program calls it on clients.
func take_value(p_index: int, p_value: float) -> void:
	if p_index >= 0 and p_index < _values.size() and _values[p_index] != p_value:
		_values[p_index] = p_value
		field_changed.emit(type.fields[p_index].name, p_value)


## Passes a command on: the program calls it on the server.
func take_command(p_session: int, p_index: int, p_values: PackedFloat32Array) -> void:
	commanded.emit(p_session, type.commands[p_index].name, p_values)


## Passes an event on: the program calls it on clients.
func take_event(p_index: int, p_values: PackedFloat32Array) -> void:
	happened.emit(type.events[p_index].name, p_values)
