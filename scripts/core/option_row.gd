class_name OptionRow
extends RefCounted
## One option of a program: its name, default, what it can be, which roles take it and what it
## means. Checks, help and the table of the documents are made from rows like this.

## What the value of an option is.
enum Kind {
	## Any text.
	TEXT,
	## One of [member choices].
	CHOICE,
	## Some of [member choices], with commas between.
	CHOICES,
	## A whole number from [member lowest] to [member highest].
	NUMBER,
	## A number from [member lowest] to [member highest].
	DECIMAL,
	## Path of a file.
	FILE,
	## Paths of files, with commas between.
	FILES,
	## 0 or 1; without a value 1.
	FLAG,
}

## Longer numbers do not fit, and the engine would report an error.
const _MAX_DIGITS: int = 10
## What stands for a value in help and errors.
const _FORMS: Dictionary[Kind, String] = {
	Kind.TEXT: "TEXT",
	Kind.CHOICE: "NAME",
	Kind.CHOICES: "NAME,...",
	Kind.NUMBER: "NUMBER",
	Kind.DECIMAL: "NUMBER",
	Kind.FILE: "FILE",
	Kind.FILES: "FILE,...",
	Kind.FLAG: "0|1",
}

## Name, without the two hyphens.
var name: String = ""
## What its value is.
var kind: Kind = Kind.TEXT
## Names of the roles that take it.
var roles: PackedStringArray = []
## Default: a text, an int or a float.
var default_value: Variant = ""
## Its minimum, in its unit.
var lowest: float = 0.0
## Its maximum, in its unit. Of a text: its maximum of characters, 0 for no limit.
var highest: float = 0.0
## Unit of a number: "s", "degrees"; empty for counts.
var unit: String = ""
## The possible values, if it is not any text.
var choices: PackedStringArray = []
## What it means, for people.
var meaning: String = ""
## What it is where it is given without a value; empty: it needs one.
var bare: String = ""
## What stands for a value in help and errors, such as "AZIMUTH,ELEVATION,DISTANCE".
var form: String = ""
## Whether it may be given again: values are put together with commas between.
var is_repeatable: bool = false


## An option that is any text, with a maximum length; 0 for no limit.
static func text(
	p_name: String, p_roles: PackedStringArray, p_meaning: String, p_max_length: int = 0
) -> OptionRow:
	var row: OptionRow = _make(Kind.TEXT, p_name, p_roles, "", p_meaning)
	row.highest = p_max_length
	return row


## An option that is one of some words. An empty default is allowed: it is none of them.
static func choice(
	p_name: String,
	p_roles: PackedStringArray,
	p_default: String,
	p_choices: PackedStringArray,
	p_meaning: String
) -> OptionRow:
	var row: OptionRow = _make(Kind.CHOICE, p_name, p_roles, p_default, p_meaning)
	row.choices = p_choices
	return row


## An option that is any number of some words, with commas between.
static func choices_of(
	p_name: String,
	p_roles: PackedStringArray,
	p_default: String,
	p_choices: PackedStringArray,
	p_meaning: String
) -> OptionRow:
	var row: OptionRow = choice(p_name, p_roles, p_default, p_choices, p_meaning)
	row.kind = Kind.CHOICES
	row.form = _FORMS[Kind.CHOICES]
	return row


## An option that is a whole number within limits.
static func number(
	p_name: String,
	p_roles: PackedStringArray,
	p_default: int,
	p_limits: Array[int],
	p_meaning: String,
	p_unit: String = ""
) -> OptionRow:
	var row: OptionRow = _make(Kind.NUMBER, p_name, p_roles, p_default, p_meaning)
	row.lowest = p_limits[0]
	row.highest = p_limits[1]
	row.unit = p_unit
	return row


## An option that is a number of some unit within limits.
static func decimal(
	p_name: String,
	p_roles: PackedStringArray,
	p_default: float,
	p_limits: Array[float],
	p_meaning: String,
	p_unit: String
) -> OptionRow:
	var row: OptionRow = _make(Kind.DECIMAL, p_name, p_roles, p_default, p_meaning)
	row.lowest = p_limits[0]
	row.highest = p_limits[1]
	row.unit = p_unit
	return row


## An option that names a file.
static func file(p_name: String, p_roles: PackedStringArray, p_meaning: String) -> OptionRow:
	return _make(Kind.FILE, p_name, p_roles, "", p_meaning)


