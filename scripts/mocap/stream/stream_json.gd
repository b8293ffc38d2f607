class_name StreamJson
extends RefCounted
## JSON of strangers: read without the engine's own complaints, which would fill the log.

## Numbers with three digits in their exponent are none of a person's, and the engine warns of them.
const _EXPONENT: String = "[eE][+-]?[0-9]{3}"
## Longest name, characters.
const _MAX_NAME: int = 64

## Why the last text is none, or an empty text.
var fault: String = ""

var _json: JSON = JSON.new()
var _exponent: RegEx = RegEx.create_from_string(_EXPONENT)


## The object that a text is; an empty dictionary where it is none.
func read(p_bytes: PackedByteArray) -> Dictionary:
	fault = ""
	# Byte by byte: the engine reports an error for UTF-8 that is none. Names are decoded later.
	var text: String = p_bytes.get_string_from_ascii()
	if _exponent.search(text) != null:
		fault = "it has a number with an exponent of three digits"
	elif _json.parse(text) != OK:
		fault = "it is no JSON: %s" % ByteReader.clean(_json.get_error_message()).left(100)
	elif not _json.data is Dictionary:
		fault = "it is JSON but no object"
	return _json.data if fault == "" else {}


## A number of an object, or NAN.
static func number(p_object: Dictionary, p_key: String) -> float:
	var value: Variant = p_object.get(p_key)
	return float(value) if value is float or value is int else NAN


## An object of an object, or an empty one.
static func child(p_object: Dictionary, p_key: String) -> Dictionary:
	var value: Variant = p_object.get(p_key)
	return value if value is Dictionary else {}


## A list of an object, or an empty one.
static func list(p_object: Dictionary, p_key: String) -> Array:
	var value: Variant = p_object.get(p_key)
	return value if value is Array else []


## A name of an object, or an empty text.
static func text(p_object: Dictionary, p_key: String) -> String:
	var value: Variant = p_object.get(p_key)
	if not value is String:
		return ""
	var bytes: PackedByteArray = PackedByteArray()
	for letter: String in (value as String).left(4 * _MAX_NAME):
		bytes.append(letter.unicode_at(0) & 0xFF)
	var sized: PackedByteArray = [0, 0]
	sized.encode_u16(0, bytes.size())
	sized.append_array(bytes)
	return ByteReader.new(sized).read_text(0xFFFF).left(_MAX_NAME)


## x, y and z of an object; not finite where one is missing.
static func vector(p_object: Dictionary) -> Vector3:
	return Vector3(number(p_object, "x"), number(p_object, "y"), number(p_object, "z"))


## x, y, z and w of an object; not finite where one is missing.
static func quaternion(p_object: Dictionary) -> Quaternion:
	var part: Vector3 = vector(p_object)
	return Quaternion(part.x, part.y, part.z, number(p_object, "w"))
