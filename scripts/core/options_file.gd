class_name OptionsFile
extends RefCounted
## A file of options, for [code]--config[/code]: lines such as [code]max-clients = 8[/code], in the
## form of Godot's .cfg files.
##
## Text may stand in quotation marks; comments begin with ; or #. Lines below [code][server][/code]
## are for that role, those below [code][all][/code] for each role that takes them, those above any
## heading for the role that reads the file. Every fault is named with its line.

## Largest file that is read, bytes.
const MAX_BYTES: int = 1 << 20
## Maximum of faults that are named; the others are counted.
const MAX_FAULTS: int = 8
## Heading for all roles.
const ALL: String = "all"
## Options that say what to read, so they cannot be read from it.
const OUTSIDE: PackedStringArray = ["role", "config"]

## The texts of the options of the role, by name; checked.
var values: Dictionary[String, String] = {}
## What is wrong, a line each: "FILE:LINE: ...".
var faults: PackedStringArray = []

var _path: String = ""
var _role: String = ""
var _rows: Dictionary[String, OptionRow] = {}
var _lines: Dictionary[String, int] = {}
var _heading: String = ""
var _is_skipped: bool = false


## Reads a file for a role, or for any if the role is empty.
static func read(
	p_path: String, p_rows: Dictionary[String, OptionRow], p_role: String
) -> OptionsFile:
	var file: FileAccess = FileAccess.open(p_path, FileAccess.READ)
	if file == null:
		var result: OptionsFile = OptionsFile.new()
		var why: String = error_string(FileAccess.get_open_error())
		result.faults.append("the configuration %s cannot be read: %s" % [p_path, why])
		return result
	return parse(file.get_buffer(MAX_BYTES + 1), p_path, p_rows, p_role)


## Reads the bytes of a file; the path is for the messages.
static func parse(
	p_bytes: PackedByteArray, p_path: String, p_rows: Dictionary[String, OptionRow], p_role: String
) -> OptionsFile:
	var result: OptionsFile = OptionsFile.new()
	result._path = p_path
	result._rows = p_rows
	result._role = p_role
	if p_bytes.size() > MAX_BYTES:
		result._refuse(1, "a configuration has at most %d bytes" % MAX_BYTES)
		return result
	if p_bytes.has(0):
		result._refuse(1, "this is no text")
		return result
	var number: int = 0
	for line: String in p_bytes.get_string_from_utf8().split("\n"):
		number += 1
		result._read_line(number, line.strip_edges())
	return result


## All faults as one text, at most [constant MAX_FAULTS] of them; empty if there are none.
func describe_faults() -> String:
	var text: String = "\n".join(faults.slice(0, MAX_FAULTS))
	if faults.size() > MAX_FAULTS:
		text += "\nand %d more" % (faults.size() - MAX_FAULTS)
	return text


func _refuse(p_line: int, p_what: String) -> void:
	faults.append("%s:%d: %s" % [_path, p_line, p_what])


func _read_line(p_number: int, p_line: String) -> void:
	if p_line == "" or p_line[0] == ";" or p_line[0] == "#":
		return
	if p_line[0] == "[":
		_read_heading(p_number, p_line)
		return
	var equals: int = p_line.find("=")
	if equals < 0:
		_refuse(p_number, "write name = value, found '%s'" % ByteReader.clean(p_line).left(80))
		return
	var name: String = p_line.left(equals).strip_edges().trim_prefix("--")
	var row: OptionRow = _rows.get(name)
	if row == null:
		var shown: String = ByteReader.clean(name).left(80)
		_refuse(p_number, "there is no option %s%s" % [shown, _suggest(name)])
	elif OUTSIDE.has(name):
		_refuse(p_number, "%s is given in the command line" % name)
	else:
		_take(p_number, row, p_line.substr(equals + 1).strip_edges())


func _read_heading(p_number: int, p_line: String) -> void:
	_heading = p_line.trim_prefix("[").trim_suffix("]").strip_edges()
	var known: PackedStringArray = [ALL]
	for row: OptionRow in _rows.values():
		for role: String in row.roles:
			if not known.has(role):
				known.append(role)
	_is_skipped = _role != "" and _heading != ALL and _heading != _role
	if not known.has(_heading) or not p_line.ends_with("]"):
		var shown: String = ByteReader.clean(p_line).left(80)
		var hint: String = Nearest.suggest(_heading, known)
		if hint == "":
			hint = ": the headings are [%s]" % "], [".join(known)
		_refuse(p_number, "there is no heading %s%s" % [shown, hint])


func _take(p_number: int, p_row: OptionRow, p_value: String) -> void:
	var value: String = _read_value(p_number, p_row, p_value)
	var reader: String = _role if _heading == "" or _heading == ALL else _heading
	if reader != "" and not p_row.roles.has(reader):
		if _heading != ALL:
			var parts: Array = [p_row.name, ", ".join(p_row.roles), reader]
			_refuse(p_number, "%s is for %s, not for %s" % parts)
		return
	var key: String = _heading + "/" + p_row.name
	if _lines.has(key):
		_refuse(p_number, "%s is given twice, see line %d" % [p_row.name, _lines[key]])
		return
	_lines[key] = p_number
	var fault: String = p_row.find_fault(value)
	if fault != "":
		_refuse(p_number, "%s %s" % [p_row.name, fault])
	elif not _is_skipped:
		values[p_row.name] = value


func _read_value(p_number: int, p_row: OptionRow, p_value: String) -> String:
	if p_row.kind == OptionRow.Kind.FLAG and p_value in ["true", "false"]:
		return "1" if p_value == "true" else "0"
	if not p_value.begins_with('"'):
		return p_value
	if p_value.length() < 2 or not p_value.ends_with('"'):
		_refuse(p_number, "a quotation mark is missing")
		return p_value
	return p_value.substr(1, p_value.length() - 2).c_unescape()


func _suggest(p_name: String) -> String:
	var names: PackedStringArray = []
	var reader: String = _role if _heading == "" else _heading
	for row: OptionRow in _rows.values():
		if not OUTSIDE.has(row.name) and (row.roles.has(reader) or reader in ["", ALL]):
			names.append(row.name)
	return Nearest.suggest(p_name, names)
