class_name CallValues
extends RefCounted
## The arguments of a call between server and clients as bytes. Godot's own decoder reports an
## engine error for each byte that is wrong; this one only fails.
##
## A value, little-endian: u8 [enum Kind], then what the kind needs: nothing, u8, s64, f64, text,
## 2, 3 or 4 f64, the 12 f32 of a transform, u16 size and bytes, u8 count and that many values, u8
## count and that many keys and values.

## What a value is.
enum Kind {
	NULL,
	BOOL,
	INT,
	FLOAT,
	STRING,
	STRING_NAME,
	VECTOR2,
	VECTOR3,
	QUATERNION,
	COLOR,
	TRANSFORM3D,
	BYTES,
	ARRAY,
	DICTIONARY,
}

## Arrays and dictionaries may lie in each other this deep.
const MAX_DEPTH: int = 4
## Longest text and most bytes of one value.
const MAX_SIZE: int = 1000

const _TYPES: Dictionary[Variant.Type, Kind] = {
	TYPE_NIL: Kind.NULL,
	TYPE_BOOL: Kind.BOOL,
	TYPE_INT: Kind.INT,
	TYPE_FLOAT: Kind.FLOAT,
	TYPE_STRING: Kind.STRING,
	TYPE_STRING_NAME: Kind.STRING_NAME,
	TYPE_VECTOR2: Kind.VECTOR2,
	TYPE_VECTOR3: Kind.VECTOR3,
	TYPE_QUATERNION: Kind.QUATERNION,
	TYPE_COLOR: Kind.COLOR,
	TYPE_TRANSFORM3D: Kind.TRANSFORM3D,
	TYPE_PACKED_BYTE_ARRAY: Kind.BYTES,
	TYPE_ARRAY: Kind.ARRAY,
	TYPE_DICTIONARY: Kind.DICTIONARY,
}


## Adds a value to bytes. Returns why it cannot be sent, or an empty text.
static func append(r_bytes: PackedByteArray, p_value: Variant, p_depth: int = 0) -> String:
	if not _TYPES.has(typeof(p_value)):
		return "a %s cannot be sent" % type_string(typeof(p_value))
	if p_depth > MAX_DEPTH:
		return "arrays and dictionaries lie more than %d deep in each other" % MAX_DEPTH
	var kind: Kind = _TYPES[typeof(p_value)]
	r_bytes.append(kind)
	match kind:
		Kind.BOOL:
			r_bytes.append(1 if p_value else 0)
		Kind.INT:
			r_bytes.append_array(PackedInt64Array([p_value]).to_byte_array())
		Kind.STRING, Kind.STRING_NAME:
			r_bytes.append_array(ByteReader.text_bytes(p_value))
		Kind.TRANSFORM3D:
			r_bytes.append_array(ByteReader.transform_bytes(p_value))
		Kind.BYTES:
			r_bytes.append_array([p_value.size() & 0xFF, p_value.size() >> 8])
			r_bytes.append_array(p_value)
		Kind.ARRAY:
			return _append_all(r_bytes, p_value, p_depth)
		Kind.DICTIONARY:
			var flat: Array = []
			for key: Variant in p_value:
				flat.append_array([key, p_value[key]])
			return _append_all(r_bytes, flat, p_depth, 2)
		_:
			r_bytes.append_array(_numbers_of(kind, p_value).to_byte_array())
	return "" if r_bytes.size() <= Protocol.MAX_DATAGRAM else "the arguments are too large"


## Reads a value; the reader has failed if there is none.
static func read(p_reader: ByteReader, p_depth: int = 0) -> Variant:
	var kind: int = p_reader.read_u8()
	if p_reader.failed or kind >= Kind.size() or p_depth > MAX_DEPTH:
		p_reader.failed = true
		return null
	match kind:
		Kind.NULL:
			return null
		Kind.BOOL:
			return p_reader.read_u8() != 0
		Kind.INT:
			var low: int = p_reader.read_u32()
			return low | (p_reader.read_u32() << 32)
		Kind.STRING:
			return p_reader.read_text(MAX_SIZE)
		Kind.STRING_NAME:
			return StringName(p_reader.read_text(MAX_SIZE))
		Kind.TRANSFORM3D:
			return p_reader.read_transform()
		Kind.BYTES:
			return p_reader.read_bytes(mini(p_reader.read_u16(), MAX_SIZE))
		Kind.ARRAY:
			return _read_all(p_reader, p_depth, 1)
		Kind.DICTIONARY:
			var flat: Array = _read_all(p_reader, p_depth, 2)
			var made: Dictionary = {}
			for index: int in range(0, flat.size() - 1, 2):
				made[flat[index]] = flat[index + 1]
			return made
	return _read_numbers(p_reader, kind)


static func _append_all(
	r_bytes: PackedByteArray, p_values: Array, p_depth: int, p_each: int = 1
) -> String:
	if p_values.size() / p_each > 255:
		return "more than 255 values in one array"
	r_bytes.append(p_values.size() / p_each)
	for value: Variant in p_values:
		var fault: String = append(r_bytes, value, p_depth + 1)
		if fault != "":
			return fault
	return ""


static func _read_all(p_reader: ByteReader, p_depth: int, p_each: int) -> Array:
	var values: Array = []
	for _value: int in p_reader.read_u8() * p_each:
		values.append(read(p_reader, p_depth + 1))
		if p_reader.failed:
			break
	return values


static func _numbers_of(p_kind: Kind, p_value: Variant) -> PackedFloat64Array:
	match p_kind:
		Kind.FLOAT:
			return [p_value]
		Kind.VECTOR2:
			return [p_value.x, p_value.y]
		Kind.VECTOR3:
			return [p_value.x, p_value.y, p_value.z]
		Kind.QUATERNION:
			return [p_value.x, p_value.y, p_value.z, p_value.w]
		Kind.COLOR:
			return [p_value.r, p_value.g, p_value.b, p_value.a]
	return []


static func _read_numbers(p_reader: ByteReader, p_kind: int) -> Variant:
	var x: float = p_reader.read_double()
	if p_kind == Kind.FLOAT:
		return x
	var y: float = p_reader.read_double()
	if p_kind == Kind.VECTOR2:
		return Vector2(x, y)
	var z: float = p_reader.read_double()
	if p_kind == Kind.VECTOR3:
		return Vector3(x, y, z)
	var w: float = p_reader.read_double()
	if p_kind == Kind.QUATERNION:
		return Quaternion(x, y, z, w)
	return Color(x, y, z, w)
