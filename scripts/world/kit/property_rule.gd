@tool
class_name PropertyRule
extends RefCounted
## What a property of a received level may hold: a kind of value and its range. See [LevelKit].

## Kinds of values.
enum Kind {
	## A truth value.
	FLAG,
	## A whole number.
	WHOLE,
	## A number.
	NUMBER,
	## Two numbers.
	VECTOR2,
	## Three numbers.
	VECTOR3,
	## A colour; numbers above 1 are allowed up to the range's end.
	COLOUR,
	## A transform in the parent's frame.
	TRANSFORM,
	## A text.
	TEXT,
	## Points in space.
	POINTS,
	## Points in a plane.
	POINTS2,
	## Rectangles.
	RECTS,
	## Numbers.
	NUMBERS,
	## Colours.
	COLOURS,
	## A resource of one of some classes.
	RESOURCE,
	## Resources of one of some classes.
	RESOURCES,
	## A node of the level.
	NODE,
	## A path to a node of the level.
	PATH,
	## The name of a file of the level's folder, such as [code]town.height[/code]; the node gets the
	## whole path.
	FILE,
	## Accepted and forgotten: what only the editor uses.
	IGNORED,
}

## Openings of a wall or gaps of a railing, and where they may be, m.
const MAX_OPENINGS: int = 64
const FARTHEST_OPENING_M: float = 250.0
## Greatest distance of a thing from its parent, and from the level's origin, m.
const FARTHEST: float = 8000.0
## Largest and smallest length of an axis of a transform.
const LARGEST_SCALE: float = 1000.0

## What the property holds.
var kind: Kind = Kind.FLAG
## Least number, length of a text, or number of elements.
var least: float = 0.0
## Greatest number, length of a text, or number of elements.
var most: float = 0.0
## Range of the numbers in a list of numbers or points.
var most_each: float = 1e6
## Classes of a resource or a node: the keys of [LevelKit]; the ending of a file.
var classes: PackedStringArray = []


## A truth value.
static func flag() -> PropertyRule:
	return _make(Kind.FLAG, 0.0, 0.0)


## A whole number of a range.
static func whole(p_least: int, p_most: int) -> PropertyRule:
	return _make(Kind.WHOLE, p_least, p_most)


## A number of a range.
static func number(p_least: float, p_most: float) -> PropertyRule:
	return _make(Kind.NUMBER, p_least, p_most)


## Two numbers of a range.
static func vector2(p_least: float, p_most: float) -> PropertyRule:
	return _make(Kind.VECTOR2, p_least, p_most)


## Three numbers of a range.
static func vector3(p_least: float, p_most: float) -> PropertyRule:
	return _make(Kind.VECTOR3, p_least, p_most)


## A colour whose channels go up to a number.
static func colour(p_most: float = 1.0) -> PropertyRule:
	return _make(Kind.COLOUR, 0.0, p_most)


## Where something stands in its parent.
static func transform() -> PropertyRule:
	return _make(Kind.TRANSFORM, 0.0, 0.0)


## A text of so many characters at most.
static func text(p_most: int = 80) -> PropertyRule:
	return _make(Kind.TEXT, 0.0, p_most)


## Points in space, so many at most.
static func points(p_most: int) -> PropertyRule:
	var rule: PropertyRule = _make(Kind.POINTS, 0.0, p_most)
	rule.most_each = FARTHEST
	return rule


## Points in a plane, so many at most, and how far from the origin.
static func points2(p_most: int, p_farthest: float) -> PropertyRule:
	var rule: PropertyRule = _make(Kind.POINTS2, 0.0, p_most)
	rule.most_each = p_farthest
	return rule


## Openings in a wall: as many and as far away as a level needs.
static func openings() -> PropertyRule:
	return rects(MAX_OPENINGS, FARTHEST_OPENING_M)


## Gaps in a kerb or a railing, each from x to y, m.
static func gaps() -> PropertyRule:
	return points2(MAX_OPENINGS, FARTHEST_OPENING_M)


## Rectangles, so many at most, and how large their numbers may be. Their sizes are not negative.
static func rects(p_most: int, p_farthest: float) -> PropertyRule:
	var rule: PropertyRule = _make(Kind.RECTS, 0.0, p_most)
	rule.most_each = p_farthest
	return rule


