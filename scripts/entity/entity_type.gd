@tool
@icon("res://scenes/entity/icons/entity_type.svg")
class_name EntityType
extends Resource
## What a kind of entity is: its body, the fields that everybody knows, the commands that it
## takes, the events that it sends, and who may command it.
##
## Sent reliably to every client that joins. A new kind of thing (a turret, a door, a scenario's
## variable) is a new resource of this class and needs no other code in the network.

## What is simulated of an entity and where it is on the wire.
enum Body {
	## Nothing: it only has fields.
	NONE,
	## One rigid body: see [member Entity.body].
	RIGID,
	## A person's limbs: see [Limbs].
	PERSON,
}

## Who may send commands to an entity.
enum CommandedBy {
	## Nobody: it acts by itself.
	NOBODY,
	## The session that possesses it: see [Possession].
	POSSESSOR,
	## Every session that may command at all: a button, a door.
	ANYBODY,
}

## Field of a person with the number of the entity that carries it; 0 none.
const CARRIER: StringName = &"carrier"
## Field of a person: how the motion's own frame is turned about the Y axis, rad.
const HEADING: StringName = &"heading"
## Fields of a person: the tether, the vector from the hips of the motion to the hips of the body,
## in the world, m; 0 where it is shorter than 0.1 m.
const TETHER_X: StringName = &"tether_x"
const TETHER_Z: StringName = &"tether_z"
## Maximum of commands, and of events, of a type.
const MAX_SCHEMAS: int = 32
## Longest name of a type, command, event or field, characters.
const MAX_NAME: int = 48

## Name of the type; the same on all machines.
@export var name: StringName = &"":
	set(p_value):
		name = p_value
		resource_name = p_value
## What is simulated of it.
@export var body: Body = Body.NONE
## The numbers that all clients know.
@export var fields: Array[EntityField] = []
## What it can be commanded to do.
@export var commands: Array[EntitySchema] = []
## What can happen to it.
@export var events: Array[EntitySchema] = []
## Who may command it.
@export var commanded_by: CommandedBy = CommandedBy.NOBODY

var _spawn_schema: EntitySchema = null


## The type of a person with a body and nothing else.
static func person() -> EntityType:
	var type: EntityType = EntityType.new()
	type.name = &"person"
	type.body = Body.PERSON
	type.fields = [
		EntityField.create_count(CARRIER, 65536),
		EntityField.create(HEADING, EntityField.Kind.ANGLE, -PI, PI, 0.001),
		EntityField.create(TETHER_X, EntityField.Kind.STEP, -100.0, 100.0, 0.05),
		EntityField.create(TETHER_Z, EntityField.Kind.STEP, -100.0, 100.0, 0.05),
	]
	return type


## Position of a field in the list, or -1.
func find_field(p_name: StringName) -> int:
	for index: int in fields.size():
		if fields[index].name == p_name:
			return index
	return -1


## Position of a command in the list, or -1.
func find_command(p_name: StringName) -> int:
	return _find(commands, p_name)


## Position of an event in the list, or -1.
func find_event(p_name: StringName) -> int:
	return _find(events, p_name)


## The fields as a list of values, as a spawn has it. The type must not change afterwards.
func spawn_schema() -> EntitySchema:
	if _spawn_schema == null or _spawn_schema.fields != fields:
		_spawn_schema = EntitySchema.create(&"spawn", fields)
	return _spawn_schema


## Defines the type in an encoder or decoder: [param p_define_type] is its method
## [method SnapshotEncoder.define_type].
func define(p_define_type: Callable, p_number: int) -> void:
	var kinds: PackedByteArray = []
	var mins: PackedFloat32Array = []
	var maxs: PackedFloat32Array = []
	var resolutions: PackedFloat32Array = []
	for field: EntityField in fields:
		kinds.append(field.kind)
		mins.append(field.min_value)
		maxs.append(field.max_value)
		resolutions.append(field.resolution)
	p_define_type.call(p_number, kinds, mins, maxs, resolutions)


## Whether another type is the same on the wire.
func is_same(p_other: EntityType) -> bool:
	return encode() == p_other.encode()


