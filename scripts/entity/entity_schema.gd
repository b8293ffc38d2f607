@tool
class_name EntitySchema
extends Resource
## A named list of values: what a command or an event of an entity carries.
##
## On the wire each value is a step of its [EntityField], little-endian in as few bytes as its
## range takes.

## Maximum of values in a list.
const MAX_FIELDS: int = 32

## Name of the command or event within its type.
@export var name: StringName = &"":
	set(p_value):
		name = p_value
		resource_name = p_value
## What it carries, in this order.
@export var fields: Array[EntityField] = []
## Of an event: whether it is sent reliably. Unreliable ones are repeated a few times, arrive
## sooner, and may get lost on a bad network. Not used for a command.
@export var is_reliable: bool = true
## Of a command: the field with the session that alone may send it, as [member Seat.occupant_field]
## is; empty: whoever the type says. Only the server knows it.
@export var seat: StringName = &""
## Of a command: the [enum Roles.Capability] that its sender's role needs besides; 0 none. Only the
## server knows it.
@export_flags("Send motion", "Command", "Direct", "Moderate", "Review") var capability: int = 0


## A command or event, for types that are made by a script.
static func create(
	p_name: StringName, p_fields: Array[EntityField] = [], p_is_reliable: bool = true
) -> EntitySchema:
	var schema: EntitySchema = EntitySchema.new()
	schema.name = p_name
	schema.fields = p_fields
	schema.is_reliable = p_is_reliable
	return schema


## The values of a new entity.
func defaults() -> PackedFloat32Array:
	var values: PackedFloat32Array = []
	for field: EntityField in fields:
		values.append(field.quantize(field.default_value))
	return values


## Bytes of the values.
func size() -> int:
	var bytes: int = 0
	for field: EntityField in fields:
		bytes += field.size()
	return bytes


## Values as bytes; those that are missing count as their defaults.
func encode(p_values: PackedFloat32Array) -> PackedByteArray:
	var bytes: PackedByteArray = []
	bytes.resize(size())
	var offset: int = 0
	for index: int in fields.size():
		var field: EntityField = fields[index]
		var is_given: bool = index < p_values.size()
		var step: int = field.to_step(p_values[index] if is_given else field.default_value)
		match field.size():
			1:
				bytes.encode_u8(offset, step)
			2:
				bytes.encode_u16(offset, step)
			_:
				bytes.encode_u32(offset, step)
		offset += field.size()
	return bytes


## Reads values. [member ByteReader.failed] is true if they are invalid, as a step out of range is.
func decode(p_reader: ByteReader) -> PackedFloat32Array:
	var values: PackedFloat32Array = []
	for field: EntityField in fields:
		var step: int = 0
		match field.size():
			1:
				step = p_reader.read_u8()
			2:
				step = p_reader.read_u16()
			_:
				step = p_reader.read_u32()
		p_reader.failed = p_reader.failed or step > field.steps()
		values.append(field.from_step(step))
	return values


## Why this schema is invalid and how to fix it, or an empty text.
func find_fault() -> String:
	if name == &"":
		return "a command or event has no name"
	return find_fault_in(fields, "'%s'" % name)


## Why a list of fields cannot be used and how to fix it, or an empty text.
static func find_fault_in(p_fields: Array[EntityField], p_where: String) -> String:
	if p_fields.size() > MAX_FIELDS:
		return "%s has %d fields, %d are the most" % [p_where, p_fields.size(), MAX_FIELDS]
	var names: Dictionary[StringName, bool] = {}
	for field: EntityField in p_fields:
		if field == null:
			return "%s has an empty field: remove it or choose an EntityField" % p_where
		if field.find_fault() != "":
			return "%s: %s" % [p_where, field.find_fault()]
		if names.has(field.name):
			return "%s has two fields named '%s'" % [p_where, field.name]
		names[field.name] = true
	return ""
