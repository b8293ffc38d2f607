@tool
class_name EffectKey
extends RefCounted
## What one setting of an effect's header may be: [code]// @NAME VALUE[/code].

## How the value is written.
enum Kind {
	## Any words.
	TEXT,
	## The name of an effect.
	NAME,
	## A number.
	NUMBER,
	## A number without a fraction.
	WHOLE,
	## yes or no.
	YES_NO,
	## One of [member choices].
	CHOICE,
	## Several numbers.
	NUMBERS,
	## Several colours, such as #ff8000 or #ff800080 with opacity.
	COLOURS,
}

const YES: PackedStringArray = ["yes", "true", "on", "1"]
const NO: PackedStringArray = ["no", "false", "off", "0"]

## The word after the @.
var name: String = ""
var kind: Kind = Kind.TEXT
## The value where the header does not say one.
var default: Variant = ""
## Bounds of each number, in [member suffix].
var minimum: float = 0.0
var maximum: float = 0.0
## The fewest and the most values of [constant NUMBERS] and [constant COLOURS].
var fewest: int = 1
var most: int = 1
## What [constant CHOICE] chooses from.
var choices: PackedStringArray = []
## The unit of a number.
var suffix: String = ""
## What the setting does, for people.
var meaning: String = ""


static func number(
	p_name: String,
	p_default: float,
	p_minimum: float,
	p_maximum: float,
	p_suffix: String,
	p_meaning: String
) -> EffectKey:
	var key: EffectKey = _make(p_name, Kind.NUMBER, p_default, p_meaning)
	key._bound(p_minimum, p_maximum, p_suffix)
	return key


static func whole(
	p_name: String, p_default: int, p_minimum: int, p_maximum: int, p_meaning: String
) -> EffectKey:
	var key: EffectKey = _make(p_name, Kind.WHOLE, p_default, p_meaning)
	key._bound(p_minimum, p_maximum, "")
	return key


## Several numbers; [param p_count] says how many, at least and at most.
static func numbers(
	p_name: String,
	p_default: PackedFloat64Array,
	p_bounds: Vector2,
	p_suffix: String,
	p_count: Vector2i,
	p_meaning: String
) -> EffectKey:
	var key: EffectKey = _make(p_name, Kind.NUMBERS, p_default, p_meaning)
	key._bound(p_bounds.x, p_bounds.y, p_suffix)
	key.fewest = p_count.x
	key.most = p_count.y
	return key


static func colours(p_name: String, p_most: int, p_meaning: String) -> EffectKey:
	var white: PackedColorArray = [Color.WHITE]
	var key: EffectKey = _make(p_name, Kind.COLOURS, white, p_meaning)
	key.most = p_most
	return key


static func choice(p_name: String, p_choices: PackedStringArray, p_meaning: String) -> EffectKey:
	var key: EffectKey = _make(p_name, Kind.CHOICE, p_choices[0], p_meaning)
	key.choices = p_choices
	return key


static func yes_no(p_name: String, p_meaning: String) -> EffectKey:
	return _make(p_name, Kind.YES_NO, false, p_meaning)


## Words, or the name of an effect.
static func words(p_name: String, p_is_name: bool, p_meaning: String) -> EffectKey:
	return _make(p_name, Kind.NAME if p_is_name else Kind.TEXT, "", p_meaning)


## The value that the words after the setting's name say, or an [EffectProblem] without a line that
## says why they say none. Keys are shared between threads: nothing of a reading stays in them.
func read(p_words: PackedStringArray) -> Variant:
	if p_words.is_empty():
		return _fail("'%s' needs a value: %s." % [name, meaning])
	if kind != Kind.TEXT and p_words.size() > most:
		return _fail("'%s' has too many values: %s." % [name, usage()])
	match kind:
		Kind.TEXT:
			return " ".join(p_words).left(80)
		Kind.NAME:
			return _read_name(p_words[0])
		Kind.NUMBER, Kind.WHOLE:
			return _read_number(p_words[0])
		Kind.YES_NO:
			return _read_yes_no(p_words[0])
		Kind.CHOICE:
			if choices.has(p_words[0]):
				return p_words[0]
			return _fail("'%s' is one of %s, not '%s'." % _choices_and(p_words[0]))
		Kind.NUMBERS:
			return _read_numbers(p_words)
	return _read_colours(p_words)


## How the setting is written.
func usage() -> String:
	match kind:
		Kind.NUMBER, Kind.WHOLE:
			return "// @%s %s" % [name, _text(default)]
		Kind.NUMBERS:
			var all: PackedStringArray = []
			for value: float in default as PackedFloat64Array:
				all.append(_text(value))
			return "// @%s %s" % [name, " ".join(all)]
		Kind.COLOURS:
			return "// @%s #ffffff" % name
		Kind.YES_NO:
			return "// @%s yes" % name
		Kind.CHOICE:
			return "// @%s %s" % [name, choices[0]]
	return "// @%s %s" % [name, "smoke" if kind == Kind.NAME else "Words"]


static func _make(p_name: String, p_kind: Kind, p_default: Variant, p_meaning: String) -> EffectKey:
	var key: EffectKey = EffectKey.new()
	key.name = p_name
	key.kind = p_kind
	key.default = p_default
	key.meaning = p_meaning
	return key


## A number as short as it can be written.
static func _text(p_value: Variant) -> String:
	return String.num(float(p_value), 4).trim_suffix(".0")


func _bound(p_minimum: float, p_maximum: float, p_suffix: String) -> void:
	minimum = p_minimum
	maximum = p_maximum
	suffix = p_suffix


func _fail(p_text: String) -> EffectProblem:
	return EffectProblem.new(0, p_text)


func _choices_and(p_word: String) -> Array:
	return [name, ", ".join(choices), p_word.left(40)]


func _read_name(p_word: String) -> Variant:
	if EffectLimits.is_name(p_word):
		return p_word
	return _fail("'%s' is the name of an effect in small letters, digits and _." % name)


func _read_yes_no(p_word: String) -> Variant:
	if YES.has(p_word):
		return true
	if NO.has(p_word):
		return false
	return _fail("'%s' is yes or no, not '%s'." % [name, p_word.left(40)])


func _read_number(p_word: String) -> Variant:
	if not p_word.is_valid_float():
		return _fail("'%s' is a number, not '%s'." % [name, p_word.left(40)])
	var value: float = p_word.to_float()
	# Not the other way round: what is no number at all fails every comparison.
	if not (value >= minimum and value <= maximum):
		return _fail(
			(
				"'%s' lies between %s and %s%s, not at %s."
				% [name, _text(minimum), _text(maximum), _unit(), p_word.left(20)]
			)
		)
	if kind != Kind.WHOLE:
		return value
	if value != floorf(value):
		return _fail("'%s' is a whole number, not %s." % [name, p_word.left(20)])
	return int(value)


func _unit() -> String:
	return "" if suffix == "" else " " + suffix


func _read_numbers(p_words: PackedStringArray) -> Variant:
	if p_words.size() < fewest:
		return _fail("'%s' needs %d numbers: %s." % [name, fewest, usage()])
	var values: PackedFloat64Array = []
	for word: String in p_words:
		var value: Variant = _read_number(word)
		if value is EffectProblem:
			return value
		values.append(value)
	return values


func _read_colours(p_words: PackedStringArray) -> Variant:
	var values: PackedColorArray = []
	for word: String in p_words:
		if not word.begins_with("#") or not Color.html_is_valid(word):
			return _fail("'%s' is a colour such as #ff8000, not '%s'." % [name, word.left(40)])
		values.append(Color.html(word))
	return values