## Why this type is invalid and how to fix it, or an empty text.
func find_fault() -> String:
	if name == &"" or String(name).length() > MAX_NAME:
		return "a type needs a name of at most %d characters" % MAX_NAME
	var fault: String = EntitySchema.find_fault_in(fields, "type '%s'" % name)
	if fault != "":
		return fault
	for list: Array[EntitySchema] in [commands, events]:
		var names: Dictionary[StringName, bool] = {}
		if list.size() > MAX_SCHEMAS:
			return "type '%s': more than %d commands or events" % [name, MAX_SCHEMAS]
		for schema: EntitySchema in list:
			if schema == null:
				return "type '%s' has an empty command or event: remove it" % name
			if schema.find_fault() != "":
				return "type '%s': %s" % [name, schema.find_fault()]
			if names.has(schema.name):
				return "type '%s' has '%s' twice" % [name, schema.name]
			if schema.seat != &"" and find_field(schema.seat) < 0:
				return "type '%s': '%s' needs the field '%s'" % [name, schema.name, schema.seat]
			names[schema.name] = true
	return ""


## The type as bytes. Little-endian: text name, u8 [enum Body], u8 [enum CommandedBy], fields,
## u8 number of commands, of each text name and fields, u8 number of events, of each text name,
## u8 reliable, fields. Fields: u8 number, of each text name, u8 [enum EntityField.Kind],
## f64 lowest, highest, resolution, default.
func encode() -> PackedByteArray:
	var bytes: PackedByteArray = ByteReader.text_bytes(name)
	bytes.append_array([body, commanded_by])
	bytes.append_array(_field_bytes(fields))
	bytes.append(commands.size())
	for schema: EntitySchema in commands:
		bytes.append_array(ByteReader.text_bytes(schema.name) + _field_bytes(schema.fields))
	bytes.append(events.size())
	for schema: EntitySchema in events:
		bytes.append_array(ByteReader.text_bytes(schema.name))
		bytes.append(1 if schema.is_reliable else 0)
		bytes.append_array(_field_bytes(schema.fields))
	return bytes


## Reads a type; [member ByteReader.failed] is true if it is invalid.
static func decode(p_reader: ByteReader) -> EntityType:
	var type: EntityType = EntityType.new()
	type.name = p_reader.read_text(4 * MAX_NAME)
	var body_kind: int = p_reader.read_u8()
	var commander: int = p_reader.read_u8()
	if body_kind >= Body.size() or commander >= CommandedBy.size():
		p_reader.failed = true
		return type
	type.body = body_kind as Body
	type.commanded_by = commander as CommandedBy
	type.fields = _read_fields(p_reader)
	for _command: int in p_reader.read_u8():
		if not p_reader.failed:
			var name_read: String = p_reader.read_text(4 * MAX_NAME)
			type.commands.append(EntitySchema.create(name_read, _read_fields(p_reader)))
	for _event: int in p_reader.read_u8():
		if not p_reader.failed:
			var name_read: String = p_reader.read_text(4 * MAX_NAME)
			var is_reliable: bool = p_reader.read_u8() != 0
			type.events.append(EntitySchema.create(name_read, _read_fields(p_reader), is_reliable))
	p_reader.failed = p_reader.failed or type.find_fault() != ""
	return type


static func _field_bytes(p_fields: Array[EntityField]) -> PackedByteArray:
	var bytes: PackedByteArray = [p_fields.size()]
	for field: EntityField in p_fields:
		bytes.append_array(ByteReader.text_bytes(field.name))
		bytes.append(field.kind)
		var numbers: PackedFloat64Array = [
			field.min_value, field.max_value, field.resolution, field.default_value
		]
		bytes.append_array(numbers.to_byte_array())
	return bytes


static func _read_fields(p_reader: ByteReader) -> Array[EntityField]:
	var fields_read: Array[EntityField] = []
	for _field: int in p_reader.read_u8():
		if p_reader.failed:
			return fields_read
		var field: EntityField = EntityField.new()
		field.name = p_reader.read_text(4 * MAX_NAME)
		var kind: int = p_reader.read_u8()
		p_reader.failed = p_reader.failed or kind >= EntityField.Kind.size()
		field.kind = clampi(kind, 0, EntityField.Kind.size() - 1) as EntityField.Kind
		field.min_value = p_reader.read_double()
		field.max_value = p_reader.read_double()
		field.resolution = p_reader.read_double()
		field.default_value = p_reader.read_double()
		fields_read.append(field)
	return fields_read


static func _find(p_list: Array[EntitySchema], p_name: StringName) -> int:
	for index: int in p_list.size():
		if p_list[index].name == p_name:
			return index
	return -1
