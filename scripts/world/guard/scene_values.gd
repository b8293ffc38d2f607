class_name SceneValues
extends RefCounted
## Reads the values of a text scene by a grammar of its own: numbers, truth values, texts, vectors,
## colours, transforms, arrays of numbers, paths of nodes, references. It has no word for an object,
## a script, a dictionary, a callable or a signal, and calls none of the engine's own readers.

## Numbers that a value may hold.
const MAX_NUMBERS: int = 300_000
## Longest text, characters.
const MAX_TEXT: int = 400
## Longest list of rectangles, characters.
const MAX_RECTS_TEXT: int = 20_000
## Largest number.
const LARGEST: float = 1e9
## Largest whole number: the editor numbers nodes by chance.
const LARGEST_WHOLE: int = 1 << 53

const _NUMBER: String = (
	"-?(?:[0-9]{1,19}(?:\\.[0-9]{0,40})?|\\.[0-9]{1,40})" + "(?:[eE][-+]?[0-9]{1,2})?"
)
## How many numbers a value of several numbers has; 0: any number of them.
const _SIZES: Dictionary[String, int] = {
	"Vector2": 2,
	"Vector2i": 2,
	"Vector3": 3,
	"Vector3i": 3,
	"Color": 4,
	"Transform3D": 12,
	"PackedFloat32Array": 0,
	"PackedInt32Array": 0,
	"PackedVector2Array": 0,
	"PackedVector3Array": 0,
	"PackedColorArray": 0,
}
const _REFERENCES: Dictionary[String, SceneReference.Kind] = {
	"SubResource": SceneReference.Kind.SUB,
	"ExtResource": SceneReference.Kind.EXTERNAL,
}

static var _number: RegEx = RegEx.create_from_string("^" + _NUMBER + "$")
static var _numbers: RegEx = RegEx.create_from_string(
	"^(?>" + _NUMBER + ")(?>, ?" + _NUMBER + ")*+$"
)
static var _call: RegEx = RegEx.create_from_string("^([A-Za-z0-9_]{1,40})\\((.*)\\)$")
static var _text: RegEx = RegEx.create_from_string('^"((?>[^"\\\\]++|\\\\["\\\\nt])*+)"$')
static var _list: RegEx = RegEx.create_from_string(
	"^(?:Array\\[([^\\[\\]]*)\\]\\()?\\[(.*)\\]\\)?$"
)
static var _item: RegEx = RegEx.create_from_string(
	'(?>(SubResource|ExtResource)\\("([A-Za-z0-9_.-]{1,80})"\\))(?:, ?|$)'
)
static var _rect: RegEx = RegEx.create_from_string("(?>Rect2\\(([^()]{1,200})\\))(?:, ?|$)")
static var _quoted: RegEx = RegEx.create_from_string('"([^"\\\\]*)"(?:, ?|$)')
static var _id: RegEx = RegEx.create_from_string("^[A-Za-z0-9_.-]{1,80}$")

## Why the last value is none, or an empty text.
var fault: String = ""


## The value of a text; where it is none, [member fault] says why.
func read(p_text: String) -> Variant:
	fault = ""
	if p_text == "":
		return _refuse("a value is missing")
	var first: String = p_text[0]
	if first == '"':
		return _read_text(p_text)
	if first == "[" or p_text.begins_with("Array["):
		return _read_list(p_text)
	if first == "-" or first == "." or (first >= "0" and first <= "9"):
		return _read_number(p_text)
	match p_text:
		"true":
			return true
		"false":
			return false
		"null":
			return null
	if first == "&":
		var name: Variant = _read_text(p_text.substr(1))
		if fault == "":
			name = StringName(name)
		return name
	var call: RegExMatch = _call.search(p_text)
	if call == null:
		return _refuse("'%s' is no value that a level may hold" % _show(p_text))
	return _read_call(call.get_string(1), call.get_string(2))


func _read_call(p_word: String, p_inside: String) -> Variant:
	if _SIZES.has(p_word):
		return _read_numbers(p_word, p_inside)
	if p_word == "PackedStringArray":
		return _read_texts(p_inside)
	if not _REFERENCES.has(p_word) and p_word != "NodePath":
		return _refuse("'%s' is no value that a level may hold" % _show(p_word))
	var inside: Variant = _read_text(p_inside)
	if fault != "":
		return null
	if p_word == "NodePath":
		return NodePath(inside as String)
	if _id.search(inside as String) == null:
		return _refuse("'%s' is no id of a resource" % _show(inside as String))
	return SceneReference.of(_REFERENCES[p_word], inside as String)


func _read_number(p_text: String) -> Variant:
	if p_text.length() > 80 or _number.search(p_text) == null:
		return _refuse("'%s' is no finite number" % _show(p_text))
	if p_text.is_valid_int():
		var whole: int = p_text.to_int()
		return whole if absi(whole) <= LARGEST_WHOLE else _refuse("a number is too large")
	var number: float = p_text.to_float()
	if not is_finite(number) or absf(number) > LARGEST:
		return _refuse("a number is too large")
	return number


