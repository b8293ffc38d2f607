class_name EntityTableMessage
extends RefCounted
## Changes of the entity table as bytes: server to client, reliable, in [MessageParts].
##
## Little-endian: u8 message; u8 1 if all is new and what was known before is void, else 0; u32
## version of the table after the changes; f32 largest error of poses (degrees); u8 number of new
## types, each as in [method EntityType.encode], numbered on from those that are known; u16 number
## of entities that are gone, of each u16; u16 number of new entities, of each: u16 id, u8 type, u32
## tick, s32 owner, u8 source, text path, of an instance of a scene 12 f32
## transform (columns of the basis, origin), its values as in [method EntitySchema.encode]; of a
## person also u8 which of its session's people, text name, u8 limbs (0 or all) and of each 3 f32
## joint in the parent's frame, 3 f32 in its own (m), 4 f32 x, y, z, w of the body in the reset
## pose.

## Smallest and largest error of poses, degrees.
const MIN_ERROR_DEG: float = 0.02
const MAX_ERROR_DEG: float = 5.0
const _MAX_TEXT: int = 1024

## Whether what was known before is void.
var is_full: bool = false
## Version of the table after the changes.
var version: int = 0
## Maximum error of a limb's orientation in snapshots, degrees: both ends need the same.
var pose_error_deg: float = Protocol.POSE_ERROR_DEG
## New types, numbered on from those that are known.
var types: Array[EntityType] = []
## Entities that are gone.
var despawned: PackedInt32Array = PackedInt32Array()
## Entities that have come.
var spawned: Array[EntityRow] = []


## The whole of a table.
static func of_table(p_table: EntityTable, p_error_deg: float) -> EntityTableMessage:
	var message: EntityTableMessage = EntityTableMessage.new()
	message.is_full = true
	message.version = p_table.version
	message.pose_error_deg = p_error_deg
	message.types = p_table.types
	message.spawned = p_table.rows.values()
	return message


## The bytes.
func encode() -> PackedByteArray:
	var rows: PackedByteArray = []
	for row: EntityRow in spawned:
		rows.append_array(row_bytes(row))
	return encode_with(rows, spawned.size())


## The bytes, with new entities that are encoded already, see [method row_bytes].
func encode_with(p_rows: PackedByteArray, p_count: int) -> PackedByteArray:
	var bytes: PackedByteArray = [Protocol.Message.TABLE, 1 if is_full else 0, 0, 0, 0, 0]
	bytes.encode_u32(2, version)
	bytes.append_array(PackedFloat32Array([pose_error_deg]).to_byte_array())
	bytes.append(types.size())
	for type: EntityType in types:
		bytes.append_array(type.encode())
	var offset: int = bytes.size()
	bytes.resize(offset + 2 * despawned.size() + 4)
	bytes.encode_u16(offset, despawned.size())
	for index: int in despawned.size():
		bytes.encode_u16(offset + 2 + 2 * index, despawned[index])
	bytes.encode_u16(bytes.size() - 2, p_count)
	return bytes + p_rows


## The changes in a packet; null if it is none. [param p_known] are the types that are known.
static func decode(p_bytes: PackedByteArray, p_known: Array[EntityType]) -> EntityTableMessage:
	var reader: ByteReader = ByteReader.new(p_bytes)
	var message: EntityTableMessage = EntityTableMessage.new()
	if reader.read_u8() != Protocol.Message.TABLE:
		return null
	message.is_full = reader.read_u8() != 0
	message.version = reader.read_u32()
	# As exact as the number was before it went as f32.
	message.pose_error_deg = snappedf(reader.read_float(), 0.001)
	var error: float = message.pose_error_deg
	if reader.failed or error < MIN_ERROR_DEG or error > MAX_ERROR_DEG:
		return null
	var all: Array[EntityType] = []
	if not message.is_full:
		all.assign(p_known)
	for _type: int in reader.read_u8():
		var type: EntityType = EntityType.decode(reader)
		if reader.failed or all.size() >= EntityTable.MAX_TYPES:
			return null
		message.types.append(type)
		all.append(type)
	for _gone: int in reader.read_u16():
		message.despawned.append(reader.read_u16())
	var count: int = reader.read_u16()
	if reader.failed or count > EntityTable.MAX_ENTITIES:
		return null
	for _new: int in count:
		var row: EntityRow = _read_row(reader, all)
		if row == null:
			return null
		message.spawned.append(row)
	return message if reader.is_complete() else null


