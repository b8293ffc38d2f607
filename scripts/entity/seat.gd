@tool
@icon("res://scenes/entity/icons/seat.svg")
class_name Seat
extends SeatGeometry
## A seat for one in something that moves: whoever takes the first one possesses the entity, and
## the occupant's people are carried along in the entity's frame.
##
## The entity's type needs the field [member occupant_field] (see [method add_to]) and the commands
## [constant TAKE] and [constant LEAVE]. An entity with several seats gives each an [member index],
## a field of its own and [constant TAKE] a value, the index; commands that belong to one of them
## name its field in [member EntitySchema.seat]. A session sits once: taking a seat leaves the one
## before.
##
## [SeatGeometry] says where it is, and how it holds who sits there.

## Somebody has taken or left the seat; 0 is nobody. On every machine.
signal occupied(p_session: int)

## Command that takes the seat.
const TAKE: StringName = &"take_seat"
## Command that leaves the seat.
const LEAVE: StringName = &"leave_seat"
## Highest number of a session that a seat's field can hold.
const MAX_SESSION: int = 1 << 16

## The field with the session of who sits here.
@export var occupant_field: StringName = &"occupant"


func _ready() -> void:
	if not Engine.is_editor_hint() and entity != null:
		entity.commanded.connect(_on_commanded)
		entity.field_changed.connect(_on_field_changed)


func _get_configuration_warnings() -> PackedStringArray:
	if entity == null or entity.type == null:
		return ["It needs the Entity that it is part of: choose one in the inspector."]
	var type: EntityType = entity.type
	if type.find_field(occupant_field) < 0:
		return ["The type '%s' needs a field '%s'." % [type.name, occupant_field]]
	if type.find_command(TAKE) < 0 or type.find_command(LEAVE) < 0:
		return ["The type '%s' needs the commands '%s' and '%s'." % [type.name, TAKE, LEAVE]]
	return []


## Adds the field and the commands of a seat to a type that is made by a script.
static func add_to(p_type: EntityType, p_field: StringName = &"occupant") -> void:
	p_type.fields.append(EntityField.create_count(p_field, MAX_SESSION))
	if p_type.find_command(TAKE) < 0:
		p_type.commands.append(EntitySchema.create(TAKE))
		p_type.commands.append(EntitySchema.create(LEAVE))


func get_prompt() -> String:
	if is_mine():
		return "leave"
	return (prompt if prompt != "" else "take the seat") if occupant() == 0 else ""


func interact() -> void:
	if is_mine():
		entity.send_command(LEAVE)
	else:
		entity.send_command(TAKE, [index])


## Whether this client's session sits here.
func is_mine() -> bool:
	return entity.is_started() and occupant() != 0 and occupant() == entity.get_host().session()


## The session that sits here; 0 nobody.
func occupant() -> int:
	return int(entity.get_value(occupant_field)) if entity.is_started() else 0


## Frees the seat: on the server.
func vacate() -> void:
	var session: int = occupant()
	if session == 0:
		return
	var host: SeatAuthority = _host()
	if index == 0:
		host.possession().release(entity.id)
	host.possession().sit(session, null)
	host.detach(session)
	entity.set_value(occupant_field, 0)


## Seats a session that leaves its former seat for it: on the server. Returns whether it could.
func take(p_session: int) -> bool:
	var host: SeatAuthority = _host()
	var possession: Possession = host.possession()
	var former: Seat = possession.seat_of(p_session) as Seat
	if occupant() != 0:
		return false
	if not possession.may_sit(p_session):
		possession.refused.emit(p_session, "takes seats faster than people can")
		return false
	if former != null and former.entity != entity and not former._lets_go(p_session):
		return false
	if index == 0 and not possession.take(p_session, entity.id):
		return false
	if former != null:
		former.vacate()
	possession.sit(p_session, self)
	entity.set_value(occupant_field, p_session)
	if carries_people:
		host.attach(p_session, entity.id, self)
	return true


func _on_commanded(p_session: int, p_command: StringName, p_values: PackedFloat32Array) -> void:
	if p_command == TAKE and (p_values.is_empty() or int(p_values[0]) == index):
		take(p_session)
	elif p_command == LEAVE and occupant() == p_session:
		if _lets_go(p_session):
			vacate()


## Whether a session can leave the seat now; if it cannot, it gets a notice that says why.
func _lets_go(p_session: int) -> bool:
	var possession: Possession = _host().possession()
	var has_people: bool = possession.has_people.call(p_session)
	var hindrance: String = find_hindrance() if has_people else ""
	if hindrance != "":
		possession.refused.emit(p_session, hindrance)
	return hindrance == ""


func _on_field_changed(p_field: StringName, p_value: float) -> void:
	if p_field == occupant_field:
		occupied.emit(int(p_value))


func _host() -> SeatAuthority:
	return entity.get_authority() as SeatAuthority