## The rule that the hint of an exported property states, as
## [method Object.get_property_list] has it; null where a hint says too little.
static func from_hint(p_property: Dictionary) -> PropertyRule:
	var hint: PropertyHint = p_property["hint"]
	var words: PackedStringArray = (p_property["hint_string"] as String).split(",")
	match p_property["type"]:
		TYPE_BOOL:
			return flag()
		TYPE_COLOR:
			return colour()
		TYPE_FLOAT when hint == PROPERTY_HINT_RANGE:
			return number(words[0].to_float(), words[1].to_float())
		TYPE_INT when hint == PROPERTY_HINT_RANGE:
			return whole(words[0].to_int(), words[1].to_int())
		TYPE_INT when hint == PROPERTY_HINT_ENUM:
			return whole(0, words.size() - 1)
	return null


## Numbers, so many at most.
static func numbers(p_most: int) -> PropertyRule:
	return _make(Kind.NUMBERS, 0.0, p_most)


## Colours, so many at most.
static func colours(p_most: int) -> PropertyRule:
	return _make(Kind.COLOURS, 0.0, p_most)


## A resource of one of some classes (keys of [LevelKit]), or none.
static func resource(p_classes: PackedStringArray) -> PropertyRule:
	return _of(Kind.RESOURCE, p_classes, 0)


## Resources of one of some classes, so many at most.
static func resources(p_classes: PackedStringArray, p_most: int) -> PropertyRule:
	return _of(Kind.RESOURCES, p_classes, p_most)


## A node of the level of one of some classes; any class if there is none.
static func node(p_classes: PackedStringArray = []) -> PropertyRule:
	return _of(Kind.NODE, p_classes, 0)


## A path to a node of the level.
static func path() -> PropertyRule:
	return _make(Kind.PATH, 0.0, 0.0)


## A file of the level's folder with an ending.
static func file(p_ending: String) -> PropertyRule:
	return _of(Kind.FILE, [p_ending], 0)


## Accepted and forgotten.
static func ignored() -> PropertyRule:
	return _make(Kind.IGNORED, 0.0, 0.0)


## The value as the property takes it; why it does not take it is added to [param r_faults].
## References are for [LevelReader]. Threads share rules, so nothing of it is kept here.
func take(p_value: Variant, r_faults: PackedStringArray) -> Variant:
	match kind:
		Kind.FLAG, Kind.WHOLE, Kind.NUMBER:
			return _take_one(p_value, r_faults)
		Kind.VECTOR2:
			return _take_vector2(p_value, r_faults)
		Kind.VECTOR3:
			return _take_vector3(p_value, r_faults)
		Kind.COLOUR:
			return _take_colour(p_value, r_faults)
		Kind.TRANSFORM:
			return _take_transform(p_value, r_faults)
		Kind.TEXT:
			return _take_text(p_value, r_faults)
		Kind.POINTS, Kind.POINTS2, Kind.NUMBERS, Kind.COLOURS:
			return _take_list(p_value, r_faults)
		Kind.RECTS:
			return _take_rects(p_value, r_faults)
	return p_value


func _take_one(p_value: Variant, r_faults: PackedStringArray) -> Variant:
	if kind == Kind.FLAG:
		return p_value if p_value is bool else _refuse(r_faults, "has to be true or false")
	if kind == Kind.WHOLE and not p_value is int:
		return _refuse(r_faults, "has to be a whole number")
	if not (p_value is float or p_value is int):
		return _refuse(r_faults, "has to be a number")
	return _take_number(p_value, r_faults)


func _take_number(p_value: Variant, r_faults: PackedStringArray) -> Variant:
	if p_value < least or p_value > most:
		return _refuse(
			r_faults, "is %s: %s to %s are allowed" % [p_value, _short(least), _short(most)]
		)
	return p_value


func _take_vector2(p_value: Variant, r_faults: PackedStringArray) -> Variant:
	if not p_value is Vector2:
		return _refuse(r_faults, "has to be a Vector2")
	for axis: int in 2:
		_take_number((p_value as Vector2)[axis], r_faults)
	return p_value


func _take_vector3(p_value: Variant, r_faults: PackedStringArray) -> Variant:
	if not p_value is Vector3:
		return _refuse(r_faults, "has to be a Vector3")
	for axis: int in 3:
		_take_number((p_value as Vector3)[axis], r_faults)
	return p_value