## Applies the changes to a client's table. Returns false, and changes nothing, if they do not fit.
func apply(p_table: EntityTable) -> bool:
	if not is_full and not _fits(p_table):
		return false
	if is_full:
		p_table.clear()
	p_table.types.append_array(types)
	for id: int in despawned:
		p_table.despawn(id)
	for row: EntityRow in spawned:
		p_table.add(row)
	p_table.version = version
	return true


## A new entity as it is sent.
static func row_bytes(p_row: EntityRow) -> PackedByteArray:
	if p_row.encoded.is_empty():
		p_row.encoded = _encode_row(p_row)
	return p_row.encoded


func _fits(p_table: EntityTable) -> bool:
	var taken: Dictionary[int, bool] = {}
	for id: int in despawned:
		if not p_table.rows.has(id):
			return false
		taken[id] = false
	for row: EntityRow in spawned:
		if taken.get(row.id, p_table.rows.has(row.id)):
			return false
		taken[row.id] = true
	var count: int = p_table.rows.size() + spawned.size() - despawned.size()
	return count <= EntityTable.MAX_ENTITIES


static func _encode_row(p_row: EntityRow) -> PackedByteArray:
	var bytes: PackedByteArray = []
	bytes.resize(12)
	bytes.encode_u16(0, p_row.id)
	bytes.encode_u8(2, p_row.type_number)
	bytes.encode_u32(3, p_row.tick)
	bytes.encode_s32(7, p_row.owner)
	bytes.encode_u8(11, p_row.source)
	bytes.append_array(ByteReader.text_bytes(p_row.path))
	if p_row.source == EntityRow.Source.SCENE:
		bytes.append_array(ByteReader.transform_bytes(p_row.transform))
	bytes.append_array(p_row.type.spawn_schema().encode(p_row.values))
	if p_row.is_person():
		bytes.append(p_row.person_index)
		bytes.append_array(ByteReader.text_bytes(p_row.person_name))
		_append_skeleton(bytes, p_row.skeleton)
	return bytes


static func _read_row(p_reader: ByteReader, p_types: Array[EntityType]) -> EntityRow:
	var row: EntityRow = EntityRow.new()
	row.id = p_reader.read_u16()
	row.type_number = p_reader.read_u8()
	row.tick = p_reader.read_u32()
	row.owner = p_reader.read_s32()
	var source: int = p_reader.read_u8()
	row.path = p_reader.read_text(_MAX_TEXT)
	if p_reader.failed or row.type_number >= p_types.size() or source >= EntityRow.Source.size():
		return null
	row.type = p_types[row.type_number]
	row.source = source as EntityRow.Source
	if row.source == EntityRow.Source.SCENE:
		row.transform = p_reader.read_transform()
	if not EntityTable.is_id_for(row.id, row.type.body):
		return null
	row.values = row.type.spawn_schema().decode(p_reader)
	if row.is_person():
		row.person_index = p_reader.read_u8()
		row.person_name = p_reader.read_text(_MAX_TEXT)
		row.skeleton = _read_skeleton(p_reader)
	return null if p_reader.failed else row


static func _append_skeleton(p_bytes: PackedByteArray, p_skeleton: PersonSkeleton) -> void:
	p_bytes.append(p_skeleton.joints_in_limb.size())
	for limb: int in p_skeleton.joints_in_limb.size():
		var outer: Vector3 = p_skeleton.joints_in_parent[limb]
		var inner: Vector3 = p_skeleton.joints_in_limb[limb]
		var reset: Quaternion = p_skeleton.reset_orientations[limb]
		var numbers: PackedFloat32Array = [outer.x, outer.y, outer.z, inner.x, inner.y, inner.z]
		numbers.append_array([reset.x, reset.y, reset.z, reset.w])
		p_bytes.append_array(numbers.to_byte_array())


static func _read_skeleton(p_reader: ByteReader) -> PersonSkeleton:
	var skeleton: PersonSkeleton = PersonSkeleton.new()
	for _limb: int in p_reader.read_u8():
		var outer: Vector3 = p_reader.read_vector()
		var inner: Vector3 = p_reader.read_vector()
		skeleton.add(outer, inner, p_reader.read_rotation())
		if p_reader.failed:
			return skeleton
	if not skeleton.joints_in_limb.is_empty() and not skeleton.is_sound():
		p_reader.failed = true
	return skeleton