func _read_text(p_text: String) -> Variant:
	if p_text.length() > MAX_TEXT + 2:
		return _refuse("a text has more than %d characters" % MAX_TEXT)
	var found: RegExMatch = _text.search(p_text)
	if found == null:
		return _refuse("a text is unfinished, goes over several lines or has unknown escapes")
	return found.get_string(1).c_unescape()


func _read_texts(p_inside: String) -> Variant:
	var texts: PackedStringArray = []
	var end: int = 0
	for found: RegExMatch in _quoted.search_all(p_inside.left(4 * MAX_TEXT)):
		if found.get_start() != end:
			break
		end = found.get_end()
		texts.append(found.get_string(1))
	if end != p_inside.length():
		return _refuse("a list of texts is broken or too long")
	return texts


func _read_list(p_text: String) -> Variant:
	var found: RegExMatch = _list.search(p_text)
	if found == null:
		return _refuse("'%s' is no list that a level may hold" % _show(p_text))
	var inside: String = found.get_string(2)
	if inside.begins_with('"'):
		return _read_texts(inside)
	if inside.begins_with("Rect2"):
		return _read_rects(inside)
	if inside == "" and found.get_string(1) == "Rect2":
		return [] as Array[Rect2]
	var list: SceneReference = SceneReference.of(SceneReference.Kind.LIST, "")
	var end: int = 0
	for item: RegExMatch in _item.search_all(inside):
		if item.get_start() != end:
			break
		end = item.get_end()
		list.items.append(SceneReference.of(_REFERENCES[item.get_string(1)], item.get_string(2)))
	if end != inside.length():
		return _refuse("'%s' is no list that a level may hold" % _show(p_text))
	return list


func _read_rects(p_inside: String) -> Variant:
	var rects: Array[Rect2] = []
	var end: int = 0
	for found: RegExMatch in _rect.search_all(p_inside.left(MAX_RECTS_TEXT)):
		if found.get_start() != end:
			break
		end = found.get_end()
		var numbers: Variant = _read_numbers("Color", found.get_string(1))
		if fault != "":
			return null
		var four: Color = numbers
		rects.append(Rect2(four.r, four.g, four.b, four.a))
	if end != p_inside.length():
		return _refuse("a list of rectangles is broken or too long")
	return rects


func _read_numbers(p_word: String, p_inside: String) -> Variant:
	var needed: int = _SIZES[p_word]
	var most: int = needed if needed > 0 else MAX_NUMBERS
	var is_empty: bool = needed == 0 and p_inside == ""
	var numbers: PackedFloat64Array = []
	if not is_empty:
		if p_inside.count(",") >= most:
			return _refuse("%s has more than %d numbers" % [p_word, most])
		if _numbers.search(p_inside) == null:
			return _refuse("%s holds something that is no finite number" % p_word)
		numbers = p_inside.split_floats(",")
	if needed > 0 and numbers.size() != needed:
		return _refuse("%s needs %d numbers" % [p_word, needed])
	for number: float in numbers:
		# A NaN is not below it either.
		if not absf(number) <= LARGEST:
			return _refuse("a number is too large")
	return _compose(p_word, numbers)


func _compose(p_word: String, p_n: PackedFloat64Array) -> Variant:
	match p_word:
		"Vector2", "Vector2i":
			return Vector2(p_n[0], p_n[1])
		"Vector3", "Vector3i":
			return Vector3(p_n[0], p_n[1], p_n[2])
		"Color":
			return Color(p_n[0], p_n[1], p_n[2], p_n[3])
		"Transform3D":
			return Transform3D(
				Vector3(p_n[0], p_n[3], p_n[6]),
				Vector3(p_n[1], p_n[4], p_n[7]),
				Vector3(p_n[2], p_n[5], p_n[8]),
				Vector3(p_n[9], p_n[10], p_n[11])
			)
		"PackedFloat32Array":
			return PackedFloat32Array(Array(p_n))
		"PackedInt32Array":
			return PackedInt32Array(Array(p_n))
	return _compose_list(p_word, p_n)


func _compose_list(p_word: String, p_n: PackedFloat64Array) -> Variant:
	var step: int = {"PackedVector2Array": 2, "PackedVector3Array": 3}.get(p_word, 4)
	if p_n.size() % step != 0:
		return _refuse("%s needs numbers by %d" % [p_word, step])
	var bytes: PackedByteArray = PackedFloat32Array(Array(p_n)).to_byte_array()
	match step:
		2:
			return bytes.to_vector2_array()
		3:
			return bytes.to_vector3_array()
	return bytes.to_color_array()


func _refuse(p_why: String) -> Variant:
	if fault == "":
		fault = p_why
	return null


## A part of a strange text that can be shown in a log.
static func _show(p_text: String) -> String:
	return ByteReader.clean(p_text.left(40))