## An option that names files, with commas between.
static func files(p_name: String, p_roles: PackedStringArray, p_meaning: String) -> OptionRow:
	return _make(Kind.FILES, p_name, p_roles, "", p_meaning)


## An option that switches something on.
static func flag(p_name: String, p_roles: PackedStringArray, p_meaning: String) -> OptionRow:
	var row: OptionRow = _make(Kind.FLAG, p_name, p_roles, 0, p_meaning)
	row.highest = 1
	row.bare = "1"
	return row


## The same row, with another default.
func or_default(p_default: Variant) -> OptionRow:
	default_value = p_default
	return self


## The same row, with what the option is where it is given without a value.
func or_bare(p_bare: String) -> OptionRow:
	bare = p_bare
	return self


## The same row, for an option that may be given again.
func or_more() -> OptionRow:
	is_repeatable = true
	return self


## The same row, with what stands for a value in help and errors.
func shown_as(p_form: String) -> OptionRow:
	form = p_form
	return self


## The environment variable of the same meaning.
func variable() -> String:
	return "DISMOUNT_" + name.to_upper().replace("-", "_")


## How it is written, for help and errors: [code]--port=NUMBER[/code].
func usage() -> String:
	if kind == Kind.FLAG:
		return "--" + name
	return ("--%s[=%s]" if bare != "" else "--%s=%s") % [name, form]


## What it can be, for people: "1 to 65535", "local, server"; empty if it is any text or file.
func describe_range() -> String:
	match kind:
		Kind.NUMBER, Kind.DECIMAL:
			return ("%s to %s %s" % [_short(lowest), _short(highest), unit]).strip_edges()
		Kind.CHOICE, Kind.CHOICES:
			return ", ".join(choices)
		Kind.TEXT:
			return "at most %s characters" % _short(highest) if highest > 0 else ""
	return ""


## The default, for people: empty if it is nothing.
func describe_default() -> String:
	return _short(default_value) if default_value is float else str(default_value)


## Reads a value. Returns null if it is invalid, see [method find_fault].
func parse(p_value: String) -> Variant:
	if find_fault(p_value) != "":
		return null
	if kind == Kind.NUMBER or kind == Kind.FLAG:
		return p_value.to_int()
	if kind == Kind.DECIMAL:
		return p_value.to_float()
	return p_value


## What is wrong with a value: what is expected and what was found; or an empty text.
func find_fault(p_value: String) -> String:
	var found: String = "found '%s'" % p_value.left(80)
	match kind:
		Kind.NUMBER, Kind.DECIMAL, Kind.FLAG:
			if not _is_number(p_value):
				var what: String = "a number" if kind == Kind.DECIMAL else "a whole number"
				return "expects %s, %s, %s" % [what, _limits(), found]
			if p_value.to_float() < lowest or p_value.to_float() > highest:
				return "is %s, %s" % [_limits(), found]
		Kind.CHOICE:
			if p_value != default_value and not choices.has(p_value):
				found += Nearest.suggest(p_value, choices)
				return "is one of %s, %s" % [", ".join(choices), found]
		Kind.CHOICES:
			for part: String in p_value.split(",", false):
				if not choices.has(part):
					found += Nearest.suggest(part, choices)
					return "is any of %s, with commas between, %s" % [", ".join(choices), found]
		Kind.TEXT:
			if highest > 0 and p_value.length() > highest:
				return "has %s, found %d" % [describe_range(), p_value.length()]
	return ""


func _limits() -> String:
	return "0 or 1" if kind == Kind.FLAG else describe_range()


func _is_number(p_value: String) -> bool:
	if kind != Kind.DECIMAL:
		return p_value.is_valid_int() and p_value.length() < _MAX_DIGITS
	var is_short: bool = p_value.length() < 2 * _MAX_DIGITS and not "e" in p_value.to_lower()
	return is_short and p_value.is_valid_float()


static func _make(
	p_kind: Kind, p_name: String, p_roles: PackedStringArray, p_default: Variant, p_meaning: String
) -> OptionRow:
	var row: OptionRow = OptionRow.new()
	row.kind = p_kind
	row.name = p_name
	row.roles = p_roles
	row.default_value = p_default
	row.meaning = p_meaning
	row.form = _FORMS[p_kind]
	return row


static func _short(p_number: float) -> String:
	return String.num(p_number, 6).trim_suffix(".0")