func _take_colour(p_value: Variant, r_faults: PackedStringArray) -> Variant:
	if not p_value is Color:
		return _refuse(r_faults, "has to be a Color")
	for channel: int in 4:
		_take_number((p_value as Color)[channel], r_faults)
	return p_value


func _take_transform(p_value: Variant, r_faults: PackedStringArray) -> Variant:
	if not p_value is Transform3D:
		return _refuse(r_faults, "has to be a Transform3D")
	var value: Transform3D = p_value
	var lengths: Vector3 = value.basis.get_scale().abs()
	var shortest: float = minf(lengths.x, minf(lengths.y, lengths.z))
	var longest: float = maxf(lengths.x, maxf(lengths.y, lengths.z))
	var volume: float = absf(value.basis.determinant())
	if longest > LARGEST_SCALE or shortest < 1.0 / LARGEST_SCALE:
		return _refuse(r_faults, "scales by less than 0.001 or more than 1000")
	if volume < 1e-3 * lengths.x * lengths.y * lengths.z:
		return _refuse(r_faults, "is flat")
	if value.origin.length() > FARTHEST:
		return _refuse(
			r_faults, "stands %.0f m away, %.0f m are the most" % [value.origin.length(), FARTHEST]
		)
	return value


func _take_text(p_value: Variant, r_faults: PackedStringArray) -> Variant:
	if not (p_value is String or p_value is StringName):
		return _refuse(r_faults, "has to be a text")
	if String(p_value).length() > most:
		return _refuse(r_faults, "has more than %.0f characters" % most)
	return ByteReader.clean(String(p_value))


func _take_list(p_value: Variant, r_faults: PackedStringArray) -> Variant:
	var types: Dictionary[Kind, Array] = {
		Kind.POINTS: [TYPE_PACKED_VECTOR3_ARRAY],
		Kind.POINTS2: [TYPE_PACKED_VECTOR2_ARRAY],
		Kind.NUMBERS: [TYPE_PACKED_FLOAT32_ARRAY, TYPE_PACKED_INT32_ARRAY],
		Kind.COLOURS: [TYPE_PACKED_COLOR_ARRAY],
	}
	if not typeof(p_value) in types[kind]:
		return _refuse(r_faults, "has to be a %s" % type_string(types[kind][0]))
	if p_value.size() > most:
		return _refuse(r_faults, "has %d elements, %.0f are the most" % [p_value.size(), most])
	var flat: PackedFloat32Array = []
	if p_value is PackedInt32Array:
		flat = PackedFloat32Array(Array(p_value))
	else:
		flat = (p_value.to_byte_array() as PackedByteArray).to_float32_array()
	for each: float in flat:
		if absf(each) > most_each:
			return _refuse(r_faults, "holds %s, %s is the most" % [each, _short(most_each)])
	return p_value


func _take_rects(p_value: Variant, r_faults: PackedStringArray) -> Variant:
	if not p_value is Array or (p_value as Array).get_typed_builtin() != TYPE_RECT2:
		return _refuse(r_faults, "has to be an Array[Rect2]")
	var rects_given: Array[Rect2] = p_value
	if rects_given.size() > most:
		return _refuse(r_faults, "has %d elements, %.0f are the most" % [rects_given.size(), most])
	for rect: Rect2 in rects_given:
		var corner: Vector2 = rect.position.abs().max(rect.end.abs())
		var is_near: bool = maxf(corner.x, corner.y) <= most_each
		if not is_near or rect.size.x < 0.0 or rect.size.y < 0.0:
			return _refuse(r_faults, "holds %s: %s m is the most" % [rect, _short(most_each)])
	return p_value


static func _refuse(r_faults: PackedStringArray, p_why: String) -> Variant:
	r_faults.append(p_why)
	return null


static func _make(p_kind: Kind, p_least: float, p_most: float) -> PropertyRule:
	var rule: PropertyRule = PropertyRule.new()
	rule.kind = p_kind
	rule.least = p_least
	rule.most = p_most
	return rule


static func _of(p_kind: Kind, p_classes: PackedStringArray, p_most: int) -> PropertyRule:
	var rule: PropertyRule = _make(p_kind, 0.0, p_most)
	rule.classes = p_classes
	return rule


static func _short(p_number: float) -> String:
	return String.num(p_number, 3).trim_suffix(".0")
